// Real numbers that are enclosed rather than rounded: intervals of as many digits as a decision needs.
//
// `decided` runs a computation with 40 decimal digits and, wherever a sign does not follow from the intervals, again
// from the start with twice as many, up to 1280. There a number whose interval still holds 0 counts as exactly 0. That
// cannot be proven for tan(fov / 2), which is transcendental as a rule; but a number made of doubles by the few dozen
// operations of a ray, none of which leaves 10^+-320, that is smaller than 10^-900 and not 0 would be a marvel.
#pragma once

#include <boost/multiprecision/mpfi.hpp>

#include "vec.h"

namespace gnomon::oracle {

using Interval = boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<0>,
                                               boost::multiprecision::expression_template_option::et_off>;

/// Thrown where the digits at hand do not tell, and caught by `decided`.
struct Undecided {};

/// The digits that new intervals have, as long as it lives.
class Digits {
  public:
    static constexpr unsigned fewest = 40, most = 1280;

    explicit Digits(unsigned digits) : before_(Interval::default_precision()) { Interval::default_precision(digits); }
    ~Digits() { Interval::default_precision(before_); }
    Digits(const Digits&) = delete;
    Digits& operator=(const Digits&) = delete;

  private:
    unsigned before_;
};

/// The result of `compute()`, which must make all its intervals anew each time.
template <class Compute>
auto decided(Compute compute) {
    for (unsigned count = Digits::fewest;; count *= 2) {
        const Digits digits(count);
        try {
            return compute();
        } catch (const Undecided&) {
            if (count >= Digits::most) throw std::logic_error("the oracle: undecided with the most digits");
        }
    }
}

/// -1, 0 or 1; Undecided when the interval holds 0 and more, and more digits may tell.
int sign(const Interval& x);
/// Whether an interval with the most digits still holds 0.
bool counts_as_zero(const Interval& x);
/// The square root of what is >= 0 or counts as 0.
Interval root(const Interval& x);
Interval pi();

/// The nearest double; Undecided when it is not known to 2^-58 of its value (or, for the second, of `scale`).
double nearest(const Interval& x);
double nearest(const Interval& x, const Interval& scale);
/// No less than the number, but for a rounding.
inline double double_above(const Interval& x) { return nearest(x); }

template <class Real>
struct Vector {
    Real x, y, z;

    Vector(Real a, Real b, Real c) : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
    explicit Vector(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}
};

template <class Real>
Vector<Real> operator+(const Vector<Real>& a, const Vector<Real>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
Vector<Real> operator-(const Vector<Real>& a, const Vector<Real>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
Vector<Real> operator*(const Vector<Real>& a, const Real& s) {
    return {a.x * s, a.y * s, a.z * s};
}
template <class Real>
Real dot(const Vector<Real>& a, const Vector<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real>
Vector<Real> unit(const Vector<Real>& v) {
    return v * Real(1. / root(dot(v, v)));
}
/// Of a vector no longer than about 1: components to 2^-58.
inline Vec3 nearest(const Vector<Interval>& v) { return {nearest(v.x, 1), nearest(v.y, 1), nearest(v.z, 1)}; }

/// Doubles for a vector no longer than about `scale`, and by how much more than their roundings they may be off.
struct Known {
    Vec3 value;
    double off;
};
Known known(const Vector<Interval>& v, const Interval& scale);

/// The narrowest that is known of a number of which there are two enclosures: here the first is as good as any.
template <class Other>
const Interval& narrower(const Interval& x, Other) {
    return x;
}

}  // namespace gnomon::oracle
