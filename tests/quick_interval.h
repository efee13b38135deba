// Intervals between doubles: what most decisions need, a hundred times as fast as intervals of many digits
// (interval.h), and as sure. Where a sign does not follow they say Undecided, and never guess.
//
// The library is Boost.Interval; only how its ends are rounded is ours. Each is computed to nearest and moved outward
// by one double or a little more (Rump, Zimmermann, Boldo, Melquiond, *Computing predecessor and successor in rounding
// to nearest*, BIT 49, 2009: c - (phi |c| + eta) is no more than the double below c), which needs no rounding mode, of
// which compilers and vector units know little.
#pragma once

#include <boost/numeric/interval/arith.hpp>
#include <boost/numeric/interval/arith2.hpp>
#include <boost/numeric/interval/checking.hpp>
#include <boost/numeric/interval/interval.hpp>
#include <boost/numeric/interval/policies.hpp>
#include <boost/numeric/interval/rounding.hpp>
#include <boost/numeric/interval/utility.hpp>
#include <cmath>

#include "interval.h"

namespace gnomon::oracle {

struct Outward {
    static constexpr double phi = 0x1p-53 * (1 + 0x1p-52), eta = 0x1p-1074;

    static void init() {}
    static double down(double c) { return c - (phi * std::fabs(c) + eta); }
    static double up(double c) { return c + (phi * std::fabs(c) + eta); }

    static double conv_down(double x) { return x; }
    static double conv_up(double x) { return x; }
    static double add_down(double x, double y) { return down(x + y); }
    static double add_up(double x, double y) { return up(x + y); }
    static double sub_down(double x, double y) { return down(x - y); }
    static double sub_up(double x, double y) { return up(x - y); }
    static double mul_down(double x, double y) { return down(x * y); }
    static double mul_up(double x, double y) { return up(x * y); }
    static double div_down(double x, double y) { return down(x / y); }
    static double div_up(double x, double y) { return up(x / y); }
    static double sqrt_down(double x) { return down(std::sqrt(x)); }
    static double sqrt_up(double x) { return up(std::sqrt(x)); }
    static double median(double x, double y) { return x / 2 + y / 2; }
};

/// Between two doubles. Numbers are expected to stay below 10^150, so that no square of theirs overflows.
using QuickInterval = boost::numeric::interval<
    double, boost::numeric::interval_lib::policies<boost::numeric::interval_lib::save_state_nothing<Outward>,
                                                   boost::numeric::interval_lib::checking_base<double>>>;

/// -1, 0 or 1, or Undecided. A NaN is undecided.
inline int sign(const QuickInterval& x) {
    if (x.lower() > 0) return 1;
    if (x.upper() < 0) return -1;
    if (x.lower() == 0 && x.upper() == 0) return 0;
    throw Undecided();
}
inline QuickInterval root(const QuickInterval& x) { return sign(x) == 0 ? QuickInterval(0.) : sqrt(x); }

inline double double_above(const QuickInterval& x) { return x.upper(); }

/// The doubles around what an interval of many digits holds.
QuickInterval around(const Interval& x);
inline Vector<QuickInterval> around(const Vector<Interval>& v) { return {around(v.x), around(v.y), around(v.z)}; }

/// Off by the half diagonal, which is less than the sum of the sides: room enough for the roundings here.
inline Known known(const Vector<QuickInterval>& v, const QuickInterval&) {
    return {{median(v.x), median(v.y), median(v.z)}, width(v.x) + width(v.y) + width(v.z)};
}

template <class Other>
QuickInterval narrower(const QuickInterval& x, Other other) {
    return intersect(x, other());
}

}  // namespace gnomon::oracle
