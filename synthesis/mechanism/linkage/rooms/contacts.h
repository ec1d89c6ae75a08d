#pragma once
/// \file
/// What a box about parts of a linkage is touched by, where it is turned so that it is least.

#include <array>
#include <cstddef>
#include <numbers>
#include <optional>

#include "analysis/linkage/measuring/course.h"

namespace mechwright::measuring {

/// A place at which a side of the box is touched: of which of the room's pins, and where in the motion. Stationary
/// where it is the farthest of its surroundings.
struct Contact {
    std::size_t pin = 0;
    linkage::Extreme place{};
    Vector<double> at_limit{};  ///< where it is, at a limit of the motion
};

/// What is touched on the sides of a box: where its width is greatest and least, and its height.
using Contacts = std::array<Contact, 4>;

/// The side of a box on which a contact is: the turn of its outward direction against the width's.
inline double turn_of_side(std::size_t side) {
    constexpr double quarter = std::numbers::pi / 2;
    return side == 0 ? 0 : side == 1 ? 2 * quarter : side == 2 ? quarter : -quarter;
}

/// Two places of the path of a point and how far they are apart.
struct Approach {
    Contact one{}, other{};
    double distance = 0;
};

/// A box turned to be least.
struct TurnedBox {
    bool possible = true;
    double direction = 0;  ///< of its width, radians
    Contacts contacts{};
    std::size_t side = 0;             ///< that lies on two places, if any does:
    std::optional<Contact> beside{};  ///< on this, too
};

}  // namespace mechwright::measuring
