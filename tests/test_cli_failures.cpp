// The program as a user runs it, when something is wrong: exit code, message, and nothing left behind.
#include <fcntl.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "catch.h"
#include "run_program.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;
namespace fs = std::filesystem;

namespace {

/// A scene that keeps any device busy for long: 4096 x 4096 rays and as many to each lamp, 40000 spheres each.
std::string long_scene() {
    std::string spheres, lights;
    for (int i = 0; i < 40000; ++i)
        spheres += (i ? ",\n" : "\n") + ("{\"center\": [" + std::to_string(i % 200 - 100) + ", ") +
                   std::to_string(i / 200 - 100) + ", 100], \"radius\": 0.6, \"albedo\": [1, 1, 1]}";
    for (int i = 0; i < 64; ++i)
        lights += (i ? "," : "") + std::string(R"({"type": "point", "position": [0, 0, -5], "power": [1, 1, 1]})");
    return R"({"image": {"width": 4096, "height": 4096},
               "camera": {"eye": [0, 0, 0], "at": [0, 0, 1], "up": [0, 1, 0], "fov": 90},
               "spheres": [)" +
           spheres + "], \"lights\": [" + lights + "]}";
}

/// Starts the program with its standard output in a file.
pid_t start(const std::vector<std::string>& arguments, const std::string& out) {
    const pid_t child = fork();
    if (child != 0) return child;
    const int file = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    std::vector<char*> argv;
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    execv(GNOMON_PROGRAM, argv.data());
    _exit(127);
}

}  // namespace

TEST_CASE("a wrong command line exits with 2 and says what is wrong", "[cli]") {
    check_refused(run_program(""), "subcommand");
    check_refused(run_program("paint"), "paint");
    check_refused(run_program("--fast"), "--fast");
    check_refused(run_program("render"), "SCENE");
    check_refused(run_program("render " + example_path("point.json") + " --fast"), "--fast");
    check_refused(render_small("--view colour"), "colour");
    check_refused(render_small("--accuracy precise"), "expected fast, strict, certified or double");
    check_refused(render_small("--bits 12"), "12");
    check_refused(render_small("--lanes 3"), "--lanes");
    check_refused(render_small("--lanes many"), "many");
    check_refused(render_small("--tile 63"), "--tile");
    check_refused(render_small("--tile -64"), "--tile");
    for (const char* size : {"0x5", "40", "40x", "ax4", "-4x4"})
        check_refused(run_program("render " + example_path("point.json") + " --size=" + size), size);
}

TEST_CASE("a scene that is missing or broken exits with 2, file and path", "[cli]") {
    const TempFolder folder;
    const std::string path = folder / "scene.json";
    check_refused(run_program("render " + quoted(path)), path);
    write_file(path, "{\"image\": ");
    check_refused(run_program("render " + quoted(path)), path);
    write_file(path, R"({"image": {"width": 4, "height": 4},
        "camera": {"eye": [0, 0, 0], "at": [0, 0, 1], "up": [0, 1, 0], "fov": 60},
        "spheres": [{"center": [0, 0, 5], "radius": -1, "albedo": [1, 1, 1]}], "lights": []})");
    const Ran ran = run_program("render " + quoted(path));
    check_refused(ran, path + ": /spheres/0/radius: found -1");
    CHECK(ran.out.empty());
}

TEST_CASE("a device that there is not exits with 2 and the list", "[cli]") {
    const Ran ran = render_small("--device no_such_thing");
    check_refused(ran, "no_such_thing");
    for (const DeviceInfo& device : list_devices()) CHECK(contains(ran.err, device.number() + "  "));
    for (const DeviceInfo& device : list_devices()) CHECK(contains(ran.err, device.name));
}

