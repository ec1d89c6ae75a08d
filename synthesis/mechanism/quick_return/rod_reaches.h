#pragma once
/// \file
/// A condition of several ram-driving mechanisms (Mechanism::ways_again).

#include "synthesis/mechanism/mechanism.h"

namespace mechwright::quick_return {

/// Both sides on which a pin that goes round stands farthest from the slide line.
inline Way rod_reaches(std::string_view arm, std::string_view offset) {
    const std::string_view why = "the rod reaches the slide line from the pin where it is farthest away";
    return {{why, {"rod", offset}, {arm}}, {why, {"rod"}, {arm, offset}}};
}

}  // namespace mechwright::quick_return
