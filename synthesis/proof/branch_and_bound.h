#pragma once
/// \file
/// Branch and bound: the least value over a box is bounded from below by bounds over ever smaller boxes (Land and Doig;
/// Horst and Tuy, Global Optimization, chapter 4).

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <vector>

#include "synthesis/program/run_options.h"

namespace mechwright {

/// Bounds are raised to this part below the value of the best design, and no further.
inline constexpr double closed_within = 1e-6;

/// A box of up to four parameters in one of the parts that a problem falls into.
struct Box {
    static constexpr std::size_t most = 4;
    std::size_t part = 0;
    std::array<double, most> middle{};
    std::array<double, most> half{};  ///< 0 for parameters that are not free
};

struct BoxBound {
    double least;       ///< no value in the box is less; infinite where it holds no design
    std::size_t split;  ///< the parameter by which the box is best divided
};

struct LowerBound {
    double least;        ///< no value anywhere is less
    bool reached;        ///< the target was
    bool ended = false;  ///< early, by time or a stop
    long boxes = 0;      ///< examined
};

/// Raises the lower bound over all boxes to a target > 0, in stages, until the deadline or a stop ends it: what it says
/// then is the last stage that was reached. `bound` is called from several threads; the outcome does not depend on
/// their number, and memory does not grow with the boxes examined.
LowerBound lower_bound(const std::vector<Box>& boxes, const std::function<BoxBound(const Box&)>& bound, double target,
                       const RunOptions& options, std::chrono::steady_clock::time_point deadline);

}  // namespace mechwright
