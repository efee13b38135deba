// Built kernels on disk: what is kept comes back, what is damaged does not, and pictures are the same either way.
#include <nlohmann/json.hpp>
#include <thread>

#include "binary_cache.h"
#include "catch.h"
#include "error.h"
#include "run_program.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

const std::string key = "device, driver, options, source";
const std::string binary("machine code\0\n\xff", 15);  // with bytes that text would lose

/// Renders with kernels kept in the folder, and gives how many of them came from there. PoCL's own cache is empty, so
/// that all others are compiled, with nothing for the compiler to remark.
int kernels_from(const TempFolder& folder, const std::string& picture, const std::string& cache) {
    const TempFolder pocl;
    const Ran ran = render_small("-o " + (folder / picture) + " --stats " + (folder / "stats.json"),
                                 "GNOMON_CACHE_DIR=" + quoted(cache) + " POCL_CACHE_DIR=" + quoted(pocl.path()));
    CHECK(ran.err.empty());
    REQUIRE(ran.code == 0);
    const auto stats = nlohmann::json::parse(read_file(folder / "stats.json"));
    REQUIRE(stats["kernels"].size() > 0);
    int count = 0;
    for (const auto& kernel : stats["kernels"]) count += kernel["from_cache"].get<bool>();
    return count;
}

}  // namespace

TEST_CASE("what was kept is found, under its own key alone", "[binary_cache]") {
    const TempFolder folder;
    const BinaryCache cache(folder / "new/folder");
    CHECK_FALSE(cache.find(key));
    cache.keep(key, binary);
    CHECK(cache.find(key) == binary);
    CHECK_FALSE(cache.find(key + " "));
    cache.keep(key, "newer");
    CHECK(cache.find(key) == "newer");
}

TEST_CASE("a damaged file is as good as none", "[binary_cache]") {
    const TempFolder folder;
    const BinaryCache cache(folder.path());
    cache.keep(key, binary);
    const std::string path = cache.file_of(key).string(), whole = read_file(path);
    for (size_t at = 0; at < whole.size(); ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 1);
        write_file(path, damaged);
        REQUIRE_FALSE(cache.find(key));
        write_file(path, whole.substr(0, at));
        REQUIRE_FALSE(cache.find(key));
    }
    write_file(path, whole + "more");
    CHECK_FALSE(cache.find(key));
    cache.keep(key, binary);
    CHECK(cache.find(key) == binary);
}

TEST_CASE("a file that belongs to another key is not taken for this one's", "[binary_cache]") {
    const TempFolder folder;
    const BinaryCache cache(folder.path());
    cache.keep("another", binary);
    std::filesystem::rename(cache.file_of("another"), cache.file_of(key));
    CHECK_FALSE(cache.find(key));
}

TEST_CASE("who writes at once leaves one whole file", "[binary_cache]") {
    const TempFolder folder;
    const BinaryCache cache(folder.path());
    std::vector<std::thread> writers;
    for (char name = 'a'; name < 'e'; ++name)
        writers.emplace_back([&cache, name] {
            for (int i = 0; i < 20; ++i) cache.keep(key, std::string(10000, name));
        });
    for (int i = 0; i < 50; ++i)
        if (const auto found = cache.find(key)) CHECK(*found == std::string(10000, found->front()));
    for (std::thread& writer : writers) writer.join();
    REQUIRE(cache.find(key));
    CHECK(folder.count() == 1);
}

TEST_CASE("a folder that cannot be made is an error", "[binary_cache]") {
    const TempFolder folder;
    write_file(folder / "file", "");
    CHECK_THROWS_AS(BinaryCache(folder / "file/folder").keep(key, binary), Error);
}

TEST_CASE("the second run takes the first one's kernels, and draws the same picture", "[binary_cache][cli]") {
    const TempFolder folder, cache;
    CHECK(kernels_from(folder, "first.exr", cache.path()) == 0);
    const size_t kept = cache.count();
    CHECK(kernels_from(folder, "second.exr", cache.path()) > 0);
    CHECK(cache.count() == kept);
    CHECK(run_program("diff " + (folder / "first.exr") + " " + (folder / "second.exr")).code == 0);
}

TEST_CASE("compilers have nothing to remark on kernels of large scenes", "[binary_cache][cli]") {
    for (const std::string accuracy : {"strict", "certified", "double"}) {
        INFO(accuracy);
        const TempFolder folder, pocl;
        const Ran ran = render_small("--quiet --accuracy " + accuracy + " -o " + (folder / "a.exr"),
                                     "GNOMON_CACHE_DIR= POCL_CACHE_DIR=" + quoted(pocl.path()), "sphereflake.json");
        CHECK(ran.code == 0);
        CHECK(ran.err.empty());
    }
}

TEST_CASE("kernels that were damaged on disk are built again", "[binary_cache][cli]") {
    const TempFolder folder, cache;
    kernels_from(folder, "first.exr", cache.path());
    for (const auto& file : std::filesystem::directory_iterator(cache.path()))
        write_file(file.path().string(), read_file(file.path().string()).substr(0, 100));
    CHECK(kernels_from(folder, "second.exr", cache.path()) == 0);
    CHECK(kernels_from(folder, "third.exr", cache.path()) > 0);
}

TEST_CASE("where kernels cannot be kept, a warning says so and the picture comes", "[binary_cache][cli]") {
    const TempFolder folder;
    write_file(folder / "file", "");
    const Ran ran = render_small("-o " + (folder / "a.png"), "GNOMON_CACHE_DIR=" + quoted(folder / "file/folder"));
    CHECK(ran.code == 0);
    CHECK(contains(ran.err, "warning: built kernels are not kept"));
    CHECK(std::filesystem::exists(folder / "a.png"));
}
