#pragma once
/// \file
/// From a problem to a result: picks the method, runs it, re-evaluates and verifies what it found.

#include <atomic>
#include <functional>
#include <string_view>
#include <vector>

#include "synthesis/program/result.h"

namespace mechwright {

namespace homotopy {
struct StartSystem;
}

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
    bool all = false;  ///< an exact method keeps designs with defects too
    /// That a homotopy begins with, where it is one of the problem's kind; else the one that comes with the program.
    const homotopy::StartSystem* start_system = nullptr;
};

/// Solves, then verifies. Never throws for anything a problem file can contain; a proof whose certificate does not hold
/// is a defect of the program, std::logic_error.
Result solve(const Problem& problem, const RunOptions& options);

struct MethodDescription {
    std::string_view name;
    std::string_view meaning;
};

/// All methods of the program, "auto" first.
std::vector<MethodDescription> all_methods();

/// Why a method cannot be used for a problem; empty if it can.
std::string why_not_applicable(std::string_view method, const Problem& problem);

/// A design that is given, not sought (every dimension fixed): evaluated, not verified; objective and violation as for
/// any other solution. In the first of the problem's assemblies, or another one.
Solution evaluate_given(const Problem& problem);
Solution evaluate_given(const Problem& problem, std::size_t assembly);

}  // namespace mechwright
