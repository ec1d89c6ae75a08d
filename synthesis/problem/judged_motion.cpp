#include "synthesis/problem/judged_motion.h"

#include <algorithm>
#include <numbers>

#include "synthesis/problem/input_tasks.h"

namespace mechwright {

Motion motion_of(const Problem& problem, std::size_t family, std::size_t assembly) {
    Motion motion;
    motion.assembly = assembly;
    motion.family = family;
    motion.settings = problem.settings;
    motion.model = problem.mechanism->model.data();
    motion.function = problem.function.get();
    motion.followed = problem.followed ? problem.followed->shape : Followed::nothing;
    motion.asked = problem.over_input.get();
    motion.has_instant = problem.has_instant;
    motion.is_range_of_use = problem.use.has_value();
    motion.full_turn =
        problem.mechanism->families[family].full_turn && !problem.crank_range && !has_moving_ends(problem);
    if (problem.crank_range) {
        motion.from = problem.crank_range->x;
        motion.to = problem.crank_range->y;
    } else if (motion.full_turn) {
        motion.to = 2 * std::numbers::pi * problem.mechanism->families[family].turns;
    } else {
        motion.from = 1;  // not known before the design is
        motion.to = 0;
    }
    return motion;
}

Motion motion_of(const Problem& problem, const Quantity& quantity, Motion motion) {
    const Family& family = problem.mechanism->families[motion.family];
    if (quantity.whole && family.full_turn) {
        motion.full_turn = true;
        motion.from = 0;
        motion.to = 2 * std::numbers::pi * family.turns;
    }
    return motion_for(quantity, motion);
}

const Quantity& programmed_quantity(const Problem& problem, std::size_t quantity) {
    const Quantity& plain = problem.mechanism->quantities[quantity];
    if (!has_moving_ends(problem) || !problem.mechanism->input) return plain;
    const auto& moving = problem.mechanism->input->quantities;
    const auto at = std::find_if(moving.begin(), moving.end(), [&](const Quantity& q) { return q.name == plain.name; });
    return at == moving.end() ? plain : *at;
}

bool has_moving_ends(const Problem& problem, const Quantity& quantity) {
    if (!has_moving_ends(problem) || !problem.mechanism->input) return false;
    const auto& moving = problem.mechanism->input->quantities;
    return std::any_of(moving.begin(), moving.end(), [&](const Quantity& one) { return &one == &quantity; });
}

bool has_value(const Problem& problem, std::size_t index, const Motion& motion) {
    const Quantity& quantity = programmed_quantity(problem, index);
    if (quantity.path != PathMeasure::none) return true;
    const bool over_use = !problem.use || !quantity.of_motion || quantity.whole || has_moving_ends(problem, quantity);
    return over_use && quantity.defined(motion_of(problem, quantity, motion));
}

bool may_have_family(const Problem& problem, std::size_t family) {
    return !moves_over_targets(problem) || problem.mechanism->families[family].full_turn == must_turn_fully(problem);
}

}  // namespace mechwright
