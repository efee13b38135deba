#include "scene_io.h"

#include <cerrno>
#include <cfloat>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>

#include "error.h"
#include "json_reader.h"
#include "sha1.h"
#include "sphere_entries.h"

namespace gnomon {
namespace {

constexpr int max_side = 65536;
constexpr std::int64_t max_pixels = std::int64_t{1} << 30;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// C's streams, for they alone say through errno what went wrong: a directory opens, and fails when it is read.
std::string read_file(const std::string& path) {
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file) throw Error(Blame::input, std::string("cannot open the scene file: ") + std::strerror(errno), path);
    std::string bytes;
    char block[65536];
    while (const std::size_t count = std::fread(block, 1, sizeof block, file.get())) bytes.append(block, count);
    if (std::ferror(file.get())) {
        throw Error(Blame::input, std::string("cannot read the scene file: ") + std::strerror(errno), path);
    }
    return bytes;
}

void expect_few_pixels(ImageSize size, const std::string& where) {
    const std::int64_t pixels = std::int64_t{size.width} * size.height;
    if (pixels <= max_pixels) return;
    throw Error(Blame::input,
                "found " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                    " pixels, expected at most " + std::to_string(max_pixels) + " in all",
                where);
}

ImageSize read_image(const JsonReader& image) {
    image.expect_object("the image", {"width", "height"});
    const ImageSize size{image["width"].integer(1, max_side), image["height"].integer(1, max_side)};
    expect_few_pixels(size, image.where());
    return size;
}

/// A vector with a direction.
Vec3 read_direction(const JsonReader& vector) {
    const Vec3 value = vector.vec3();
    if (length(value) == 0) vector.refuse("a vector that is not zero");
    return value;
}

/// Whether rounding alone could account for the angle between two vectors.
/// With u = 2^-53: the view is a rounded difference (u), both are divided by their lengths (u each), and every
/// component of the cross product is two rounded products and a rounded difference, 2u of at most 1, sqrt(3) times
/// that as a vector. Together 6.5u, below 4 epsilon = 8u; common factors, as from the lengths, do not turn a vector.
bool are_parallel(Vec3 a, Vec3 b) { return length(cross(normalize(a), normalize(b))) <= 4 * DBL_EPSILON; }

Camera read_camera(const JsonReader& camera) {
    camera.expect_object("the camera", {"eye", "at", "up", "fov"});
    const Camera result{camera["eye"].vec3(), camera["at"].vec3(), read_direction(camera["up"]),
                        camera["fov"].number()};
    const Vec3 view = result.at - result.eye;
    if (length(view) == 0) camera["at"].refuse("another point than the eye");
    if (are_parallel(view, result.up)) camera["up"].refuse("a vector that is not parallel to the view, at - eye");
    if (result.fov <= 0 || result.fov >= 180) camera["fov"].refuse("degrees > 0 and < 180");
    return result;
}

Light read_directional(const JsonReader& light) {
    light.expect_object("a directional light", {"type", "direction_to_light", "irradiance"});
    return DirectionalLight{read_direction(light["direction_to_light"]), light["irradiance"].rgb()};
}

Light read_point(const JsonReader& light) {
    light.expect_object("a point light", {"type", "position", "power"});
    return PointLight{light["position"].vec3(), light["power"].rgb()};
}

/// The type decides which keys are right, and so is read before the others are looked at.
Light read_light(const JsonReader& light) {
    if (!light.has("type")) light.refuse("a light: an object with the key \"type\"");
    const std::string type = light["type"].text();
    if (type == "directional") return read_directional(light);
    if (type == "point") return read_point(light);
    light["type"].refuse("\"directional\" or \"point\"");
}

template <class Item>
std::vector<Item> read_list(const JsonReader& list, Item (*read)(const JsonReader&)) {
    std::vector<Item> items;
    const std::size_t size = list.array_size();
    items.reserve(size);
    for (std::size_t i = 0; i < size; ++i) items.push_back(read(list[i]));
    return items;
}

LoadedScene read_scene(const JsonReader& root, const std::string& folder) {
    root.expect_object("a scene", {"image", "camera", "spheres", "lights"}, {"$schema"});
    if (root.has("$schema")) root["$schema"].text();  // for editors; here it only has to be a string
    LoadedScene loaded;
    Scene& scene = loaded.scene;
    scene.image = read_image(root["image"]);
    scene.camera = read_camera(root["camera"]);
    scene.lights = read_list(root["lights"], read_light);
    read_spheres(root["spheres"], folder, loaded);  // last, for files are the longest to read
    return loaded;
}

/// One side of "WxH"; `text` is the whole, for the message.
int parse_side(std::string_view digits, const char* side, const std::string& text) {
    const bool is_number = !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
    if (!is_number) {
        throw Error(Blame::input, "found " + quote(text) + ", expected WIDTHxHEIGHT in pixels, such as 1920x1080",
                    "size");
    }
    int value = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (result.ec != std::errc() || value < 1 || value > max_side) {
        throw Error(Blame::input,
                    "found " + quote(text) + ", expected a " + side + " from 1 to " + std::to_string(max_side), "size");
    }
    return value;
}

}  // namespace

LoadedScene load_scene(const std::string& path) {
    const std::string bytes = read_file(path);
    LoadedScene loaded = parse_scene(bytes, path);
    loaded.scene.sha1 = sha1_hex(bytes);
    return loaded;
}

LoadedScene parse_scene(const std::string& text, const std::string& name) {
    const nlohmann::json document = parse_json(text, name);
    return read_scene({document, name}, std::filesystem::path(name).parent_path().string());
}

ImageSize parse_size(const std::string& text) {
    const std::string_view view = text;
    const std::size_t x = view.find('x');
    const std::string_view height = x == std::string_view::npos ? "" : view.substr(x + 1);
    const ImageSize size{parse_side(view.substr(0, x), "width", text), parse_side(height, "height", text)};
    expect_few_pixels(size, "size");
    return size;
}

}  // namespace gnomon
