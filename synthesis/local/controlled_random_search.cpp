#include "synthesis/local/controlled_random_search.h"

#include "synthesis/local/nlopt_end.h"

namespace mechwright {

namespace {

double value_in_box(const std::vector<double>& x, std::vector<double>&, void* function) {
    return static_cast<const BoxFunction*>(function)->value(x);
}

}  // namespace

std::vector<double> controlled_random_search(const BoxFunction& function, std::vector<double> start,
                                             int most_evaluations, unsigned long seed) {
    BoxFunction f = function;  // NLopt takes no pointer to const
    nlopt::srand(seed);
    nlopt::opt solver(nlopt::GN_CRS2_LM, static_cast<unsigned>(start.size()));
    solver.set_min_objective(value_in_box, &f);
    solver.set_lower_bounds(f.lower);
    solver.set_upper_bounds(f.upper);
    solver.set_maxeval(most_evaluations);
    return end_of(solver, std::move(start));
}

}  // namespace mechwright
