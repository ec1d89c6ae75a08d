// The most uniform cutting speed: SLSQP, Ipopt and a dense scan agree, and the optimum has as many equal extremes as a
// minimax of its free dimensions must have. The scan has formulas of its own: positions by plain geometry on many crank
// angles, speeds by their differences.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "analysis/quick_return.h"
#include "synthesis/mechanism/crank_shaper/layout.h"
#include "synthesis/mechanism/drag_link/layout.h"
#include "synthesis/mechanism/quick_return/drive.h"
#include "synthesis/mechanism/whitworth/layout.h"
#include "tests/degree.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

constexpr double share = 0.6;
constexpr int samples = 1440;

/// (greatest - least) / mean speed on the middle share of the slow stroke, from positions at even crank angles.
double variation_by_scan(const std::vector<double>& position) {
    const int n = static_cast<int>(position.size());
    const auto at = [&](int i) { return position[static_cast<std::size_t>(((i % n) + n) % n)]; };
    const int top = static_cast<int>(std::max_element(position.begin(), position.end()) - position.begin());
    const int bottom = static_cast<int>(std::min_element(position.begin(), position.end()) - position.begin());
    const int out = ((top - bottom) % n + n) % n;
    const bool outward = 2 * out >= n;
    const int begin = outward ? bottom : top, length = outward ? out : n - out;
    const double stroke = at(top) - at(bottom), sign = outward ? 1 : -1;
    const double h = 2 * std::numbers::pi / n;
    const auto travelled = [&](int i) { return sign * (at(begin + i) - at(begin)) / stroke; };
    const auto speed = [&](int i) { return sign * (at(begin + i + 1) - at(begin + i - 1)) / (2 * h); };
    const double margin = 0.5 * (1 - share);
    double from = 0, to = 0, least = 1e300, greatest = 0;
    const auto consider = [&](double v) {
        least = std::min(least, v);
        greatest = std::max(greatest, v);
    };
    for (int i = 1; i < length; ++i) {
        const double a = travelled(i), b = travelled(i + 1);
        for (const double limit : {margin, 1 - margin})
            if (a < limit && b >= limit) {  // an end of the working part
                const double part = (limit - a) / (b - a);
                consider(speed(i) + part * (speed(i + 1) - speed(i)));
                (limit == margin ? from : to) = (i + part) * h;
            }
        if (a >= margin && a <= 1 - margin) consider(speed(i));
    }
    return (greatest - least) * (to - from) / (share * stroke);
}

std::vector<double> turn_of(const std::function<double(double)>& position) {
    std::vector<double> all;
    for (int i = 0; i < samples; ++i)
        all.push_back(position(2 * std::numbers::pi * i / samples));
    return all;
}

/// The least of a function on a grid over a box, then on ever smaller grids around the best; not finite: no design.
template <std::size_t N>
double least_on_grids(std::array<double, N> low, std::array<double, N> high, int steps, int rounds,
                      const std::function<double(const std::array<double, N>&)>& f) {
    const auto box_low = low, box_high = high;
    double least = 1e300;
    std::array<double, N> best = low;
    for (int round = 0; round < rounds; ++round) {
        std::size_t count = 1;
        for (std::size_t k = 0; k < N; ++k)
            count *= static_cast<std::size_t>(steps + 1);
        for (std::size_t i = 0; i < count; ++i) {
            std::array<double, N> x;
            std::size_t rest = i;
            for (std::size_t k = 0; k < N; ++k, rest /= static_cast<std::size_t>(steps + 1))
                x[k] = low[k] +
                       (high[k] - low[k]) * static_cast<double>(rest % static_cast<std::size_t>(steps + 1)) / steps;
            if (const double value = f(x); value < least) {
                least = value;
                best = x;
            }
        }
        for (std::size_t k = 0; k < N; ++k) {
            const double reach = 1.5 * (high[k] - low[k]) / steps;
            low[k] = std::max(box_low[k], best[k] - reach);
            high[k] = std::min(box_high[k], best[k] + reach);
        }
    }
    return least;
}

