#pragma once

#include <numbers>

namespace mechwright {

inline constexpr double degree = std::numbers::pi / 180;  ///< rad

}  // namespace mechwright
