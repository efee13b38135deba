// Two films in, figures out: each figure against one found by brute force or by hand.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "catch.h"
#include "difference_picture.h"
#include "error.h"
#include "picture_diff.h"
#include "small_films.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// All figures of the distances of one row.
Differences compare(const std::vector<float>& a, const std::vector<float>& b, double tolerance = 0) {
    const PictureDiff diff = diff_pictures(distances(a), distances(b), {0, tolerance, 0});
    REQUIRE(diff.channels.size() == 1);
    CHECK(diff.different.all() == diff.channels[0].diff.all.different());
    return diff.channels[0].diff.all;
}

bool is_silhouette(const PictureDiff& diff, size_t pixel) { return diff.marks[pixel] & silhouette_mark; }

/// The least of the values that so many thousandths of them do not exceed, by counting.
double percentile_by_definition(std::vector<double> values, int64_t permille) {
    std::sort(values.begin(), values.end());
    for (const double value : values) {
        const int64_t count = std::upper_bound(values.begin(), values.end(), value) - values.begin();
        if (1000 * count >= permille * static_cast<int64_t>(values.size())) return value;
    }
    return values.back();
}

/// Figures of one region by brute force, in long double.
void check_by_brute_force(const Film& a, const Film& b, const PictureDiff& diff, const Differences& found,
                          bool (*in_region)(bool at_silhouette), double tolerance) {
    std::vector<double> values;
    long double squares = 0;
    int64_t over = 0, nonfinite = 0;
    for (size_t i = 0; i < a.pixels(); ++i) {
        const float x = a.distance[i], y = b.distance[i];
        if (!in_region(is_silhouette(diff, i))) continue;
        if (std::isfinite(x) && std::isfinite(y)) {
            values.push_back(std::fabs(static_cast<double>(x) - y));
            squares += static_cast<long double>(values.back()) * values.back();
            over += values.back() > tolerance;
        } else {
            nonfinite += !(x == y || (std::isnan(x) && std::isnan(y)));
        }
    }
    REQUIRE(!values.empty());
    CHECK(found.finite == static_cast<int64_t>(values.size()));
    CHECK(found.over == over);
    CHECK(found.nonfinite == nonfinite);
    CHECK(found.max == *std::max_element(values.begin(), values.end()));
    for (size_t i = 0; i < permilles.size(); ++i)
        CHECK(found.percentiles[i] == percentile_by_definition(values, permilles[i]));
    // n positive terms, each a rounded product, added one by one: relative error below (n + 1) u, u = 2^-53; the root
    // halves it, and its rounding, the division's and the reference's add less than 3 u.
    const double n = static_cast<double>(values.size());
    CHECK(found.rms() == Approx(std::sqrt(static_cast<double>(squares / n))).epsilon((n + 7) * 0x1p-53));
    CHECK(found.worst.has_value() == (found.max > 0));
    if (!found.worst) return;
    const auto first = std::find_if(diff.marks.begin(), diff.marks.end(), [&](const uint8_t& mark) {
        const auto i = static_cast<size_t>(&mark - diff.marks.data());
        return in_region(is_silhouette(diff, i)) &&
               std::fabs(static_cast<double>(a.distance[i]) - b.distance[i]) == found.max;
    });
    CHECK(found.worst->pixel == static_cast<size_t>(first - diff.marks.begin()));
}

}  // namespace

TEST_CASE("equal pictures have no difference", "[picture_diff]") {
    const Differences d = compare({1, -2, 3e38f, 0}, {1, -2, 3e38f, 0});
    CHECK(d.finite == 4);
    CHECK(d.different() == 0);
    CHECK(d.max == 0);
    CHECK(d.rms() == 0);
    CHECK_FALSE(d.worst);
    CHECK_FALSE(d.first_nonfinite);
}

TEST_CASE("NaN and infinities are values", "[picture_diff]") {
    CHECK(compare({not_a_number, inf, -inf}, {-not_a_number, inf, -inf}).different() == 0);
    const float values[] = {not_a_number, inf, -inf, 5, 0};
    for (const float a : values)
        for (const float b : values) {
            if (std::isfinite(a) && std::isfinite(b)) continue;
            const bool same = std::isnan(a) ? std::isnan(b) : a == b;
            INFO(a << " against " << b);
            CHECK(compare({1, a}, {1, b}, 1e30).nonfinite == (same ? 0 : 1));  // no tolerance takes that in
        }
}

