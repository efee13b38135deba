// Display pictures: the sRGB curve against published values, its table against the formula, and every view.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <set>
#include <vector>

#include "catch.h"
#include "display.h"
#include "error.h"

using namespace gnomon;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

using Codes = std::vector<uint16_t>;

Codes all_rows(const Film& film, const Display& display) {
    const DisplayImage image(film, display);
    Codes codes(film.pixels() * 3);
    for (int y = 0; y < film.height; ++y) image.row(y, &codes[static_cast<size_t>(y * film.width) * 3]);
    return codes;
}

/// A film of one row with grey radiance.
Film grey_film(const std::vector<float>& values) {
    Film film(static_cast<int>(values.size()), 1, {true, false, false, false});
    for (auto& plane : film.radiance) std::copy(values.begin(), values.end(), plane.begin());
    return film;
}

Film distance_film(const std::vector<float>& values) {
    Film film(static_cast<int>(values.size()), 1, {false, true, false, false});
    std::copy(values.begin(), values.end(), film.distance.begin());
    return film;
}

Film id_film(const std::vector<int32_t>& values) {
    Film film(static_cast<int>(values.size()), 1, {false, false, false, true});
    std::copy(values.begin(), values.end(), film.id.begin());
    return film;
}

/// The red channels.
Codes reds(const Codes& codes) {
    Codes red;
    for (size_t i = 0; i < codes.size(); i += 3) red.push_back(codes[i]);
    return red;
}

uint16_t code_by_formula(double linear, int top) {
    const double clipped = linear > 0 ? std::min(linear, 1.0) : 0;
    return static_cast<uint16_t>(std::floor(srgb_encode(clipped) * top + 0.5));
}

}  // namespace

TEST_CASE("the sRGB curve has its published values", "[display]") {
    CHECK(srgb_encode(0) == 0);
    CHECK(srgb_encode(1) == Approx(1).epsilon(1e-15));
    CHECK(srgb_encode(0.0031308) == Approx(0.040449936).epsilon(1e-9));  // the end of the straight part
    CHECK(srgb_encode(0.0031309) == Approx(0.0404509).epsilon(1e-5));    // and the power's beginning, without a gap
    CHECK(srgb_encode(0.001) == Approx(0.01292).epsilon(1e-12));
    CHECK(srgb_encode(0.18) == Approx(0.46135612950044164).epsilon(1e-12));
    CHECK(srgb_encode(0.5) == Approx(0.735356983052449).epsilon(1e-12));
    for (const double code : {0.0, 0.01, 0.04, 0.05, 0.2, 0.7, 1.0})
        CHECK(srgb_encode(srgb_decode(code)) == Approx(code));
}

TEST_CASE("quantising by table agrees with the formula", "[display]") {
    const int bits = GENERATE(8, 16);
    const int top = (1 << bits) - 1;
    const SrgbQuantiser quantise(bits);
    size_t wrong = 0;
    const auto compare = [&](float linear) { wrong += quantise(linear) != code_by_formula(linear, top); };
    for (int i = 0; i <= 1000000; ++i) compare(static_cast<float>(i) / 1000000);
    for (float tiny = 1; tiny > 1e-40f; tiny *= 0.99f) compare(tiny);
    CHECK(wrong == 0);

    // Each code's lower edge: the floats beside it belong to it and to the code below.
    for (int code = 1; code <= top; ++code) {
        const double edge = srgb_decode((code - 0.5) / top);
        wrong += quantise(static_cast<float>(edge * (1 + 1e-6))) != code;
        wrong += quantise(static_cast<float>(edge * (1 - 1e-6))) != code - 1;
    }
    CHECK(wrong == 0);
}

TEST_CASE("what no code can show is clipped", "[display]") {
    const int bits = GENERATE(8, 16);
    const int top = (1 << bits) - 1;
    const SrgbQuantiser quantise(bits);
    CHECK(quantise(-1) == 0);
    CHECK(quantise(-inf) == 0);
    CHECK(quantise(not_a_number) == 0);
    CHECK(quantise(std::numeric_limits<float>::denorm_min()) == 0);
    CHECK(quantise(std::nextafter(1.0f, 0.0f)) == top);
    CHECK(quantise(1) == top);
    CHECK(quantise(1.5f) == top);
    CHECK(quantise(inf) == top);
}

TEST_CASE("radiance is encoded at 8 and at 16 bits", "[display]") {
    const Film film = grey_film({0, 0.18f, 0.5f, 1, 7});
    CHECK(reds(all_rows(film, {View::radiance, 0, 8})) == Codes{0, 118, 188, 255, 255});
    CHECK(reds(all_rows(film, {View::radiance, 0, 16})) == Codes{0, 30235, 48192, 65535, 65535});
}

