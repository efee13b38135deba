// The key "spheres": spheres one by one, and files of many.
#include "catch.h"
#include "scene_io.h"
#include "scenes.h"
#include "sphere_files.h"

using namespace gnomon;
using namespace gnomon::test;
namespace fs = std::filesystem;

namespace {

std::string scene_with(const std::string& spheres) {
    return R"({"image": {"width": 1, "height": 1}, "lights": [],
               "camera": {"eye": [0, 0, 0], "at": [0, 0, 1], "up": [0, 1, 0], "fov": 60},
               "spheres": )" +
           spheres + "}";
}

/// A sphere whose radius tells it from others.
std::string sphere(const std::string& radius, const std::string& albedo = "[0.5, 0.25, 0]") {
    return R"({"center": [1, 2, 3], "radius": )" + radius + R"(, "albedo": )" + albedo + "}";
}

std::string array_of(const std::vector<float>& rows, size_t columns) {
    return npy(npy_dict("<f4", rows.size() / columns, columns), bytes_of(rows));
}

std::vector<double> radii(const Scene& scene) {
    std::vector<double> result;
    for_each_sphere(scene, [&](int64_t, const Sphere& s) { result.push_back(s.radius); });
    return result;
}

const std::vector<float> two_grains{0, 0, 0, 11, 0, 0, 0, 12};

}  // namespace

TEST_CASE("ids count on from spheres to files and back", "[scene_io][sphere_io]") {
    const TempFolder folder;
    folder.write("grains.npy", array_of(two_grains, 4));
    folder.write("gas.xyz", "1\n\nH 0 0 0\n");
    const std::string text = scene_with(
        "[" + sphere("1") + "," + sphere("2") + R"(, {"file": "grains.npy"}, )" + sphere("3") + "," + sphere("4") +
        R"(, {"file": "gas.xyz", "radius": 5}, {"file": "grains.npy"}, )" + sphere("6", "[0, 0.1, 0.2]") + "]");
    const LoadedScene loaded = load_scene(folder.write("scene.json", text));
    const Scene& scene = loaded.scene;
    CHECK(loaded.warnings.empty());
    CHECK(scene.spheres.size() == 2);
    CHECK(scene.tables.size() == 5);
    CHECK(sphere_count(scene) == 10);
    CHECK(radii(scene) == std::vector<double>{1, 2, 11, 12, 3, 4, 5, 11, 12, 6});
    CHECK(values_of(sphere_of(scene, 9)) == std::vector<double>{1, 2, 3, 6, 0, 0.1, 0.2});
    CHECK(values_of(sphere_of(scene, 6)) == std::vector<double>{0, 0, 0, 5, 1, 1, 1});
}

TEST_CASE("a file that is named twice is one in memory", "[scene_io][sphere_io]") {
    const TempFolder folder;
    folder.write("grains.npy", array_of(two_grains, 4));
    const std::string file = R"({"file": "grains.npy"})", green = R"({"file": "grains.npy", "albedo": [0, 1, 0]})";
    const Scene scene = load_scene(folder.write("scene.json", scene_with("[" + file + "," + green + "]"))).scene;
    REQUIRE(scene.tables.size() == 2);
    CHECK(scene.tables[0].owner == scene.tables[1].owner);
    CHECK(radii(scene) == std::vector<double>{11, 12, 11, 12});
    CHECK(values_of(sphere_of(scene, 0)) == std::vector<double>{0, 0, 0, 11, 1, 1, 1});
    CHECK(values_of(sphere_of(scene, 3)) == std::vector<double>{0, 0, 0, 12, 0, 1, 0});
}

TEST_CASE("an entry alone stands for a list of one", "[scene_io][sphere_io]") {
    const TempFolder folder;
    const auto load = [&](const std::string& spheres) {
        return load_scene(folder.write("scene.json", scene_with(spheres))).scene;
    };
    folder.write("grains.npy", array_of(two_grains, 4));
    const Scene one = load(sphere("7"));
    CHECK(one.spheres.size() == 1);
    CHECK(one.tables.empty());
    CHECK(radii(one) == std::vector<double>{7});
    const Scene file = load(R"({"file": "grains.npy", "radius": 5, "albedo": [0, 0.5, 1]})");
    CHECK(file.spheres.empty());
    CHECK(radii(file) == std::vector<double>{11, 12});
    CHECK(values_of(sphere_of(file, 1)) == std::vector<double>{0, 0, 0, 12, 0, 0.5, 1});
}