TEST_CASE("what is not finite does not spoil the figures of what is", "[picture_diff]") {
    const Differences d = compare({1, not_a_number, inf, 4, inf}, {1, 5, -inf, 7, inf});
    CHECK(d.finite == 2);
    CHECK(d.over == 1);
    CHECK(d.nonfinite == 2);
    CHECK(d.max == 3);
    CHECK(d.rms() == std::sqrt(4.5));
    REQUIRE(d.worst);
    CHECK(d.worst->pixel == 3);
    CHECK(d.worst->a == 4);
    CHECK(d.worst->b == 7);
    REQUIRE(d.first_nonfinite);
    CHECK(d.first_nonfinite->pixel == 1);
    CHECK(std::isnan(d.first_nonfinite->a));
    CHECK(d.first_nonfinite->b == 5);
}

TEST_CASE("a diff takes -0 and 0 as equal, and not the least float", "[picture_diff]") {
    const float least = std::numeric_limits<float>::denorm_min();
    CHECK(compare({-0.0f}, {0.0f}).different() == 0);
    const Differences d = compare({0, least}, {least, 2 * least});
    CHECK(d.over == 2);
    CHECK(d.max == 0x1p-149);
    CHECK(d.rms() == 0x1p-149);
}

TEST_CASE("the largest difference of floats is in range", "[picture_diff]") {
    const float most = std::numeric_limits<float>::max();
    const Differences d = compare({most}, {-most});
    CHECK(d.max == 2 * static_cast<double>(most));
    CHECK(d.rms() == d.max);
}

TEST_CASE("a tolerance is relative to the largest finite magnitude in A, and reaches that far", "[picture_diff]") {
    const std::vector<float> a{-8, 1, inf, 2}, b{-8, 1.5f, inf, 2.5625f};
    CHECK(compare(a, b, 0.0625).over == 1);     // 0.5 is not over 0.5
    CHECK(compare(a, b, 0.0624).over == 2);     // it is over 0.4992
    CHECK(compare(a, b, 0.0703125).over == 0);  // 0.5625 / 8
    CHECK(compare(b, a, 0.0624).over == 2);
    CHECK(compare({0, not_a_number}, {1, not_a_number}, 0.5).over == 1);  // of nothing it is nothing
}

TEST_CASE("red, green and blue share a scale, results do not", "[picture_diff]") {
    Film a(1, 1, {true, true, true, false}), b(1, 1, {true, true, true, false});
    const float values[] = {16, 1, 0, 500, 1, 0, 0};
    for (size_t c = 0; c < float_channels.size(); ++c) {
        plane_of(a, c)[0] = values[c];
        plane_of(b, c)[0] = values[c] + 0.25f;
    }
    const PictureDiff diff = diff_pictures(a, b, {0.015625, 0.0001, 0.5});
    const std::vector<double> scales{16, 16, 16, 500, 1, 1, 1};
    const std::vector<int64_t> over{0, 0, 0, 1, 0, 0, 0};
    REQUIRE(diff.channels.size() == scales.size());
    for (size_t c = 0; c < scales.size(); ++c) {
        INFO(float_channels[c].name);
        CHECK(diff.channels[c].scale == scales[c]);
        CHECK(diff.channels[c].diff.all.over == over[c]);
    }
    CHECK(diff.different.all() == 1);
}

TEST_CASE("figures and percentiles are those of a brute sort, inside and at silhouettes", "[picture_diff]") {
    const int width = GENERATE(1, 2, 7, 50), height = GENERATE(3, 20);
    const double share_of_equal = GENERATE(0.0, 0.6, 0.97);
    std::mt19937 random(static_cast<unsigned>(width * 100 + height));
    std::uniform_real_distribution<double> uniform(0, 1);
    Film a(width, height, {false, true, false, true}), b(width, height, {false, true, false, true});
    for (size_t i = 0; i < a.pixels(); ++i) {
        a.id[i] = b.id[i] = i % static_cast<size_t>(width) > static_cast<size_t>(width / 3) ? 1 : 0;
        a.distance[i] = static_cast<float>(100 * uniform(random));
        // Few different values, so that there are ties.
        const double step = uniform(random) < share_of_equal ? 0 : std::floor(8 * uniform(random)) / 8;
        b.distance[i] = a.distance[i] + static_cast<float>(step);
        if (i > 0 && uniform(random) < 0.05) a.distance[i] = inf;
        if (i > 0 && uniform(random) < 0.05) b.distance[i] = uniform(random) < 0.5 ? inf : not_a_number;
    }
    const PictureDiff diff = diff_pictures(a, b, {0, 0.002, 0});
    const ComparedChannel& channel = diff.channels.at(0);
    check_by_brute_force(
        a, b, diff, channel.diff.all, [](bool) { return true; }, channel.tolerance);
    if (diff.pixels.inside > height)
        check_by_brute_force(
            a, b, diff, channel.diff.inside, [](bool edge) { return !edge; }, channel.tolerance);
    if (diff.pixels.silhouette > height)
        check_by_brute_force(
            a, b, diff, channel.diff.silhouette, [](bool edge) { return edge; }, channel.tolerance);
}

