#pragma once
/// \file
/// By how much the joints of a larger group miss each other where it closes nowhere: least squares from many places
/// (Levenberg and Marquardt; Nocedal and Wright, Numerical Optimization, section 10.3).

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "analysis/linkage/groups/factors.h"
#include "analysis/linkage/motion/driven.h"

namespace mechwright::linkage {

namespace detail {

/// What the equations of a group miss together, and how to make it less.
class Misses {
public:
    Misses(Driven<double>& driven, std::size_t group)
        : driven_(driven),
          solver_(driven.groups[group]),
          normal_(solver_.unknowns()),
          missed_(solver_.unknowns()),
          column_(solver_.unknowns()) {}

    double sum_of_squares(const std::vector<double>& places) {
        solver_.write(std::span<const double>(places), driven_.pose);
        solver_.residual(driven_.pose, driven_.inputs(), missed_);
        double sum = 0;
        for (const double each : missed_)
            sum += each * each;
        return sum;
    }
    /// The least sum of squares near some places.
    double reduced(std::vector<double> places) {
        constexpr int most = 60;
        const std::size_t n = places.size();
        double sum = sum_of_squares(places), damping = 1e-2;
        std::vector<double> step(n);
        for (int i = 0; i < most && damping < 1e9; ++i) {
            sum_of_squares(places);
            linearise();
            for (std::size_t j = 0; j < n; ++j)
                for (std::size_t k = 0; k < n; ++k) {
                    double product = j == k ? damping : 0;
                    for (std::size_t e = 0; e < n; ++e)
                        product += slopes_[j][e] * slopes_[k][e];
                    normal_.at(j, k) = product;
                }
            for (std::size_t j = 0; j < n; ++j) {
                step[j] = 0;
                for (std::size_t e = 0; e < n; ++e)
                    step[j] += slopes_[j][e] * missed_[e];
            }
            if (normal_.factor() == 0) return sum;
            normal_.solve(step);
            std::vector<double> next = places;
            for (std::size_t j = 0; j < n; ++j)
                next[j] -= step[j] * solver_.unit(j);
            if (const double then = sum_of_squares(next); then < sum) {
                const bool settled = then > (1 - 1e-9) * sum;
                sum = then;
                places = std::move(next);
                damping = std::max(0.1 * damping, 1e-12);
                if (settled) break;
            } else {
                damping *= 10;
            }
        }
        return sum;
    }

private:
    /// The derivatives by each unknown, at the pose in which it stands.
    void linearise() {
        slopes_.assign(missed_.size(), {});
        for (std::size_t j = 0; j < slopes_.size(); ++j) {
            std::fill(column_.begin(), column_.end(), 0.0);
            column_[j] = solver_.unit(j);
            slopes_[j].resize(missed_.size());
            solver_.along(driven_.pose, driven_.inputs(), column_, slopes_[j]);
        }
    }

    Driven<double>& driven_;
    GroupSolver<double>& solver_;
    Factors normal_;
    std::vector<double> missed_, column_;
    std::vector<std::vector<double>> slopes_;
};

}  // namespace detail

/// The root of the sum of squares of what the group's equations miss at least, as lengths, in the pose of a linkage in
/// which all that it hangs on is placed; of what is found from several places.
inline double least_missing(Driven<double>& driven, std::size_t group) {
    constexpr int starts = 12;
    detail::Misses misses(driven, group);
    const GroupSolver<double>& solver = driven.groups[group];
    std::mt19937_64 draw(1);
    const auto number = [&draw] { return static_cast<double>(draw() >> 11) * 0x1p-52 - 1; };
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < starts; ++i) {
        std::vector<double> places;
        for (std::size_t k = 0; k < solver.unknowns(); ++k)
            places.push_back(number() * (solver.group().unknowns[k].part == 2 ? std::numbers::pi : solver.size()));
        least = std::min(least, misses.reduced(std::move(places)));
    }
    return std::sqrt(least);
}

}  // namespace mechwright::linkage
