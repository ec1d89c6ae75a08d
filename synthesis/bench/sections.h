#pragma once
/// \file
/// The sections, one file each.

#include "synthesis/bench/section.h"

namespace mechwright::bench {

Section kernels();
Section linkages();
Section linkage_synthesis();
Section start_up();
Section derivatives();
Section gradients();
Section extremes();
Section exact();
Section scaling();
Section peers();
Section work_precision();
Section data_profiles();
Section recovery();
Section curves();
Section curve_peers();
Section everyday();
Section agreement();

}  // namespace mechwright::bench
