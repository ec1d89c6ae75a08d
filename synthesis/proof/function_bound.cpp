#include "synthesis/proof/function_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "synthesis/program/alternation/error_extremes.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/target/function/function_target.h"
#include "synthesis/target/function/loop_row.h"

namespace mechwright {

namespace {

constexpr std::size_t order = 4;
using Row = std::array<Interval, order>;

/// Extremes this close to the greatest are as great as it.
constexpr double as_great_within = 1e-4;
constexpr std::size_t most_extremes = 8;
/// Places beside the extremes: those of a Chebyshev polynomial.
constexpr std::size_t other_places = 6;
/// How often the errors are divided before a set of places is given up.
constexpr int most_divisions = 16;
/// Parts of the error that a box is tried with.
constexpr std::array<double, 4> parts_of_error{0.5, 0.9, 0.99, 1 - closed_within};

Interval dot(const Row& a, const Row& b) {
    Interval sum = a[0] * b[0];
    for (std::size_t k = 1; k < order; ++k)
        sum += a[k] * b[k];
    return sum;
}

/// The cofactors of row j, so that the determinant is its product with that row.
Row cofactors(const std::array<LoopRow<Interval>, order>& rows, std::size_t j) {
    std::array<const Row*, order - 1> others{};
    for (std::size_t i = 0, k = 0; i < order; ++i)
        if (i != j) others[k++] = &rows[i].value;
    Row c;
    for (std::size_t column = 0; column < order; ++column) {
        std::array<std::size_t, order - 1> left{};
        for (std::size_t i = 0, k = 0; i < order; ++i)
            if (i != column) left[k++] = i;
        const auto m = [&](std::size_t r, std::size_t k) -> const Interval& { return (*others[r])[left[k]]; };
        const Interval minor = m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) -
                               m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
                               m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
        c[column] = (j + column) % 2 == 0 ? minor : -minor;
    }
    return c;
}

/// One variable of the determinant: its range, and the enclosure of the derivative by it.
struct Influence {
    Interval range;
    Interval slope;
};

/// Where a function of this slope is least over the range: at an end, or not known; then the middle.
double least_at(const Influence& v) {
    if (v.slope.low >= 0) return v.range.low;
    if (v.slope.high <= 0) return v.range.high;
    return v.range.middle();
}

/// How far the value in the middle may lie above the least where it is not known where that is.
double penalty(const Influence& v) {
    return v.slope.low >= 0 || v.slope.high <= 0 ? 0 : v.slope.size() * v.range.radius();
}

}  // namespace

std::string FunctionBound::why_not(const Problem& problem) {
    if (!problem.function) return "the problem has no [function]";
    if (problem.mechanism->function->loop_row == nullptr)
        return fmt::format("no bound is known for functions of a {}", problem.mechanism->name);
    if (!problem.objective || problem.objective->terms.size() != 1 || problem.objective->terms.front().maximize ||
        &problem.mechanism->quantities[problem.objective->terms.front().quantity] !=
            &deviation_from(*problem.mechanism, "function"))
        return "the greatest error of the function is not what is minimised";
    return {};
}

FunctionBound::FunctionBound(const Problem& problem, const Design& best) {
    loop_row_ = problem.mechanism->function->loop_row;
    const FunctionTarget& f = *problem.function;
    auto extremes = every_extreme(problem, input_tasks(problem).front(), best);
    error_ = 0;
    for (const ErrorExtreme& e : extremes)
        error_ = std::max(error_, std::abs(e.error));
    const auto part = [&](double share) { return part_at(f, share); };
    for (const ErrorExtreme& e : extremes)
        if (std::abs(e.error) >= (1 - as_great_within) * error_ && points_.size() < most_extremes)
            points_.push_back({e.share, f.parts.empty() ? part(e.share) : e.part});
    const std::size_t own = points_.size();
    for (std::size_t k = 0; k < other_places; ++k) {
        const double share = 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(k) / (other_places - 1));
        if (f.parts.empty())
            points_.push_back({share, part(share)});
        else
            points_.push_back(f.parts[static_cast<std::size_t>(share * static_cast<double>(f.parts.size() - 1))]);
    }
    // Neighbours first: at a minimax optimum they are the ones that bound it.
    const auto choose_neighbours = [&](std::size_t from, std::size_t to) {
        for (std::size_t a = from; a + places <= to; ++a)
            chosen_.push_back({a, a + 1, a + 2, a + 3});
    };
    choose_neighbours(0, own);
    choose_neighbours(own, points_.size());
    for (std::size_t a = 0; a < own; ++a)
        for (std::size_t b = a + 1; b < own; ++b)
            for (std::size_t c = b + 1; c < own; ++c)
                for (std::size_t d = c + 1; d < own; ++d)
                    if (d - a > places - 1) chosen_.push_back({a, b, c, d});
    for (std::size_t k = 0; k < Box::most; ++k) {
        const DimensionRange& range = problem.dimensions[problem.mechanism->input->start + k];
        // A start that may be anywhere is taken once round.
        const bool start = k % 2 == 0;
        const bool angle =
            problem.mechanism->dimensions[problem.mechanism->input->start + k].kind == DimensionKind::angle;
        const double to = start && angle ? std::min(range.max, range.min + 2 * std::numbers::pi) : range.max;
        scales_.middle[k] = 0.5 * (range.min + to);
        scales_.half[k] = 0.5 * (to - range.min);
    }
}

