// Where silhouettes are, and what differs there.
#include <algorithm>
#include <random>
#include <string>

#include "catch.h"
#include "picture_diff.h"
#include "silhouettes.h"
#include "small_films.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// Whether the pixel has a neighbour with another id, by looking at all of the 3 x 3 around it.
bool silhouette_by_definition(const Film& film, int x, int y) {
    const auto id = [&](int column, int row) { return film.id[static_cast<size_t>(row * film.width + column)]; };
    bool found = false;
    for (int row = std::max(0, y - 1); row <= std::min(film.height - 1, y + 1); ++row)
        for (int column = std::max(0, x - 1); column <= std::min(film.width - 1, x + 1); ++column)
            found = found || id(column, row) != id(x, y);
    return found;
}

}  // namespace

TEST_CASE("silhouettes are where a neighbour has another id", "[picture_diff]") {
    const auto [width, height] = GENERATE(table<int, int>({{1, 1}, {1, 9}, {9, 1}, {2, 2}, {3, 3}, {13, 11}}));
    const int kinds = GENERATE(1, 2, 40);
    std::mt19937 random(static_cast<unsigned>(width * height * kinds));
    std::vector<int32_t> values(static_cast<size_t>(width * height));
    // Mostly alike, so that pixels off all silhouettes are among them.
    for (int32_t& value : values) value = random() % 12 == 0 ? static_cast<int32_t>(random()) % kinds : -1;
    const Film film = ids(width, height, values);
    std::vector<uint8_t> marks(values.size());
    mark_silhouettes(film.id, static_cast<size_t>(width), silhouette_mark, marks);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            CHECK(marks[static_cast<size_t>(y * width + x)] == (silhouette_by_definition(film, x, y) ? 1 : 0));
}

TEST_CASE("a sphere that B lacks is a difference inside, and at its silhouette", "[picture_diff]") {
    std::vector<int32_t> with(49, -1);
    for (size_t y = 1; y < 6; ++y)
        for (size_t x = 1; x < 6; ++x) with[7 * y + x] = 3;
    const PictureDiff diff = diff_pictures(ids(7, 7, with), ids(7, 7, std::vector<int32_t>(49, -1)), {});
    REQUIRE(diff.id);
    CHECK(diff.id->different.inside == 9);  // 3 x 3 whose neighbours are all of the sphere
    CHECK(diff.id->different.silhouette == 16);
    CHECK(diff.pixels.silhouette == 40);  // and the 24 around
    REQUIRE(diff.id->first);
    CHECK(diff.id->first->pixel == 8);
    CHECK(diff.id->first->a == 3);
    CHECK(diff.id->first->b == 0xFFFFFFFF);
}

TEST_CASE("one picture's ids are enough for silhouettes; without any, all is inside", "[picture_diff]") {
    Film a(4, 1, {false, true, false, true});
    const Film b = distances({1, 1, 2, 2});
    for (size_t i = 0; i < 4; ++i) a.distance[i] = 1, a.id[i] = i < 3 ? 0 : 1;
    for (const bool swapped : {false, true}) {
        const PictureDiff diff = swapped ? diff_pictures(b, a, {}) : diff_pictures(a, b, {});
        CHECK(diff.different.inside == 0);
        CHECK(diff.different.silhouette == 2);
        CHECK((swapped ? diff.only_in_b : diff.only_in_a) == std::vector<std::string>{"id"});
        CHECK((swapped ? diff.only_in_a : diff.only_in_b).empty());
        CHECK_FALSE(diff.id);
    }
    const PictureDiff without = diff_pictures(distances({1, 1, 1, 1}), b, {});
    CHECK(without.different.inside == 2);
    CHECK(without.pixels.silhouette == 0);
}
