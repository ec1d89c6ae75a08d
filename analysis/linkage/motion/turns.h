#pragma once
/// \file
/// How far the links of a linkage have turned along its motion: directions alone leave out whole turns, which gears and
/// angle signals need.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "analysis/linkage/motion/driven.h"

namespace mechwright::linkage {

/// Turns of all links at inputs of the master so close together that no link turns far between them.
class Turns {
public:
    Turns() = default;
    /// Follows the links over [from, to], from turns near `start` (in (-pi, pi] where that is empty). Ends early where
    /// the linkage does not close.
    Turns(Driven<double>& driven, double from, double to, std::span<const double> start = {})
        : links_(driven.pose.links.size()) {
        constexpr double widest_step = std::numbers::pi / 16, narrowest = 1e-12, farthest_turn = 0.5;
        std::vector<double> last(links_, 0.0), next(links_);
        if (!start.empty()) last.assign(start.begin(), start.end());
        double at = from;
        if (!step_to(driven, at, last, next)) return;
        add(at, next);
        double step = std::min(widest_step, (to - from) / 16);
        while (at < to) {
            last.assign(turns_.end() - static_cast<std::ptrdiff_t>(links_), turns_.end());
            const double there = at + step < to ? at + step : to;
            if (!step_to(driven, there, last, next)) return;
            double farthest = 0;
            for (std::size_t i = 0; i < links_; ++i)
                farthest = std::max(farthest, std::abs(next[i] - last[i]));
            if (farthest > farthest_turn && there - at > narrowest * (1 + std::abs(at))) {
                step = 0.5 * (there - at);
                continue;
            }
            add(there, next);
            at = there;
            step = std::min(widest_step, 2 * step);
        }
    }

    bool empty() const { return at_.empty(); }
    /// How far they are known.
    double from() const { return at_.front(); }
    double to() const { return at_.back(); }

    /// Those of all links at the nearest input at which they are known: less than half a turn from those at `master`.
    std::span<const double> near(double master) const {
        if (at_.empty()) return {};
        auto next = static_cast<std::size_t>(std::lower_bound(at_.begin(), at_.end(), master) - at_.begin());
        if (next == at_.size() || (next > 0 && master - at_[next - 1] < at_[next] - master)) --next;
        return {turns_.data() + next * links_, links_};
    }

    /// The turns of all links of a pose, from turns that are near.
    static void of(const Pose<double>& pose, std::span<const double> near, std::span<double> turns) {
        for (std::size_t i = 0; i < pose.links.size(); ++i)
            turns[i] = detail::unwound(std::atan2(pose.links[i].along.y, pose.links[i].along.x), near[i]);
    }

private:
    static bool step_to(Driven<double>& driven, double at, std::span<const double> near, std::span<double> turns) {
        if (!driven.place(at, near)) return false;
        of(driven.pose, near, turns);
        return true;
    }
    void add(double at, const std::vector<double>& turns) {
        at_.push_back(at);
        turns_.insert(turns_.end(), turns.begin(), turns.end());
    }

    std::size_t links_ = 0;
    std::vector<double> at_, turns_;
};

}  // namespace mechwright::linkage
