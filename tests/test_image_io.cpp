// Image files, read back through OpenImageIO: headers, and the values of formats that are looked at.
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "catch.h"
#include "image_files.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

TEST_CASE("metadata and compression are in the header", "[image_io]") {
    const TempFolder folder;
    const std::string exr = folder / "header.exr", png = folder / "header.png";
    write_image(make_film(2, 2), exr, {}, metadata);
    write_image(make_film(2, 2), png, {}, metadata);
    for (const auto& [name, value] : metadata) CHECK(open_image(exr)->spec().get_string_attribute(name) == value);
    CHECK(open_image(exr)->spec().get_string_attribute("compression") == "zip");
    CHECK(open_image(png)->spec().get_string_attribute("Software") == "gnomon test");
}

TEST_CASE("a file's time is SOURCE_DATE_EPOCH or 1970", "[image_io]") {
    const TempFolder folder;
    const char* before = std::getenv("SOURCE_DATE_EPOCH");
    const std::string kept = before ? before : "";
    const std::string name = GENERATE("time.exr", "time.tif");
    unsetenv("SOURCE_DATE_EPOCH");
    write_image(make_film(2, 2), folder / name, {}, {});
    CHECK(open_image(folder / name)->spec().get_string_attribute("DateTime") == "1970:01:01 00:00:00");
    setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
    write_image(make_film(2, 2), folder / name, {}, {});
    CHECK(open_image(folder / name)->spec().get_string_attribute("DateTime") == "2023:11:14 22:13:20");
    before ? setenv("SOURCE_DATE_EPOCH", kept.c_str(), 1) : unsetenv("SOURCE_DATE_EPOCH");
}

TEST_CASE("the same film gives the same bytes", "[image_io]") {
    const TempFolder folder;
    const Film film = make_film(120, 90);
    const auto extensions = {".exr", ".png", ".tif", ".jpg"};
    for (const std::string extension : extensions) write_image(film, folder / ("a" + extension), {}, metadata);
    usleep(1100 * 1000);  // the formats' clocks tick in seconds
    for (const std::string extension : extensions) {
        write_image(film, folder / ("b" + extension), {}, metadata);
        const std::string first = read_file(folder / ("a" + extension));
        CHECK_FALSE(first.empty());
        CHECK((first == read_file(folder / ("b" + extension))));
    }
}

TEST_CASE("a PNG carries no time", "[image_io]") {
    const TempFolder folder;
    write_image(make_film(3, 3), folder / "a.png", {}, metadata);
    CHECK(contains(read_file(folder / "a.png"), "IDAT"));
    CHECK_FALSE(contains(read_file(folder / "a.png"), "tIME"));
}

TEST_CASE("PNG and TIFF values are sRGB at 8 and 16 bits", "[image_io]") {
    const TempFolder folder;
    const std::string path = folder / GENERATE("srgb.png", "srgb.tif", "SRGB.PNG");
    Film film(3, 2, {true, false, false, false});
    const float linear[] = {0, 0.0031308f, 0.18f, 0.5f, 1, 2.5f};
    for (size_t c = 0; c < 3; ++c)
        for (size_t i = 0; i < 6; ++i) film.radiance[c][i] = linear[(i + c) % 6];

    // By the standard's formula, worked out elsewhere.
    const uint8_t bytes[] = {0, 10, 118, 188, 255, 255};
    const uint16_t words[] = {0, 2651, 30235, 48192, 65535, 65535};
    std::vector<uint8_t> expected_bytes;
    std::vector<uint16_t> expected_words;
    for (size_t i = 0; i < 6; ++i)
        for (size_t c = 0; c < 3; ++c) {
            expected_bytes.push_back(bytes[(i + c) % 6]);
            expected_words.push_back(words[(i + c) % 6]);
        }

    write_image(film, path, {View::radiance, 0, 8}, {});
    CHECK(open_image(path)->spec().format == TypeDesc::UINT8);
    CHECK(open_image(path)->spec().nchannels == 3);
    CHECK(read_codes<uint8_t>(path, TypeDesc::UINT8) == expected_bytes);
    write_image(film, path, {View::radiance, 0, 16}, {});
    CHECK(open_image(path)->spec().format == TypeDesc::UINT16);
    CHECK(read_codes<uint16_t>(path, TypeDesc::UINT16) == expected_words);
}

TEST_CASE("exposure and view reach the file", "[image_io]") {
    const TempFolder folder;
    const std::string path = folder / "view.png";
    Film film = make_film(1, 1);
    for (auto& plane : film.radiance) plane[0] = 0.25f;
    film.normal[0][0] = film.normal[1][0] = 0, film.normal[2][0] = 1;
    write_image(film, path, {View::radiance, 1, 8}, {});
    CHECK(read_codes<uint8_t>(path, TypeDesc::UINT8) == std::vector<uint8_t>{188, 188, 188});
    write_image(film, path, {View::normal, 1, 8}, {});
    CHECK(read_codes<uint8_t>(path, TypeDesc::UINT8) == std::vector<uint8_t>{188, 188, 255});
    write_image(film, path, {View::distance, 1, 8}, {});
    CHECK(read_codes<uint8_t>(path, TypeDesc::UINT8) == std::vector<uint8_t>{255, 255, 255});
}

TEST_CASE("other formats and odd sizes can be written and read", "[image_io]") {
    const TempFolder folder;
    const std::string path = folder / GENERATE("a.jpg", "a.tif", "a.png", "a.bmp", "a.tga", "a.ppm");
    const auto [width, height] = GENERATE(table<int, int>({{1, 1}, {3, 7}, {1, 5000}}));
    Film film(width, height, {true, false, false, false});
    for (auto& plane : film.radiance) std::fill(plane.begin(), plane.end(), 0.5f);
    check_writable(path, {});
    write_image(film, path, {}, metadata);
    CHECK(open_image(path)->spec().width == width);
    CHECK(open_image(path)->spec().height == height);
    const std::vector<uint8_t> codes = read_codes<uint8_t>(path, TypeDesc::UINT8);
    CHECK(codes.size() == film.pixels() * 3);
    CHECK(std::count_if(codes.begin(), codes.end(), [](int code) { return std::abs(code - 188) > 2; }) == 0);  // jpeg
    CHECK(folder.count() == 1);
}
