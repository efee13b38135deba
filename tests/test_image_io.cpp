// Image files, read back through OpenImageIO: every channel bit for bit, headers, and what failures leave behind.
#include <OpenImageIO/imageio.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "catch.h"
#include "error.h"
#include "image_io.h"

using namespace gnomon;
using OIIO::TypeDesc;
namespace fs = std::filesystem;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
const Metadata metadata{{"Software", "gnomon test"}, {"gnomon:scene", "0123abcd"}};

/// An empty folder of its own, gone with the object.
struct Folder {
    fs::path path;
    Folder() {
        std::string name = (fs::temp_directory_path() / "gnomon_XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("mkdtemp");
        path = name;
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { fs::remove_all(path); }

    std::string operator/(const std::string& name) const { return (path / name).string(); }
    size_t entries() const {
        return static_cast<size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
    }
};

/// Values with all sorts of bits, a miss every fifth pixel and ids that no float can hold.
Film make_film(int width, int height, const Outputs& outputs = {true, true, true, true}) {
    Film film(width, height, outputs);
    const auto fill = [](Plane<float>& plane, float scale, float miss) {
        for (size_t i = 0; i < plane.size(); ++i)
            plane[i] = i % 5 == 4 ? miss : scale * static_cast<float>(i * 7919 % 1013) / 1013;
    };
    for (size_t c = 0; c < 3; ++c) {
        fill(film.radiance[c], 1.3f + static_cast<float>(c), 0);
        fill(film.normal[c], 0.9f - static_cast<float>(c), inf);
    }
    fill(film.distance, 1e6f, inf);
    for (size_t i = 0; i < film.id.size(); ++i) film.id[i] = i % 5 == 4 ? -1 : 16777217 + static_cast<int32_t>(i);
    return film;
}

std::unique_ptr<OIIO::ImageInput> open_image(const std::string& path) {
    auto image = OIIO::ImageInput::open(path);
    if (!image) throw std::runtime_error(path + ": " + OIIO::geterror());
    return image;
}

/// One channel of an image in the type it has in the file.
template <class T>
std::vector<T> read_channel(const std::string& path, int channel, TypeDesc type) {
    const auto image = open_image(path);
    std::vector<T> values(image->spec().image_pixels());
    if (!image->read_image(0, 0, channel, channel + 1, type, values.data()))
        throw std::runtime_error(image->geterror());
    return values;
}

/// All channels of a display image, side by side.
template <class T>
std::vector<T> read_codes(const std::string& path, TypeDesc type) {
    const auto image = open_image(path);
    std::vector<T> values(image->spec().image_pixels() * static_cast<size_t>(image->spec().nchannels));
    if (!image->read_image(0, 0, 0, image->spec().nchannels, type, values.data()))
        throw std::runtime_error(image->geterror());
    return values;
}

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Whether the file's channel has exactly the plane's bits and the right type.
template <class T>
bool same_channel(const std::string& path, const char* name, TypeDesc type, const Plane<T>& plane) {
    const OIIO::ImageSpec spec = open_image(path)->spec();
    const int index = spec.channelindex(name);
    if (index < 0 || spec.channelformat(index) != type) return false;
    const auto values = read_channel<T>(path, index, type);
    return values.size() == plane.size() && !std::memcmp(values.data(), plane.data(), values.size() * sizeof(T));
}

void check_exr(const std::string& path, const Film& film) {
    CHECK(same_channel(path, "R", TypeDesc::FLOAT, film.radiance[0]));
    CHECK(same_channel(path, "G", TypeDesc::FLOAT, film.radiance[1]));
    CHECK(same_channel(path, "B", TypeDesc::FLOAT, film.radiance[2]));
    CHECK(same_channel(path, "distance.Z", TypeDesc::FLOAT, film.distance));
    CHECK(same_channel(path, "N.X", TypeDesc::FLOAT, film.normal[0]));
    CHECK(same_channel(path, "N.Y", TypeDesc::FLOAT, film.normal[1]));
    CHECK(same_channel(path, "N.Z", TypeDesc::FLOAT, film.normal[2]));
    CHECK(same_channel(path, "id", TypeDesc::UINT32, film.id));
}

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

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

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

TEST_CASE("an EXR holds every plane bit for bit", "[image_io]") {
    const Folder folder;
    const std::string path = folder / "film.exr";
    const auto [width, height] = GENERATE(table<int, int>({{1, 1}, {3, 7}, {1, 5000}, {5000, 1}, {640, 517}}));
    const Film film = make_film(width, height);
    write_image(film, path, {}, metadata);
    const OIIO::ImageSpec spec = open_image(path)->spec();
    CHECK(spec.width == width);
    CHECK(spec.height == height);
    CHECK(spec.nchannels == 8);
    check_exr(path, film);
    CHECK(folder.entries() == 1);
}

TEST_CASE("a miss is inf and 0xFFFFFFFF in an EXR", "[image_io]") {
    const Folder folder;
    const std::string path = folder / "miss.exr";
    write_image(make_film(5, 1), path, {}, {});
    const OIIO::ImageSpec spec = open_image(path)->spec();
    CHECK(read_channel<uint32_t>(path, spec.channelindex("id"), TypeDesc::UINT32)[4] == 0xFFFFFFFF);
    CHECK(read_channel<uint32_t>(path, spec.channelindex("id"), TypeDesc::UINT32)[0] == 16777217);
    for (const char* name : {"distance.Z", "N.X", "N.Y", "N.Z"})
        CHECK(read_channel<float>(path, spec.channelindex(name), TypeDesc::FLOAT)[4] == inf);
}

TEST_CASE("an EXR larger than one chunk is whole", "[image_io]") {
    const Folder folder;
    const std::string path = folder / "large.exr";
    const Film film = make_film(700, 800);  // 18 MB of pixels
    write_image(film, path, {}, {});
    check_exr(path, film);
}

TEST_CASE("an EXR has the channels that the film has", "[image_io]") {
    const Folder folder;
    const std::string path = folder / "part.exr";
    const Film film = make_film(4, 4, {true, false, false, true});
    write_image(film, path, {}, {});
    CHECK(open_image(path)->spec().nchannels == 4);
    CHECK(same_channel(path, "G", TypeDesc::FLOAT, film.radiance[1]));
    CHECK(same_channel(path, "id", TypeDesc::UINT32, film.id));
}

TEST_CASE("metadata and compression are in the header", "[image_io]") {
    const Folder folder;
    const std::string exr = folder / "header.exr", png = folder / "header.png";
    write_image(make_film(2, 2), exr, {}, metadata);
    write_image(make_film(2, 2), png, {}, metadata);
    for (const auto& [name, value] : metadata) CHECK(open_image(exr)->spec().get_string_attribute(name) == value);
    CHECK(open_image(exr)->spec().get_string_attribute("compression") == "zip");
    CHECK(open_image(png)->spec().get_string_attribute("Software") == "gnomon test");
}

TEST_CASE("a file's time is SOURCE_DATE_EPOCH or 1970", "[image_io]") {
    const Folder folder;
    const char* before = std::getenv("SOURCE_DATE_EPOCH");
    const std::string kept = before ? before : "";
    const std::string name = GENERATE("time.exr", "time.tif");
    unsetenv("SOURCE_DATE_EPOCH");
    write_image(make_film(2, 2), folder / name, {}, {});
    CHECK(open_image(folder / name)->spec().get_string_attribute("DateTime") == "1970:01:01 00:00:00");
    setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
    write_image(make_film(2, 2), folder / name, {}, {});
    CHECK(open_image(folder / name)->spec().get_string_attribute("DateTime") == "2023:11:14 22:13:20");
    before ? setenv("SOURCE_DATE_EPOCH", kept.c_str(), 1) : unsetenv("SOURCE_DATE_EPOCH");
}

TEST_CASE("the same film gives the same bytes", "[image_io]") {
    const Folder folder;
    const Film film = make_film(120, 90);
    const auto extensions = {".exr", ".png", ".tif", ".jpg"};
    for (const std::string extension : extensions) write_image(film, folder / ("a" + extension), {}, metadata);
    usleep(1100 * 1000);  // the formats' clocks tick in seconds
    for (const std::string extension : extensions) {
        write_image(film, folder / ("b" + extension), {}, metadata);
        const std::string first = bytes_of(folder / ("a" + extension));
        CHECK_FALSE(first.empty());
        CHECK((first == bytes_of(folder / ("b" + extension))));
    }
}

TEST_CASE("a PNG carries no time", "[image_io]") {
    const Folder folder;
    write_image(make_film(3, 3), folder / "a.png", {}, metadata);
    CHECK(contains(bytes_of(folder / "a.png"), "IDAT"));
    CHECK_FALSE(contains(bytes_of(folder / "a.png"), "tIME"));
}

TEST_CASE("PNG and TIFF values are sRGB at 8 and 16 bits", "[image_io]") {
    const Folder folder;
    const std::string path = folder / GENERATE("srgb.png", "srgb.tif", "SRGB.PNG");
    Film film(3, 2, {true, false, false, false});
    const float linear[] = {0, 0.0031308f, 0.18f, 0.5f, 1, 2.5f};
    for (size_t c = 0; c < 3; ++c)
        for (size_t i = 0; i < 6; ++i) film.radiance[c][i] = linear[(i + c) % 6];

    // By the standard's formula, worked out elsewhere.
    const uint8_t bytes[] = {0, 10, 118, 188, 255, 255};
    const uint16_t words[] = {0, 2651, 30235, 48192, 65535, 65535};
    std::vector<uint8_t> expected_bytes;
    std::vector<uint16_t> expected_words;
    for (size_t i = 0; i < 6; ++i)
        for (size_t c = 0; c < 3; ++c) {
            expected_bytes.push_back(bytes[(i + c) % 6]);
            expected_words.push_back(words[(i + c) % 6]);
        }

    write_image(film, path, {View::radiance, 0, 8}, {});
    CHECK(open_image(path)->spec().format == TypeDesc::UINT8);
    CHECK(open_image(path)->spec().nchannels == 3);
    CHECK(read_codes<uint8_t>(path, TypeDesc::UINT8) == expected_bytes);
    write_image(film, path, {View::radiance, 0, 16}, {});
    CHECK(open_image(path)->spec().format == TypeDesc::UINT16);
    CHECK(read_codes<uint16_t>(path, TypeDesc::UINT16) == expected_words);
}

TEST_CASE("exposure and view reach the file", "[image_io]") {
    const Folder folder;
    const std::string path = folder / "view.png";
    Film film = make_film(1, 1);
    for (auto& plane : film.radiance) plane[0] = 0.25f;
    film.normal[0][0] = film.normal[1][0] = 0, film.normal[2][0] = 1;
    write_image(film, path, {View::radiance, 1, 8}, {});
    CHECK(read_codes<uint8_t>(path, TypeDesc::UINT8) == std::vector<uint8_t>{188, 188, 188});
    write_image(film, path, {View::normal, 1, 8}, {});
    CHECK(read_codes<uint8_t>(path, TypeDesc::UINT8) == std::vector<uint8_t>{188, 188, 255});
    write_image(film, path, {View::distance, 1, 8}, {});
    CHECK(read_codes<uint8_t>(path, TypeDesc::UINT8) == std::vector<uint8_t>{255, 255, 255});
}

TEST_CASE("other formats and odd sizes can be written and read", "[image_io]") {
    const Folder folder;
    const std::string path = folder / GENERATE("a.jpg", "a.tif", "a.png", "a.bmp", "a.tga", "a.ppm");
    const auto [width, height] = GENERATE(table<int, int>({{1, 1}, {3, 7}, {1, 5000}}));
    Film film(width, height, {true, false, false, false});
    for (auto& plane : film.radiance) std::fill(plane.begin(), plane.end(), 0.5f);
    check_writable(path, {});
    write_image(film, path, {}, metadata);
    CHECK(open_image(path)->spec().width == width);
    CHECK(open_image(path)->spec().height == height);
    const std::vector<uint8_t> codes = read_codes<uint8_t>(path, TypeDesc::UINT8);
    CHECK(codes.size() == film.pixels() * 3);
    CHECK(std::count_if(codes.begin(), codes.end(), [](int code) { return std::abs(code - 188) > 2; }) == 0);  // jpeg
    CHECK(folder.entries() == 1);
}

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
    const Folder folder;
    for (const char* name : {"a.exr", "a.png", "a.TIF", "a.jpg", "what?b=c.png", ".a.png"})
        CHECK(outcome_of([&] { check_writable(folder / name, {}); }).message == "");
    CHECK(outcome_of([&] { check_writable(folder / "a.png", {View::id, 0, 16}); }).message == "");
    CHECK(folder.entries() == 0);
    std::ofstream(folder / "old.png") << "old";
    check_writable(folder / "old.png", {});
    CHECK(bytes_of(folder / "old.png") == "old");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a name without a folder is of the current one", "[image_io]") {
    const Folder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path);
    const Outcome check = outcome_of([] { check_writable("here.png", {}); });
    const Outcome write = outcome_of([] { write_image(make_film(2, 2), "here.png", {}, {}); });
    fs::current_path(before);
    CHECK(check.message == "");
    CHECK(write.message == "");
    CHECK(fs::exists(folder / "here.png"));
}

