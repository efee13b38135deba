// How a picture's decisions and numbers are made sure of, and at what price: docs/accuracy.md.
#pragma once

namespace gnomon {

enum class Accuracy {
    strict,    ///< float, IEEE operations only
    certified  ///< strict, and every decision that rounding may have made is made again, exactly
};

}  // namespace gnomon
