#pragma once
/// \file
/// What tolerances do, as tables for a terminal.

#include <string>

#include "synthesis/study/tolerance.h"

namespace mechwright {

/// For each quantity its spread, predicted and sampled; then which dimension it comes from.
std::string tolerance_text(const ToleranceReport& report);

}  // namespace mechwright
