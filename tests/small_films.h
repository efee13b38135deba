// Films of a few pixels and one result, made of their values.
#pragma once

#include <algorithm>
#include <vector>

#include "film.h"

namespace gnomon::test {

/// One row of distances and nothing else.
inline Film distances(const std::vector<float>& values) {
    Film film(static_cast<int>(values.size()), 1, {false, true, false, false});
    std::copy(values.begin(), values.end(), film.distance.begin());
    return film;
}

inline Film ids(int width, int height, const std::vector<int32_t>& values) {
    Film film(width, height, {false, false, false, true});
    std::copy(values.begin(), values.end(), film.id.begin());
    return film;
}

}  // namespace gnomon::test
