// The program as a user runs it, when all goes well.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "run_program.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;
using nlohmann::json;

namespace {

constexpr const char* png_start = "\x89PNG\r\n";       // PNG specification, 5.2
constexpr const char* exr_start = "\x76\x2f\x31\x01";  // OpenEXR File Layout, magic number

bool starts_with(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

/// The options of all kernels, as --stats lists them.
std::string kernel_options(const json& stats) {
    std::string all;
    for (const json& kernel : stats.at("kernels")) all += kernel.at("options").get<std::string>() + "\n";
    return all;
}

}  // namespace

TEST_CASE("version and help print and succeed", "[cli]") {
    const Ran version = run_program("--version");
    CHECK(version.code == 0);
    CHECK(starts_with(version.out, "gnomon "));
    CHECK(version.err.empty());
    const Ran help = run_program("--help");
    CHECK(help.code == 0);
    CHECK(contains(help.out, "render"));
    CHECK(contains(help.out, "devices"));
    CHECK(contains(help.out, "diff"));
    const Ran render_help = run_program("render --help");
    CHECK(render_help.code == 0);
    for (const char* flag : {"--output", "--device", "--size", "--view", "--no-shadows", "--lanes", "--tile",
                             "--exposure", "--bits", "--stats", "--quiet"})
        CHECK(contains(render_help.out, flag));
}

TEST_CASE("the chosen device is printed, and the summary", "[cli]") {
    const DeviceInfo device = choose_device(list_devices(), "");
    const Ran ran = render_small("");
    CHECK(ran.code == 0);
    CHECK(ran.err.empty());
    CHECK(contains(ran.out, device.number() + ": " + device.name));
    CHECK(contains(ran.out, "40x30, 3 spheres, 3 lights"));
}

TEST_CASE("a quiet run prints nothing", "[cli]") {
    const TempFolder folder;
    const Ran ran = render_small("--quiet -o " + quoted(folder / "a.png") + " --stats " + quoted(folder / "a.json"));
    CHECK(ran.code == 0);
    CHECK(ran.out.empty());
    CHECK(ran.err.empty());
    CHECK(folder.count() == 2);
}

TEST_CASE("a compiler that sees the kernels for the first time has nothing to remark", "[cli]") {
    const TempFolder cache;  // an empty one, PoCL's
    const std::string environment = "POCL_CACHE_DIR=" + quoted(cache.path());
    // `certified` builds those of doubles too.
    for (const std::string accuracy : {"strict", "certified"}) {
        const Ran ran = render_small("--quiet --accuracy " + accuracy, environment, "point.json");
        CHECK(ran.code == 0);
        CHECK(ran.err == "");
    }
}

TEST_CASE("GNOMON_DEVICE chooses, --device overrides it", "[cli]") {
    const std::string number = choose_device(list_devices(), "").number();
    const Ran chosen = render_small("", "GNOMON_DEVICE=" + number);
    CHECK(chosen.code == 0);
    CHECK(contains(chosen.out, "device " + number));
    CHECK(render_small("", "GNOMON_DEVICE=no_such_thing").code == 2);
    const Ran overridden = render_small("--device " + number, "GNOMON_DEVICE=no_such_thing");
    CHECK(overridden.code == 0);
    CHECK(contains(overridden.out, "device " + number));
    CHECK(render_small("--device no_such_thing", "GNOMON_DEVICE=" + number).code == 2);
}

TEST_CASE("one run writes several images, and the next run the same bytes", "[cli]") {
    const TempFolder folder;
    const std::string first = folder / "a.exr", second = folder / "b.exr", png = folder / "a.png";
    CHECK(render_small("-o " + quoted(png) + " -o " + quoted(first)).code == 0);
    CHECK(render_small("-o " + quoted(second)).code == 0);
    CHECK(starts_with(read_file(png), png_start));
    CHECK(starts_with(read_file(first), exr_start));
    CHECK(read_file(first) == read_file(second));
    CHECK(folder.count() == 3);
    CHECK(render_small("-o " + quoted(second) + " --no-shadows").code == 0);
    CHECK(read_file(first) != read_file(second));
}

TEST_CASE("views, bits and exposure change a display image", "[cli]") {
    const TempFolder folder;
    const std::string plain = folder / "plain.png", other = folder / "other.png";
    REQUIRE(render_small("-o " + quoted(plain)).code == 0);
    for (const char* flags : {"--view distance", "--view normal", "--view id", "--bits 16", "--exposure -1"}) {
        INFO(flags);
        CHECK(render_small("-o " + quoted(other) + " " + flags).code == 0);
        CHECK(starts_with(read_file(other), png_start));
        CHECK(read_file(plain) != read_file(other));
    }
}

TEST_CASE("lanes and tiles do not change the image", "[cli]") {
    const TempFolder folder;
    const std::string plain = folder / "plain.png", other = folder / "other.png";
    REQUIRE(render_small("-o " + quoted(plain) + " --bits 16").code == 0);
    for (const char* flags : {"--lanes 4", "--lanes 1", "--tile 64"}) {
        INFO(flags);
        CHECK(render_small("-o " + quoted(other) + " --bits 16 --view radiance " + flags).code == 0);
        // The file says how its kernels were built, so its pixels are what is the same: those of the image data (IDAT).
        const std::string a = read_file(plain), b = read_file(other);
        CHECK(a.substr(a.find("IDAT"), a.find("IEND") - a.find("IDAT")) ==
              b.substr(b.find("IDAT"), b.find("IEND") - b.find("IDAT")));
    }
}

TEST_CASE("the stats are JSON that lists the kernels, and only those that the scene needs", "[cli]") {
    const TempFolder folder;
    const std::string path = folder / "stats.json";
    REQUIRE(render_small("--stats " + quoted(path)).code == 0);
    json stats = json::parse(read_file(path));
    CHECK(stats.at("accuracy") == "strict");
    CHECK(stats.at("image").at("width") == 40);
    CHECK(stats.at("scene").at("sha1").get<std::string>().size() == 40);
    CHECK(stats.at("scene").at("spheres") == 3);
    CHECK(stats.at("error").at("wrong_ids") == 0);
    CHECK(stats.at("error").at("flips") == 0);
    CHECK(contains(kernel_options(stats), "LIGHT_DIRECTIONAL"));
    CHECK_FALSE(contains(kernel_options(stats), "SHADOWS_OFF"));
    CHECK_FALSE(contains(read_file(path), "LIGHT_POINT"));
    REQUIRE(render_small("--no-shadows --stats " + quoted(path), "", "point.json").code == 0);
    stats = json::parse(read_file(path));
    CHECK(contains(kernel_options(stats), "LIGHT_POINT"));
    CHECK_FALSE(contains(read_file(path), "LIGHT_DIRECTIONAL"));
    CHECK_FALSE(contains(read_file(path), "intersect_shadow"));
    CHECK(contains(kernel_options(stats), "SHADOWS_OFF"));
    CHECK(folder.count() == 1);
}

TEST_CASE("an accuracy stands in the last line, the stats, the kernels' options and the picture's header", "[cli]") {
    const TempFolder folder;
    const std::string path = folder / "stats.json", image = folder / "a.exr";
    if (!choose_device(list_devices(), "").fp64) return;  // refused: test_accuracy.cpp
    const Ran ran = render_small("--accuracy double --stats " + quoted(path) + " -o " + quoted(image));
    REQUIRE(ran.code == 0);
    CHECK(contains(ran.out, ", double; "));
    const json stats = json::parse(read_file(path));
    CHECK(stats.at("accuracy") == "double");
    CHECK(contains(kernel_options(stats), "REAL_IS_DOUBLE=1"));
    CHECK(contains(read_file(image), "gnomon:accuracy"));
    REQUIRE(render_small("--accuracy fast --stats " + quoted(path)).code == 0);
    CHECK(contains(kernel_options(json::parse(read_file(path))), "FAST=1"));
}

TEST_CASE("devices lists what there is, --json as JSON", "[cli]") {
    const std::vector<DeviceInfo> devices = list_devices();
    const Ran text = run_program("devices"), as_json = run_program("devices --json");
    CHECK(text.code == 0);
    CHECK(as_json.code == 0);
    const json list = json::parse(as_json.out);
    REQUIRE(list.size() == devices.size());
    for (size_t i = 0; i < devices.size(); ++i) {
        CHECK(contains(text.out, devices[i].number() + "  " + to_string(devices[i].type) + "  " + devices[i].name));
        CHECK(list[i].at("number") == devices[i].number());
        CHECK(list[i].at("name") == devices[i].name);
        CHECK(list[i].at("type") == to_string(devices[i].type));
    }
}

TEST_CASE("GNOMON_CL_DIR runs the kernels of a folder", "[cli]") {
    const TempFolder folder;
    std::filesystem::copy(std::string(GNOMON_SOURCE_DIR) + "/cl", folder / "cl");
    const std::string own = folder / "own.exr", built_in = folder / "built_in.exr";
    CHECK(render_small("-o " + quoted(own), "GNOMON_CL_DIR=" + quoted(folder / "cl")).code == 0);
    CHECK(render_small("-o " + quoted(built_in)).code == 0);
    CHECK(read_file(own) == read_file(built_in));
}
