// gnomon diff as a user runs it: exit codes, what is printed, and what is left behind.
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "channels.h"
#include "image_io.h"
#include "image_read.h"
#include "run_program.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// 4x3 pixels: on the left a sphere, on the right none.
Film small_film(const Outputs& outputs = {true, true, true, true}) {
    Film film(4, 3, outputs);
    for (size_t i = 0; i < film.pixels(); ++i) {
        const bool hit = i % 4 < 2;
        for (size_t c = 0; c < float_channels.size(); ++c)
            if (!plane_of(film, c).empty()) plane_of(film, c)[i] = hit ? 0.5f : c < 3 ? 0 : INFINITY;
        if (!film.id.empty()) film.id[i] = hit ? 5 : -1;
    }
    return film;
}

/// Two files of a folder of their own.
struct Pictures {
    TempFolder folder;
    std::string a = folder / "a.exr", b = folder / "b.exr";

    Pictures(const Film& film_a, const Film& film_b) {
        write_image(film_a, a, {}, {});
        write_image(film_b, b, {}, {});
    }
    Ran diff(const std::string& arguments = "") const {
        return run_program("diff " + quoted(a) + " " + quoted(b) + " " + arguments);
    }
    json figures(const std::string& arguments = "") const {
        const std::string path = folder / "figures.json";
        const Ran ran = diff("--json " + quoted(path) + " " + arguments);
        INFO(ran.err);
        REQUIRE(ran.code < 2);
        return json::parse(read_file(path));
    }
};

}  // namespace

TEST_CASE("a picture is the same as itself, and quietly so", "[cli][picture_diff]") {
    const Pictures pictures(small_film(), small_film());
    const Ran ran = pictures.diff();
    CHECK(ran.code == 0);
    CHECK(ran.err.empty());
    CHECK(contains(ran.out, "same: 0 of 12 pixels differ"));
    CHECK(contains(ran.out, "6 of 12 pixels at silhouettes, by the ids of A and B"));
    const Ran quiet = pictures.diff("--quiet");
    CHECK(quiet.code == 0);
    CHECK(quiet.out.empty());
    CHECK(quiet.err.empty());
}

TEST_CASE("what render writes, diff compares", "[cli][picture_diff]") {
    const TempFolder folder;
    const std::string lit = folder / "lit.exr", unshadowed = folder / "unshadowed.exr";
    REQUIRE(render_small("--quiet -o " + quoted(lit)).code == 0);
    REQUIRE(render_small("--quiet --no-shadows -o " + quoted(unshadowed)).code == 0);
    const std::string path = folder / "figures.json";
    const Ran ran = run_program("diff " + quoted(lit) + " " + quoted(unshadowed) + " --json " + quoted(path));
    CHECK(ran.code == 1);
    const json figures = json::parse(read_file(path));
    REQUIRE(figures.at("channels").size() == 7);
    CHECK(figures.at("id").at("different").at("all") == 0);
    for (const json& channel : figures.at("channels")) {
        const std::string name = channel.at("channel");
        INFO(name);
        if (name == "distance.Z" || name[0] == 'N') CHECK(channel.at("all").at("max") == 0);
    }
    CHECK(figures.at("different").at("all") > 0);
}

TEST_CASE("a difference says where, and both values", "[cli][picture_diff]") {
    Film film = small_film();
    film.radiance[1][4] = 0.75f;  // (0, 1): no neighbour with another id
    film.distance[6] = 2;         // (2, 1): a miss
    film.id[6] = 4;
    const Pictures pictures(small_film(), film);
    const Ran ran = pictures.diff();
    CHECK(ran.code == 1);
    CHECK(contains(ran.out, "(0, 1): 0.5, 0.75"));
    CHECK(contains(ran.out, "distance.Z: NaN or infinity against another value in 1 pixels, first (2, 1): inf, 2"));
    CHECK(contains(ran.out, "ids differ in 0 pixels inside and 1 at silhouettes, first (2, 1): 4294967295, 4"));
    CHECK(contains(ran.out, "different: 2 of 12 pixels differ, 1 inside and 1 at silhouettes"));
    CHECK(pictures.diff("--allow 2").code == 0);
    CHECK(pictures.diff("--allow 1").code == 1);
    const json figures = pictures.figures();
    CHECK(figures.at("same") == false);
    const json& green = figures.at("channels").at(1);
    CHECK(green.at("inside").at("worst") == json{{"x", 0}, {"y", 1}, {"a", 0.5}, {"b", 0.75}});
    CHECK(green.at("silhouette").at("worst").is_null());
    const json& distance = figures.at("channels").at(3);
    CHECK(distance.at("silhouette").at("first_nonfinite") == json{{"x", 2}, {"y", 1}, {"a", "inf"}, {"b", 2.0}});
    CHECK(figures.at("id").at("first") == json{{"x", 2}, {"y", 1}, {"a", 4294967295u}, {"b", 4}});
}