/// How many of the speeds at the ends of the working part and at its stationary points are the greatest or the least.
template <template <class> class Drive>
int equal_extremes(const Solved& s) {
    const Drive<double> m =
        quick_return::drive_of<Drive>(s.result.best->design.dimensions, s.result.best->design.assembly);
    const auto part = working_part(m, share);
    std::vector<double> speeds{std::abs(ram_velocity(m, part.from)), std::abs(ram_velocity(m, part.to))};
    const auto extremes = ram_velocity_extremes(m, CrankRange<double>{false, part.from, part.to});
    for (const double x : extremes.all())
        speeds.push_back(std::abs(ram_velocity(m, x)));
    const auto [least, greatest] = std::minmax_element(speeds.begin(), speeds.end());
    return static_cast<int>(std::count_if(speeds.begin(), speeds.end(), [&](double v) {
        return v - *least <= 1e-7 * *greatest || *greatest - v <= 1e-7 * *greatest;
    }));
}

/// Both methods agree with each other and with the scan, which knows about five digits.
void expect_optimum(const Solved& slsqp, const Solved& ipopt, double scanned) {
    ASSERT_EQ(slsqp.result.status, Status::solved);
    ASSERT_EQ(ipopt.result.status, Status::solved);
    EXPECT_NEAR(slsqp.value("speed-variation"), ipopt.value("speed-variation"), 1e-9);
    EXPECT_GE(scanned, slsqp.value("speed-variation") * (1 - 2e-5));
    EXPECT_LE(scanned, slsqp.value("speed-variation") * (1 + 3e-3));
}

TEST(UniformSpeed, OfACrankShaper) {
    const Solved a = solved(shipped("uniform-speed-crank-shaper.toml", "quick-return"), "slsqp");
    const Solved b = solved(shipped("uniform-speed-crank-shaper.toml", "quick-return"), "ipopt");
    const auto variation = [](double rod, double ram_distance) {
        return variation_by_scan(turn_of([&](double angle) {
            const double lever = std::atan2(std::sin(angle), 2 + std::cos(angle));  // crank half the centre distance
            const double below = ram_distance - 200 * std::cos(lever);
            return 200 * std::sin(lever) + std::sqrt(rod * rod - below * below);
        }));
    };
    // The best ram distance for every rod: together they would have to be followed down a valley with a sharp floor.
    const double scanned = least_on_grids<1>({150}, {500}, 24, 3, [&](const std::array<double, 1>& rod) {
        return least_on_grids<1>({100}, {300}, 24, 5, [&](const std::array<double, 1>& ram_distance) {
            return variation(rod[0], ram_distance[0]);
        });
    });
    expect_optimum(a, b, scanned);
    EXPECT_NEAR(a.dimension("rod"), 150, 1e-9);
    EXPECT_GE(equal_extremes<CrankShaper>(a), 3);  // the ram distance is free
}

TEST(UniformSpeed, OfAWhitworthDrive) {
    const Solved a = solved(shipped("uniform-speed-whitworth.toml", "quick-return"), "slsqp");
    const Solved b = solved(shipped("uniform-speed-whitworth.toml", "quick-return"), "ipopt");
    const double scanned = least_on_grids<2>({150, 31}, {500, 149}, 24, 4, [](const std::array<double, 2>& x) {
        const double rod = x[0], slide = x[1] * degree;
        const double crank = 2 * std::sin(slide);  // centre distance 1; time ratio 2
        if (crank < 1.05) return 1e300;
        return variation_by_scan(turn_of([&](double angle) {
            const double arm =
                std::atan2(crank * std::sin(angle), 1 + crank * std::cos(angle)) + std::numbers::pi - slide;
            const double across = 100 * std::sin(arm);
            return 100 * std::cos(arm) + std::sqrt(rod * rod - across * across);
        }));
    });
    expect_optimum(a, b, scanned);
    EXPECT_NEAR(a.dimension("rod"), 500, 1e-9);
    EXPECT_GE(equal_extremes<Whitworth>(a), 3);  // the slide angle is free, with it goes the crank
}

