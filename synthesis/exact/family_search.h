#pragma once
/// \file
/// The best members of a family of exact designs, where fewer conditions than dimensions leave some of them free.

#include <functional>
#include <optional>
#include <span>

#include "synthesis/exact/exact_designs.h"
#include "synthesis/program/run_end.h"
#include "synthesis/program/run_options.h"

namespace mechwright {

/// The best design of those that numbers in (0, 1) stand for; nothing where there is none.
using FamilyMember = std::function<std::optional<ExactDesign>(std::span<const double> numbers)>;

struct DesignFamily {
    std::size_t numbers = 0;
    FamilyMember member;
    /// Members near that of some numbers, where they follow from it sooner than from nothing; null: they do not.
    std::function<FamilyMember(std::span<const double> numbers)> near{};
    int examined = 4096;  ///< members, before any is improved
};

/// Members spread evenly over the cube of the numbers, the best of which are improved by Subplex; as many as the
/// problem's `starts`. Every design meets its targets exactly; that it is the best is not proved.
ExactDesigns search_family(const Problem& problem, const DesignFamily& family, const RunOptions& options,
                           const RunEnd& end);

}  // namespace mechwright
