#include "synthesis/search/curve/batch.h"

#include <algorithm>
#include <cmath>

namespace mechwright {

namespace {

/// The part of the evaluations that goes into shapes that are drawn, and of that the part in which all of them are
/// taken a little way; the rest is for the best of them. A shape is the one of so many that fits best where it is laid.
constexpr double drawn_part = 0.4;
constexpr double first_part_of_drawn = 0.7;
constexpr int drawn_for_shape = 3;
/// Designs that are varied: so many, whose sums differ by more than this part.
constexpr std::size_t most_kept = 6;
constexpr double same_curve_within = 1e-4;
/// Evaluations of the first, the second and the last part of a descent. It goes on while its sum is no more than so
/// many times that of the last design kept.
constexpr int first_part = 20;
constexpr int second_part = 100;
constexpr int last_part = 400;
constexpr double promising = 4;
constexpr double promising_variation = 2;
constexpr double promising_later = 1.3;
/// A descent that has come so near to a design that is kept, by the arguments and by the sum, would end there.
constexpr double known_within = 0.03;
constexpr double tolerance = 1e-9;
/// A batch is gone on with while the second half of its evaluations gains more than this part, until there are so many
/// times as many as at least.
constexpr double gain_of_half = 3e-6;
constexpr long most_times_as_long = 16;
/// Variations spread from this to that, small ones more often.
constexpr double least_spread = 0.003;
constexpr double most_spread = 0.5;
constexpr double most_spread_of_chain = 0.1;
/// A descent that settles a design.
constexpr int evaluations_to_settle = 2000;
constexpr double settled_within = 1e-14;

bool by_sum(const FittedCurve& a, const FittedCurve& b) { return a.sum < b.sum; }

struct Batch {
    const CurveProblem& problem;
    LaidFirst by{};
    CurveBatch result{};
    CurveWork work{};

    double least() const { return result.best.empty() ? unlimited : result.best.front().sum; }
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
        std::stable_sort(best.begin(), best.end(), by_sum);
        if (best.size() > most_kept) best.pop_back();
    }

    bool goes_to(const FittedCurve& known, const FittedCurve& design) const {
        if (design.assembly != known.assembly || design.sum < known.sum || design.sum > (1 + known_within) * known.sum)
            return false;
        for (std::size_t i = 0; i < problem.arguments; ++i) {
            const double size = std::max(problem.spread, std::abs(known.arguments[i]));
            if (std::abs(design.arguments[i] - known.arguments[i]) > known_within * size) return false;
        }
        return true;
    }

    bool goes_to_known(const FittedCurve& design) const {
        return std::any_of(result.best.begin(), result.best.end(),
                           [&](const FittedCurve& known) { return goes_to(known, design); });
    }

    /// The first part of a descent. False: the design does not assemble.
    bool take_first_part(FittedCurve& design) {
        ++result.optimised;
        work.roughly = true;
        const bool assembles = descend(problem, design, first_part, tolerance, work);
        work.roughly = false;
        return assembles;
    }

    /// The others; it is given up where it does not come close to what is kept.
    void go_on(FittedCurve design) {
        descend(problem, design, second_part, tolerance, work);
        if (design.sum > promising_later * last_kept()) return;
        descend(problem, design, last_part, tolerance, work);
        keep(design);
    }

    std::optional<FittedCurve> best_of_drawn(RandomNumbers& random) {
        std::optional<FittedCurve> best;
        for (int i = 0; i < drawn_for_shape; ++i) {
            ++result.drawn;
            const std::optional<FittedCurve> shape = drawn_shape(problem, by, random, work);
            if (shape && (!best || shape->sum < best->sum)) best = shape;
        }
        return best;
    }

    /// Descents from shapes that are drawn: all of them a little way, then the best of them.
    void draw(long most_evaluations, long most_drawn, RandomNumbers& random, const std::function<bool()>& stop) {
        std::vector<FittedCurve> begun;
        const double of_first = first_part_of_drawn * static_cast<double>(most_evaluations);
        while (static_cast<double>(work.evaluations) < of_first && result.drawn < most_drawn && !stop())
            if (std::optional<FittedCurve> shape = best_of_drawn(random); shape && take_first_part(*shape))
                begun.push_back(*shape);
        std::stable_sort(begun.begin(), begun.end(), by_sum);
        for (const FittedCurve& design : begun) {
            if (work.evaluations >= most_evaluations || is_exact() || stop()) break;
            if (design.sum > promising * last_kept()) break;
            go_on(design);
        }
    }

    bool is_exact() const { return !result.best.empty() && is_rounding(problem, result.best.front().sum); }

    void settle_best() {
        if (result.best.empty()) return;
        descend(problem, result.best.front(), evaluations_to_settle, settled_within, work);
        result.evaluations = work.evaluations;
    }

    /// Descents from variations of what is kept, the better ones more often.
    void vary(double most, long most_evaluations, long most_drawn, RandomNumbers& random,
              const std::function<bool()>& stop) {
        while (work.evaluations < most_evaluations && result.drawn < most_drawn && !result.best.empty() &&
               !is_exact() && !stop()) {
            ++result.drawn;
            const double part = random.even();
            const auto from = static_cast<std::size_t>(part * part * static_cast<double>(result.best.size()));
            const double size = random.even();
            const double spread = least_spread + most * size * size;
            std::optional<FittedCurve> variation = varied(problem, result.best[from], spread, random, work);
            if (!variation || !take_first_part(*variation)) continue;
            if (variation->sum <= promising_variation * last_kept() && !goes_to_known(*variation)) go_on(*variation);
        }
        result.evaluations = work.evaluations;
    }
};

}  // namespace

CurveBatch curve_batch(const CurveProblem& problem, LaidFirst by, std::uint64_t seed, long evaluations,
                       const std::function<bool()>& stop) {
    Batch batch{problem, by};
    RandomNumbers random(seed);
    const long most_drawn = evaluations;  // where shapes never assemble, there is an end
    batch.draw(static_cast<long>(drawn_part * static_cast<double>(evaluations)), most_drawn, random, stop);
    double before = unlimited;
    for (long until = evaluations / 2; until <= most_times_as_long * evaluations; until *= 2) {
        batch.vary(most_spread, until, 2 * until, random, stop);
        batch.settle_best();
        const double now = batch.least();
        if (!(now < (1 - gain_of_half) * before)) break;
        before = now;
    }
    return std::move(batch.result);
}

CurveBatch curve_variations(const CurveProblem& problem, const std::vector<FittedCurve>& from, std::uint64_t seed,
                            long most_evaluations, const std::function<bool()>& stop) {
    Batch batch{problem};
    RandomNumbers random(seed);
    for (const FittedCurve& design : from)
        batch.keep(design);
    batch.vary(most_spread_of_chain, most_evaluations, most_evaluations, random, stop);
    return std::move(batch.result);
}

void settle(const CurveProblem& problem, FittedCurve& design, CurveWork& work) {
    descend(problem, design, evaluations_to_settle, settled_within, work);
}

}  // namespace mechwright
