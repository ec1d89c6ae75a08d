#pragma once
/// \file
/// What is asked over input ranges, functions, lines and arcs, whether one of them stands alone or several have names:
/// as the problem has it, with what the mechanism does for it.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "synthesis/problem/problem.h"

namespace mechwright {

struct InputTask {
    AskedOverInput asked;                            ///< without a name where it stands alone
    std::size_t number = every_target;               ///< among several
    std::size_t start = no_dimension;                ///< of its input range; the next one is the range
    const FunctionGeneration* generation = nullptr;  ///< of a function
    const FollowedShape* shape = nullptr;            ///< of a line or an arc
    const Quantity* deviation = nullptr;             ///< the greatest error

    bool is_function() const { return generation != nullptr; }
    bool is_line() const { return asked.followed == Followed::line; }
    /// The section of files and documents that it stands in.
    const char* section() const { return is_function() ? "function" : is_line() ? "line" : "arc"; }
    /// The form in which the mechanism's functions know which target is meant.
    Form form(const Mechanism& mechanism, std::size_t assembly) const {
        return mechanism.form(assembly, shape != nullptr ? shape->guided : 0, number == every_target ? 0 : number);
    }
    /// A motion of the design in which this is what is asked for.
    Motion alone(Motion motion) const {
        motion.function = asked.function.get();
        motion.followed = asked.followed;
        return motion;
    }
    /// The unit of the error.
    Unit unit() const { return deviation->unit; }
};

/// All of them, in the order of their numbers among the dimensions. `Asker` is a problem or the claim of a document,
/// with the members of these names, and outlives what comes back.
template <class Asker>
std::vector<InputTask> input_tasks(const Asker& of) {
    const Mechanism& m = *of.mechanism;
    std::vector<InputTask> all;
    for (std::size_t i = 0; of.over_input && i < of.over_input->size(); ++i) {
        const InputTarget& target = m.over_input[i];
        const auto deviation = std::find_if(m.quantities.begin(), m.quantities.end(), [&](const Quantity& q) {
            return q.of_target == i && q.path == PathMeasure::none && q.reduce == Reduce::greatest;
        });
        all.push_back({(*of.over_input)[i], i, target.start, target.function ? &*target.function : nullptr,
                       target.shape ? &*target.shape : nullptr, &*deviation});
    }
    if (of.function)
        all.push_back({{{}, 1, of.function, Followed::nothing, false},
                       every_target,
                       m.input->start,
                       &*m.function,
                       nullptr,
                       &deviation_from(m, "function")});
    if (of.followed) {
        const FollowedShape& shape = *followed_shape_of(m, *of.followed);
        all.push_back({{{}, 1, {}, of.followed->shape, of.followed->full_turn},
                       every_target,
                       m.input->start,
                       nullptr,
                       &shape,
                       &deviation_from(m, shape.name)});
    }
    return all;
}

/// Whether the crank has to turn fully beyond an input range.
template <class Asker>
bool must_turn_fully(const Asker& of) {
    const bool one = of.followed && of.followed->full_turn;
    return one || (of.over_input && std::any_of(of.over_input->begin(), of.over_input->end(),
                                                [](const AskedOverInput& asked) { return asked.full_turn; }));
}

}  // namespace mechwright