TEST_CASE("an output that cannot be written exits with 2 before any rendering", "[cli]") {
    const TempFolder folder;
    const std::string missing = folder / "missing/a.png", directory = folder / "folder.png";
    fs::create_directory(directory);
    for (const std::string& path : {missing, directory, folder / "a.nonsense", folder / "a"}) {
        const Ran ran = render_small("-o " + quoted(path));
        check_refused(ran, path);
        CHECK(ran.out.empty());  // not even the device
    }
    check_refused(render_small("-o " + quoted(folder / "good.png") + " -o " + quoted(missing)), missing);
    CHECK(folder.count() == 1);  // the directory
    CHECK(fs::is_empty(directory));
}

TEST_CASE("without kernels exits with 1 and names the folder", "[cli]") {
    const TempFolder folder;
    const Ran ran = render_small("", "GNOMON_CL_DIR=" + quoted(folder / "missing"));
    CHECK(ran.code == 1);
    CHECK(contains(ran.err, folder / "missing"));
    CHECK(contains(ran.err, "GNOMON_CL_DIR"));
}

TEST_CASE("a broken kernel exits with 1 and the build log, file and line", "[cli]") {
    const TempFolder folder;
    fs::copy(std::string(GNOMON_SOURCE_DIR) + "/cl", folder / "cl");
    write_file(folder / "cl/intersect_closest.cl", "#include \"sphere.h\"\n\nthis is no kernel;\n");
    const Ran ran = render_small("-o " + quoted(folder / "a.png"), "GNOMON_CL_DIR=" + quoted(folder / "cl"));
    CHECK(ran.code == 1);
    CHECK(contains(ran.err, "cannot build kernel intersect_closest"));
    CHECK(contains(ran.err, "cl/intersect_closest.cl:3"));
    CHECK_FALSE(fs::exists(folder / "a.png"));
}

TEST_CASE("without an OpenCL platform exits with 1 and names a package", "[cli]") {
    for (const std::string& command : {std::string("devices"), "render " + example_path("point.json")}) {
        const Ran ran = run_program(command, "OCL_ICD_VENDORS=/nonexistent");
        CHECK(ran.code == 1);
        CHECK(contains(ran.err, "pocl-opencl-icd"));
        CHECK(ran.out.empty());
    }
}

TEST_CASE("a disk that fills up exits with 1 and leaves no part of a picture", "[cli]") {
    const TempFolder folder;
    const std::string arguments = "render " + example_path("directional.json") + " --size 1600x1200 -o ";
    REQUIRE(run_program(arguments + quoted(folder / "whole.exr")).code == 0);  // builds the kernels
    // Files may have 8000 blocks of 512 bytes (POSIX ulimit -f; 1024 in some shells), which is enough for a compiler
    // and for the trial before rendering. More fails, since the signal is ignored.
    REQUIRE(fs::file_size(folder / "whole.exr") > 8000 * 1024);
    const Ran ran = run_program(arguments + quoted(folder / "a.exr"), "", "trap '' XFSZ; ulimit -f 8000; ");
    INFO(ran.err);
    CHECK(ran.code == 1);
    CHECK(contains(ran.out, "device"));
    CHECK(contains(ran.err, folder / "a.exr"));
    CHECK(folder.count() == 1);
}

TEST_CASE("kill -9 in the middle of a render leaves no picture", "[cli]") {
    const TempFolder folder;
    const std::string scene = folder / "long.json", out = folder / "out", picture = folder / "a.png";
    write_file(scene, long_scene());
    const pid_t child = start({"gnomon", "render", scene, "-o", picture}, out);
    REQUIRE(child > 0);
    const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(50)); };
    for (int i = 0; i < 1200 && !contains(read_file(out), "device"); ++i) wait();
    for (int i = 0; i < 10; ++i) wait();  // into the render
    kill(child, SIGKILL);
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    INFO(read_file(out));
    CHECK((WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL));  // it was still at work
    CHECK(contains(read_file(out), "device"));
    CHECK_FALSE(fs::exists(picture));
    CHECK(folder.count() == 2);  // scene and output
}
