// Work that is asked to stop, and the program when it is interrupted.
#include "catch.h"
#include "crowds.h"
#include "interrupted.h"
#include "render.h"
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
                Scene larger = scene;  // and many tiles too, however late this program hears of the first
                larger.image = {1500, 900};
                CHECK_THROWS_AS(renderer.render(larger, options, again), Stopped);
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

TEST_CASE("interrupt: a picture under way is given up with 128 + the signal's number, and leaves no file",
          "[stop][cli]") {
    // It builds kernels then, or renders.
    const Moment rendering = [](pid_t, const std::string& out) {
        if (!contains(out, "device")) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        return true;
    };
    for (const int signal : {SIGINT, SIGTERM}) {
        const TempFolder folder;
        const std::string scene = folder / "scene.json";
        write_file(scene, to_json(lit_by(1500, 100, {2000, 1500})).dump());  // half a minute at least
        const Interrupted run = interrupt({"render", scene, "-o", folder / "picture.png", "-o", folder / "picture.exr",
                                           "--stats", folder / "stats.json"},
                                          signal, rendering);
        INFO(run.err);
        CHECK(run.code == 128 + signal);
        CHECK(contains(run.err, "gnomon: interrupted"));
        CHECK(folder.count() == 1);
    }
}
