// The extremes of the velocity ratio: every one that a dense scan finds, and no others, at their exact places.

#include "analysis/four_bar/velocity_ratio.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/analysis/precise.h"
#include "tests/analysis/random_linkages.h"

namespace mechwright::test {
namespace {

constexpr double pi_ = std::numbers::pi;

/// Even steps, and steps that shrink towards the ends and the multiples of pi.
std::vector<double> dense_scan(double from, double to, int count) {
    std::vector<double> angles;
    for (int i = 1; i < count; ++i)
        angles.push_back(from + (to - from) * i / count);
    for (const double centre : {from, to, 0.0, pi_, 2 * pi_})
        for (double step = (to - from) / 8; step > 1e-12 * (to - from); step *= 0.98)
            for (const double x : {centre - step, centre + step})
                if (x > from && x < to) angles.push_back(x);
    std::sort(angles.begin(), angles.end());
    return angles;
}

struct Bracket {
    double left, right;
};

std::vector<Bracket> sign_changes(const FourBar<double>& m, Assembly assembly, const std::vector<double>& angles) {
    std::vector<Bracket> found;
    double last = angles.front();
    bool rising = velocity_ratio_slope(m, last, assembly) > 0;
    for (const double x : angles) {
        const bool now = velocity_ratio_slope(m, x, assembly) > 0;
        if (now != rising) found.push_back({last, x});
        rising = now;
        last = x;
    }
    return found;
}

/// How many of the brackets of a scan hold none of the angles, and how many angles lie in no bracket. The ratio of a
/// linkage that is nearly a parallelogram hardly changes: rounding moves its extremes by up to 1e-7 there.
struct Mismatch {
    int missed = 0, invented = 0;
};

Mismatch mismatch(const std::vector<Bracket>& brackets, std::vector<double> angles) {
    Mismatch m;
    for (const Bracket& b : brackets) {
        const auto inside = [&](double x) { return x >= b.left - 1e-6 && x <= b.right + 1e-6; };
        const auto hit = std::find_if(angles.begin(), angles.end(), inside);
        if (hit == angles.end())
            ++m.missed;
        else
            angles.erase(hit);
    }
    m.invented = static_cast<int>(angles.size());
    return m;
}

void expect_what_the_scan_finds(const FourBar<double>& m, Assembly assembly, int count) {
    const auto range = assembled_range(m);
    ASSERT_TRUE(range.full_turn);
    const auto extremes = velocity_ratio_extremes(m, assembly, range);
    const std::vector<double> angles(extremes.at.begin(), extremes.at.begin() + extremes.count);
    EXPECT_TRUE(std::is_sorted(angles.begin(), angles.end()));
    for (const double x : angles)
        EXPECT_TRUE(x >= 0 && x < 2 * pi_);
    // The seam of the scan lies at one radian, and the angles follow it there.
    std::vector<double> turned = angles;
    for (double& x : turned)
        x = x < 1 ? x + 2 * pi_ : x;
    auto scan = dense_scan(0, 2 * pi_, count);
    for (double& x : scan)
        x = x < 1 ? x + 2 * pi_ : x;
    scan.push_back(1);
    scan.push_back(1 + 2 * pi_);
    std::sort(scan.begin(), scan.end());
    const Mismatch wrong = mismatch(sign_changes(m, assembly, scan), turned);
    EXPECT_EQ(wrong.missed, 0) << m.ground << ' ' << m.crank << ' ' << m.coupler << ' ' << m.rocker;
    EXPECT_EQ(wrong.invented, 0) << m.ground << ' ' << m.crank << ' ' << m.coupler << ' ' << m.rocker;
}

TEST(VelocityRatioExtremes, AreThoseOfAScanOfAHundredThousandPoints) {
    Random random(4);
    for (int i = 0; i < 100; ++i)
        expect_what_the_scan_finds(turning_linkage(random, 0.05), random.assembly(), 100000);
}

TEST(VelocityRatioExtremes, AreThoseOfAScanCloseToAChangePoint) {
    Random random(5);
    for (int i = 0; i < 180; ++i) {
        // One margin, then two, of 1e-2 to 1e-9.
        const double p = std::pow(10, -2 - 7 * random.between(0, 1)), q = i % 2 == 0 ? random.between(0.2, 2) : p,
                     s = random.between(0.2, 2), shortest = random.between(0.2, 1);
        const double margins[3]{p, q, s};
        const int turn = i % 3;
        const double a = margins[turn], b = margins[(turn + 1) % 3], c = margins[(turn + 2) % 3];
        const auto m = random.coin() ? crank_rocker(shortest, a, b, c) : double_crank(shortest, a, b, c);
        expect_what_the_scan_finds(m, random.assembly(), 20000);
    }
}

TEST(VelocityRatioExtremes, BetweenTogglesAreThoseOfAScanAndTheEnds) {
    Random random(6);
    int limited = 0;
    while (limited < 300) {
        const double spread = random.log_between(0.01, 2);
        const auto length = [&] { return std::exp(random.between(-spread, spread)); };
        const FourBar<double> m{length(), length(), length(), length()};
        const auto range = assembled_range(m);
        if (range.full_turn || range.from > range.to) continue;
        ++limited;
        const Assembly assembly = random.assembly();
        const auto extremes = velocity_ratio_extremes(m, assembly, range);
        ASSERT_GE(extremes.count, 2u);
        EXPECT_EQ(extremes.at[0], range.from);
        EXPECT_EQ(extremes.at[extremes.count - 1], range.to);
        const std::vector<double> inside(extremes.at.begin() + 1, extremes.at.begin() + extremes.count - 1);
        EXPECT_TRUE(std::is_sorted(inside.begin(), inside.end()));
        const Mismatch wrong = mismatch(sign_changes(m, assembly, dense_scan(range.from, range.to, 5000)), inside);
        EXPECT_EQ(wrong.missed + wrong.invented, 0)
            << m.ground << ' ' << m.crank << ' ' << m.coupler << ' ' << m.rocker;
    }
}

TEST(VelocityRatioExtremes, OfAPartOfTheTurnLieInsideIt) {
    const FourBar<double> m{100, 25, 90, 75};
    const auto all = velocity_ratio_extremes(m, Assembly::open, {true, 0, 2 * pi_});
    ASSERT_EQ(all.count, 2u);
    const double first = all.at[0], second = all.at[1];
    const auto count_between = [&](double from, double to) {
        return velocity_ratio_extremes(m, Assembly::open, {false, from, to}).count;
    };
    EXPECT_EQ(count_between(first - 0.1, second + 0.1), 4u);
    EXPECT_EQ(count_between(first + 0.1, second - 0.1), 2u);
    EXPECT_EQ(count_between(first - 0.1, first + 0.1), 3u);
    EXPECT_EQ(count_between(first - 0.1 + 8 * pi_, first + 0.1 + 8 * pi_), 3u);
    EXPECT_EQ(count_between(first - 0.1 - 2 * pi_, first + 0.1 - 2 * pi_), 3u);
    EXPECT_EQ(count_between(0, 20 * pi_), 4u);  // the first turn says everything
    EXPECT_EQ(count_between(0.3, 0.3), 2u);
    EXPECT_GE(count_between(1e17, 1e17 + 64), 2u);  // angles without digits: nothing to find, but an end of the search
}

// Freudenstein: where the ratio is extreme the collineation axis, through the intersections of crank with rocker line
// and of coupler with ground line, is perpendicular to the coupler.
TEST(VelocityRatioExtremes, HaveTheCollineationAxisSquareToTheCoupler) {
    Random random(7);
    int checked = 0;
    while (checked < 200) {
        const auto m = turning_linkage(random, 0.1);
        const Assembly assembly = random.assembly();
        const auto cosine = [&](double theta) {
            const auto p = pose(m, theta, assembly);
            // A0 + a crank = B0 + b rocker; A + c coupler = (x, 0)
            const Vector<double> ground{m.ground, 0};
            const double a = cross(ground, p.rocker) / cross(p.crank, p.rocker);
            const Vector<double> pin = m.crank * p.crank;
            const double x = pin.x - p.coupler.x * pin.y / p.coupler.y;
            const Vector<double> axis = a * p.crank - Vector<double>{x, 0};
            return dot(axis, p.coupler) / std::hypot(axis.x, axis.y);
        };
        const auto extremes = velocity_ratio_extremes(m, assembly, assembled_range(m));
        for (std::size_t i = 0; i < extremes.count; ++i) {
            const double at = extremes.at[i];
            const auto p = pose(m, at, assembly);
            if (std::abs(cross(p.crank, p.rocker)) < 0.05 || std::abs(p.coupler.y) < 0.05) continue;  // parallel lines
            ++checked;
            EXPECT_NEAR(cosine(at), 0, 1e-11);
            // Elsewhere it is not square: the angle crosses a right one.
            EXPECT_LT(cosine(at - 1e-3) * cosine(at + 1e-3), 0);
        }
    }
}

TEST(VelocityRatioExtremes, AreExactToRounding) {
    Random random(8);
    for (int i = 0; i < 30; ++i) {
        const auto m = turning_linkage(random, 0.1);
        const Assembly assembly = random.assembly();
        const auto extremes = velocity_ratio_extremes(m, assembly, assembled_range(m));
        const auto slope = [&](double x) { return velocity_ratio_slope(precise(m), Precise(x), assembly); };
        for (std::size_t k = 0; k < extremes.count; ++k) {
            const double x = extremes.at[k], h = 1e-13;
            EXPECT_LT(slope(x - h) * slope(x + h), 0);
        }
    }
}

TEST(VelocityRatio, HasTwoValuesAtAChangePoint) {
    // Of a parallelogram: that of parallel cranks, and that of the contraparallelogram; folded and stretched.
    for (const bool away : {false, true}) {
        const auto ratios = velocity_ratios_at_change_point(FourBar<double>{100, 40, 100, 40}, away);
        const double contrary = away ? -60.0 / 140 : -140.0 / 60;
        EXPECT_NEAR(ratios[0], contrary, 1e-14);
        EXPECT_NEAR(ratios[1], 1, 1e-14);
    }
    // Others are what the ratio tends to on either side, by Richardson's extrapolation.
    const FourBar<double> folding{75, 51, 65, 89};
    const auto ratios = velocity_ratios_at_change_point(folding, false);
    for (const int side : {-1, 1}) {
        const auto near = [&](double step) { return velocity_ratio(folding, side * step, Assembly::open); };
        const double limit = 2 * near(1e-5) - near(2e-5);
        EXPECT_NEAR(std::min(std::abs(ratios[0] - limit), std::abs(ratios[1] - limit)), 0, 1e-8);
    }
}

}  // namespace
}  // namespace mechwright::test
