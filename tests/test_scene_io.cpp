// Scenes as JSON: what is read, and how what is wrong is refused.
#include <algorithm>
#include <string>
#include <vector>

#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

const std::string good = R"({
  "image": {"width": 320, "height": 200},
  "camera": {"eye": [1, 2, 3], "at": [4, 5, 7], "up": [0, 1, 0.5], "fov": 45.5},
  "spheres": [{"center": [-30, -22.5, 140], "radius": 16.5, "albedo": [0.999, 0.5, 0.25]},
              {"center": [6, 7, 8], "radius": 9, "albedo": [0, 1, 0]}],
  "lights": [{"type": "directional", "direction_to_light": [1, -1, 0], "irradiance": [2, 3, 4]},
             {"type": "point", "position": [-50, 30, 140], "power": [1e5, 0, 7]}]
})";

std::string replaced(std::string text, char from, char to) {
    std::replace(text.begin(), text.end(), from, to);
    return text;
}

/// The good scene with one thing changed; single quotes stand for double ones, to spare the tables their backslashes.
std::string changed(const std::string& from, const std::string& to) {
    std::string text = good;
    const std::string quoted = replaced(from, '\'', '"');
    const std::size_t at = text.find(quoted);
    REQUIRE(at != std::string::npos);
    return text.replace(at, quoted.size(), replaced(to, '\'', '"'));
}

std::string scene_refusal(const std::string& text) {
    return refusal(2, [&] { parse_scene(text, "s.json"); });
}

void check_rgb(Rgb found, Rgb expected) {
    check_vec({found.r, found.g, found.b}, {expected.r, expected.g, expected.b});
}

struct Wrong {
    std::string from, to;                ///< the change that makes the good scene wrong
    std::vector<std::string> fragments;  ///< of the message, its quotes single
};

void check_refused(const std::vector<Wrong>& cases) {
    for (const Wrong& wrong : cases) {
        const std::string message = replaced(scene_refusal(changed(wrong.from, wrong.to)), '"', '\'');
        INFO(wrong.from << " -> " << wrong.to << "\n" << message);
        CHECK(message.rfind("s.json:", 0) == 0);
        CHECK(message.size() < 400);
        for (const std::string& fragment : wrong.fragments) {
            INFO("expected in the message: " << fragment);
            CHECK(contains(message, fragment));
        }
    }
}

std::string spheres_with_albedo(int count, const std::string& albedo) {
    std::string spheres;
    for (int i = 0; i < count; ++i) {
        spheres += R"({"center": [6, 7, 8], "radius": 9, "albedo": )" + albedo + "}, ";
    }
    return changed(R"("spheres": [)", R"("spheres": [)" + spheres);
}

}  // namespace

TEST_CASE("a good scene is read value by value", "[scene_io]") {
    const LoadedScene loaded = parse_scene(good, "s.json");
    const Scene& scene = loaded.scene;
    CHECK(loaded.warnings.empty());
    CHECK(scene.sha1.empty());
    CHECK(scene.image.width == 320);
    CHECK(scene.image.height == 200);
    check_vec(scene.camera.eye, {1, 2, 3});
    check_vec(scene.camera.at, {4, 5, 7});
    check_vec(scene.camera.up, {0, 1, 0.5});
    CHECK(scene.camera.fov == 45.5);
    REQUIRE(scene.spheres.size() == 2);
    check_vec(scene.spheres[0].center, {-30, -22.5, 140});
    CHECK(scene.spheres[0].radius == 16.5);
    check_rgb(scene.spheres[0].albedo, {0.999, 0.5, 0.25});
    check_vec(scene.spheres[1].center, {6, 7, 8});
    REQUIRE(scene.lights.size() == 2);
    const auto& sun = std::get<DirectionalLight>(scene.lights[0]);
    check_vec(sun.direction_to_light, {1, -1, 0});
    check_rgb(sun.irradiance, {2, 3, 4});
    const auto& lamp = std::get<PointLight>(scene.lights[1]);
    check_vec(lamp.position, {-50, 30, 140});
    check_rgb(lamp.power, {1e5, 0, 7});
}

