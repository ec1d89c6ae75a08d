#include <algorithm>
#include <cmath>
#include <vector>

#include "synthesis/local/linear_program.h"
#include "synthesis/local/local.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of every variable, the part that a step may change: at first, at most, and where the method gives up.
constexpr double least_length = 0.01;  ///< what a variable counts as that is nearly zero
constexpr double first_reach = 1e-2, greatest_reach = 0.5, least_reach = 1e-13;
/// Below this part of the greatest error a promised gain is rounding.
constexpr double least_descent = 1e-13;
/// So many steps have to gain this part; where they do not, the optimum lies where the worst are curved and not level,
/// which Newton's method is for.
constexpr int steps_that_pay = 40;
constexpr double pays_from = 0.05;
constexpr double least_unit = 1e-300;
constexpr int most_corrections = 4;
constexpr int most_projections = 3;
/// What a violation of one costs, in greatest errors at the start: more than any multiplier, so that in the end there
/// is none.
constexpr double price = 1e3;

/// What the greatest is made small of, and the other constraints, with their derivatives by the variables of a step.
struct Linearised {
    VectorXd errors;  ///< each no more than the greatest
    MatrixXd errors_by;
    VectorXd rows;
    MatrixXd rows_by;
    double greatest() const { return errors.maxCoeff(); }
};

/// A point, its values, and how it compares.
struct MinimaxPoint {
    VectorXd x;
    Linearised at;
    double objective = unlimited;
    double violation = unlimited;
};

/// A step, and what the linear program promises of it.
struct Step {
    VectorXd change;
    double cost = 0;  ///< greatest error and price of the violation
};

/// Whether the worst is that of the squared distances of an untimed path.
bool bounds_distances(const Program& p) {
    return p.untimed_path() && p.path->squares && residuals_per_point(p) == 2 && p.problem->path->parts.empty() &&
           p.epigraphs.front().outputs.front().index == *p.path->squares &&
           std::ranges::all_of(p.problem->path->weights, [](double w) { return w == 1; });
}

struct Minimax {
    const Program& program;
    std::size_t worst;  ///< the variable that bounds all errors, or all of them with their signs changed
    double sign;        ///< 1 where it lies above them, -1 where they are changed and it lies below
    bool by_distance;   ///< errors are signed distances of the points from the curve, which set their crank angles
    Index size;         ///< of a step: the first variables, without the worst and what follows from the others
    std::vector<Index> error_rows{};
    std::vector<Index> other_rows{};
    ProgramValues values{};
    PathResiduals path{};
    double unit = 1;  ///< greatest error at the start
    long evaluations = 0;

    explicit Minimax(const Program& p)
        : program(p),
          worst(p.epigraphs.front().variable),
          sign(p.epigraphs.front().above ? 1 : -1),
          by_distance(bounds_distances(p)),
          size(static_cast<Index>(by_distance ? p.dimension_variables : worst)) {
        for (std::size_t r = 0; r < p.rows.size(); ++r) {
            const auto& variables = p.rows[r].form.variables;
            const bool bounds_error = variables.size() == 1 && variables.front().index == worst;
            (bounds_error ? error_rows : other_rows).push_back(static_cast<Index>(r));
        }
    }

    /// The distance of a point from the curve along its normal, both ways round, in units in which the greatest squared
    /// is what the program makes small.
    bool distances(const VectorXd& x, Linearised& at) {
        if (!path_residuals(program, x, true, path)) return false;
        const Index points = path.value.size() / 2;
        at.errors.resize(2 * points);
        at.errors_by.resize(2 * points, size);
        for (Index i = 0; i < points; ++i) {
            const Eigen::Vector2d along = path.by_angle.segment<2>(2 * i);
            const double speed = along.norm();
            if (!(speed > 0)) return false;
            const Eigen::Vector2d normal(-along[1] / speed, along[0] / speed);
            const double error = normal.dot(path.value.segment<2>(2 * i));
            at.errors[2 * i] = error;
            at.errors[2 * i + 1] = -error;
            at.errors_by.row(2 * i) = normal.transpose() * path.jacobian.middleRows<2>(2 * i);
            at.errors_by.row(2 * i + 1) = -at.errors_by.row(2 * i);
        }
        return true;
    }

