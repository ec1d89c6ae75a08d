#include "synthesis/proof/branch_and_bound.h"

#include <algorithm>
#include <cmath>

#include "synthesis/search/work_sharing.h"

namespace mechwright {

namespace {

/// Boxes that are divided together, and tasks that they are shared out in; fixed, so that the order in which boxes are
/// divided is too.
constexpr std::size_t most_at_once = 4096;
constexpr std::size_t per_task = 64;
/// Boxes kept at most: about half a gigabyte.
constexpr std::size_t most_boxes = 5000000;

struct Open {
    Box box;
    double least;
    std::size_t split;
};

bool later(const Open& a, const Open& b) { return a.least > b.least; }

/// Both halves of a box.
std::array<Box, 2> halves(const Open& open) {
    std::array<Box, 2> both{open.box, open.box};
    const std::size_t k = open.split;
    const double quarter = 0.5 * open.box.half[k];
    for (Box& box : both)
        box.half[k] = quarter;
    both[0].middle[k] -= quarter;
    both[1].middle[k] += quarter;
    return both;
}

}  // namespace

LowerBound lower_bound(std::vector<Box> boxes, const std::function<BoxBound(const Box&)>& bound, double target,
                       const RunOptions& options, std::chrono::steady_clock::time_point deadline) {
    LowerBound result{0, false};
    std::vector<Open> open;  // a heap, the least bound first
    std::vector<double> inherited(boxes.size(), 0);
    const auto stopped = [&] {
        return (options.stop && options.stop->load()) || std::chrono::steady_clock::now() >= deadline ||
               open.size() > most_boxes;
    };
    while (true) {
        std::vector<BoxBound> bounds(boxes.size());
        const std::size_t tasks = (boxes.size() + per_task - 1) / per_task;
        share_work(static_cast<int>(tasks), options.jobs, [&](int task) {
            const std::size_t first = static_cast<std::size_t>(task) * per_task;
            for (std::size_t i = first; i < std::min(first + per_task, boxes.size()); ++i)
                bounds[i] = bound(boxes[i]);
        });
        result.boxes += static_cast<long>(boxes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const double least = std::fmax(bounds[i].least, inherited[i]);
            if (least >= target) continue;
            open.push_back({boxes[i], least, bounds[i].split});
            std::push_heap(open.begin(), open.end(), later);
        }
        if (open.empty()) {
            result.least = target;
            result.reached = true;
            return result;
        }
        result.least = open.front().least;
        if (stopped()) return result;
        boxes.clear();
        inherited.clear();
        for (std::size_t k = 0; k < most_at_once && !open.empty(); ++k) {
            std::pop_heap(open.begin(), open.end(), later);
            for (const Box& half : halves(open.back())) {
                boxes.push_back(half);
                inherited.push_back(open.back().least);
            }
            open.pop_back();
        }
    }
}

}  // namespace mechwright
