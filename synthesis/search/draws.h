#pragma once
/// \file
/// Low-discrepancy points in the ranges of a program's design variables.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/program/program.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// Points of a program, each a function of (seed, number) alone. Lengths are drawn evenly in their logarithm, all else
/// evenly; each dimension has a coordinate of its own, whichever targets a problem has, and the crank angles of an
/// untimed path have the first two numbers of their timing.
class Draws {
public:
    Draws(const Program& program, std::uint64_t seed);

    /// Point number k; what is no dimension and no crank angle is 0.
    Eigen::VectorXd operator()(std::uint64_t k) const;

private:
    const Program& program_;
    std::vector<std::size_t> coordinates_;  ///< [dimension]
    std::size_t timing_;                    ///< the first coordinate of the crank angles
    LowDiscrepancy sequence_;
};

/// How many points were drawn to find starts, and what became of them.
struct DrawCounts {
    long drawn = 0;
    long assembled = 0;  ///< of these the mechanism assembles at every target of the path
    long optimised = 0;  ///< of these local searches began at them
    long preferred = 0;  ///< of these: the preferred values

    DrawCounts& operator+=(const DrawCounts& more) {
        drawn += more.drawn;
        assembled += more.assembled;
        optimised += more.optimised;
        preferred += more.preferred;
        return *this;
    }
};

/// Adds them to what is reported; starts that are not the preferred values came from one source.
void add_counts(SearchReport& report, const DrawCounts& counts, long StartSources::*source = &StartSources::drawn);

/// Sum of violations of the rows that are linear in the variables alone: conditions of motion, order.
double linear_violation(const Program& program, const Eigen::VectorXd& x);

/// Sets the crank angles of an untimed path in x to a guess (path_timing.h).
void set_path_angles(const Program& program, double start, double span, Eigen::VectorXd& x);

}  // namespace mechwright
