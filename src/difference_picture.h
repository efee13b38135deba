// Pictures of where two pictures differ.
#pragma once

#include "film.h"
#include "picture_diff.h"

namespace gnomon {

/// |A - B| in every float channel that both have, rounded to float: 0 where the values are equal, NaN and infinities
/// included, and inf where such a value stands against another. Id: 1 where the ids differ, else 0.
Film difference_film(const Film& a, const Film& b);

/// One colour a pixel, as radiance: black where all compared channels are equal; grey where they differ within the
/// tolerance; beyond it blue at a silhouette, and red elsewhere.
Film difference_map(const PictureDiff& diff);

}  // namespace gnomon
