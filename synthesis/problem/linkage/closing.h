#pragma once
/// \file
/// Whether and where a linkage closes, from its poses at many inputs.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "analysis/linkage/place.h"
#include "synthesis/problem/linkage/linkage.h"

namespace mechwright {

/// Calls `use` with every assembly that the sides allow (0: either); of more than `most` open sides the last are left
/// at 1, so that it ends.
void for_each_assembly(const std::vector<std::int8_t>& sides, std::size_t most,
                       const std::function<void(const std::vector<std::int8_t>&)>& use);

/// Poses of a linkage of given numbers; its order must be closed.
struct LinkagePoses {
    const Linkage& linkage;
    std::vector<double> numbers;
    std::vector<linkage::Sized<double>> sizes;
    linkage::Pose<double> pose;

    LinkagePoses(const Linkage& of, std::vector<double> numbers_of_it);
    /// Whether it closes; the pose is then in `pose`.
    bool place(double master, const std::vector<std::int8_t>& sides);
    /// The greatest distance between pins of a link, or from the frame's origin: what is small against it is nothing.
    double size() const;
    /// The greatest distance by which a link that is left out of the order (Linkage::redundant) misses its second pin.
    double misfit() const;
};

/// By how much the best assembly fails to close where it comes nearest, and where that is, from many inputs and golden
/// section between them; 0 where one closes, and where there are too many assemblies to look at them all.
struct Gap {
    double missing = 0;
    double at = 0;           ///< the master's input
    std::size_t margin = 0;  ///< which margin of the order fails
};

Gap least_gap(const Linkage& linkage, const std::vector<double>& numbers);

/// How badly the redundant links fit between their pins: at the worst of the inputs at which some assembly closes, by
/// the best of these; relative to the size. Negative where none closes at two inputs at least.
double redundant_misfit(const Linkage& linkage, const std::vector<double>& numbers);

}  // namespace mechwright
