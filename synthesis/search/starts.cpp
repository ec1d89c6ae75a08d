#include "synthesis/search/starts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "synthesis/search/draws.h"
#include "synthesis/target/followed/fit.h"
#include "synthesis/target/function/fit.h"
#include "synthesis/target/path/fit.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What screening ranks candidates by; both parts are of order one.
double merit(const Program& program, const VectorXd& x, ProgramValues& values) {
    evaluate(program, x, false, values);
    if (!values.assembled) return unlimited;
    const double worst = violation(program, x, values);
    return values.objective + 10 * worst;
}

bool mechanism_closes_rarely(const Program& program) {
    return program.problem->mechanism->families[program.variant.family].assembly_margin.has_value();
}

}  // namespace

int start_candidates(const Problem& problem) {
    // With a path most of them are worth nothing, and the good ones are rare.
    return problem.path ? 400 : 16;
}

Start screened_start(const Program& program, std::uint64_t seed, int index, int candidates) {
    const auto n = static_cast<Index>(program.size());
    const std::vector<InputTask> tasks = input_tasks(*program.problem);
    const Draws draws(program, seed);
    constexpr int tries = 40;  // draws for each candidate until the conditions of motion hold
    const auto base = static_cast<std::uint64_t>(index) * static_cast<std::uint64_t>(candidates * tries);

    Start best{VectorXd::Zero(n), false, unlimited};
    DrawCounts counts;
    bool found = false;
    ProgramValues values;
    // Of linkages few random ones close: only those count as candidates.
    const bool few_close = mechanism_closes_rarely(program);
    const auto consider = [&](VectorXd x, bool preferred) {
        if (program.path) fit_placement(program, x);
        for (const InputTask& task : tasks)
            task.is_function() ? fit_function(program, task, x) : fit_followed(program, task, x);
        settle_epigraphs(program, x);
        const double m = merit(program, x, values);
        counts += {1, m < unlimited ? 1 : 0};
        if (found && !(m < best.merit)) return m < unlimited;
        best = {std::move(x), preferred, m};
        found = true;
        return m < unlimited;
    };

    if (index == 0) {
        VectorXd x = program.reference;
        if (program.untimed_path()) set_path_angles(program, 0.5, 0.5, x);
        consider(std::move(x), true);
    }
    // Candidates that miss the conditions of motion are used only where none meets them.
    VectorXd closest;
    double closest_violation = unlimited;
    int accepted = 0;
    for (int draw = 0; draw < candidates * tries && accepted < candidates; ++draw) {
        VectorXd x = draws(base + static_cast<std::uint64_t>(draw));
        const double missed = linear_violation(program, x);
        if (missed == 0) {
            accepted += consider(std::move(x), false) || !few_close ? 1 : 0;
        } else if (missed < closest_violation) {
            closest_violation = missed;
            closest = std::move(x);
        }
    }
    if (accepted == 0 && closest.size() > 0) consider(std::move(closest), false);
    best.counts = counts;
    return best;
}

Eigen::VectorXd start_point(const Program& program, std::uint64_t seed, int index, int candidates) {
    return screened_start(program, seed, index, candidates).x;
}

}  // namespace mechwright
