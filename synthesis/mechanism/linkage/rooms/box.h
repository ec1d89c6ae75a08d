#pragma once
/// \file
/// The box itself that pins of a linkage need.

#include <optional>
#include <span>

#include "synthesis/mechanism/linkage/rooms/rooms.h"
#include "synthesis/mechanism/quantity.h"

namespace mechwright {

/// From where to where it reaches along its width and across, in the drawing's axes turned by its direction.
struct Box {
    Vector<double> along, across;
    double direction = 0;  ///< of its width, radians
};

/// The box of a room over a motion, whose model is a LinkageModel; absent where the linkage does not close over it.
std::optional<Box> box_of(const Motion& motion, std::span<const double> dimensions, const LinkageRoom& room);

}  // namespace mechwright
