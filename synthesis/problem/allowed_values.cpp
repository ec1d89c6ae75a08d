#include "synthesis/problem/allowed_values.h"

#include <algorithm>
#include <cmath>

namespace mechwright {

namespace {

double last_step(const DimensionRange& range) { return std::round((range.max - range.min) / range.step); }

double steps_to(const DimensionRange& range, double value) {
    return std::clamp((value - range.min) / range.step, 0.0, last_step(range));
}

/// The last value is the end of the range, which is not rounded.
double at_step(const DimensionRange& range, double count) {
    return count == last_step(range) ? range.max : range.min + count * range.step;
}

}  // namespace

std::size_t count_allowed(const DimensionRange& range) {
    return range.choices.empty() ? static_cast<std::size_t>(last_step(range)) + 1 : range.choices.size();
}

double allowed_value(const DimensionRange& range, std::size_t number) {
    return range.choices.empty() ? at_step(range, static_cast<double>(number)) : range.choices[number];
}

double nearest_allowed(const DimensionRange& range, double value) {
    if (range.choices.empty()) return at_step(range, std::round(steps_to(range, value)));
    return *std::min_element(range.choices.begin(), range.choices.end(),
                             [&](double a, double b) { return std::abs(a - value) < std::abs(b - value); });
}

std::pair<double, double> allowed_around(const DimensionRange& range, double value) {
    if (range.choices.empty()) {
        const double lower = std::min(std::floor(steps_to(range, value)), last_step(range) - 1);
        // Rounding can put a value that is allowed below its step.
        const double count = at_step(range, lower + 1) <= value && lower + 2 <= last_step(range) ? lower + 1 : lower;
        return {at_step(range, count), at_step(range, count + 1)};
    }
    const auto above = std::clamp(std::upper_bound(range.choices.begin(), range.choices.end(), value),
                                  range.choices.begin() + 1, range.choices.end() - 1);
    return {above[-1], *above};
}

bool end_with_step(DimensionRange& range, double step) {
    const double steps = (range.max - range.min) / step;
    if (!(step > 0) || !(steps <= most_steps)) return false;
    const double rounded = std::abs(steps - std::round(steps)) <= 1e-9 * steps ? std::round(steps) : std::floor(steps);
    if (rounded < 1) return false;
    if (rounded < steps * (1 - 1e-9)) range.max = range.min + rounded * step;
    if (range.start) range.start = std::min(*range.start, range.max);
    range.step = step;
    return true;
}

bool round_to(DimensionRange& range, double multiple) {
    constexpr double within = 1e-9;  // of a multiple, what rounding leaves
    const double first = std::ceil(range.min / multiple - within), last = std::floor(range.max / multiple + within);
    if (!(multiple > 0) || !(first <= last) || last - first > most_steps) return false;
    // A tenth is no double: 51 of them are 5.1 where they are divided by ten.
    const double whole = std::round(1 / multiple);
    const bool divides = whole >= 1 && std::abs(whole * multiple - 1) < within;
    range.min = divides ? first / whole : first * multiple;
    range.max = divides ? last / whole : last * multiple;
    range.step = range.min == range.max ? 0 : multiple;
    if (range.start) range.start = std::clamp(*range.start, range.min, range.max);
    return true;
}

DimensionRange continuous(DimensionRange range) {
    range.choices.clear();
    range.step = 0;
    return range;
}

DimensionRange allowed_between(const DimensionRange& range, double least, double greatest) {
    DimensionRange part = range;
    part.min = least;
    part.max = greatest;
    std::erase_if(part.choices, [&](double value) { return value < least || value > greatest; });
    if (part.start) part.start = std::clamp(*part.start, least, greatest);
    return least == greatest ? continuous(part) : part;
}

}  // namespace mechwright
