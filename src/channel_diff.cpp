#include "channel_diff.h"

#include <algorithm>
#include <cmath>

namespace gnomon {

namespace {

void add_finite(Differences& sum, const Sample<float>& sample, double difference, double tolerance) {
    sum.over += difference > tolerance;
    sum.sum_of_squares += difference * difference;  // at most (2^129)^2, at least (2^-149)^2: both in a double's range
    if (!(difference > sum.max)) return;
    sum.max = difference;
    sum.worst = sample;
}

void add_nonfinite(Differences& sum, const Sample<float>& sample) {
    if (sum.nonfinite++ == 0) sum.first_nonfinite = sample;
}

/// `begin` to `end` are those of the finite differences that are not 0; they are reordered. Every percentile is looked
/// for among those from the one before on.
void find_percentiles(double* begin, double* end, Differences& result) {
    const int64_t zeros = result.finite - (end - begin);
    double* from = begin;
    for (size_t i = 0; i < permilles.size(); ++i) {
        const int64_t rank = (permilles[i] * result.finite + 999) / 1000;  // from 1, rounded up
        if (rank <= zeros) continue;
        double* const at = begin + (rank - zeros - 1);
        std::nth_element(from, at, end);
        result.percentiles[i] = *at;
        from = at;
    }
}

/// The sample whose difference is larger; of two that are as large, the first.
std::optional<Sample<float>> worse(const Differences& a, const Differences& b) {
    if (a.max != b.max) return a.max > b.max ? a.worst : b.worst;
    return a.worst && b.worst && b.worst->pixel < a.worst->pixel ? b.worst : a.worst;
}

std::optional<Sample<float>> earlier(const std::optional<Sample<float>>& a, const std::optional<Sample<float>>& b) {
    return !a || (b && b->pixel < a->pixel) ? b : a;
}

/// All but the percentiles.
Differences merged(const Differences& a, const Differences& b) {
    Differences sum;
    sum.finite = a.finite + b.finite;
    sum.over = a.over + b.over;
    sum.nonfinite = a.nonfinite + b.nonfinite;
    sum.max = std::max(a.max, b.max);
    sum.sum_of_squares = a.sum_of_squares + b.sum_of_squares;
    sum.worst = worse(a, b);
    sum.first_nonfinite = earlier(a.first_nonfinite, b.first_nonfinite);
    return sum;
}

}  // namespace

bool equal_values(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

double Differences::rms() const { return finite > 0 ? std::sqrt(sum_of_squares / static_cast<double>(finite)) : 0; }

/// The differences inside fill the room from its front and those at silhouettes from its back.
ChannelDiff diff_channel(const Plane<float>& a, const Plane<float>& b, double tolerance, std::vector<uint8_t>& marks,
                         std::vector<double>& room) {
    ChannelDiff diff;
    room.resize(a.size());
    double *inside_end = room.data(), *const room_end = inside_end + room.size(), *silhouette_begin = room_end;
    for (size_t i = 0; i < a.size(); ++i) {
        const bool at_silhouette = marks[i] & silhouette_mark, finite = std::isfinite(a[i]) && std::isfinite(b[i]);
        Differences& sum = at_silhouette ? diff.silhouette : diff.inside;
        sum.finite += finite;
        if (equal_values(a[i], b[i])) continue;
        // The difference of two floats, rounded to double: at most 2^-53 of it off, and never 0 unless it is.
        const double difference = std::fabs(static_cast<double>(a[i]) - b[i]);
        const Sample<float> sample{i, a[i], b[i]};
        marks[i] |= !finite || difference > tolerance ? unequal_mark | different_mark : unequal_mark;
        finite ? add_finite(sum, sample, difference, tolerance) : add_nonfinite(sum, sample);
        if (finite) (at_silhouette ? *--silhouette_begin : *inside_end++) = difference;
    }
    diff.all = merged(diff.inside, diff.silhouette);
    find_percentiles(room.data(), inside_end, diff.inside);
    find_percentiles(silhouette_begin, room_end, diff.silhouette);
    double* const all_end = std::copy(silhouette_begin, room_end, inside_end);
    find_percentiles(room.data(), all_end, diff.all);
    return diff;
}

}  // namespace gnomon
