#pragma once
/// \file
/// Numbers that problems are made from: the same ones everywhere.

#include <cmath>
#include <cstdint>

#include "analysis/numbers/low_discrepancy.h"

namespace mechwright::bench {

/// Number i in (0, 1) of problem k.
inline double random_number(std::uint64_t k, std::uint64_t i) {
    return std::ldexp(static_cast<double>(mixed(mixed(k) ^ (i * 7919)) >> 11) + 0.5, -53);
}

}  // namespace mechwright::bench
