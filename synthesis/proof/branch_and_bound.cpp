#include "synthesis/proof/branch_and_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "synthesis/program/work_sharing.h"

namespace mechwright {

namespace {

/// Boxes that are divided together, and tasks that they are shared out in; fixed, so that the order in which boxes are
/// divided is too.
constexpr std::size_t most_at_once = 2048;
constexpr std::size_t per_task = 64;
/// Boxes put aside for the next stage; where there are more, it starts anew.
constexpr std::size_t most_aside = 4000000;
/// Parts of the target that are reached one after the other.
constexpr std::array<double, 5> stages{0.1, 0.3, 0.6, 0.9, 1};

/// Both halves of a box.
std::array<Box, 2> halves(const Box& box, std::size_t parameter) {
    std::array<Box, 2> both{box, box};
    const double quarter = 0.5 * box.half[parameter];
    for (Box& half : both)
        half.half[parameter] = quarter;
    both[0].middle[parameter] -= quarter;
    both[1].middle[parameter] += quarter;
    return both;
}

struct Search {
    const std::function<BoxBound(const Box&)>& bound;
    const RunOptions& options;
    std::chrono::steady_clock::time_point deadline;
    double target;
    long boxes = 0;
    double reached = 0;  ///< part of the target

    bool stopped() const {
        return (options.stop && options.stop->load()) || std::chrono::steady_clock::now() >= deadline;
    }

    /// Where the run ends before, not of all: none of them counts then.
    std::vector<BoxBound> bounds_of(const std::vector<Box>& some) {
        std::vector<BoxBound> bounds(some.size());
        const std::size_t tasks = (some.size() + per_task - 1) / per_task;
        share_work(static_cast<int>(tasks), options.jobs, [&](int task) {
            const std::size_t first = static_cast<std::size_t>(task) * per_task;
            for (std::size_t i = first; i < std::min(first + per_task, some.size()) && !stopped(); ++i)
                bounds[i] = bound(some[i]);
        });
        boxes += static_cast<long>(some.size());
        return bounds;
    }

    enum class Outcome { reached, missed, ended };

    /// Whether every box is bounded by the stage, the last ones divided being looked at first: few are then open at a
    /// time. Boxes without extension cannot be divided: with them it is missed. Boxes that are bounded by the stage but
    /// not by the target are put aside; one more than is allowed says that some are missing.
    Outcome reach(double stage, std::vector<Box> open, std::vector<Box>& aside) {
        while (!open.empty()) {
            if (stopped()) return Outcome::ended;
            const std::size_t count = std::min(most_at_once, open.size());
            const std::vector<Box> some(open.end() - static_cast<std::ptrdiff_t>(count), open.end());
            open.resize(open.size() - count);
            const std::vector<BoxBound> bounds = bounds_of(some);
            if (stopped()) return Outcome::ended;
            if (options.bounding) options.bounding(reached, boxes);
            for (std::size_t i = 0; i < count; ++i) {
                if (bounds[i].least >= target) continue;
                if (bounds[i].least >= stage) {
                    if (aside.size() <= most_aside) aside.push_back(some[i]);
                    continue;
                }
                if (!(some[i].half[bounds[i].split] > 0)) return Outcome::missed;
                for (const Box& half : halves(some[i], bounds[i].split))
                    open.push_back(half);
            }
        }
        return Outcome::reached;
    }
};

}  // namespace

LowerBound lower_bound(const std::vector<Box>& boxes, const std::function<BoxBound(const Box&)>& bound, double target,
                       const RunOptions& options, std::chrono::steady_clock::time_point deadline) {
    Search search{bound, options, deadline, target};
    LowerBound result{0, false};
    std::vector<Box> open = boxes;
    for (const double part : stages) {
        std::vector<Box> aside;
        const Search::Outcome outcome = search.reach(part * target, std::move(open), aside);
        result.boxes = search.boxes;
        if (outcome != Search::Outcome::reached) {
            result.ended = outcome == Search::Outcome::ended;
            return result;
        }
        result.least = part * target;
        search.reached = part;
        open = aside.size() > most_aside ? boxes : std::move(aside);
    }
    result.reached = true;
    return result;
}

}  // namespace mechwright
