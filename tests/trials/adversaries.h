// Adversaries by subject, each in a file of its name.
#pragma once

#include "trials.h"

namespace gnomon::test {

const std::vector<Maker>& edges();
const std::vector<Maker>& contacts();

}  // namespace gnomon::test