TEST_CASE("what is unusual but right is accepted", "[scene_io]") {
    CHECK(parse_scene("\xEF\xBB\xBF" + good, "s.json").scene.spheres.size() == 2);
    CHECK(parse_scene(changed("{", R"({"$schema": "scene.schema.json",)"), "s.json").scene.lights.size() == 2);
    CHECK(parse_scene(changed("[6, 7, 8]", "[6, 7, 3.4028234e38]"), "s.json").scene.spheres[1].center.z ==
          3.4028234e38);
    CHECK(parse_scene(changed("'width': 320", "'width': 65536"), "s.json").scene.image.width == 65536);
    CHECK(parse_scene(changed("[0, 1, 0.5]", "[3, 3, 4.000001]"), "s.json").scene.camera.up.z == 4.000001);
    const std::string bare = R"({"image": {"width": 1, "height": 1}, "spheres": [], "lights": [],
                                 "camera": {"eye": [0, 0, 0], "at": [0, 0, 1], "up": [0, 1, 0], "fov": 60}})";
    const Scene scene = parse_scene(bare, "s.json").scene;
    CHECK(scene.spheres.empty());
    CHECK(scene.lights.empty());
    CHECK(scene.image.width == 1);
}

TEST_CASE("broken JSON is refused by line and column", "[scene_io]") {
    check_refused({
        {"[6, 7, 8]", "[6, 7, 8", {"s.json:5:44: not valid JSON: ", "unexpected ':'; expected ',' or ']'", "near '"}},
        {"200},", "200}", {"s.json:3:10: not valid JSON: ", "expected ',' or '}'", "near '\\'camera\\'"}},
        {"45.5", "NaN", {"s.json:3:75: not valid JSON: ", "invalid literal"}},
        {"45.5", "-Infinity", {"s.json:3:", "not valid JSON: ", "near '", "-Inf"}},
        {"7]}]\n}", "7]}]\n", {"s.json:8:1: not valid JSON: ", "unexpected end of input", "near the end of the file"}},
        {"7]}]\n}", "7]}]\n} 1", {"s.json:8:3: not valid JSON: ", "expected end of input"}},
        {"'point'", "'po\xFFint'", {"s.json:7:26: not valid JSON: ", "ill-formed UTF-8"}},
        {"'point'", "'" + std::string(5000, 'p') + "\n'", {"s.json:7:", "not valid JSON: ", "control character"}},
        {"45.5", "1e999", {"s.json:3:", ": /camera/fov: found 1e999, expected a finite number"}},
        {"7, 8]", "7, -1e999]", {"s.json:5:", ": /spheres/1/center/2: found -1e999, expected a finite number"}},
    });
    CHECK(contains(scene_refusal(""), "s.json: found an empty file"));
    CHECK(contains(scene_refusal("\xEF\xBB\xBF \n"), "s.json: found an empty file"));
    CHECK(contains(scene_refusal("\"" + std::string(100, 'x')), "s.json:1:102: not valid JSON"));
}

TEST_CASE("wrong keys are refused by name", "[scene_io]") {
    check_refused({
        {"'radius': 9",
         "'raduis': 9",
         {": /spheres/1: found the unknown key 'raduis'", "'center', 'radius', 'albedo'", "did you mean 'radius'?"}},
        {"'fov': 45.5",
         "'fov': 45.5, 'aperture': 1",
         {": /camera: found the unknown key 'aperture'", "'eye', 'at', 'up', 'fov'"}},
        {"{",
         "{'version': 1,",
         {": top level: found the unknown key 'version'", "'image', 'camera', 'spheres', 'lights', '$schema'"}},
        {"'width': 320",
         "'width': 320, '" + std::string(5000, 'k') + "': 1",
         {": /image: found the unknown key 'kkk", "...'"}},
        {"'width': 320", "'width': 320, '\\u001b[31m': 1", {": /image: found the unknown key '\\u001b[31m'"}},
        {", 'radius': 9", "", {": /spheres/1: found no key 'radius'", "'center', 'radius', 'albedo'"}},
        {", 'albedo': [0, 1, 0]", "", {": /spheres/1: found no key 'albedo'"}},
        {", 'fov': 45.5", "", {": /camera: found no key 'fov'"}},
        {"'up': [0, 1, 0.5], ", "", {": /camera: found no key 'up'"}},
        {", 'height': 200", "", {": /image: found no key 'height'"}},
        {"'image': {'width': 320, 'height': 200},", "", {": top level: found no key 'image'"}},
        {", 'power': [1e5, 0, 7]", "", {": /lights/1: found no key 'power'", "a point light"}},
        {"'type': 'point', ", "", {": /lights/1: found an object, expected a light", "'type'"}},
        {"'radius': 9", "'radius': 9, 'radius': 9", {": /spheres/1: found the key 'radius' twice"}},
        {"{", "{'lights': [],", {": top level: found the key 'lights' twice"}},
        {"'lights': [", "'lights': [{'a/b': [{'c': 1, 'c': 2}]},", {": /lights/0/a~1b/0: found the key 'c' twice"}},
        {"'type': 'point'",
         "'type': 'directional'",
         {": /lights/1: found the unknown key 'position'",
          "'direction_to_light', 'irradiance' in a directional light"}},
        {"'power': [1e5, 0, 7]",
         "'power': [1e5, 0, 7], 'irradiance': [1, 1, 1]",
         {": /lights/1: found the unknown key 'irradiance'", "'position', 'power' in a point light"}},
    });
    CHECK_FALSE(contains(scene_refusal(changed("{", "{'version': 1,")), "did you mean"));
}