TEST_CASE("files are found from the scene file's folder", "[scene_io][sphere_io]") {
    const TempFolder folder;
    const std::string beside = folder.write("scenes/grains.npy", array_of(two_grains, 4));
    folder.write("above.npy", array_of({1, 2, 3, 5}, 4));
    const auto text = [](const std::string& path) { return scene_with(R"([{"file": ")" + path + R"("}])"); };
    const auto load = [&](const std::string& path) {
        return radii(load_scene(folder.write("scenes/scene.json", text(path))).scene);
    };
    CHECK(load("grains.npy") == std::vector<double>{11, 12});
    CHECK(load("../above.npy") == std::vector<double>{5});
    CHECK(load(beside) == std::vector<double>{11, 12});
    const std::string name = folder / "scenes/not_there.json";
    CHECK(radii(parse_scene(text("grains.npy"), name).scene) == std::vector<double>{11, 12});
    const std::string from_here = fs::relative(beside).string();
    CHECK(radii(parse_scene(text(from_here), "s.json").scene) == std::vector<double>{11, 12});
}

TEST_CASE("wrong entries are refused", "[scene_io][sphere_io]") {
    const TempFolder folder;
    folder.write("grains.npy", array_of(two_grains, 4));
    folder.write("points.ply", ply_header("ascii", "float", 0, 3));
    folder.write("bad.npy", array_of({1, 2, 3, -1}, 4));
    const auto check = [&](const std::string& spheres, const std::string& expected) {
        const std::string path = folder.write("scene.json", scene_with(spheres));
        const std::string message = refusal(2, [&] { load_scene(path); });
        INFO(message);
        INFO(expected);
        CHECK(message.rfind(folder / "", 0) == 0);
        CHECK(contains(message, expected));
    };
    const std::string places = "scene.json: /spheres";
    check("7", places + ": found 7, expected an array");
    check("{}", places + ": found no key \"center\"");
    check("[7]", places + "/0: found 7, expected a sphere");
    check("[[]]", places + "/0: found [], expected a sphere");
    check(R"({"file": 7})", places + "/file: found 7, expected a string");
    check(R"([{"file": ""}])", places + "/0/file: found \"\", expected the name of a file");
    check(R"([{"file": "a\u0000.npy"}])", places + "/0/file: found \"a\\u0000.npy\", expected the name of a file");
    check(R"([{"file": "\u001b[2J.npy"}])", places + "/0/file: found \"\\u001b[2J.npy\", expected the name");
    check(R"([{"file": "grains.npy", "color": 1}])", places + "/0: found the unknown key \"color\"");
    check(R"([{"file": "grains.npy", "center": [1, 2, 3]}])", places + "/0: found the unknown key \"center\"");
    check(R"([{"file": "grains.npy", "radius": 0}])", places + "/0/radius: found 0, expected a number > 0");
    check(R"([{"file": "grains.npy", "albedo": [0, -1, 0]}])", places + "/0/albedo/1: found -1");
    check(R"([{"file": "missing.npy"}])", "missing.npy: cannot read the file: No such file or directory");
    check(R"([{"file": "scene.json"}])", "scene.json: found no format for spheres, expected .npy");
    check(R"([{"file": "bad.npy"}])", "bad.npy: row 0: found radius -1, expected a number > 0");
    check(R"([{"file": "points.ply"}])", "points.ply: found no radius: the vertices have none");
    check("[" + sphere("1") + R"(, {"file": "grains.npy"}, )" + sphere("-1") + "]", places + "/2/radius: found -1");
}

TEST_CASE("albedos above 1 in files are warnings too", "[scene_io][sphere_io]") {
    const TempFolder folder;
    folder.write("grains.npy", array_of(two_grains, 4));
    const std::string bright =
        folder.write("bright.npy", array_of({1, 2, 3, 4, 1, 1, 1, 1, 2, 3, 4, 1.5, 1, 0.25, 1, 2, 3, 4, 0, 0, 2}, 7));
    const std::string scene = folder / "scene.json";
    const auto warnings = [&](const std::string& spheres) {
        return load_scene(folder.write("scene.json", scene_with(spheres))).warnings;
    };
    const std::string above = ", above 1: this sphere reflects more light than arrives";
    CHECK(warnings(sphere("1", "[2, 0, 0]")) ==
          std::vector<std::string>{scene + ": /spheres/albedo: found [2,0,0]" + above});
    CHECK(warnings(R"([{"file": "bright.npy"}])") ==
          std::vector<std::string>{bright + ": row 1: found albedo [1.5,1.0,0.25]" + above,
                                   bright + ": row 2: found albedo [0.0,0.0,2.0]" + above});
    CHECK(warnings(R"([{"file": "bright.npy", "albedo": [3, 3, 3]}])").size() == 2);
    CHECK(warnings(R"({"file": "grains.npy", "albedo": [0, 0, 3]})") ==
          std::vector<std::string>{scene + ": /spheres/albedo: found [0,0,3]" + above});
    const std::string file = R"({"file": "bright.npy"})", two = sphere("1", "[2, 0, 0]") + "," + sphere("2");
    const auto many = warnings("[" + two + "," + file + "," + two + "," + file + "," + file + "]");
    REQUIRE(many.size() == 5);
    CHECK(contains(many[2], bright + ": row 2: "));
    CHECK(contains(many[3], scene + ": /spheres/3/albedo: "));
    CHECK(many[4] == scene + ": /spheres: and 4 more");
}
