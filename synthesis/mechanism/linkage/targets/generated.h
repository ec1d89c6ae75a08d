#pragma once
/// \file
/// The error of a linkage that generates a function: a signal less what is asked of it (LinkageModel::output), over the
/// input range, at its extremes or at samples.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "synthesis/mechanism/linkage/targets/found_places.h"
#include "synthesis/target/function/function_target.h"

namespace mechwright::measuring {

inline constexpr std::size_t most_errors = 16;  ///< components of the greatest error

/// The signals with the error of a function's output as the last, and what is asked of that.
inline LinkageMeasure error_measure(const LinkageModel& model, std::size_t over_input, Kind kind) {
    LinkageMeasure measure{kind, model.signals, {model.signals.size(), 0}, {}, 0, over_input};
    measure.signals.push_back({Signal::Kind::error, model.over_input[over_input].of});
    return measure;
}

/// By how many whole turns the output has to be counted on to be next to what is asked at the start of the input range.
template <std::size_t K>
double whole_turns_of_error(const Over& over, linkage::Measured<double, K>& plain, const Course& course,
                            std::span<const double> arguments) {
    const std::size_t output = over.measure.signals[over.measure.asked.signal].of;
    if (!linkage::turns_are_alike(over.measure.signals, output)) return 0;
    const auto scales = arguments.last(4);
    const double start = over.input_at(scales[0]);
    const linkage::Limit& limit = start == course.travel.from ? course.travel.first : course.travel.last;
    const double here = plain.value(output, start, course.turns.near(start), limit).c[0];
    return std::isfinite(here) ? std::round((here - scales[2]) / turn) : 0;
}

/// The error at each sample of a function, in the order in which they are given.
template <std::size_t K>
std::vector<Term> errors_at_samples(const Over& over, linkage::Measured<double, K>& plain, const Course& course,
                                    std::span<const double> arguments, double whole_turns) {
    const auto scales = arguments.last(4);
    std::vector<Term> terms;
    for (const Vector<double>& sample : over.motion.function->parts) {
        plain.ask(over.wanted_of(arguments, whole_turns, {&sample.y, 1}));
        // The ends of the range are those of the motion to the last bit.
        const double at = over.input_at(sample.x == 1 ? scales[0] + scales[1] : scales[0] + scales[1] * sample.x);
        const auto& travel = course.travel;
        const linkage::Limit limit = at == travel.from ? travel.first
                                     : at == travel.to ? travel.last
                                                       : linkage::Limit{};
        const Extreme place{at, plain.value(over.measure.asked.signal, at, course.turns.near(at), limit).c[0], false,
                            limit};
        terms.push_back({over.measure.asked, place, 1, 0});
    }
    return terms;
}

/// The error where it can be greatest, along the motion. `plain` has to be asked for it.
template <std::size_t K>
std::vector<Term> extremes_of_error(const Over& over, linkage::Measured<double, K>& plain, const Course& course) {
    std::vector<Term> terms;
    for (const Extreme& place :
         linkage::extremes(plain, over.measure.asked, course, course.travel.from, course.travel.to))
        terms.push_back({over.measure.asked, place, 1, 0});
    return terms;
}

/// Those of them that a quantity is made of: for the greatest error some of the greatest, in their order along the
/// motion, with the sign that makes them positive. `plain` is asked for what is measured then. Not possible where the
/// linkage does not close.
template <std::size_t K>
Found found_of_error(const Over& over, linkage::Measured<double, K>& plain, const Course& course,
                     std::span<const double> arguments) {
    Found found;
    const FunctionTarget& function = *over.motion.function;
    found.whole_turns = whole_turns_of_error(over, plain, course, arguments);
    found.samples = !function.parts.empty();
    plain.ask(over.wanted_of(arguments, found.whole_turns, function.series));
    const bool greatest = over.measure.kind == Kind::function_greatest;
    if (!greatest && !found.samples) return found;
    found.plus = found.samples ? errors_at_samples(over, plain, course, arguments, found.whole_turns)
                               : extremes_of_error(over, plain, course);
    for (std::size_t i = 0; i < found.plus.size(); ++i)
        found.plus[i].sample = i;
    found.possible = !found.plus.empty() && std::all_of(found.plus.begin(), found.plus.end(), [](const Term& term) {
        return std::isfinite(term.place.value);
    });
    if (!greatest || !found.possible) return found;
    for (Term& term : found.plus)
        term.factor = term.place.value < 0 ? -1 : 1;
    keep_greatest(found.plus, most_errors);
    std::sort(found.plus.begin(), found.plus.end(), [](const Term& a, const Term& b) { return a.sample < b.sample; });
    return found;
}

}  // namespace mechwright::measuring