/// Follower angles over a turn, continued; empty unless crank and follower turn fully with transmission angles of at
/// least 45 deg. Ground link 100, open assembly.
std::vector<double> follower_turn(double crank, double coupler, double follower) {
    const auto transmission = [&](double diagonal) {
        return std::acos((coupler * coupler + follower * follower - diagonal * diagonal) / (2 * coupler * follower));
    };
    const double near = transmission(crank - 100), far = transmission(crank + 100);
    constexpr double rounding = 1e-9;  // at the optimum itself the transmission angle is at its limit
    if (!(near >= std::numbers::pi / 4 - rounding && far <= 3 * std::numbers::pi / 4 + rounding)) return {};
    std::vector<double> angles;
    for (int i = 0; i < samples; ++i) {
        const double x = 2 * std::numbers::pi * i / samples;
        const double dx = 100 - crank * std::cos(x), dy = -crank * std::sin(x), q = dx * dx + dy * dy;
        const double along = (1 + (coupler * coupler - follower * follower) / q) / 2;
        const double across =
            std::sqrt(std::pow(coupler + follower, 2) - q) * std::sqrt(q - std::pow(coupler - follower, 2)) / (2 * q);
        const double px = along * dx - across * dy - dx, py = along * dy + across * dx - dy;
        double angle = std::atan2(py, px);
        if (!angles.empty()) angle = angles.back() + std::remainder(angle - angles.back(), 2 * std::numbers::pi);
        angles.push_back(angle);
    }
    return angles;
}

/// The least variation over the slide angles that give time ratio 2.
double best_slide(const std::vector<double>& follower, double rod) {
    const int n = static_cast<int>(follower.size());
    // The crank takes 240 deg from a follower angle to the opposite one, or 120: at samples beside such places.
    const auto turned = [&](int i) {
        return follower[static_cast<std::size_t>(i % n)] + 2 * std::numbers::pi * (i / n);
    };
    double least = 1e300;
    for (const int slow : {2 * n / 3, n / 3}) {
        const auto off = [&](int i) { return turned(i + slow) - turned(i) - std::numbers::pi; };
        for (int i = 0; i < n; ++i) {
            if ((off(i) > 0) == (off(i + 1) > 0)) continue;
            const double part = off(i) / (off(i) - off(i + 1));
            const double slide = turned(i) + part * (turned(i + 1) - turned(i));
            std::vector<double> position;
            for (const double angle : follower) {
                const double across = 100 * std::sin(angle - slide);
                position.push_back(100 * std::cos(angle - slide) + std::sqrt(rod * rod - across * across));
            }
            least = std::min(least, variation_by_scan(position));
        }
    }
    return least;
}

TEST(UniformSpeed, OfADragLink) {
    const Solved a = solved(shipped("uniform-speed-drag-link.toml", "quick-return"), "slsqp");
    const Solved b = solved(shipped("uniform-speed-drag-link.toml", "quick-return"), "ipopt");
    ASSERT_EQ(a.result.status, Status::solved);
    EXPECT_NEAR(a.value("speed-variation"), b.value("speed-variation"), 1e-8);
    const auto variation = [](const std::array<double, 4>& x) {
        const auto follower = follower_turn(x[0], x[1], x[2]);
        return follower.empty() ? 1e300 : best_slide(follower, x[3]);
    };
    // Nothing better anywhere on a coarse grid, nor on fine ones with the optimum in their middle.
    const double optimum = a.value("speed-variation");
    const int coarse = cases_to_try(7, 9), fine = cases_to_try(6, 8);
    EXPECT_GE(least_on_grids<4>({105, 105, 105, 150}, {400, 400, 400, 500}, coarse, cases_to_try(2, 3), variation),
              optimum * (1 - 1e-4));
    std::array<double, 4> low, high;
    const std::array names{"crank", "coupler", "follower", "rod"};
    for (std::size_t k = 0; k < 4; ++k) {
        const double length = a.dimension(names[k]);
        low[k] = std::max(0.99 * length, k == 3 ? 150.0 : 105.0);
        high[k] = std::min(1.01 * length, k == 3 ? 500.0 : 400.0);
    }
    const double near = least_on_grids<4>(low, high, fine, 4, variation);
    EXPECT_GE(near, optimum * (1 - 1e-4));
    EXPECT_LE(near, optimum * (1 + 3e-3));
    EXPECT_GE(equal_extremes<DragLink>(a), 3);
}

}  // namespace

}  // namespace mechwright
