#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <vector>

#include "synthesis/local/local.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// One side of a row as NLopt wants it: factor (c - limit), which is to be 0 or <= 0.
struct Side {
    Index row;
    double limit;
    double factor;
};

/// What the callbacks share. NLopt asks for objective and constraints separately at the same point: values are kept and
/// recognised by the bits of x.
struct Run {
    const Program& program;
    const LocalLimits& limits;
    nlopt_opt optimiser = nullptr;
    LocalOutcome best;
    std::vector<Side> equalities;
    std::vector<Side> inequalities;
    double objective_scale = 1;
    VectorXd x;
    ProgramValues values;
    bool derivatives_known = false;
    std::exception_ptr thrown{};  ///< by a callback: NLopt is C, no exception may pass through it

    const ProgramValues& at(const double* point, bool derivatives) {
        const auto n = static_cast<Index>(program.size());
        const bool same = x.size() == n && std::equal(point, point + n, x.data());
        if (same && (derivatives_known || !derivatives)) return values;
        x = Eigen::Map<const VectorXd>(point, n);
        evaluate(program, x, derivatives, values);
        derivatives_known = derivatives;
        if (!same) best.consider(program, x, values);
        if (limits.reached() || best.evaluations >= limits.most_evaluations) nlopt_force_stop(optimiser);
        return values;
    }
};

double objective_value(Run& run, unsigned n, const double* x, double* gradient) {
    const ProgramValues& v = run.at(x, gradient != nullptr);
    // Infinity makes the line search step back.
    if (!v.assembled) {
        if (gradient) std::fill_n(gradient, n, 0.0);
        return HUGE_VAL;
    }
    if (gradient) VectorXd::Map(gradient, n) = run.objective_scale * v.gradient;
    return run.objective_scale * v.objective;
}

void constraints(Run& run, const std::vector<Side>& sides, unsigned m, double* result, unsigned n, const double* x,
                 double* gradient) {
    const ProgramValues& v = run.at(x, gradient != nullptr);
    if (!v.assembled) {
        std::fill_n(result, m, 0.0);
        if (gradient) std::fill_n(gradient, static_cast<std::size_t>(m) * n, 0.0);
        return;
    }
    for (unsigned i = 0; i < m; ++i) {
        const Side& s = sides[i];
        result[i] = s.factor * (v.rows[s.row] - s.limit);
        if (gradient) VectorXd::Map(gradient + static_cast<std::size_t>(i) * n, n) = s.factor * v.jacobian.row(s.row);
    }
}

/// Carries out what a callback is to do, and keeps what it throws until NLopt has returned.
template <class Work>
void guarded(Run& run, const Work& work) {
    try {
        work();
    } catch (...) {
        run.thrown = std::current_exception();
        nlopt_force_stop(run.optimiser);
    }
}

double objective(unsigned n, const double* x, double* gradient, void* data) {
    Run& run = *static_cast<Run*>(data);
    double value = HUGE_VAL;
    guarded(run, [&] { value = objective_value(run, n, x, gradient); });
    return value;
}

void equalities(unsigned m, double* result, unsigned n, const double* x, double* gradient, void* data) {
    Run& run = *static_cast<Run*>(data);
    guarded(run, [&] { constraints(run, run.equalities, m, result, n, x, gradient); });
}

void inequalities(unsigned m, double* result, unsigned n, const double* x, double* gradient, void* data) {
    Run& run = *static_cast<Run*>(data);
    guarded(run, [&] { constraints(run, run.inequalities, m, result, n, x, gradient); });
}

/// NLopt's last word; a stop is ours.
std::string_view verdict_of(nlopt_result result, const LocalLimits& limits) {
    switch (result) {
        case NLOPT_SUCCESS: return "slsqp: converged";
        case NLOPT_FTOL_REACHED: return "slsqp: gains too small";
        case NLOPT_XTOL_REACHED: return "slsqp: steps too small";
        case NLOPT_ROUNDOFF_LIMITED: return "slsqp: stopped by rounding";
        case NLOPT_MAXEVAL_REACHED: return "slsqp: evaluations used up";
        case NLOPT_FORCED_STOP: return limits.reached() ? "slsqp: stopped" : "slsqp: evaluations used up";
        default: return "slsqp: failed";
    }
}

}  // namespace

LocalOutcome slsqp(const Program& program, const VectorXd& start, const LocalLimits& limits) {
    const auto n = static_cast<unsigned>(program.size());
    Run run{program, limits, {}, {}, {}, {}, 1, {}, {}, false, {}};
    for (std::size_t r = 0; r < program.rows.size(); ++r) {
        const Row& row = program.rows[r];
        const auto index = static_cast<Index>(r);
        if (row.equality()) {
            run.equalities.push_back({index, row.lower, 1});
            continue;
        }
        if (std::isfinite(row.lower)) run.inequalities.push_back({index, row.lower, -1});
        if (std::isfinite(row.upper)) run.inequalities.push_back({index, row.upper, 1});
    }

    const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> optimiser(nlopt_create(NLOPT_LD_SLSQP, n), nlopt_destroy);
    if (!optimiser) throw std::bad_alloc();
    run.optimiser = optimiser.get();
    // A gradient of order one at the start: SLSQP's line search is not invariant to the scale of the objective.
    const ProgramValues& first = run.at(start.data(), true);
    // Without a value at the start NLopt 2.7.1 asks for no rows and goes by those that happen to be in its memory.
    if (!first.assembled || !std::isfinite(first.objective)) {
        run.best.verdict = "slsqp: not assembled";
        return run.best;
    }
    const double slope = first.gradient.lpNorm<Eigen::Infinity>();
    if (slope > 0) run.objective_scale = 1 / slope;
    // NLopt 2.7.1 refuses more equalities than variables; what we hold of such a problem is its start.
    run.best.verdict = n == 0 ? "slsqp: no variables" : "slsqp: more equalities than variables";
    if (n == 0 || run.equalities.size() > n) return run.best;

    VectorXd lower(n);
    VectorXd upper(n);
    for (unsigned i = 0; i < n; ++i) {
        lower[i] = program.variables[i].lower;
        upper[i] = program.variables[i].upper;
    }
    nlopt_set_min_objective(run.optimiser, objective, &run);
    nlopt_set_lower_bounds(run.optimiser, lower.data());
    nlopt_set_upper_bounds(run.optimiser, upper.data());
    if (!run.equalities.empty())
        nlopt_add_equality_mconstraint(run.optimiser, static_cast<unsigned>(run.equalities.size()), equalities, &run,
                                       nullptr);
    if (!run.inequalities.empty())
        nlopt_add_inequality_mconstraint(run.optimiser, static_cast<unsigned>(run.inequalities.size()), inequalities,
                                         &run, nullptr);
    // Steps and gains below these are rounding; the polish that follows does better from here.
    nlopt_set_xtol_rel(run.optimiser, std::max(limits.tolerance, 1e-13));
    nlopt_set_ftol_rel(run.optimiser, std::max(limits.tolerance, 1e-14));
    nlopt_set_maxeval(run.optimiser, limits.most_evaluations);
    VectorXd x = start;
    double reached = 0;
    // Its verdict is not evidence, `best` is what counts; but a run that lacked memory is not finished.
    const nlopt_result verdict = nlopt_optimize(run.optimiser, x.data(), &reached);
    if (run.thrown) std::rethrow_exception(run.thrown);
    if (verdict == NLOPT_OUT_OF_MEMORY) throw std::bad_alloc();
    run.best.verdict = verdict_of(verdict, limits);
    return run.best;
}

}  // namespace mechwright
