#pragma once
/// \file
/// The four-bar linkage in its own frame.
///
/// Crank pivot A0 at the origin, rocker pivot B0 at (ground, 0). The crank A0-A turns about A0, its angle counted from
/// the ground link counter-clockwise; the coupler joins the crank pin A to the rocker pin B; the rocker is B0-B. All
/// angles are radians, all lengths in one unit of the caller's choice; nothing depends on that unit (multiplying every
/// length by a power of two changes no digit).

#include "analysis/geometry/vector.h"
#include "analysis/numbers/scalar.h"

namespace mechwright {

/// The four link lengths, each > 0.
template <class T>
struct FourBar {
    T ground;
    T crank;
    T coupler;
    T rocker;
};

/// The side of the line from crank pin to rocker pivot on which the rocker pin lies: left (open) or right (crossed).
enum class Assembly { open, crossed };

/// +1 for open, -1 for crossed: the sign of the sine of the angle from coupler to rocker.
constexpr double side_of(Assembly assembly) { return assembly == Assembly::open ? 1.0 : -1.0; }

/// The dimensions in another number type.
template <class To, class From>
FourBar<To> converted(const FourBar<From>& links) {
    return {number_as<To>(links.ground), number_as<To>(links.crank), number_as<To>(links.coupler),
            number_as<To>(links.rocker)};
}

}  // namespace mechwright
