// EXR files, read back through OpenImageIO: every channel bit for bit.
#include <cstring>

#include "catch.h"
#include "image_files.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// Whether the file's channel has exactly the plane's bits and the right type.
template <class T>
bool same_channel(const std::string& path, const char* name, TypeDesc type, const Plane<T>& plane) {
    const OIIO::ImageSpec spec = open_image(path)->spec();
    const int index = spec.channelindex(name);
    if (index < 0 || spec.channelformat(index) != type) return false;
    const auto values = read_channel<T>(path, index, type);
    return values.size() == plane.size() && !std::memcmp(values.data(), plane.data(), values.size() * sizeof(T));
}

void check_exr(const std::string& path, const Film& film) {
    CHECK(same_channel(path, "R", TypeDesc::FLOAT, film.radiance[0]));
    CHECK(same_channel(path, "G", TypeDesc::FLOAT, film.radiance[1]));
    CHECK(same_channel(path, "B", TypeDesc::FLOAT, film.radiance[2]));
    CHECK(same_channel(path, "distance.Z", TypeDesc::FLOAT, film.distance));
    CHECK(same_channel(path, "N.X", TypeDesc::FLOAT, film.normal[0]));
    CHECK(same_channel(path, "N.Y", TypeDesc::FLOAT, film.normal[1]));
    CHECK(same_channel(path, "N.Z", TypeDesc::FLOAT, film.normal[2]));
    CHECK(same_channel(path, "id", TypeDesc::UINT32, film.id));
}

}  // namespace

TEST_CASE("an EXR holds every plane bit for bit", "[image_io]") {
    const TempFolder folder;
    const std::string path = folder / "film.exr";
    const auto [width, height] = GENERATE(table<int, int>({{1, 1}, {3, 7}, {1, 5000}, {5000, 1}, {640, 517}}));
    const Film film = make_film(width, height);
    write_image(film, path, {}, metadata);
    const OIIO::ImageSpec spec = open_image(path)->spec();
    CHECK(spec.width == width);
    CHECK(spec.height == height);
    CHECK(spec.nchannels == 8);
    check_exr(path, film);
    CHECK(folder.count() == 1);
}

TEST_CASE("a miss is inf and 0xFFFFFFFF in an EXR", "[image_io]") {
    const TempFolder folder;
    const std::string path = folder / "miss.exr";
    write_image(make_film(5, 1), path, {}, {});
    const OIIO::ImageSpec spec = open_image(path)->spec();
    CHECK(read_channel<uint32_t>(path, spec.channelindex("id"), TypeDesc::UINT32)[4] == 0xFFFFFFFF);
    CHECK(read_channel<uint32_t>(path, spec.channelindex("id"), TypeDesc::UINT32)[0] == 16777217);
    for (const char* name : {"distance.Z", "N.X", "N.Y", "N.Z"})
        CHECK(read_channel<float>(path, spec.channelindex(name), TypeDesc::FLOAT)[4] == inf);
}

TEST_CASE("an EXR larger than one chunk is whole", "[image_io]") {
    const TempFolder folder;
    const std::string path = folder / "large.exr";
    const Film film = make_film(700, 800);  // 18 MB of pixels
    write_image(film, path, {}, {});
    check_exr(path, film);
}

TEST_CASE("an EXR has the channels that the film has", "[image_io]") {
    const TempFolder folder;
    const std::string path = folder / "part.exr";
    const Film film = make_film(4, 4, {true, false, false, true});
    write_image(film, path, {}, {});
    CHECK(open_image(path)->spec().nchannels == 4);
    CHECK(same_channel(path, "G", TypeDesc::FLOAT, film.radiance[1]));
    CHECK(same_channel(path, "id", TypeDesc::UINT32, film.id));
}
