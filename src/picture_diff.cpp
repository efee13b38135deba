#include "picture_diff.h"

#include <algorithm>
#include <cmath>

#include "error.h"
#include "silhouettes.h"

namespace gnomon {

namespace {

std::string size_text(const Film& film) { return std::to_string(film.width) + "x" + std::to_string(film.height); }

void expect_same_size(const Film& a, const Film& b) {
    if (a.width != b.width || a.height != b.height)
        throw Error(Blame::input, "the pictures differ in size: " + size_text(a) + " and " + size_text(b) + " pixels");
}

bool both_have(const Film& a, const Film& b, size_t channel) {
    return !plane_of(a, channel).empty() && !plane_of(b, channel).empty();
}

void note_missing(bool in_a, bool in_b, const char* name, PictureDiff& diff) {
    if (in_a && !in_b) diff.only_in_a.emplace_back(name);
    if (in_b && !in_a) diff.only_in_b.emplace_back(name);
}

double largest_finite(const Plane<float>& plane) {
    float largest = 0;
    for (const float value : plane)
        if (std::isfinite(value)) largest = std::max(largest, std::fabs(value));
    return largest;
}

/// Over the channels of one result, so that a picture with little blue in it is not held to little of that.
double scale_of(const Film& a, const Film& b, Result result) {
    double scale = 0;
    for (size_t c = 0; c < float_channels.size(); ++c)
        if (float_channels[c].result == result && both_have(a, b, c))
            scale = std::max(scale, largest_finite(plane_of(a, c)));
    return scale;
}

ComparedIds compare_ids(const Film& a, const Film& b, std::vector<uint8_t>& marks) {
    ComparedIds result;
    for (size_t i = 0; i < a.id.size(); ++i) {
        if (a.id[i] == b.id[i]) continue;
        if (!result.first) result.first = {i, static_cast<uint32_t>(a.id[i]), static_cast<uint32_t>(b.id[i])};
        ++(marks[i] & silhouette_mark ? result.different.silhouette : result.different.inside);
        marks[i] |= unequal_mark | different_mark;
    }
    return result;
}

void find_silhouettes(const Film& a, const Film& b, PictureDiff& diff) {
    diff.ids_in_a = !a.id.empty();
    diff.ids_in_b = !b.id.empty();
    for (const Film* film : {&a, &b})
        mark_silhouettes(film->id, static_cast<size_t>(film->width), silhouette_mark, diff.marks);
}

void compare_channels(const Film& a, const Film& b, const Tolerances& tolerances, PictureDiff& diff) {
    std::vector<double> room;
    const std::array<double, 3> scales{scale_of(a, b, Result::radiance), scale_of(a, b, Result::distance),
                                       scale_of(a, b, Result::normal)};
    for (size_t c = 0; c < float_channels.size(); ++c) {
        const FloatChannel& channel = float_channels[c];
        note_missing(!plane_of(a, c).empty(), !plane_of(b, c).empty(), channel.name, diff);
        if (!both_have(a, b, c)) continue;
        const double scale = scales[static_cast<size_t>(channel.result)],
                     tolerance = tolerances.of(channel.result) * scale;
        diff.channels.push_back(
            {channel, scale, tolerance, diff_channel(plane_of(a, c), plane_of(b, c), tolerance, diff.marks, room)});
    }
    note_missing(diff.ids_in_a, diff.ids_in_b, id_channel, diff);
    if (diff.ids_in_a && diff.ids_in_b) diff.id = compare_ids(a, b, diff.marks);
}

/// How many of the marks have all `bits`.
PixelCount count(const std::vector<uint8_t>& marks, uint8_t bits) {
    PixelCount result;
    for (const uint8_t mark : marks)
        if ((mark & bits) == bits) ++(mark & silhouette_mark ? result.silhouette : result.inside);
    return result;
}

}  // namespace

PictureDiff diff_pictures(const Film& a, const Film& b, const Tolerances& tolerances) {
    expect_same_size(a, b);
    PictureDiff diff;
    diff.width = a.width;
    diff.height = a.height;
    diff.marks.resize(a.pixels());
    find_silhouettes(a, b, diff);
    compare_channels(a, b, tolerances, diff);
    if (diff.channels.empty() && !diff.id)
        throw Error(Blame::input, "the pictures have no channel in common", "",
                    "R G B, distance.Z, N.X N.Y N.Z and id are compared");
    diff.pixels = count(diff.marks, 0);
    diff.different = count(diff.marks, different_mark);
    return diff;
}

}  // namespace gnomon
