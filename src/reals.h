// Structs of reals (cl/real.h) for kernels of either type.
#pragma once

#include <variant>

#include "../cl/types.h"
#include "accuracy.h"

namespace gnomon {

/// Of the type in which the kernels compute that it is passed to.
template <template <class> class Struct>
using Either = std::variant<Struct<float>, Struct<double>>;

/// work(0.0f) or work(0.0), whose type says in what this accuracy computes.
template <class Work>
auto with_real(Accuracy accuracy, const Work& work) {
    return computes_in_double(accuracy) ? work(0.0) : work(0.0f);
}

}  // namespace gnomon
