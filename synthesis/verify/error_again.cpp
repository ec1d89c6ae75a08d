#include "synthesis/verify/error_again.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/numbers/golden_section.h"
#include "analysis/numbers/scalar.h"
#include "synthesis/problem/problem.h"

namespace mechwright {

ErrorAgain::ErrorAgain(const Rebuilt& design, const InputTask& task)
    : design_(&design), task_(task), function_(task.asked.function.get()) {
    if (!function_) return;
    if (function_->parts.empty()) {
        y_ = std::make_shared<ExpressionValues>(function_->expression);
        y_from_ = (*y_)(function_->from);
        height_ = (*y_)(function_->to) - y_from_;
    }
    // The registry measures sizes alone: asked for a little less, the output errs by so much more, and the size of that
    // tells the sign. A little: an angle that is off by more than half a turn counts from the other side.
    shift_ = task.unit() == Unit::angle ? Digits50(1e-6) : design.longest;
}

double ErrorAgain::part(double share) const {
    if (!function_) return 0;
    if (y_) return ((*y_)(function_->from + share * (function_->to - function_->from)) - y_from_) / height_;
    const auto at =
        std::min_element(function_->parts.begin(), function_->parts.end(),
                         [&](const auto& a, const auto& b) { return std::abs(a.x - share) < std::abs(b.x - share); });
    return at->y;
}

Digits50 ErrorAgain::of_function(double share, std::vector<Digits50> d) const {
    const std::size_t scale = task_.start;
    d[scale] += d[scale + 1] * share;
    d[scale + 2] += d[scale + 3] * part(share);
    FunctionTarget here;
    here.parts = {{0, 0}};
    Motion motion = design_->motion;
    motion.from = motion.to = d[scale].convert_to<double>();
    return of_sample(here, motion, std::move(d));
}

Digits50 ErrorAgain::of_sample(const FunctionTarget& sample, Motion motion, std::vector<Digits50> d) const {
    motion.asked = nullptr;
    motion.function = &sample;
    const Digits50 size = measure_again(*task_.deviation, motion, d);
    d[task_.start + 2] -= shift_;
    const Digits50 shifted = measure_again(*task_.deviation, motion, d);
    const Digits50 more = size + shift_, less = size - shift_;
    // More than half a turn may count from the other side.
    const Digits50 off_if_positive = std::min<Digits50>(abs(shifted - more), abs(shifted - abs(counted_on(more, 0))));
    return off_if_positive <= abs(shifted - abs(less)) ? size : Digits50(-size);
}

Digits50 ErrorAgain::of_shape(double share, std::span<const Digits50> d) const {
    const Claim& claim = *design_->claim;
    const Digits50 crank_angle = d[task_.start] + d[task_.start + 1] * share;
    const Vector<Digits50> p =
        point_again(*claim.mechanism, task_.form(*claim.mechanism, claim.assembly), d, crank_angle);
    const std::size_t place = task_.shape->place;
    if (task_.is_line()) return cos(d[place]) * p.y - sin(d[place]) * p.x - d[place + 1];
    const Vector<Digits50> away = p - Vector<Digits50>{d[place], d[place + 1]};
    return sqrt(dot(away, away)) - d[place + 2];
}

Digits50 ErrorAgain::at(double share, std::span<const Digits50> dimensions) const {
    return function_ ? of_function(share, {dimensions.begin(), dimensions.end()}) : of_shape(share, dimensions);
}

Digits50 ErrorAgain::counted_on(const Digits50& error, const Digits50& other) const {
    if (task_.unit() != Unit::angle) return error;
    return error + 2 * pi<Digits50>() * round((other - error) / (2 * pi<Digits50>()));
}

double ErrorAgain::place_before_jump(double before, double after) const {
    const Digits50 first = at(before);
    for (double middle = 0.5 * (before + after); before < middle && middle < after; middle = 0.5 * (before + after))
        (abs(at(middle) - first) > pi<Digits50>() ? after : before) = middle;
    return before;
}

bool ErrorAgain::goes_on() const {
    if (!function_ || task_.unit() != Unit::angle) return false;
    Motion motion = task_.alone(design_->motion);
    motion.asked = nullptr;
    return measure_again(*task_.deviation, motion, design_->dimensions) > pi<Digits50>();
}

std::vector<ExtremeAgain> ErrorAgain::at_samples() const {
    const bool counted_from_start = goes_on();
    std::vector<ExtremeAgain> found;
    for (const Vector<double>& sample : function_->parts) {
        FunctionTarget one;
        one.parts = {sample};
        found.push_back(
            {sample.x, counted_from_start ? of_sample(one, design_->motion, design_->dimensions) : at(sample.x)});
    }
    return found;
}

std::vector<ExtremeAgain> ErrorAgain::extremes() const {
    if (function_ && !function_->parts.empty()) return at_samples();
    std::vector<ExtremeAgain> found;
    constexpr int steps = 600;
    std::vector<double> share, error;
    std::vector<bool> jumps;  // on the way to here
    Digits50 last = at(0);
    for (int i = 0; i <= steps; ++i) {
        share.push_back(0.5 - 0.5 * std::cos(std::numbers::pi * i / steps));
        const Digits50 here = at(share.back());
        error.push_back((i == 0 ? here : counted_on(here, error.back())).convert_to<double>());
        jumps.push_back(task_.unit() == Unit::angle && abs(here - last) > pi<Digits50>());
        last = here;
    }
    const bool any_jump = std::find(jumps.begin(), jumps.end(), true) != jumps.end();
    const bool on = any_jump && goes_on();
    const auto add = [&](double place, double near) {
        found.push_back({place, on ? counted_on(at(place), near) : at(place)});
    };
    add(0, error.front());
    for (std::size_t i = 1; i <= steps; ++i) {
        if (jumps[i] && !on) add(place_before_jump(share[i - 1], share[i]), error[i]);
        if (i == steps) break;
        const double before = error[i] - error[i - 1], after = error[i + 1] - error[i];
        if (!(before * after < 0 || after == 0)) continue;
        const double sign = before > 0 || after < 0 ? 1 : -1;
        add(greatest_between([&](double s) { return Digits50(sign * counted_on(at(s), error[i])); }, share[i - 1],
                             share[i + 1]),
            error[i]);
    }
    add(1, error.back());
    std::stable_sort(found.begin(), found.end(),
                     [](const ExtremeAgain& a, const ExtremeAgain& b) { return a.share < b.share; });
    return found;
}

std::vector<ExtremeAgain> greatest_of(const std::vector<ExtremeAgain>& all, const Digits50& equal_within) {
    constexpr double as_great_within = 1e-6;
    Digits50 greatest = 0;
    for (const ExtremeAgain& e : all)
        greatest = std::max<Digits50>(greatest, abs(e.error));
    std::vector<ExtremeAgain> kept;
    std::copy_if(all.begin(), all.end(), std::back_inserter(kept), [&](const ExtremeAgain& e) {
        return abs(e.error) >= (1 - as_great_within) * greatest - equal_within;
    });
    return kept;
}

}  // namespace mechwright
