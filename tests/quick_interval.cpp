#include "quick_interval.h"

namespace gnomon::oracle {

QuickInterval around(const Interval& x) {
    return {mpfr_get_d(lower(x).backend().data(), MPFR_RNDD), mpfr_get_d(upper(x).backend().data(), MPFR_RNDU)};
}

}  // namespace gnomon::oracle