    /// The crank angles at which the points are nearest, after a change of the dimensions.
    void meet_points(VectorXd& x) {
        for (int k = 0; k < most_projections; ++k) {
            if (!path_residuals(program, x, true, path)) return;
            for (Index i = 0; 2 * i < path.value.size(); ++i) {
                const Eigen::Vector2d along = path.by_angle.segment<2>(2 * i);
                const double square = along.squaredNorm();
                if (square > 0)
                    x[static_cast<Index>(program.first_path_angle) + i] -=
                        along.dot(path.value.segment<2>(2 * i)) / square;
            }
        }
        x = within_bounds(program, std::move(x));
    }

    /// The point with all that follows from its dimensions; false where the mechanism does not assemble.
    bool settle(VectorXd x, MinimaxPoint& place) {
        ++evaluations;
        if (by_distance) meet_points(x);
        settle_epigraphs(program, x);
        evaluate(program, x, true, values);
        if (!values.assembled || !values.jacobian.allFinite()) return false;
        place.objective = values.objective;
        place.violation = violation(program, x, values);
        const auto others = static_cast<Index>(other_rows.size());
        place.at.rows.resize(others);
        place.at.rows_by.resize(others, size);
        for (Index k = 0; k < others; ++k) {
            const Index row = other_rows[static_cast<std::size_t>(k)];
            place.at.rows[k] = values.rows[row];
            place.at.rows_by.row(k) = values.jacobian.row(row).head(size);
        }
        place.x = std::move(x);
        if (by_distance) return distances(place.x, place.at);
        const auto count = static_cast<Index>(error_rows.size());
        place.at.errors.resize(count);
        place.at.errors_by.resize(count, size);
        for (Index k = 0; k < count; ++k) {
            const Index row = error_rows[static_cast<std::size_t>(k)];
            place.at.errors[k] = sign * place.x[static_cast<Index>(worst)] - values.rows[row];
            place.at.errors_by.row(k) = -values.jacobian.row(row).head(size);
        }
        return true;
    }

    /// What is to fall: the greatest error, and the price of the greatest violation of a row.
    double cost(const Linearised& at) const { return at.greatest() / unit + price * greatest_violation(at); }

    double greatest_violation(const Linearised& at) const {
        double worst_row = 0;
        for (Index k = 0; k < at.rows.size(); ++k) {
            const Row& row = other(k);
            worst_row = std::max({worst_row, at.rows[k] - row.upper, row.lower - at.rows[k]});
        }
        return worst_row;
    }

    const Row& other(Index k) const {
        return program.rows[static_cast<std::size_t>(other_rows[static_cast<std::size_t>(k)])];
    }

    /// The linear program of a step from x, for the change of each variable in units of the farthest, the greatest
    /// error and the greatest violation, with the derivatives `by` and the values `at`.
    LinearProgram linear(const VectorXd& x, const Linearised& by, const Linearised& at,
                         const VectorXd& farthest) const {
        const Index most = at.errors.size() + 2 * at.rows.size() + 2 * size + 1;
        LinearProgram lp{VectorXd::Zero(size + 2), MatrixXd::Zero(most, size + 2), VectorXd::Zero(most)};
        lp.cost[size] = 1;
        lp.cost[size + 1] = price;
        Index next = 0;
        for (Index k = 0; k < at.errors.size(); ++k, ++next) {
            lp.rows.row(next).head(size) = by.errors_by.row(k).cwiseProduct(farthest.transpose()) / unit;
            lp.rows(next, size) = -1;
            lp.limit[next] = -at.errors[k] / unit;
        }
        const auto add_row = [&](Index k, double side, double limit) {
            if (!std::isfinite(limit)) return;
            lp.rows.row(next).head(size) = side * by.rows_by.row(k).cwiseProduct(farthest.transpose());
            lp.rows(next, size + 1) = -1;
            lp.limit[next++] = side * (limit - at.rows[k]);
        };
        for (Index k = 0; k < at.rows.size(); ++k) {
            add_row(k, 1, other(k).upper);
            add_row(k, -1, other(k).lower);
        }
        for (Index i = 0; i < size; ++i) {
            const Variable& v = program.variables[static_cast<std::size_t>(i)];
            lp.rows(next, i) = 1;
            lp.limit[next++] = std::clamp((v.upper - x[i]) / farthest[i], 0.0, 1.0);
            lp.rows(next, i) = -1;
            lp.limit[next++] = std::clamp((x[i] - v.lower) / farthest[i], 0.0, 1.0);
        }
        lp.rows(next++, size + 1) = -1;  // no violation is less than none
        lp.rows.conservativeResize(next, size + 2);
        lp.limit.conservativeResize(next);
        return lp;
    }

