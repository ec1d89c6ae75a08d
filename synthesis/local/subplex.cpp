#include "synthesis/local/subplex.h"

#include "synthesis/local/nlopt_end.h"

namespace mechwright {

namespace {

double value_in_cube(const std::vector<double>& x, std::vector<double>&, void* function) {
    const auto& f = *static_cast<const CubeFunction*>(function);
    if (f.ended()) throw nlopt::forced_stop();
    return f.value(x);
}

}  // namespace

std::vector<double> subplex(const CubeFunction& function, std::vector<double> start, int most_evaluations) {
    constexpr double margin = 1e-9, first_step = 0.02, last_step = 1e-12;
    CubeFunction f = function;  // NLopt takes no pointer to const
    nlopt::opt solver(nlopt::LN_SBPLX, static_cast<unsigned>(start.size()));
    solver.set_min_objective(value_in_cube, &f);
    solver.set_lower_bounds(margin);
    solver.set_upper_bounds(1 - margin);
    solver.set_initial_step(first_step);
    solver.set_xtol_rel(last_step);
    solver.set_maxeval(most_evaluations);
    return end_of(solver, std::move(start));
}

}  // namespace mechwright
