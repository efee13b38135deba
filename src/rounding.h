// Rounding to float, and what it leaves over.
#pragma once

namespace gnomon {

/// `v` as a float and nothing more. GCC 12 vectorises double(float(a)), double(float(b)) into a, b, as if the way
/// through float rounded nothing; a volatile is not looked through.
inline float round_to_float(double v) {
    const volatile float rounded = static_cast<float>(v);
    return rounded;
}

/// What is left of `v` beside its float, rounded: together they have 48 bits.
inline float rest_of_float(double v) { return static_cast<float>(v - static_cast<double>(round_to_float(v))); }

inline bool is_float(double v) { return static_cast<double>(round_to_float(v)) == v; }

}  // namespace gnomon