TEST_CASE("NaN against a number is different, NaN against NaN is not", "[cli][picture_diff]") {
    Film with_nan = small_film(), with_nan_too = small_film();
    with_nan.radiance[0][0] = with_nan_too.radiance[0][0] = not_a_number;
    CHECK(Pictures(with_nan, with_nan_too).diff().code == 0);
    CHECK(Pictures(with_nan, small_film()).diff("--tolerance 1000").code == 1);
    CHECK(Pictures(small_film(), with_nan).diff("--tolerance 1000").code == 1);
}

TEST_CASE("tolerances are for all results or for one", "[cli][picture_diff]") {
    Film film = small_film();
    film.radiance[0][0] = 0.53125f;  // 1/16 of the largest value
    film.distance[1] = 0.53125f;
    const Pictures pictures(small_film(), film);
    CHECK(pictures.diff("--tolerance 0.0625").code == 0);
    CHECK(pictures.diff("--tolerance 0.06").code == 1);
    CHECK(pictures.diff("--tolerance radiance=0.0625").code == 1);
    CHECK(pictures.diff("--tolerance radiance=0.0625 --tolerance distance=1e-1").code == 0);
    CHECK(pictures.diff("--tolerance radiance=0 --tolerance 1").code == 1);
    CHECK(pictures.figures("--tolerance distance=0.5").at("tolerance").at("distance") == 0.5);
}

TEST_CASE("channels that only one picture has are told, and the others compared", "[cli][picture_diff]") {
    const Pictures pictures(small_film({true, true, false, false}), small_film({true, false, true, false}));
    const Ran ran = pictures.diff("--quiet");
    CHECK(ran.code == 0);
    CHECK(contains(ran.err, "channel \"distance.Z\" of " + pictures.a + " is not compared"));
    CHECK(contains(ran.err, "channel \"N.Y\" of " + pictures.b + " is not compared"));
    CHECK(contains(pictures.diff().out, "no ids, so that silhouettes are not told apart"));
    const json figures = pictures.figures();
    CHECK(figures.at("a").at("only_here") == json{"distance.Z"});
    CHECK(figures.at("b").at("only_here") == json({"N.X", "N.Y", "N.Z"}));
    CHECK(figures.at("channels").size() == 3);
    CHECK_FALSE(figures.contains("id"));
    check_refused_at_once(
        Pictures(small_film({true, false, false, false}), small_film({false, true, false, true})).diff(),
        "no channel in common");
}

TEST_CASE("pictures that cannot be read are trouble, and named", "[cli][picture_diff]") {
    const Pictures pictures(small_film(), small_film());
    const std::string bad = pictures.folder / "bad.exr", whole = read_file(pictures.a);
    const auto diff = [&] { return run_program("diff " + quoted(pictures.a) + " " + quoted(bad)); };
    check_refused_at_once(diff(), bad + ": there is no such file");
    fs::create_directory(bad);
    check_refused_at_once(diff(), bad + ": this is not a file");
    fs::remove(bad);
    for (const size_t size : {size_t{0}, size_t{3}, size_t{100}, whole.size() / 2, whole.size() - 1}) {
        write_file(bad, whole.substr(0, size));
        INFO(size);
        check_refused_at_once(diff(), bad);
    }
    std::string damaged = whole;
    damaged[whole.size() - 9] = static_cast<char>(~damaged[whole.size() - 9]);  // in the compressed pixels
    write_file(bad, damaged);
    check_refused_at_once(diff(), bad);
    write_file(bad, "no picture");
    check_refused_at_once(run_program("diff " + quoted(bad) + " " + quoted(pictures.a)), bad);
}