std::vector<Box> FunctionBound::boxes() const { return {scales_}; }

bool FunctionBound::excluded_for(const Box& box, const std::array<std::size_t, places>& at, const Errors& errors,
                                 int depth) const {
    const auto rows_at = [&](const std::array<Interval, Box::most>& scale, const Errors& error) {
        std::array<LoopRow<Interval>, order> rows;
        for (std::size_t j = 0; j < places; ++j) {
            const Vector<double>& p = points_[at[j]];
            const Interval input = scale[0] + scale[1] * Interval(p.x);
            const Interval output = scale[2] + scale[3] * Interval(p.y) + error[j];
            rows[j] = loop_row_(input, output);
        }
        return rows;
    };
    std::array<Interval, Box::most> scale;
    for (std::size_t k = 0; k < Box::most; ++k)
        scale[k] = box.half[k] > 0 ? detail::outward(box.middle[k] - box.half[k], box.middle[k] + box.half[k], 2)
                                   : Interval(box.middle[k]);
    const auto rows = rows_at(scale, errors);
    std::array<Influence, places> by_error;
    std::array<Influence, Box::most> by_scale;
    for (std::size_t k = 0; k < Box::most; ++k)
        by_scale[k] = {scale[k], Interval(0)};
    for (std::size_t j = 0; j < places; ++j) {
        const Row c = cofactors(rows, j);
        const Interval by_input = dot(rows[j].by_input, c), by_output = dot(rows[j].by_output, c);
        const Vector<double>& p = points_[at[j]];
        by_error[j] = {errors[j], by_output};
        by_scale[0].slope += by_input;
        by_scale[1].slope += by_input * Interval(p.x);
        by_scale[2].slope += by_output;
        by_scale[3].slope += by_output * Interval(p.y);
    }
    // The determinant is shown to be positive everywhere, or negative everywhere, the same of its opposite.
    for (const double sign : {1.0, -1.0}) {
        double allowance = 0;
        const auto place = [&](Influence v) {
            v.slope = Interval(sign) * v.slope;
            allowance += penalty(v);
            return Interval(least_at(v));
        };
        std::array<Interval, Box::most> s;
        Errors e;
        for (std::size_t k = 0; k < Box::most; ++k)
            s[k] = place(by_scale[k]);
        for (std::size_t j = 0; j < places; ++j)
            e[j] = place(by_error[j]);
        const auto there = rows_at(s, e);
        const Interval determinant = Interval(sign) * dot(there[0].value, cofactors(there, 0));
        if (determinant.low > allowance * (1 + 1e-12)) return true;
    }
    // Where a slope by an error has both signs, it may have one where the other errors are known better.
    const bool known =
        std::all_of(by_error.begin(), by_error.end(), [](const Influence& v) { return penalty(v) == 0; });
    if (known || depth == 0) return false;
    std::size_t widest = 0;
    for (std::size_t j = 1; j < places; ++j)
        if (errors[j].radius() > errors[widest].radius()) widest = j;
    for (const bool upper : {false, true}) {
        Errors half = errors;
        (upper ? half[widest].low : half[widest].high) = errors[widest].middle();
        if (!excluded_for(box, at, half, depth - 1)) return false;
    }
    return true;
}

bool FunctionBound::excluded(const Box& box, const std::array<std::size_t, places>& at, double error) const {
    Errors errors;
    errors.fill(Interval(-error, error));
    const bool given = std::all_of(box.half.begin(), box.half.end(), [](double h) { return h == 0; });
    return excluded_for(box, at, errors, given ? most_divisions : 0);
}

BoxBound FunctionBound::operator()(const Box& box) const {
    BoxBound bound{0, 0};
    for (std::size_t k = 0; k < Box::most; ++k)
        if (box.half[k] > box.half[bound.split]) bound.split = k;
    // A set of places that excludes a part of the error is the one to try with the next.
    std::size_t set = 0;
    for (const double share : parts_of_error) {
        std::size_t tried = 0;
        while (tried < chosen_.size() && !excluded(box, chosen_[set], share * error_)) {
            ++tried;
            set = (set + 1) % chosen_.size();
        }
        if (tried == chosen_.size()) break;
        bound.least = share * error_;
    }
    return bound;
}

}  // namespace mechwright
