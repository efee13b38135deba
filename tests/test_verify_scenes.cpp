// The files of hard scenes that `gnomon verify` carries with it.
#include "catch.h"
#include "run_program.h"
#include "scene_json.h"
#include "scenes.h"
#include "verify/embedded_files.h"
#include "verify_scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// Numbers that went through sin, pow and the like may differ by some ulp of double from library to library, which is
/// why the scenes are files.
constexpr double few_ulp = 0x1p-48;

void check_close(const nlohmann::ordered_json& a, const nlohmann::ordered_json& b) {
    if (a.is_number() && b.is_number()) {
        const double x = a, y = b;
        CHECK(std::fabs(x - y) <= few_ulp * std::max(std::fabs(x), std::fabs(y)));
        return;
    }
    REQUIRE(a.type() == b.type());
    REQUIRE(a.size() == b.size());
    if (a.is_array())
        for (size_t i = 0; i < a.size(); ++i) check_close(a[i], b[i]);
    else if (a.is_object())
        for (const auto& [key, value] : a.items()) check_close(value, b.at(key));
    else
        CHECK(a == b);
}

/// As JSON, a sphere and a light a line.
std::string lines(const Scene& scene) {
    std::string text = to_json(scene).dump();
    for (const std::string before : {"\"camera\"", "\"spheres\"", "\"lights\"", "{\"center\"", "{\"type\""})
        for (size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + before.size() + 1))
            text.insert(at, "\n");
    return text + "\n";
}

}  // namespace

TEST_CASE("verify's hard scenes are those of the tests", "[verify]") {
    const auto& files = embedded_verify_files();
    CHECK(files.size() == std::size(verify_scenes) + 1);  // and the record
    for (const VerifyScene& which : verify_scenes) {
        INFO(which.file);
        const std::string name = std::string(which.file) + ".json";
        REQUIRE(files.count(name) == 1);
        check_close(to_json(parse_scene(files.at(name), name).scene), to_json(scene_of(which)));
    }
}

/// For src/verify/scenes, after a change of verify_scenes.h or of a hard case.
TEST_CASE("write verify's hard scenes", "[.write_verify_scenes]") {
    for (const VerifyScene& which : verify_scenes)
        write_file(std::string(GNOMON_SOURCE_DIR) + "/src/verify/scenes/" + which.file + ".json",
                   lines(scene_of(which)));
}
