// The oracle's decisions for many pixels: by intervals between doubles where these tell, which is nearly everywhere,
// and exactly elsewhere. The same formulas with another arithmetic, that is as sure (quick_interval.h).
#pragma once

#include <cstdint>

#include "exact_line.h"
#include "oracle.h"
#include "quick_interval.h"

namespace gnomon::oracle {

class QuickOracle {
  public:
    explicit QuickOracle(const Scene& scene);

    struct Answer {
        Decisions decisions;
        bool exactly;  ///< doubles did not tell
    };
    /// Pixel (i, j), counted from the upper left.
    Answer decide(int i, int j) const;

    const Oracle& exact() const { return exact_; }

  private:
    const Scene& scene_;
    Oracle exact_;
    Pinhole<QuickInterval> pinhole_;
};

}  // namespace gnomon::oracle
