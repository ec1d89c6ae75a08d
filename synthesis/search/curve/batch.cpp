#include "synthesis/search/curve/batch.h"

#include <algorithm>
#include <cmath>

namespace mechwright {

namespace {

/// The part of the evaluations that goes into shapes that are drawn.
constexpr double drawn_part = 0.3;
/// Designs that are varied: so many, whose sums differ by more than this part.
constexpr std::size_t most_kept = 6;
constexpr double same_curve_within = 1e-4;
/// Evaluations of a descent at first; then, while its sum is no more than so many times that of the last design kept,
/// of its second and its last part.
constexpr int first_part = 30;
constexpr int second_part = 100;
constexpr int last_part = 400;
constexpr double promising = 4;
constexpr double promising_variation = 2;
constexpr double promising_later = 1.3;
constexpr double tolerance = 1e-9;
/// Variations spread from this to that, small ones more often.
constexpr double least_spread = 0.003;
constexpr double most_spread = 0.5;
constexpr double most_spread_of_chain = 0.1;
/// A descent that settles a design.
constexpr int evaluations_to_settle = 2000;
constexpr double settled_within = 1e-14;

struct Batch {
    const CurveProblem& problem;
    CurveBatch result{};
    CurveWork work{};

    double last_kept() const { return result.best.size() < most_kept ? unlimited : result.best.back().sum; }

    void keep(const FittedCurve& design) {
        auto& best = result.best;
        const auto same = std::find_if(best.begin(), best.end(), [&](const FittedCurve& b) {
            return std::abs(b.sum - design.sum) <= same_curve_within * design.sum;
        });
        if (same != best.end()) {
            if (design.sum < same->sum) *same = design;
            return;
        }
        best.push_back(design);
        std::stable_sort(best.begin(), best.end(),
                         [](const FittedCurve& a, const FittedCurve& b) { return a.sum < b.sum; });
        if (best.size() > most_kept) best.pop_back();
    }

    /// A descent in parts; it is given up where it does not come close to what is kept.
    void try_from(FittedCurve design, double at_first) {
        ++result.optimised;
        if (!descend(problem, design, first_part, tolerance, work)) return;
        if (design.sum > at_first * last_kept()) return;
        descend(problem, design, second_part, tolerance, work);
        if (design.sum > promising_later * last_kept()) return;
        descend(problem, design, last_part, tolerance, work);
        keep(design);
    }

    bool is_exact() const { return !result.best.empty() && is_rounding(problem, result.best.front().sum); }

    /// Descents from variations of what is kept, the better ones more often.
    void vary(double most, long most_evaluations, long most_drawn, Draws& draws, const std::function<bool()>& stop) {
        while (work.evaluations < most_evaluations && result.drawn < most_drawn && !result.best.empty() &&
               !is_exact() && !stop()) {
            ++result.drawn;
            const double part = draws.even();
            const auto from = static_cast<std::size_t>(part * part * static_cast<double>(result.best.size()));
            const double size = draws.even();
            const double spread = least_spread + most * size * size;
            if (const auto variation = varied(problem, result.best[from], spread, draws, work))
                try_from(*variation, promising_variation);
        }
        result.evaluations = work.evaluations;
    }
};

}  // namespace

CurveBatch curve_batch(const CurveProblem& problem, std::uint64_t seed, long most_evaluations,
                       const std::function<bool()>& stop) {
    Batch batch{problem};
    Draws draws(seed);
    CurveBatch& result = batch.result;
    const long most_drawn = most_evaluations;  // where shapes never assemble, there is an end
    const auto of_shapes = static_cast<long>(drawn_part * static_cast<double>(most_evaluations));
    while (batch.work.evaluations < of_shapes && result.drawn < most_drawn && !batch.is_exact() && !stop()) {
        ++result.drawn;
        if (const auto shape = drawn_shape(problem, draws, batch.work)) batch.try_from(*shape, promising);
    }
    batch.vary(most_spread, most_evaluations, 2 * most_drawn, draws, stop);
    return std::move(batch.result);
}

CurveBatch curve_variations(const CurveProblem& problem, const std::vector<FittedCurve>& from, std::uint64_t seed,
                            long most_evaluations, const std::function<bool()>& stop) {
    Batch batch{problem};
    Draws draws(seed);
    for (const FittedCurve& design : from)
        batch.keep(design);
    batch.vary(most_spread_of_chain, most_evaluations, most_evaluations, draws, stop);
    return std::move(batch.result);
}

void settle(const CurveProblem& problem, FittedCurve& design, CurveWork& work) {
    descend(problem, design, evaluations_to_settle, settled_within, work);
}

}  // namespace mechwright
