#include "synthesis/search/curve/bounded_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mechwright {

namespace {

constexpr double none = std::numeric_limits<double>::infinity();
/// A limit that is passed by no more than this is kept.
constexpr double rounding_of_limit = 1e-14;
/// What of a limit's normal the limits that hold leave, as a part of its square; below it they leave nothing.
constexpr double nothing_left = 1e-12;
constexpr int most_changes = 60;

struct Holding {
    std::size_t limit;
    double multiplier;
};

/// A step, the limits that hold it, and how it goes towards one more.
struct DualStep {
    const Eigen::LLT<StepMatrix>& factors;
    const StepLimits& limits;
    StepVector step;
    boost::container::static_vector<Holding, most_curve_arguments> holding{};

    double kept(std::size_t limit) const { return limits[limit].normal.dot(step) - limits[limit].least; }

    bool holds(std::size_t limit) const {
        return std::any_of(holding.begin(), holding.end(), [&](const Holding& h) { return h.limit == limit; });
    }

    /// The limit that is passed the farthest; the number of limits where none is.
    std::size_t passed() const {
        std::size_t worst = limits.size();
        double least = -rounding_of_limit;
        for (std::size_t i = 0; i < limits.size(); ++i)
            if (const double here = kept(i); here < least && !holds(i)) {
                least = here;
                worst = i;
            }
        return worst;
    }

    /// Takes the step to a limit that it passes. False: no step keeps to all, to rounding.
    bool take_to(std::size_t limit) {
        const StepVector& normal = limits[limit].normal;
        double multiplier = 0;
        for (int change = 0; change < most_changes; ++change) {
            const auto count = static_cast<Eigen::Index>(holding.size());
            StepVector way = factors.solve(normal);
            const double square = normal.dot(way);
            StepVector rates(count);
            if (count > 0) {
                StepMatrix normals(normal.size(), count);
                for (Eigen::Index i = 0; i < count; ++i)
                    normals.col(i) = limits[holding[static_cast<std::size_t>(i)].limit].normal;
                const StepMatrix solved = factors.solve(normals);
                const StepMatrix gram = normals.transpose() * solved;
                rates = gram.llt().solve(StepVector(normals.transpose() * way));
                way -= solved * rates;
            }
            // How far until a limit that holds does so no longer, and how far to this one.
            double until_free = none;
            std::size_t freed = 0;
            for (std::size_t i = 0; i < holding.size(); ++i)
                if (const double rate = rates[static_cast<Eigen::Index>(i)];
                    rate > 0 && holding[i].multiplier / rate < until_free) {
                    until_free = holding[i].multiplier / rate;
                    freed = i;
                }
            const double gain = normal.dot(way);
            const bool moves = gain > nothing_left * square && holding.size() < holding.capacity();
            const double until_there = moves ? -kept(limit) / gain : none;
            const double far = std::min(until_free, until_there);
            if (!(far < none)) return false;
            if (moves) step += far * way;
            for (std::size_t i = 0; i < holding.size(); ++i)
                holding[i].multiplier -= far * rates[static_cast<Eigen::Index>(i)];
            multiplier += far;
            if (until_there <= until_free) {
                holding.push_back({limit, multiplier});
                return true;
            }
            holding.erase(holding.begin() + static_cast<std::ptrdiff_t>(freed));
        }
        return false;
    }
};

}  // namespace

StepVector bounded_step(const Eigen::LLT<StepMatrix>& factors, const StepVector& slope, const StepLimits& limits) {
    DualStep dual{factors, limits, -factors.solve(slope)};
    for (int change = 0; change < most_changes; ++change) {
        const std::size_t limit = dual.passed();
        if (limit == limits.size() || !dual.take_to(limit)) break;
    }
    return dual.step;
}

}  // namespace mechwright
