#pragma once
/// \file
/// Proof that a dyad exists: of four conditions in fifty digits (homotopy/certify.h).

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "analysis/geometry/vector.h"
#include "synthesis/exact/poses/dyads.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// A displacement in fifty digits: `turn` is (cos, sin).
struct ExactDisplacement {
    Vector<Digits50> shift;
    Vector<Digits50> turn;
};

/// As DyadCondition.
using ExactCondition = std::array<Digits50, 7>;

ExactCondition exact_condition(const ExactDisplacement& displacement);
/// The fixed or the moving pivot lies on the line through a point in a direction (cos, sin).
ExactCondition exact_fixed_pivot_on_line(const Vector<Digits50>& point, const Vector<Digits50>& direction);
ExactCondition exact_moving_pivot_on_line(const Vector<Digits50>& point, const Vector<Digits50>& direction);

struct CertifiedDyad {
    Dyad dyad;  ///< rounded
    Vector<Digits50> fixed;
    Vector<Digits50> moving;
};

/// Dyads that doubles do not part, each proven to be another one.
struct PartedDyads {
    std::vector<CertifiedDyad> real;
    std::size_t others = 0;  ///< that are not real
};

/// The dyads that four conditions leave, from those found in double and from what Newton's method left of the singular
/// ones: each in fifty digits, and with each the one that lies next to it.
PartedDyads parted(const DyadSolutions& found, std::span<const ExactCondition, 4> conditions);

/// The one real dyad near an approximation that meets the conditions; nothing where that is not proven.
std::optional<CertifiedDyad> certified(const Dyad& approximation, std::span<const ExactCondition, 4> conditions);

}  // namespace mechwright