TEST_CASE("wrong types are refused", "[scene_io]") {
    check_refused({
        {"'radius': 9", "'radius': '9'", {": /spheres/1/radius: found '9', expected a number"}},
        {"'radius': 9", "'radius': null", {": /spheres/1/radius: found null, expected a number"}},
        {"[6, 7, 8]", "[6, 7]", {": /spheres/1/center: found [6,7], expected an array of 3 numbers"}},
        {"[6, 7, 8]", "[1, 2, 3, 4, 5]", {": /spheres/1/center: found an array of 5, expected an array of 3 numbers"}},
        {"[6, 7, 8]", "{'x': 6}", {": /spheres/1/center: found an object, expected an array of 3 numbers"}},
        {"[6, 7, 8]", "[6, true, 8]", {": /spheres/1/center/1: found true, expected a number"}},
        {"'fov': 45.5", "'fov': [45]", {": /camera/fov: found [45], expected a number"}},
        {"{'width': 320, 'height': 200}",
         "[320, 200]",
         {": /image: found [320,200], expected the image", "'width', 'height'"}},
        {"320", "320.0", {": /image/width: found 320.0, expected an integer from 1 to 65536"}},
        {"320", "'320'", {": /image/width: found '320', expected an integer"}},
        {"'type': 'point'", "'type': 1", {": /lights/1/type: found 1, expected a string"}},
        {"'type': 'point'", "'type': 'spot'", {": /lights/1/type: found 'spot', expected 'directional' or 'point'"}},
        {"'type': 'point'",
         "'type': '" + std::string(5000, 's') + "'",
         {": /lights/1/type: found 'sss", "...', expected"}},
        {"'lights': [", "'lights': [7, ", {": /lights/0: found 7, expected a light"}},
        {"'spheres': [", "'spheres': [[], ", {": /spheres/0: found [], expected a sphere"}},
        {"{", "{'$schema': 1,", {": /$schema: found 1, expected a string"}},
    });
    CHECK(contains(scene_refusal("[1, 2]"), "s.json: top level: found [1,2], expected a scene"));
    CHECK(contains(scene_refusal("7"), "s.json: top level: found 7, expected a scene"));
    const std::string no_list = R"({"image": {"width": 1, "height": 1}, "spheres": {}, "lights": {},
                                    "camera": {"eye": [0, 0, 0], "at": [0, 0, 1], "up": [0, 1, 0], "fov": 60}})";
    CHECK(contains(scene_refusal(no_list), "s.json: /lights: found an object, expected an array"));
}

