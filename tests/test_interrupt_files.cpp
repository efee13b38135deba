// The program when it is interrupted while it reads a scene or writes a picture: it ends at once, with the signal's
// exit code, and no file is left that is not whole.
#include <sys/stat.h>

#include <random>

#include "catch.h"
#include "interrupted.h"
#include "scene_json.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

constexpr size_t many = 10'000'000;

/// As NumPy writes an array of rows of four floats, 160 MB of them.
void write_many_spheres(const std::string& path) {
    std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + std::to_string(many) + ", 4), }";
    header.resize(128 - 10 - 1, ' ');  // data begins at a multiple of 64
    std::ofstream file(path, std::ios::binary);
    file << std::string("\x93NUMPY\1\0\x76\0", 10) << header << '\n';
    std::mt19937 random(1);
    std::vector<float> rows(4 * 10'000);
    for (float& value : rows) value = 1 + static_cast<float>(random() % 1000);
    for (size_t i = 0; i < many; i += rows.size() / 4)
        file.write(reinterpret_cast<const char*>(rows.data()),
                   static_cast<std::streamsize>(sizeof(float) * rows.size()));
}

Scene seen_from_afar() {
    Scene scene;
    scene.camera = {{0, 0, -10}, {0, 0, 1}, {0, 1, 0}, 60};
    scene.lights = {DirectionalLight{{0, 1, -1}, {1, 1, 1}}};
    scene.spheres = {{{0, 0, 0}, 3, {1, 1, 1}}};
    return scene;
}

/// Whether a process has a file of that name in its memory.
Moment has_mapped(const std::string& name) {
    return [name](pid_t program, const std::string&) {
        return contains(read_file("/proc/" + std::to_string(program) + "/maps"), name);
    };
}

/// A picture is rendered, and a file of it is not there as a whole.
Moment writes_in(const TempFolder& folder, size_t files_before) {
    return [&folder, files_before](pid_t, const std::string& out) {
        return contains(out, "device") && folder.count() > files_before;
    };
}

void check_ended(const Interrupted& run, int signal) {
    INFO(run.out << run.err);
    CHECK(run.code == 128 + signal);
    CHECK(run.seconds < 1);
    CHECK(contains(run.err, "gnomon: interrupted"));
}

}  // namespace

TEST_CASE("interrupt: while a scene file is read", "[stop][cli]") {
    for (const int signal : {SIGINT, SIGTERM}) {
        const TempFolder folder;
        const std::string scene = folder / "scene.json";
        REQUIRE(mkfifo(scene.c_str(), 0600) == 0);
        int writer = -1;  // a pipe can be opened without waiting once somebody reads it
        const Moment reading = [&](pid_t, const std::string&) {
            writer = open(scene.c_str(), O_WRONLY | O_NONBLOCK);
            return writer >= 0;
        };
        check_ended(interrupt({"render", scene, "-o", folder / "picture.exr"}, signal, reading), signal);
        close(writer);
        CHECK(folder.count() == 1);
    }
}

TEST_CASE("interrupt: while ten million spheres are read", "[stop][cli]") {
    const TempFolder folder;
    write_many_spheres(folder / "grains.npy");
    nlohmann::ordered_json scene = to_json(seen_from_afar());
    scene["spheres"] = {{{"file", "grains.npy"}}};
    write_file(folder / "scene.json", scene.dump());
    for (const int signal : {SIGINT, SIGTERM}) {
        const std::vector<std::string> arguments{"render", folder / "scene.json", "-o", folder / "picture.exr"};
        check_ended(interrupt(arguments, signal, has_mapped("grains.npy")), signal);
        CHECK(folder.count() == 2);
    }
}

TEST_CASE("interrupt: while a picture is written", "[stop][cli]") {
    struct Writing {
        const char *name, *size;  // which takes some tenths of a second to write
        int signal;
    };
    for (const Writing& picture : {Writing{"picture.png", "4000x3000", SIGINT},
                                   {"picture.exr", "1600x1200", SIGTERM},
                                   {"picture.tif", "4000x3000", SIGINT}}) {
        INFO(picture.name);
        const TempFolder folder;
        write_file(folder / "scene.json", to_json(seen_from_afar()).dump());
        const std::vector<std::string> arguments{"render", folder / "scene.json", "-o", folder / picture.name,
                                                 "--size", picture.size};
        check_ended(interrupt(arguments, picture.signal, writes_in(folder, 1)), picture.signal);
        CHECK(folder.count() == 1);
    }
}
