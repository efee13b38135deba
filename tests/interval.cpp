#include "interval.h"

namespace gnomon::oracle {

namespace {

bool most_digits() { return Interval::default_precision() >= Digits::most; }

mpfi_srcptr mpfi(const Interval& x) { return x.backend().data(); }

bool holds_zero(const Interval& x) { return mpfi_has_zero(mpfi(x)) != 0; }

}  // namespace

int sign(const Interval& x) {
    if (mpfi_nan_p(mpfi(x)) != 0) throw std::logic_error("the oracle: not a number");
    if (!holds_zero(x)) return mpfi_is_pos(mpfi(x)) != 0 ? 1 : -1;
    if (mpfi_is_zero(mpfi(x)) == 0 && !most_digits()) throw Undecided();
    return 0;
}

bool counts_as_zero(const Interval& x) { return holds_zero(x) && (mpfi_is_zero(mpfi(x)) != 0 || most_digits()); }

Interval root(const Interval& x) { return sign(x) == 0 ? Interval(0) : Interval(sqrt(x)); }

Interval pi() {
    Interval value;
    mpfi_const_pi(value.backend().data());
    return value;
}

double nearest(const Interval& x) { return counts_as_zero(x) ? 0 : nearest(x, x); }

double nearest(const Interval& x, const Interval& scale) {
    // Not through intervals around the ends: Boost 1.74 makes NaN of 2529175010755087872.
    if (!(upper(x) - lower(x) <= lower(Interval(abs(scale))) * 0x1p-58) && !counts_as_zero(x)) {
        if (most_digits()) throw std::logic_error("the oracle: a result of no digits");
        throw Undecided();
    }
    return mpfi_get_d(mpfi(x));
}

Known known(const Vector<Interval>& v, const Interval& scale) {
    return {{nearest(v.x, scale), nearest(v.y, scale), nearest(v.z, scale)}, 0};
}

}  // namespace gnomon::oracle
