// EXR files as gnomon diff reads them: its own, bit for bit, and those of other programs.
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "catch.h"
#include "channels.h"
#include "image_io.h"
#include "image_read.h"
#include "run_program.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;
using OIIO::TypeDesc;

namespace {

/// Any EXR: float channels that all hold 1, and others by `types`.
void write_exr(const std::string& path, OIIO::ImageSpec spec, const std::vector<std::string>& names,
               const std::vector<TypeDesc>& types) {
    spec.nchannels = static_cast<int>(names.size());
    spec.channelnames = names;
    spec.channelformats = types;
    size_t pixel_size = 0;
    for (const TypeDesc& type : types) pixel_size += type.size();
    std::vector<unsigned char> pixels(spec.image_pixels() * pixel_size);
    unsigned char* to = pixels.data();
    for (size_t i = 0; i < spec.image_pixels(); ++i)
        for (const TypeDesc& type : types) {
            const float one = 1;
            OIIO::convert_types(TypeDesc::FLOAT, &one, type, to, 1);
            to += type.size();
        }
    const auto out = OIIO::ImageOutput::create("openexr");
    REQUIRE(out->open(path, spec));
    REQUIRE(out->write_image(TypeDesc::UNKNOWN, pixels.data()));
    REQUIRE(out->close());
}

}  // namespace

TEST_CASE("files of other programs: half, tiles, unknown channels", "[cli][picture_diff]") {
    const TempFolder folder;
    const std::string a = folder / "a.exr", b = folder / "b.exr";
    OIIO::ImageSpec spec(100, 70, 1, TypeDesc::FLOAT);
    write_exr(a, spec, {"R", "id", "mask.A"}, {TypeDesc::HALF, TypeDesc::UINT32, TypeDesc::FLOAT});
    spec.tile_width = spec.tile_height = 32;
    write_exr(b, spec, {"R", "id"}, {TypeDesc::FLOAT, TypeDesc::UINT32});
    const Ran ran = run_program("diff " + quoted(a) + " " + quoted(b));
    CHECK(ran.code == 0);
    CHECK(contains(ran.err, "channel \"mask.A\" of " + a + " is not compared: unknown name"));
    CHECK(contains(ran.out, "same: 0 of 7000 pixels differ"));
    const PictureFile tiled = read_exr(b);
    CHECK(std::count(tiled.film.radiance[0].begin(), tiled.film.radiance[0].end(), 1.0f) == 7000);
    write_exr(b, spec, {"R", "id"}, {TypeDesc::FLOAT, TypeDesc::FLOAT});
    check_refused_at_once(run_program("diff " + quoted(a) + " " + quoted(b)), "channel id has type float");
    spec.x = 3;
    write_exr(b, spec, {"R"}, {TypeDesc::FLOAT});
    check_refused_at_once(run_program("diff " + quoted(a) + " " + quoted(b)), "start at different pixels");
}

TEST_CASE("a file of several parts is trouble", "[cli][picture_diff]") {
    const TempFolder folder;
    const std::string path = folder / "parts.exr";
    std::vector<OIIO::ImageSpec> parts(2, OIIO::ImageSpec(4, 3, 1, TypeDesc::FLOAT));
    const std::vector<float> pixels(12, 1.0f);
    const auto out = OIIO::ImageOutput::create("openexr");
    REQUIRE(out->open(path, 2, parts.data()));
    REQUIRE(out->write_image(TypeDesc::FLOAT, pixels.data()));
    REQUIRE(out->open(path, parts[1], OIIO::ImageOutput::AppendSubimage));
    REQUIRE(out->write_image(TypeDesc::FLOAT, pixels.data()));
    REQUIRE(out->close());
    check_refused_at_once(run_program("diff " + quoted(path) + " " + quoted(path)), "several parts");
}

TEST_CASE("a film read is the film written, bit for bit", "[picture_diff][image_io]") {
    const TempFolder folder;
    const int width = GENERATE(1, 7, 900), height = GENERATE(1, 600);  // of the largest, more than is read at once
    Film film(width, height, {true, true, true, true});
    uint32_t bits = 1;  // any bits at all, among them NaN with payloads
    const auto fill = [&bits](auto& plane) {
        for (auto& value : plane) bits = bits * 1664525 + 1013904223, std::memcpy(&value, &bits, sizeof bits);
    };
    for (size_t c = 0; c < float_channels.size(); ++c) fill(plane_of(film, c));
    fill(film.id);
    write_image(film, folder / "a.exr", {}, {});
    const PictureFile read = read_exr(folder / "a.exr");
    REQUIRE(read.film.width == width);
    REQUIRE(read.film.height == height);
    const auto same = [](const auto& a, const auto& b) {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
    };
    for (size_t c = 0; c < float_channels.size(); ++c) CHECK(same(plane_of(film, c), plane_of(read.film, c)));
    CHECK(same(film.id, read.film.id));
}