TEST_CASE("pictures of other sizes and wrong usage are trouble", "[cli][picture_diff]") {
    const Pictures pictures(small_film(), Film(3, 4, {false, false, false, true}));
    check_refused_at_once(pictures.diff(), "differ in size: 4x3 and 3x4");
    check_refused_at_once(run_program("diff " + quoted(pictures.a)), "B");
    for (const char* wrong : {"-1", "x", "nan", "inf", "1e999", "1x", "id=1", "radiance", "radiance=", "=1"})
        check_refused_at_once(pictures.diff("--tolerance=" + std::string(wrong)), "--tolerance");
    check_refused_at_once(pictures.diff("--allow=-1"), "--allow");
    check_refused_at_once(pictures.diff("--fast"), "--fast");
}

TEST_CASE("difference pictures and figures are there whole or not at all", "[cli][picture_diff]") {
    Film film = small_film();
    film.radiance[1][4] = 0.75f;
    const Pictures pictures(small_film(), film);
    const std::string exr = pictures.folder / "diff.exr", png = pictures.folder / "diff.png";
    CHECK(pictures.diff("--quiet -o " + quoted(exr)).code == 1);
    CHECK(pictures.diff("--quiet -o " + quoted(png)).code == 1);
    const Film difference = read_exr(exr).film;
    CHECK(difference.radiance[1][4] == 0.25f);
    CHECK(std::count(difference.radiance[1].begin(), difference.radiance[1].end(), 0.0f) == 11);
    CHECK(std::count(difference.distance.begin(), difference.distance.end(), 0.0f) == 12);  // inf beside inf
    CHECK(read_file(png).substr(1, 3) == "PNG");
    CHECK(pictures.folder.count() == 4);

    check_refused_at_once(pictures.diff("-o " + quoted(pictures.folder / "missing/d.png")), "missing");
    check_refused_at_once(pictures.diff("-o " + quoted(pictures.folder / "d.nonsense")), "d.nonsense");
    check_refused_at_once(pictures.diff("--json " + quoted(pictures.folder / "missing/d.json")), "missing");
    check_refused_at_once(pictures.diff("-o " + quoted(pictures.b)), pictures.b + ": this is one of the pictures");
    check_refused_at_once(pictures.diff("--json " + quoted(pictures.a)), pictures.a + ": this is one of the pictures");
    write_file(pictures.b, "no picture");
    const std::string figures = pictures.folder / "d.json", late = pictures.folder / "d.exr";
    check_refused_at_once(pictures.diff("-o " + quoted(late) + " --json " + quoted(figures)), pictures.b);
    CHECK(pictures.folder.count() == 4);
}

TEST_CASE("a disk that fills up is trouble, and not a difference", "[cli][picture_diff]") {
    const TempFolder folder;
    Film film(1600, 1200, {true, false, false, false});
    uint32_t bits = 1;
    for (auto& plane : film.radiance)  // values that do not compress
        for (float& value : plane) bits = bits * 1664525 + 1013904223, value = static_cast<float>(bits);
    const std::string a = folder / "a.exr", b = folder / "b.exr", out = folder / "d.exr";
    write_image(film, a, {}, {});
    for (float& value : film.radiance[0]) value *= 0.7f;
    for (float& value : film.radiance[1]) value *= 0.3f;
    write_image(film, b, {}, {});
    // Files may have 2000 blocks of 512 or 1024 bytes, which is enough for the trial before.
    const Ran ran =
        run_program("diff " + quoted(a) + " " + quoted(b) + " -o " + quoted(out), "", "trap '' XFSZ; ulimit -f 2000; ");
    check_refused_at_once(ran, out);
    CHECK(folder.count() == 2);
}
