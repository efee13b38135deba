// Scenes as files: the examples, what cannot be read, and which bytes a picture was made from.
#include <unistd.h>

#include <filesystem>
#include <string>

#include "run_program.h"
#include "scenes.h"
#include "sha1.h"

using namespace gnomon;
using namespace gnomon::test;
namespace fs = std::filesystem;

namespace {

const std::string examples = std::string(GNOMON_SOURCE_DIR) + "/examples/";

}  // namespace

TEST_CASE("the examples load", "[scene_io]") {
    const LoadedScene suns = load_scene(examples + "directional.json");
    CHECK(suns.warnings.empty());
    CHECK(suns.scene.image.width == 1024);
    REQUIRE(suns.scene.spheres.size() == 3);
    CHECK(suns.scene.spheres[2].radius == 1650);
    REQUIRE(suns.scene.lights.size() == 3);
    check_vec(std::get<DirectionalLight>(suns.scene.lights[1]).direction_to_light, {-1, 1, 0});
    const LoadedScene lamps = load_scene(examples + "point.json");
    CHECK(lamps.warnings.empty());
    CHECK(lamps.scene.sha1.size() == 40);
    CHECK(lamps.scene.sha1 != suns.scene.sha1);
    REQUIRE(lamps.scene.lights.size() == 4);
    const Rgb power = std::get<PointLight>(lamps.scene.lights[3]).power;
    check_vec({power.r, power.g, power.b}, {1e5, 1e5, 1e5});
}

TEST_CASE("files that cannot be read are refused", "[scene_io]") {
    const TempFolder own;
    const std::string empty = own / "empty.json";
    write_file(empty, "");
    CHECK(contains(refusal(2, [&] { load_scene(empty); }), empty + ": found an empty file"));
    const std::string folder = own.path();
    CHECK(contains(refusal(2, [&] { load_scene(folder); }), folder + ": cannot read the scene file: Is a directory"));
    const std::string missing = own / "missing.json";
    CHECK(contains(refusal(2, [&] { load_scene(missing); }), missing + ": cannot open the scene file: No such file"));
    const std::string below = empty + "/scene.json";
    CHECK(contains(refusal(2, [&] { load_scene(below); }), below + ": cannot open the scene file: Not a directory"));
}

TEST_CASE("a file without the right to read it is refused", "[scene_io]") {
    const TempFolder own;
    const std::string secret = own / "secret.json";
    fs::copy_file(examples + "point.json", secret);
    CHECK(load_scene(secret).scene.lights.size() == 4);
    fs::permissions(secret, fs::perms::none);
    if (geteuid() == 0) return;  // root may read everything
    CHECK(contains(refusal(2, [&] { load_scene(secret); }), "cannot open the scene file: Permission denied"));
}

TEST_CASE("SHA-1 gives the published digests (FIPS 180)", "[scene_io]") {
    CHECK(sha1_hex("") == "da39a3ee5e6b4b0d3255bfef95601890afd80709");
    CHECK(sha1_hex("abc") == "a9993e364706816aba3e25717850c26c9cd0d89d");
    const std::string two_blocks = "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq";
    CHECK(sha1_hex(two_blocks) == "84983e441c3bd26ebaae4aa1f95129e5e54670f1");
    CHECK(sha1_hex(std::string(1000000, 'a')) == "34aa973cd4c4daa4f61eeb2bdbad27316534016f");
}

TEST_CASE("a scene carries the SHA-1 of its file, byte for byte", "[scene_io]") {
    const std::string plain = read_file(examples + "point.json"), with_mark = "\xEF\xBB\xBF" + plain + "\r\n";
    const TempFolder own;
    write_file(own / "marked.json", with_mark);
    CHECK(load_scene(examples + "point.json").scene.sha1 == sha1_hex(plain));
    CHECK(load_scene(own / "marked.json").scene.sha1 == sha1_hex(with_mark));
}
