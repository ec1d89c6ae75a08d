#pragma once
/// \file
/// Whether and where a linkage closes, from its poses at many inputs.

#include <cstddef>
#include <span>

#include "analysis/linkage/motion/driven.h"
#include "synthesis/problem/linkage/linkage.h"

namespace mechwright {

/// The linkage of these numbers, driven by its master. Its order must be closed, and its sides have still to be said.
linkage::Driven<double> driven(const Linkage& linkage, std::span<const double> numbers);

/// By how much the best assembly fails to close where it comes nearest, and where that is, from many inputs and golden
/// section between them; 0 where one closes, and where there are too many assemblies to look at them all.
struct Gap {
    double missing = 0;
    double at = 0;           ///< the master's input
    std::size_t margin = 0;  ///< which margin of the order fails
};

Gap least_gap(const Linkage& linkage, std::span<const double> numbers);

/// How badly the redundant links fit between their pins: at the worst of the inputs at which some assembly closes, by
/// the best of these; relative to the size. Negative where none closes at two inputs at least.
double redundant_misfit(const Linkage& linkage, std::span<const double> numbers);

}  // namespace mechwright