TEST_CASE("exposure doubles and halves radiance", "[display]") {
    const Film film = grey_film({0, 0.25f, 0.36f, 0.5f});
    CHECK(reds(all_rows(film, {View::radiance, 1, 8})) == Codes{0, 188, 221, 255});
    CHECK(reds(all_rows(film, {View::radiance, -1, 8})) == Codes{0, 99, 118, 137});
    CHECK(reds(all_rows(film, {View::radiance, 0.5, 8}))[1] == code_by_formula(0.25 * std::sqrt(2.0), 255));
    CHECK(reds(all_rows(film, {View::radiance, 500, 8})) == Codes{0, 255, 255, 255});
}

TEST_CASE("channels and rows keep their places", "[display]") {
    Film film(2, 3, {true, false, false, false});
    for (size_t c = 0; c < 3; ++c)
        for (size_t i = 0; i < film.pixels(); ++i) film.radiance[c][i] = static_cast<float>(i * 3 + c) / 18;
    const Codes codes = all_rows(film, {View::radiance, 0, 16});
    for (size_t i = 0; i < codes.size(); ++i) CHECK(codes[i] == code_by_formula(static_cast<float>(i) / 18, 65535));
}

TEST_CASE("distance goes from white to a visible grey", "[display]") {
    const Codes codes = all_rows(distance_film({2, inf, 3, 4}), {View::distance, 0, 8});
    CHECK(codes[0] == 255);
    CHECK(codes[3] == 0);
    CHECK(codes[6] == code_by_formula(0.525, 255));  // half-way between 1 and 0.05
    CHECK(codes[9] == 63);
    for (size_t i = 0; i < codes.size(); i += 3) CHECK((codes[i] == codes[i + 1] && codes[i] == codes[i + 2]));
}

TEST_CASE("distances without a range still make a picture", "[display]") {
    CHECK(reds(all_rows(distance_film({5, inf, 5}), {View::distance, 0, 8})) == Codes{255, 0, 255});
    CHECK(reds(all_rows(distance_film({inf, inf}), {View::distance, 0, 8})) == Codes{0, 0});
    CHECK(reds(all_rows(distance_film({not_a_number, 1, 3e38f}), {View::distance, 0, 8})) == Codes{0, 255, 63});
}

TEST_CASE("exposure is for radiance alone", "[display]") {
    const Film film = distance_film({1, 2, 3});
    CHECK(all_rows(film, {View::distance, -3, 8}) == all_rows(film, {View::distance, 0, 8}));
}

TEST_CASE("normals are moved into the colour cube", "[display]") {
    Film film(4, 1, {false, false, true, false});
    const float normals[4][3] = {{0, 0, 1}, {-1, 0, 0}, {0.6f, -0.8f, 0}, {inf, inf, inf}};
    for (size_t i = 0; i < 4; ++i)
        for (size_t c = 0; c < 3; ++c) film.normal[c][i] = normals[i][c];
    const Codes expected{188, 188, 255, 0, 188, 188, code_by_formula(0.8, 255), code_by_formula(0.1, 255),
                         188, 0,   0,   0};
    CHECK(all_rows(film, {View::normal, 0, 8}) == expected);
}

TEST_CASE("an id has one colour wherever it is seen", "[display]") {
    const Codes here = all_rows(id_film({7, -1, 7, 123456789}), {View::id, 0, 8});
    const Codes there = all_rows(id_film({123456789, 7}), {View::id, 0, 8});
    for (size_t c = 0; c < 3; ++c) {
        CHECK(here[c] == here[6 + c]);
        CHECK(here[c] == there[3 + c]);
        CHECK(here[9 + c] == there[c]);
        CHECK(here[3 + c] == 0);  // the miss
    }
}

TEST_CASE("ids are told apart", "[display]") {
    std::vector<int32_t> ids;
    for (int32_t id = 0; id < 3000; ++id) ids.push_back(id);
    ids.push_back(std::numeric_limits<int32_t>::max());
    const Codes codes = all_rows(id_film(ids), {View::id, 0, 8});
    int darkest = 255, closest = 255;
    std::set<Codes> first_thousand;
    for (size_t i = 0; i < codes.size(); i += 3) {
        darkest = std::min<int>(darkest, std::max({codes[i], codes[i + 1], codes[i + 2]}));
        if (i < 3000) first_thousand.insert({codes[i], codes[i + 1], codes[i + 2]});
        int difference = 0;
        for (size_t c = i; c < i + 3 && i + 3 < codes.size(); ++c)
            difference = std::max(difference, std::abs(codes[c] - codes[c + 3]));
        if (i + 3 < codes.size()) closest = std::min(closest, difference);
    }
    CHECK(darkest > 100);  // never black
    CHECK(closest > 60);   // ids that follow each other
    CHECK(first_thousand.size() > 950);
}

TEST_CASE("a view that was not rendered is refused", "[display]") {
    const Film film = grey_film({1});
    for (const View view : {View::distance, View::normal, View::id})
        CHECK_THROWS_AS(DisplayImage(film, {view, 0, 8}), Error);
    CHECK_THROWS_AS(DisplayImage(distance_film({1}), {View::radiance, 0, 8}), Error);
}