TEST_CASE("what cannot be written is refused beforehand", "[image_io]") {
    const Folder folder;
    fs::create_directory(folder / "folder.png");
    std::ofstream(folder / "file") << "x";
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
    CHECK(folder.entries() == 2);
}

TEST_CASE("a folder that vanishes fails the run", "[image_io]") {
    const Folder folder;
    const std::string path = folder / GENERATE("gone/a.png", "gone/a.exr");
    const Outcome outcome = outcome_of([&] { write_image(make_film(2, 2), path, {}, {}); });
    CHECK(outcome.exit_code == 1);
    CHECK(contains(outcome.message, "gone"));
    CHECK(folder.entries() == 0);
}

TEST_CASE("a full disk leaves the old picture and nothing else", "[image_io]") {
    const Folder folder;
    const std::string path = folder / GENERATE("a.exr", "a.png", "a.jpg", "a.tif", "a.bmp");
    const int size = GENERATE(2, 200);  // less and more than a stream's buffer
    std::ofstream(path) << "old";
    Outcome write, check;
    {
        const FullDisk disk(16);
        write = outcome_of([&] { write_image(make_film(size, size), path, {}, {}); });
        check = outcome_of([&] { check_writable(path, {}); });
    }
    CHECK(write.exit_code == 1);
    CHECK(check.exit_code == 2);
    CHECK(contains(write.message, path));
    CHECK(bytes_of(path) == "old");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a target that became a folder is left alone", "[image_io]") {
    const Folder folder;
    fs::create_directories(folder / "a.png/full");
    CHECK(outcome_of([&] { write_image(make_film(2, 2), folder / "a.png", {}, {}); }).exit_code == 1);
    CHECK(fs::exists(folder / "a.png/full"));
    CHECK(folder.entries() == 1);
}

TEST_CASE("a film without the view fails and leaves nothing", "[image_io]") {
    const Folder folder;
    const Film film = make_film(2, 2, {true, false, false, false});
    CHECK(outcome_of([&] { write_image(film, folder / "a.png", {View::id, 0, 8}, {}); }).exit_code == 1);
    CHECK(folder.entries() == 0);
}
