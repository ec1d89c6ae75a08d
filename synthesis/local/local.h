#pragma once
/// \file
/// Local optimisers for a Program, behind one shape of call. What a solver says of its own success is not believed: an
/// outcome is the best point that was evaluated, with the objective and violation that we computed there.

#include <Eigen/Core>
#include <atomic>
#include <chrono>
#include <string_view>

#include "synthesis/program/program.h"

namespace mechwright {

struct LocalLimits {
    int most_evaluations = 600;
    /// A method ends where it expects to gain less than this part; none goes below what its rounding allows.
    double tolerance = 0;
    /// Whether the start is close to an optimum: an interior point method then does not first move far away from the
    /// constraints.
    bool near_optimum = false;
    /// Whether least squares bend their steps along valleys, for one more evaluation of residuals each.
    bool follows_valleys = false;
    std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
    const std::atomic<bool>* stop = nullptr;
    std::atomic<double>* polishing = nullptr;  ///< seconds that polishing takes are added here

    /// Whether it is time to end, by the clock or from outside.
    bool reached() const {
        return (stop && stop->load(std::memory_order_relaxed)) || std::chrono::steady_clock::now() >= deadline;
    }
};

struct LocalOutcome {
    Eigen::VectorXd x;
    double objective = unlimited;  ///< of the program, to be minimised
    double violation = unlimited;  ///< greatest, of rows and bounds; infinite if nothing assembled
    long evaluations = 0;
    long hessians = 0;  ///< of the Lagrangian, besides
    /// What the solver says of its end, in a few words with its name first: for people to read, of no consequence.
    std::string_view verdict{};

    /// Violation below which two points are compared by their objectives.
    static constexpr double feasible_below = 1e-9;

    /// Takes a point if it is better than the one held: feasible before infeasible, then by objective or violation.
    void consider(const Program& program, const Eigen::VectorXd& point, const ProgramValues& values);
};

/// A local optimiser: from a start to the best point it came across.
using LocalMethod = LocalOutcome (*)(const Program& program, const Eigen::VectorXd& start, const LocalLimits& limits);

/// Sequential quadratic programming by NLopt 2.7.1 (Kraft's SLSQP) with exact gradients. Thread-safe.
LocalOutcome slsqp(const Program& program, const Eigen::VectorXd& start, const LocalLimits& limits);

/// Interior point by Ipopt 3.11.9 with MUMPS and the exact Hessian. Runs one at a time: calls from other threads wait.
LocalOutcome ipopt(const Program& program, const Eigen::VectorXd& start, const LocalLimits& limits);

/// Levenberg and Marquardt's method on the sum of squared distances from a path, within the bounds of the variables.
/// The rows that do not speak of the path (rows_beside_path) go along by an augmented Lagrangian (path_fit.h), so that
/// its ends assemble along the path and meet requirements to about 1e-9. The outcome's objective is the sum, and the
/// squares of what those rows are missed by. Thread-safe.
LocalOutcome levenberg_marquardt(const Program& program, const Eigen::VectorXd& start, const LocalLimits& limits);

/// Whether a program asks for nothing but the least greatest, or the greatest least, of some outputs.
bool asks_for_one_worst(const Program& program);

/// Madsen's method for a program that asks for one worst: linear programs within a trust region, each step corrected
/// for the curvature that it meets (Madsen, J. Inst. Maths Applics 16, 1975). It goes through long flat valleys along
/// which extremes stay of one size, where quadratic models of the Lagrangian creep. The crank angles of an untimed path
/// are those of the nearest points throughout. Thread-safe.
LocalOutcome minimax(const Program& program, const Eigen::VectorXd& start, const LocalLimits& limits);

/// Newton's method on the optimality conditions of the constraints active at `from`, with exact Hessians: from a point
/// that a solver ended at to the nearby optimum at full precision. Never returns a worse point.
LocalOutcome polish(const Program& program, const LocalOutcome& from, const LocalLimits& limits);

/// The part of the objective's gradient that the constraints active at a point do not balance with multipliers of the
/// right signs: 0 at a local optimum (Karush, Kuhn and Tucker), at most 1. Where a Newton step would balance it, the
/// root of the part of the objective that the step would gain, if that is less: where the objective is curved steeply,
/// the last digit of a variable makes a gradient.
double unbalanced_part(const Program& program, const Eigen::VectorXd& x);

/// A gradient balanced to this part is that of an optimum: what is left is rounding of the polish.
constexpr double balanced_within = 1e-6;

}  // namespace mechwright
