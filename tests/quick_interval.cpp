#include "quick_interval.h"

namespace gnomon::oracle {

QuickInterval around(const Interval& x) {
    mpfi_srcptr ends = x.backend().data();
    return {mpfr_get_d(&ends->left, MPFR_RNDD), mpfr_get_d(&ends->right, MPFR_RNDU)};
}

}  // namespace gnomon::oracle
