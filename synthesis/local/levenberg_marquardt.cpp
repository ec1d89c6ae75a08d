#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "synthesis/local/local.h"
#include "synthesis/local/path_fit.h"

namespace mechwright {

namespace {

using Eigen::VectorXd;

/// A sum of squares below this part of its start, or a gain below that part of the sum, is rounding.
constexpr double zero_within = 1e-30;
constexpr double least_gain = 1e-13;
constexpr int most_small_gains = 3;
/// While rows are missed by more than this, a gain below that part leads to new multipliers.
constexpr double rows_within = 1e-9;
constexpr double gain_beside_rows = 1e-3;
constexpr int most_multipliers = 12;
constexpr double most_damping = 1e20;
constexpr double least_damping = 1e-14;
/// The root of damping is what slopes along a valley are weighed against: of linkages whose points hardly change along
/// one they are 1e-8 of the others.
constexpr double least_along_valleys = 1e-24;

struct Descent {
    PathFit& fit;
    const Program& program;
    const LocalLimits& limits;
    double negligible = 0;
    double damping = 1e-2;
    long evaluations = 0;

    bool over() const { return limits.reached() || evaluations >= limits.most_evaluations; }

    /// Steps until they gain too little. The point that follows is kept in `next`, so that its memory is there.
    void go_down(PathPlace& at, PathPlace& next) {
        double growth = 2, promised = 0;
        int small_gains = 0;
        while (!over() && at.merit > negligible && small_gains < most_small_gains && damping < most_damping) {
            while (evaluations < limits.most_evaluations && damping < most_damping) {
                const VectorXd step = fit.step(at, damping);
                next.x = within_bounds(program, at.x + step);
                promised = fit.promised(at, next.x - at.x);
                ++evaluations;
                if (limits.follows_valleys) {
                    next.x = within_bounds(program, at.x + fit.bent(at, step, damping));
                    ++evaluations;
                }
                if (!fit.evaluate(next)) next.merit = unlimited;
                if (next.merit < at.merit) break;
                damping *= growth;
                growth *= 2;
                if (at.merit - promised <= least_gain * at.merit) damping = unlimited;
                if (limits.reached()) break;
            }
            if (!(next.merit < at.merit)) break;
            const double gain = (at.merit - next.merit) / (at.merit - promised);
            damping *= std::clamp(1 - std::pow(2 * gain - 1, 3), 1.0 / 9, 2.0);
            damping = std::max(damping, limits.follows_valleys ? least_along_valleys : least_damping);
            growth = 2;
            const double enough =
                fit.greatest_excess(next) > rows_within ? gain_beside_rows : std::max(limits.tolerance, least_gain);
            small_gains = at.merit - next.merit <= enough * at.merit ? small_gains + 1 : 0;
            std::swap(at, next);
        }
    }
};

}  // namespace

LocalOutcome levenberg_marquardt(const Program& program, const VectorXd& start, const LocalLimits& limits) {
    LocalOutcome outcome;
    outcome.evaluations = 1;
    outcome.verdict = "least-squares: not assembled";
    PathFit fit(program);
    PathPlace at, next;
    at.x = within_bounds(program, start);
    if (!fit.evaluate(at)) return outcome;
    Descent descent{fit, program, limits, zero_within * at.sum, 1e-2, 1};
    descent.go_down(at, next);
    for (int time = 0; time < most_multipliers && !descent.over() && fit.greatest_excess(at) > rows_within; ++time) {
        fit.sharpen(at);
        descent.damping = std::min(descent.damping, 1.0);
        descent.go_down(at, next);
    }
    outcome.evaluations = descent.evaluations;
    outcome.verdict = !descent.over()    ? "least-squares: gains too small"
                      : limits.reached() ? "least-squares: stopped"
                                         : "least-squares: evaluations used up";
    settle_epigraphs(program, at.x);
    ProgramValues values;
    evaluate(program, at.x, false, values);
    outcome.x = at.x;
    outcome.objective = at.sum + fit.excess_squares(at);
    outcome.violation = violation(program, at.x, values);
    return outcome;
}

}  // namespace mechwright
