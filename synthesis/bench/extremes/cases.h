#pragma once
/// \file
/// Extremes over a motion that are found exactly, as the program does, and by sampling, as is usual; each for a few
/// mechanisms of one kind.

#include <functional>
#include <string_view>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright::bench {

struct ExtremeCase {
    std::string_view name;
    std::size_t mechanisms;
    std::function<double(std::size_t mechanism, int samples)> sampled;
    std::function<double(std::size_t mechanism)> exact;
    std::function<Digits50(std::size_t mechanism)> reference;  ///< as verification finds it
};

std::vector<ExtremeCase> linkage_extremes();
std::vector<ExtremeCase> cam_extremes();

}  // namespace mechwright::bench
