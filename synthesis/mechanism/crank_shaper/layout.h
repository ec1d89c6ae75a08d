#pragma once
/// \file
/// How the dimensions of the crank shaper stand in the registry (quick_return/layout.h).

#include "analysis/quick_return/crank_shaper.h"
#include "synthesis/mechanism/quick_return/layout.h"

namespace mechwright::quick_return {

template <>
struct Layout<CrankShaper> : UsualRam {
    static constexpr std::size_t reads = 5;
    static constexpr std::array<std::size_t, 4> links{0, 1, 2, 3};
    template <class T>
    static CrankShaper<T> make(const std::array<T, reads>& x, std::size_t) {
        return {x[0], x[1], x[2], x[3], x[4]};
    }

    static constexpr bool outward_is_slow = true;
    /// The rod is steepest with the lever upright or at an end of its swing.
    template <class T>
    static std::array<T, 2> least_rod_margins(const CrankShaper<T>& m) {
        const CrankShaperMargins<T> margin = margins(m);
        return {margin.reaches_upright, margin.reaches_ends};
    }
    /// What must be >= 0 over a full turn and is not linear in the dimensions.
    template <class T>
    static std::array<T, 3> conditions_of_full_turn(const CrankShaper<T>& m) {
        const CrankShaperMargins<T> margin = margins(m);
        return {margin.reaches_ends, margin.pulls_at_outer, margin.pulls_at_inner};
    }
};

}  // namespace mechwright::quick_return