TEST_CASE("wrong values are refused", "[scene_io]") {
    const std::string side = "expected an integer from 1 to 65536";
    check_refused({
        {"'radius': 9", "'radius': -2", {"s.json: /spheres/1/radius: found -2, expected a number > 0"}},
        {"'radius': 9", "'radius': 0", {": /spheres/1/radius: found 0, expected a number > 0"}},
        {"'radius': 9", "'radius': 1e-999", {": /spheres/1/radius: found 0.0, expected a number > 0"}},
        {"[0, 1, 0]", "[0, -0.5, 0]", {": /spheres/1/albedo/1: found -0.5, expected a number >= 0"}},
        {"[2, 3, 4]", "[2, 3, -4]", {": /lights/0/irradiance/2: found -4, expected a number >= 0"}},
        {"[1e5, 0, 7]", "[-1, 0, 7]", {": /lights/1/power/0: found -1, expected a number >= 0"}},
        {"45.5", "0", {": /camera/fov: found 0, expected degrees > 0 and < 180"}},
        {"45.5", "180", {": /camera/fov: found 180, expected degrees > 0 and < 180"}},
        {"45.5", "-45", {": /camera/fov: found -45, expected degrees > 0 and < 180"}},
        {"[4, 5, 7]", "[1, 2, 3]", {": /camera/at: found [1,2,3], expected another point than the eye"}},
        {"[0, 1, 0.5]", "[0, 0, 0]", {": /camera/up: found [0,0,0], expected a vector that is not zero"}},
        {"[0, 1, 0.5]",
         "[3, 3, 4]",
         {": /camera/up: found [3,3,4], expected a vector that is not parallel to the view"}},
        {"[0, 1, 0.5]", "[1, 1, 1.3333333333333333]", {": /camera/up: found [1,1,1.33333", "not parallel"}},
        {"[0, 1, 0.5]", "[-0.3, -0.3, -0.4]", {": /camera/up: found [-0.3,-0.3,-0.4]", "not parallel"}},
        {"[0, 1, 0.5]", "[3e-200, 3e-200, 4e-200]", {": /camera/up: found", "not parallel"}},
        {"[0, 1, 0.5]", "[3e37, 3e37, 4e37]", {": /camera/up: found", "not parallel"}},
        {"[1, -1, 0]", "[0, 0.0, -0]", {": /lights/0/direction_to_light: found", "expected a vector that is not zero"}},
        {"320", "0", {": /image/width: found 0", side}},
        {"320", "-1", {": /image/width: found -1", side}},
        {"200", "65537", {": /image/height: found 65537", side}},
        {"200", "18446744073709551615", {": /image/height: found 18446744073709551615", side}},
        {"200", "4294967297", {": /image/height: found 4294967297", side}},
        {"{'width': 320, 'height': 200}",
         "{'width': 32769, 'height': 32768}",
         {": /image: found 32769 x 32768 pixels, expected at most 1073741824"}},
        {"[6, 7, 8]",
         "[6, 3.5e38, 8]",
         {": /spheres/1/center/1: found 3.5e+38, expected a number from -3.4028234e38 to"}},
        {"'radius': 9", "'radius': 1e39", {": /spheres/1/radius: found 1e+39, expected a number from"}},
        {"[1e5, 0, 7]", "[1e5, 0, -1e300]", {": /lights/1/power/2: found -1e+300, expected a number from"}},
    });
}

TEST_CASE("an albedo above 1 is a warning, in a few lines", "[scene_io]") {
    const auto one = parse_scene(changed("[0, 1, 0]", "[0, 1.5, 2]"), "s.json").warnings;
    REQUIRE(one.size() == 1);
    CHECK(contains(one[0], "s.json: /spheres/1/albedo: found [0,1.5,2], above 1"));
    CHECK(parse_scene(spheres_with_albedo(4, "[1, 1, 1.01]"), "s.json").warnings.size() == 4);
    const auto many = parse_scene(spheres_with_albedo(100, "[2, 0, 0]"), "s.json").warnings;
    REQUIRE(many.size() == 5);
    CHECK(contains(many[3], "s.json: /spheres/3/albedo: "));
    CHECK(many[4] == "s.json: /spheres: and 96 more");
}

TEST_CASE("deep nesting neither crashes nor floods", "[scene_io]") {
    const int depth = 200000;
    const std::string nested = std::string(depth, '[') + std::string(depth, ']');
    CHECK(contains(scene_refusal(changed("[6, 7, 8]", nested)), ": /spheres/1/center: found an array of 1"));
    const std::string deep_overflow = scene_refusal(std::string(depth, '[') + "1e999");
    CHECK(contains(deep_overflow, ": .../0/0/0/0/0/0/0/0: found 1e999, expected a finite number"));
}

TEST_CASE("a size is read as WIDTHxHEIGHT", "[scene_io]") {
    CHECK(parse_size("1920x1080").width == 1920);
    CHECK(parse_size("1920x1080").height == 1080);
    CHECK(parse_size("1x65536").height == 65536);
    CHECK(parse_size("32768x32768").width == 32768);
}

TEST_CASE("a wrong size is refused", "[scene_io]") {
    const auto check = [](const std::string& size, const std::string& expected) {
        const std::string message = refusal(2, [&] { parse_size(size); });
        INFO(message);
        CHECK(contains(message, expected));
        CHECK(message.size() < 200);
    };
    for (const std::string size :
         {"", "x", "1920", "1920x", "x1080", "1e3x5", "-1x5", "+1x5", "12x34x5", "1 x2", "1X2"}) {
        check(size, "size: found \"" + size + "\", expected WIDTHxHEIGHT");
    }
    check("0x5", "size: found \"0x5\", expected a width from 1 to 65536");
    check("5x0", "size: found \"5x0\", expected a height from 1 to 65536");
    check("65537x1", "expected a width from 1 to 65536");
    check("1x99999999999999999999", "expected a height from 1 to 65536");
    check(std::string(5000, '9') + "x1", "expected a width from 1 to 65536");
    check("32769x32768", "size: found 32769 x 32768 pixels, expected at most 1073741824");
}
