#include "synthesis/verify/proofs/function_bound_again.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mechwright {

namespace {

constexpr std::size_t order = 4, corners = 3;

template <class T>
using Equation = std::array<T, order>;

/// Ends of the outputs at a place, and the corner between them.
template <class T>
std::array<Equation<T>, corners> hull(LoopKind kind, const T& input, const T& from, const T& to) {
    using std::cos, std::sin;
    const T c = cos(input), s = sin(input);
    if (kind == LoopKind::slider_crank) {
        const auto row = [&](const T& x, const T& square) { return Equation<T>{x * c, s, T(1), square}; };
        return {row(from, from * from), row(to, to * to), row((from + to) / 2, from * to)};
    }
    const auto row = [&](const T& x, const T& y) { return Equation<T>{x, c, T(1), c * x + s * y}; };
    const T middle = (from + to) / 2, stretch = 1 / cos((to - from) / 2);
    return {row(cos(from), sin(from)), row(cos(to), sin(to)), row(stretch * cos(middle), stretch * sin(middle))};
}

/// The six minors of two rows, of the columns 01, 02, 03, 12, 13, 23.
template <class T>
std::array<T, 6> minors(const Equation<T>& a, const Equation<T>& b) {
    const auto m = [&](std::size_t i, std::size_t j) { return T(a[i] * b[j] - a[j] * b[i]); };
    return {m(0, 1), m(0, 2), m(0, 3), m(1, 2), m(1, 3), m(2, 3)};
}

/// By Laplace: the first two rows' minors with those of the other two.
template <class T>
T determinant(const std::array<T, 6>& a, const std::array<T, 6>& b) {
    return a[0] * b[5] - a[1] * b[4] + a[2] * b[3] + a[3] * b[2] - a[4] * b[1] + a[5] * b[0];
}

template <class T>
T determinant(const std::array<Equation<T>, order>& rows) {
    return determinant(minors(rows[0], rows[1]), minors(rows[2], rows[3]));
}

using Four = std::array<std::size_t, order>;

struct Errors {
    std::array<Digits50, order> from, to;
};

/// Whether the determinant has one sign over all errors.
bool excluded(LoopKind kind, const std::vector<AskedPlace>& places, const Four& at, const Errors& errors) {
    std::array<std::array<Equation<Digits50>, corners>, order> hulls;
    for (std::size_t j = 0; j < order; ++j) {
        const AskedPlace& p = places[at[j]];
        hulls[j] = hull<Digits50>(kind, p.input, p.output + errors.from[j], p.output + errors.to[j]);
    }
    const auto pairs = [&](std::size_t j) {
        std::vector<std::array<Digits50, 6>> all;
        for (const auto& a : hulls[j])
            for (const auto& b : hulls[j + 1])
                all.push_back(minors(a, b));
        return all;
    };
    bool positive = false, negative = false;
    const auto first = pairs(0), second = pairs(2);
    for (const auto& a : first)
        for (const auto& b : second) {
            const Digits50 value = determinant(a, b);
            (value > 0 ? positive : negative) = true;
            if ((positive && negative) || value == 0) return false;
        }
    return true;
}

/// The same with the errors divided, as often as the budget allows.
bool excluded_by_parts(LoopKind kind, const std::vector<AskedPlace>& places, const Four& at, const Errors& errors,
                       int& budget) {
    if (--budget < 0) return false;
    if (excluded(kind, places, at, errors)) return true;
    std::size_t widest = 0;
    for (std::size_t j = 1; j < order; ++j)
        if (errors.to[j] - errors.from[j] > errors.to[widest] - errors.from[widest]) widest = j;
    const Digits50 middle = (errors.from[widest] + errors.to[widest]) / 2;
    for (const bool upper : {true, false}) {
        Errors half = errors;
        (upper ? half.from : half.to)[widest] = middle;
        if (!excluded_by_parts(kind, places, at, half, budget)) return false;
    }
    return true;
}

/// How far the determinant is from 0, over what errors of this size do to it to first order.
double promise(LoopKind kind, const std::vector<AskedPlace>& places, const Four& at, double error) {
    std::array<Equation<double>, order> rows;
    const auto row_at = [&](std::size_t j, double e) {
        const auto input = places[at[j]].input.convert_to<double>();
        const double output = places[at[j]].output.convert_to<double>() + e;
        return hull<double>(kind, input, output, output)[0];
    };
    for (std::size_t j = 0; j < order; ++j)
        rows[j] = row_at(j, 0);
    const double middle = std::abs(determinant(rows));
    double change = 0;
    for (std::size_t j = 0; j < order; ++j) {
        auto more = rows, less = rows;
        more[j] = row_at(j, error);
        less[j] = row_at(j, -error);
        change += std::abs(determinant(more) - determinant(less)) / 2;
    }
    return change > 0 ? middle / change : 0;
}

}  // namespace

bool every_linkage_errs(LoopKind kind, const std::vector<AskedPlace>& places, const Digits50& error) {
    // The tangents at the ends of half a circle or more do not meet beyond it.
    if (!(error >= 0) || (kind == LoopKind::four_bar && error > 1)) return false;
    constexpr double least_promise = 0.9;
    constexpr std::size_t most_sets = 40;
    std::vector<std::pair<double, Four>> sets;
    for (std::size_t a = 0; a < places.size(); ++a)
        for (std::size_t b = a + 1; b < places.size(); ++b)
            for (std::size_t c = b + 1; c < places.size(); ++c)
                for (std::size_t d = c + 1; d < places.size(); ++d) {
                    const Four at{a, b, c, d};
                    const double hope = promise(kind, places, at, error.convert_to<double>());
                    if (hope > least_promise) sets.emplace_back(hope, at);
                }
    std::sort(sets.begin(), sets.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    sets.resize(std::min(sets.size(), most_sets));
    Errors errors;
    errors.from.fill(-error);
    errors.to.fill(error);
    for (const int most_parts : {1, 400})
        for (const auto& [hope, at] : sets) {
            int budget = most_parts;
            if (excluded_by_parts(kind, places, at, errors, budget)) return true;
        }
    return false;
}

}  // namespace mechwright
