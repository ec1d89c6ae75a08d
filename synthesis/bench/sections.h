#pragma once
/// \file
/// The sections, one file each.

#include "synthesis/bench/section.h"

namespace mechwright::bench {

Section kernels();
Section start_up();

}  // namespace mechwright::bench
