#pragma once
/// \file
/// How the dimensions of a ram-driving mechanism stand in the registry, and in what the formulas of its kind differ
/// from those of the others. Each kind has its own layout in its folder.

#include <array>
#include <cstddef>

#include "analysis/quick_return.h"

namespace mechwright::quick_return {

/// `reads`: how many of the first dimensions the motion of the ram depends on; `links`: the indices of the link
/// lengths; `make`: the mechanism of these dimensions. Where over a full turn there are conditions that are not linear
/// in the dimensions, `conditions_of_full_turn` gives what must be >= 0.
template <template <class> class Drive>
struct Layout;

/// What holds for drives whose arm turns fully.
struct UsualRam {
    /// Whether the outward stroke always is the slow one.
    static constexpr bool outward_is_slow = false;
    /// How much rod is left, seen from both of its sides, where it is steepest in a full turn.
    template <class Drive>
    static auto least_rod_margins(const Drive& m) {
        const auto margin = rod_margins(output_of(m));
        return std::array{margin.crank_right, margin.crank_left};
    }
};

/// A drive with a four-bar at its input.
template <class Drive>
concept HasFourBar = requires(const Drive& m) {
    m.links.coupler;
};

/// Families of every ram-driving mechanism: two strokes in each full turn, or any other motion.
enum FamilyIndex : std::size_t { full_turn, limited_range };

/// Index into Motion::settings.
inline constexpr std::size_t working_share = 0;

}  // namespace mechwright::quick_return
