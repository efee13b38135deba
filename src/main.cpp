// The command line: subcommands, and one catch ladder.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <new>

#include "commands.h"
#include "device.h"
#include "error.h"
#include "interrupt.h"

namespace {

int fail(const std::string& message, int code) {
    fmt::print(stderr, "gnomon: {}\n", message);
    return code;
}

}  // namespace

int main(int argc, char** argv) try {
    gnomon::catch_interrupts();
    gnomon::pin_device_threads();
    CLI::App app{"Renders scenes of spheres under directional and point lights with OpenCL kernels.", "gnomon"};
    app.set_version_flag("--version", "gnomon " GNOMON_VERSION);
    app.require_subcommand(0, 1);
    gnomon::RenderCommand render(app);
    gnomon::DevicesCommand devices(app);
    gnomon::DiffCommand diff(app);
    gnomon::ReportCommand report(app);
    gnomon::VerifyCommand verify(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;  // --help and --version are no errors
    }
    if (render.chosen()) return render.run();
    if (devices.chosen()) return devices.run();
    if (diff.chosen()) return diff.run();
    if (report.chosen()) return report.run();
    if (verify.chosen()) return verify.run();
    fmt::print(stderr, "{}", app.help());
    return fail("a subcommand is required: render, devices, diff, report or verify", 2);
} catch (const gnomon::Stopped&) {
    return gnomon::interrupted();
} catch (const gnomon::Error& error) {
    return gnomon::was_interrupted() ? gnomon::interrupted() : fail(error.what(), error.exit_code());
} catch (const std::bad_alloc&) {
    return fail("out of memory; render a smaller --size", 1);
} catch (const std::exception& error) {
    return fail(std::string("internal error: ") + error.what(), 1);
}
