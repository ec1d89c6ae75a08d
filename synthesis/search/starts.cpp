#include "synthesis/search/starts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
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

/// Whether a draw is fitted to a function: where its error is asked for, not only its input range, and the scales vary
/// from draw to draw. Otherwise every draw would come to one and the same fit.
bool is_fitted_to(const Program& program, const InputTask& task) {
    const bool asked = std::any_of(program.blocks.begin(), program.blocks.end(), [&](const QuantityBlock& block) {
        const std::size_t target = block.quantity->of_target;
        return block.quantity->section == task.section() && (target == every_target || target == task.number);
    });
    const auto scales = std::span(program.variable_of).subspan(task.start, 4);
    return asked && std::any_of(scales.begin(), scales.end(), [](std::ptrdiff_t v) { return v >= 0; });
}

bool mechanism_closes_rarely(const Program& program) {
    return program.problem->mechanism->families[program.variant.family].assembly_margin.has_value();
}

}  // namespace

int start_candidates(const Problem& problem) {
    // With a path most of them are worth nothing, and the good ones are rare.
    return problem.path ? 400 : 16;
}

Start screened_start(const Program& program, std::uint64_t seed, int index, int candidates, bool with_preferred) {
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
    const auto merit_where_placed = [&](VectorXd& x) {
        for (const InputTask& task : tasks)
            if (!task.is_function()) fit_followed(program, task, x);
        settle_epigraphs(program, x);
        return merit(program, x, values);
    };
    const auto consider = [&](VectorXd x, bool preferred) {
        if (program.path) fit_placement(program, x);
        VectorXd fitted = x;
        for (const InputTask& task : tasks)
            if (task.is_function() && (preferred || is_fitted_to(program, task))) fit_function(program, task, fitted);
        double m = merit_where_placed(fitted);
        if (m < unlimited)
            x = std::move(fitted);
        else
            m = merit_where_placed(x);
        counts += {1, m < unlimited ? 1 : 0};
        if (found && !(m < best.merit)) return m < unlimited;
        best = {std::move(x), preferred, m};
        found = true;
        return m < unlimited;
    };

    if (with_preferred) {
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