TEST_CASE("ids above 2^31 and above 2^24 keep all their bits", "[picture_diff]") {
    const auto big = static_cast<int32_t>(0x80000001u);
    const PictureDiff diff = diff_pictures(ids(3, 1, {big, 16777216, big}), ids(3, 1, {big, 16777217, 1}), {});
    CHECK(diff.different.all() == 2);
    CHECK(diff.id->first->pixel == 1);
    CHECK(diff.id->first->a == 16777216);
    CHECK(diff.id->first->b == 16777217);
    CHECK(diff_pictures(ids(1, 1, {big}), ids(1, 1, {1}), {}).id->first->a == 0x80000001u);
}

TEST_CASE("a pixel that differs in several channels is one", "[picture_diff]") {
    Film a(2, 1, {true, true, true, true}), b(2, 1, {true, true, true, true});
    for (Film* film : {&a, &b})
        for (size_t i = 0; i < 2; ++i) {
            for (size_t c = 0; c < float_channels.size(); ++c) plane_of(*film, c)[i] = 1;
            film->id[i] = 7;
        }
    for (size_t c = 0; c < float_channels.size(); ++c) plane_of(b, c)[1] = 2;
    b.id[1] = 8;
    CHECK(diff_pictures(a, b, {}).different.all() == 1);
}

TEST_CASE("what cannot be compared is refused", "[picture_diff]") {
    CHECK_THROWS_AS(diff_pictures(distances({1, 2}), distances({1}), {}), Error);
    CHECK_THROWS_AS(diff_pictures(ids(2, 1, {1, 2}), ids(1, 2, {1, 2}), {}), Error);
    CHECK_THROWS_AS(diff_pictures(distances({1}), ids(1, 1, {1}), {}), Error);
}

TEST_CASE("a difference film holds |A - B|, and inf where no number would do", "[picture_diff]") {
    const Film film = difference_film(distances({1, inf, not_a_number, not_a_number, inf, -0.0f}),
                                      distances({4, inf, not_a_number, 5, -inf, 0.0f}));
    const std::vector<float> expected{3, 0, 0, inf, inf, 0};
    CHECK(std::vector<float>(film.distance.begin(), film.distance.end()) == expected);
    CHECK(film.radiance[0].empty());
    CHECK(film.id.empty());
    const Film of_ids = difference_film(ids(2, 1, {1, -1}), ids(2, 1, {1, 1}));
    CHECK(of_ids.id[0] == 0);
    CHECK(of_ids.id[1] == 1);
}

TEST_CASE("a difference map has one colour for each kind of pixel", "[picture_diff]") {
    Film a(6, 1, {false, true, false, true}), b(6, 1, {false, true, false, true});
    for (size_t i = 0; i < 6; ++i) a.distance[i] = b.distance[i] = 8, a.id[i] = b.id[i] = i < 5 ? 0 : 1;
    b.distance[0] = 8.5f;  // within the tolerance
    b.distance[1] = 10;
    b.distance[5] = 10;
    const Film map = difference_map(diff_pictures(a, b, {0, 0.125, 0}));
    const auto colour = [&](size_t i) {
        return std::vector<float>{map.radiance[0][i], map.radiance[1][i], map.radiance[2][i]};
    };
    CHECK(colour(2) == std::vector<float>{0, 0, 0});
    CHECK(colour(4) == colour(2));
    CHECK(colour(0)[0] == colour(0)[2]);
    CHECK(colour(1)[0] > colour(1)[2]);  // red
    CHECK(colour(5)[0] < colour(5)[2]);  // blue
    CHECK(std::set<std::vector<float>>{colour(0), colour(1), colour(2), colour(5)}.size() == 4);
}