    Step step(const VectorXd& x, const Linearised& by, const Linearised& at, double reach) const {
        VectorXd start = VectorXd::Zero(size + 2);
        start[size] = at.greatest() / unit;
        start[size + 1] = greatest_violation(at);
        const VectorXd farthest = reach * (x.head(size).cwiseAbs().array() + least_length).matrix();
        const LinearProgram lp = linear(x, by, at, farthest);
        const VectorXd found = solution_of(lp, std::move(start));
        return {found.head(size).cwiseProduct(farthest), lp.cost.dot(found)};
    }

    VectorXd moved(const VectorXd& x, const VectorXd& change) const {
        VectorXd next = x;
        next.head(size) += change;
        return within_bounds(program, std::move(next));
    }

    /// The values that would have led to those found, had the derivatives been right all the way.
    static Linearised strayed(const Linearised& by, const Linearised& found, const VectorXd& change) {
        return {found.errors - by.errors_by * change, {}, found.rows - by.rows_by * change, {}};
    }
};

}  // namespace

bool asks_for_one_worst(const Program& program) {
    if (program.closest_to_reference || program.epigraphs.size() != 1) return false;
    const Epigraph& epigraph = program.epigraphs.front();
    const auto& variables = program.objective.variables;
    return program.objective.outputs.empty() && variables.size() == 1 && variables.front().index == epigraph.variable &&
           (variables.front().factor > 0) == epigraph.above;
}

LocalOutcome minimax(const Program& program, const VectorXd& start, const LocalLimits& limits) {
    LocalOutcome outcome;
    Minimax method(program);
    MinimaxPoint here, there, nearer;
    if (!method.settle(within_bounds(program, start), here)) return outcome;
    method.unit = std::max(std::abs(here.at.greatest()), least_unit);
    double reach = first_reach, earlier = unlimited;
    for (int steps = 0; reach > least_reach; ++steps) {
        if (method.evaluations >= limits.most_evaluations || limits.reached()) break;
        if (steps % steps_that_pay == 0) {
            const double now = method.cost(here.at);
            if (!(now < earlier - pays_from * std::abs(now))) break;
            earlier = now;
        }
        Step step = method.step(here.x, here.at, here.at, reach);
        const double cost = method.cost(here.at), promised = cost - step.cost;
        if (!(promised > least_descent * std::abs(cost))) break;
        const bool assembled = method.settle(method.moved(here.x, step.change), there);
        // Again with what the step has shown of curvature: along a curved valley this is what allows long steps.
        for (int c = 0; assembled && c < most_corrections; ++c) {
            if (there.at.errors.size() != here.at.errors.size()) break;
            step = method.step(here.x, here.at, Minimax::strayed(here.at, there.at, step.change), reach);
            if (!method.settle(method.moved(here.x, step.change), nearer)) break;
            if (!(method.cost(nearer.at) < method.cost(there.at))) break;
            std::swap(there, nearer);
        }
        const double gained = assembled ? (cost - method.cost(there.at)) / promised : -1;
        reach = gained < 0.25 ? 0.25 * reach : gained > 0.6 ? std::min(2 * reach, greatest_reach) : reach;
        if (gained > 0) std::swap(here, there);
    }
    outcome.x = here.x;
    outcome.objective = here.objective;
    outcome.violation = here.violation;
    outcome.evaluations = method.evaluations;
    return outcome;
}

}  // namespace mechwright
