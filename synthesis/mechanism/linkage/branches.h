#pragma once
/// \file
/// The circuits and branches of a linkage of given dimensions, and which of them a motion belongs to.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "analysis/linkage/motion/branches.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// Calls `use` with every assembly that the sides allow (0: either); of more than `most` open sides the last are left
/// at 1, so that it ends.
void for_each_assembly(const std::vector<std::int8_t>& sides, std::size_t most,
                       const std::function<void(const std::vector<std::int8_t>&)>& use);

/// The greatest distance by which a link that is left out of the order, one of `redundant`, misses its second pin.
double misfit(const linkage::Structure& structure, std::span<const std::size_t> redundant,
              std::span<const double> numbers, const linkage::Pose<double>& pose);

/// The sides of a linkage that can be chosen: 0 for each dyad with two assemblies but those of redundant links.
std::vector<std::int8_t> open_sides(const linkage::Order& order, std::span<const std::size_t> redundant);

/// All branches with the sides of each (Branch::assembly).
struct AllBranches {
    std::vector<std::vector<std::int8_t>> assemblies{};
    std::vector<linkage::Branch> branches{};
};

/// Those of a linkage whose sides have still to be said, over the inputs of its master. None where more than six dyads
/// have two assemblies: too many to look at them all.
std::optional<AllBranches> all_branches(const linkage::Driven<double>& moving, const linkage::Structure& structure,
                                        std::span<const std::size_t> redundant, std::span<const double> numbers,
                                        const linkage::Inputs& inputs);

/// As Mechanism::circuit. None, besides, where the linkage has larger groups or never closes.
std::optional<CircuitAndBranch> circuit_of_linkage(const Motion& motion, std::span<const double> dimensions);

}  // namespace mechwright
