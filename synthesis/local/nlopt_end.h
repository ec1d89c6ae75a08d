#pragma once
/// \file
/// How runs of NLopt without derivatives end.

#include <new>
#include <nlopt.hpp>
#include <vector>

namespace mechwright {

/// The point that a run ends at, whatever NLopt says of it; a lack of memory alone is passed on.
inline std::vector<double> end_of(nlopt::opt& solver, std::vector<double> start) {
    double value = 0;
    try {
        solver.optimize(start, value);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {  // rounding, or a stop: the best point so far stands in `start`
    }
    return start;
}

}  // namespace mechwright
