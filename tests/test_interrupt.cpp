// Work that is asked to stop, and the program when it is interrupted.
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "catch.h"
#include "crowds.h"
#include "render.h"
#include "run_program.h"
#include "scene_json.h"
#include "scenes.h"
#include "temporary_file.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// So many lights make a picture take as long as is wanted.
Scene lit_by(int lights, int spheres, const ImageSize& image) {
    Scene scene = scene_of(Crowd::strewn, spheres);
    scene.image = image;
    scene.camera = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 60};
    for (int i = 0; i < lights; ++i) scene.lights.push_back(PointLight{{i * 0.1, 40, -90}, {1e3, 1e3, 1e3}});
    return scene;
}

/// Runs the program as a shell would, sends it a signal once a picture is under way, and returns its exit code; -1 when
/// it was ended by a signal.
int interrupt(const std::vector<std::string>& arguments, int signal, const std::string& out, const std::string& err) {
    std::vector<char*> argv{const_cast<char*>(GNOMON_PROGRAM)};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        ::signal(SIGINT, SIG_DFL);  // whoever runs tests in the background may ignore it
        dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
        dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
        execv(GNOMON_PROGRAM, argv.data());
        _exit(127);
    }
    int status = 0;
    while (read_file(out).find("device") == std::string::npos && waitpid(child, &status, WNOHANG) == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));  // it builds kernels, or renders
    kill(child, signal);
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("stop: a picture that is asked to stop does, and the next is whole", "[stop]") {
    for (const DeviceInfo& device : list_devices())
        for (const int spheres : {60, 600})
            for (const Accuracy accuracy : {Accuracy::strict, Accuracy::certified}) {
                INFO(device.name << ", " << spheres << " spheres, " << to_string(accuracy));
                Renderer renderer(device);
                const Scene scene = lit_by(3, spheres, {500, 300});
                RenderOptions options;
                options.accuracy = accuracy;
                Film whole, again;
                renderer.render(scene, options, whole);
                Stop before, during;
                before.ask();
                options.stop = &before;
                CHECK_THROWS_AS(renderer.render(scene, options, again), Stopped);
                options.stop = &during;
                options.longest_launch = 1e-12;  // so that much is to be launched after the first that ends
                options.progress = [&](double) { during.ask(); };
                CHECK_THROWS_AS(renderer.render(scene, options, again), Stopped);
                options = {};
                options.accuracy = accuracy;
                renderer.render(scene, options, again);
                CHECK(same_bits(whole, again));
            }
}

TEST_CASE("stop: temporary files are removed, and no others", "[stop]") {
    const TempFolder folder;
    write_file(folder / "kept.txt", "kept");
    {
        TemporaryFile open(folder / "open.txt"), moved(folder / "moved.txt");
        moved.close();
        moved.move_to_target();
        CHECK(folder.count() == 3);
        remove_temporary_files();
        CHECK(folder.count() == 2);
        CHECK(read_file(folder / "kept.txt") == "kept");
        CHECK(read_file(folder / "moved.txt").empty());
    }
    CHECK(folder.count() == 2);
}

TEST_CASE("stop: a temporary folder is removed with the files in it", "[stop]") {
    const TempFolder folder;
    const std::string inner = folder / "inner";
    std::filesystem::create_directory(inner);
    write_file(inner + "/file", "");
    {
        const Fleeting place(inner), file(inner + "/file");
        remove_temporary_files();
        CHECK(folder.count() == 0);
        std::filesystem::create_directory(inner);
    }
    remove_temporary_files();
    CHECK(folder.count() == 1);
}

TEST_CASE("interrupt: the program exits with 128 + the signal's number and leaves no file", "[stop][cli]") {
    for (const int signal : {SIGINT, SIGTERM}) {
        const TempFolder folder, said;
        const std::string scene = folder / "scene.json", out = said / "out", err = said / "err";
        write_file(scene, to_json(lit_by(1500, 100, {2000, 1500})).dump());  // half a minute at least
        const int code = interrupt({"render", scene, "-o", folder / "picture.png", "-o", folder / "picture.exr",
                                    "--stats", folder / "stats.json"},
                                   signal, out, err);
        INFO(read_file(err));
        CHECK(code == 128 + signal);
        CHECK(contains(read_file(err), "gnomon: interrupted"));
        CHECK(folder.count() == 1);
    }
}
