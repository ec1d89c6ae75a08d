#pragma once
/// \file
/// How a run is carried out.

#include <atomic>
#include <functional>

#include "synthesis/program/result.h"

namespace mechwright {

namespace homotopy {
struct StartSystem;
}

struct SearchTrace;

/// How a run is carried out. None of this changes what is found, except that a stop ends it early.
struct RunOptions {
    int jobs = 1;                             ///< threads for independent local searches
    const std::atomic<bool>* stop = nullptr;  ///< set from outside to end the run with the best design so far
    /// Called now and then, one call at a time: local searches done, their number, the best objective so far (NaN if
    /// there is none).
    std::function<void(int done, int total, double best)> progress;
    /// Called now and then while a lower bound is raised: the part of the objective that it has reached, the boxes
    /// examined.
    std::function<void(double part, long boxes)> bounding;
    /// A design of a problem that differs a little: unless a closed form answers, local searches from it alone take the
    /// place of the method.
    const Design* neighbour = nullptr;
    SearchTrace* trace = nullptr;  ///< where it is to be kept what the search went through (search_trace.h)
    bool all = false;              ///< an exact method keeps designs with defects too
    /// That a homotopy begins with, where it is one of the problem's kind; else the one that comes with the program.
    const homotopy::StartSystem* start_system = nullptr;
};

}  // namespace mechwright
