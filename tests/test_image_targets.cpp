// Where images are written: what is refused beforehand, and what failures leave behind.
#include <sys/resource.h>

#include <csignal>
#include <functional>

#include "catch.h"
#include "error.h"
#include "image_files.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;
namespace fs = std::filesystem;

namespace {

/// The exit code and the message of the Error that `action` throws; 0 when it throws none.
struct Outcome {
    int exit_code = 0;
    std::string message;
};
Outcome outcome_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return {error.exit_code(), error.what()};
    }
    return {};
}

/// No file can grow beyond `bytes` while it lives: a full disk, for root as well.
class FullDisk {
  public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

  private:
    void (*handler_)(int);
    rlimit before_{};
};

}  // namespace

TEST_CASE("what a path needs is what its file shows", "[image_io]") {
    const auto letters = [](const std::string& path, View view) {
        const Outputs o = outputs_for(path, {view, 0, 8});
        return std::string(o.radiance ? "r" : "") + (o.distance ? "d" : "") + (o.normal ? "n" : "") + (o.id ? "i" : "");
    };
    CHECK(letters("a.exr", View::radiance) == "rdni");
    CHECK(letters("a.EXR", View::id) == "rdni");
    CHECK(letters("a.png", View::radiance) == "r");
    CHECK(letters("a.png", View::distance) == "d");
    CHECK(letters("exr.tif", View::normal) == "n");
    CHECK(letters("a.exr.jpg", View::id) == "i");
}

TEST_CASE("a place that can be written to passes and stays as it was", "[image_io]") {
    const TempFolder folder;
    for (const char* name : {"a.exr", "a.png", "a.TIF", "a.jpg", "what?b=c.png", ".a.png"})
        CHECK(outcome_of([&] { check_writable(folder / name, {}); }).message == "");
    CHECK(outcome_of([&] { check_writable(folder / "a.png", {View::id, 0, 16}); }).message == "");
    CHECK(folder.count() == 0);
    write_file(folder / "old.png", "old");
    check_writable(folder / "old.png", {});
    CHECK(read_file(folder / "old.png") == "old");
    CHECK(folder.count() == 1);
}

TEST_CASE("a name without a folder is of the current one", "[image_io]") {
    const TempFolder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    const Outcome check = outcome_of([] { check_writable("here.png", {}); });
    const Outcome write = outcome_of([] { write_image(make_film(2, 2), "here.png", {}, {}); });
    fs::current_path(before);
    CHECK(check.message == "");
    CHECK(write.message == "");
    CHECK(fs::exists(folder / "here.png"));
}

TEST_CASE("what cannot be written is refused beforehand", "[image_io]") {
    const TempFolder folder;
    fs::create_directory(folder / "folder.png");
    write_file(folder / "file", "x");
    const auto [name, bits, part] = GENERATE(table<const char*, int, const char*>({
        {"a", 8, "no extension"},
        {"a.", 8, "no extension"},
        {".png", 8, "no extension"},
        {"a.nonsense", 8, "format cannot be written"},
        {"folder.png", 8, "is a folder"},
        {"nowhere/a.png", 8, "there is no folder"},
        {"file/a.png", 8, "is not a folder"},
        {"a.jpg", 16, "no 16 bits"},
        {"a.bmp", 16, "no 16 bits"},
        {"a.hdr", 8, "no 8 bits"},
        {"a.png", 12, "12 bits"},
    }));
    const std::string path = folder / name;
    const Display display{View::radiance, 0, bits};
    const Outcome outcome = outcome_of([&, path = path] { check_writable(path, display); });
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.message, path));
    CHECK(contains(outcome.message, part));
    CHECK(contains(outcome.message, "\n  "));  // what to try
    CHECK(folder.count() == 2);
}

TEST_CASE("a folder that vanishes fails the run", "[image_io]") {
    const TempFolder folder;
    const std::string path = folder / GENERATE("gone/a.png", "gone/a.exr");
    const Outcome outcome = outcome_of([&] { write_image(make_film(2, 2), path, {}, {}); });
    CHECK(outcome.exit_code == 1);
    CHECK(contains(outcome.message, "gone"));
    CHECK(folder.count() == 0);
}

TEST_CASE("a full disk leaves the old picture and nothing else", "[image_io]") {
    const TempFolder folder;
    const std::string path = folder / GENERATE("a.exr", "a.png", "a.jpg", "a.tif", "a.bmp");
    const int size = GENERATE(2, 200);  // less and more than a stream's buffer
    write_file(path, "old");
    Outcome write, check;
    {
        const FullDisk disk(16);
        write = outcome_of([&] { write_image(make_film(size, size), path, {}, {}); });
        check = outcome_of([&] { check_writable(path, {}); });
    }
    CHECK(write.exit_code == 1);
    CHECK(check.exit_code == 2);
    CHECK(contains(write.message, path));
    CHECK(read_file(path) == "old");
    CHECK(folder.count() == 1);
}

TEST_CASE("a target that became a folder is left alone", "[image_io]") {
    const TempFolder folder;
    fs::create_directories(folder / "a.png/full");
    CHECK(outcome_of([&] { write_image(make_film(2, 2), folder / "a.png", {}, {}); }).exit_code == 1);
    CHECK(fs::exists(folder / "a.png/full"));
    CHECK(folder.count() == 1);
}

TEST_CASE("a film without the view fails and leaves nothing", "[image_io]") {
    const TempFolder folder;
    const Film film = make_film(2, 2, {true, false, false, false});
    CHECK(outcome_of([&] { write_image(film, folder / "a.png", {View::id, 0, 8}, {}); }).exit_code == 1);
    CHECK(folder.count() == 0);
}
