// Searches of whole coupler curves: designs that are known, and what every end of a search has.

#include <algorithm>
#include <chrono>

#include "synthesis/search/curve/batch.h"
#include "synthesis/search/curve/curve_search.h"
#include "synthesis/search/curve/laying.h"
#include "tests/local/whole_curves.h"

namespace mechwright::whole_curves {
namespace {

/// A linkage of any size and place whose motion is neither tiny nor next to a border.
CurveArguments random_linkage(RandomNumbers& random) {
    while (true) {
        CurveArguments a{};
        for (std::size_t i = 0; i < 4; ++i)
            a[i] = 10 * std::pow(10, random.even());
        for (std::size_t i = 4; i < 8; ++i)
            a[i] = 10 * random.normal();
        a[8] = 2 * pi * random.even();
        const CrankRange<double> range = assembled_range(FourBar<double>{a[0], a[1], a[2], a[3]});
        if (range.to - range.from > 1) return a;
    }
}

TEST(WholeCurvesOfLinkages, HaveTheLeastGreatestDistanceWhereThatIsTheObjective) {
    const std::vector<Vector<double>> points = rounded_square(14);
    const Problem problem = problem_of(points, "closed = true\n", "path-max");
    ASSERT_TRUE(can_search_curves(problem));
    const Multistart found = curve_search(problem, {}, std::chrono::steady_clock::time_point::max());
    ASSERT_FALSE(found.optima.empty());
    const Solution& least = found.optima.front();
    EXPECT_TRUE(least.feasible);
    CurveArguments a{};
    std::copy_n(least.design.dimensions.begin(), a.size(), a.begin());
    double square = 0;
    for (const Vector<double>& point : points)
        square = std::max(square, scanned(a, least.design.assembly, point));
    EXPECT_LE(least.objective, std::sqrt(square) * (1 + 1e-9));
    EXPECT_NEAR(least.objective, std::sqrt(square), 1e-2 * least.objective);
    // The least squares of a batch have a farther one.
    const std::vector<Program> programs = programs_of(problem);
    const auto curve = curve_problem(programs);
    const CurveBatch batch = curve_batch(*curve, LaidFirst::by_crank_angles, 1, 10000, [] { return false; });
    CurveWork work;
    const double by_squares = programs.front().length * greatest_distance(*curve, batch.best.front(), work);
    EXPECT_LT(least.objective, 0.95 * by_squares);
}

TEST(WholeCurvesOfLinkages, AreLaidOverPointsThatTheyPassAtGivenTimes) {
    RandomNumbers random(5);
    CurveWork work;
    for (int n = 0; n < 20; ++n) {
        const CurveArguments a = random_linkage(random);
        const CrankRange<double> range = assembled_range(FourBar<double>{a[0], a[1], a[2], a[3]});
        std::vector<Vector<double>> points;
        for (int k = 0; k < 24; ++k)
            points.push_back(coupler_point(a, 0, range.from + (0.05 + 0.03 * k) * (range.to - range.from)));
        const Problem problem = problem_of(points);
        const std::vector<Program> programs = programs_of(problem);
        const auto curve = curve_problem(programs);
        ASSERT_TRUE(curve);
        FittedCurve known{a, 0, 0};
        for (std::size_t i = 0; i < 8; ++i)
            known.arguments[i] /= programs.front().length;
        const std::vector<double> times = times_at_targets(*curve, known, work);
        ASSERT_EQ(times.size(), points.size());
        // The same proportions elsewhere, of another size, with another point: it is told by the points alone.
        FittedCurve other = known;
        for (std::size_t i = 0; i < 4; ++i)
            other.arguments[i] *= 0.37;
        other.arguments[4] = 0.2;
        other.arguments[5] = -0.1;
        other.arguments[6] = other.arguments[7] = other.arguments[8] = 0;
        const auto laid_there = laid(*curve, other, times, 4, work);
        ASSERT_TRUE(laid_there);
        // Chords stand for the curve between its samples.
        EXPECT_LT(std::sqrt(laid_there->sum / curve->weight), 0.01 * curve->spread) << n;
        for (std::size_t i = 0; i < 8; ++i)
            EXPECT_NEAR(laid_there->arguments[i], known.arguments[i], 0.1 * curve->spread) << n << ", argument " << i;
        FittedCurve end = *laid_there;
        ASSERT_TRUE(descend(*curve, end, 2000, 1e-14, work));
        // Points are written with six digits.
        EXPECT_LT(std::sqrt(end.sum / curve->weight), 1e-5 * curve->spread) << n;
    }
}

/// So many points of a linkage's whole curve, about as far from each other along it.
std::vector<Vector<double>> even_points(const CurveArguments& a, int count) {
    const CrankRange<double> range = assembled_range(FourBar<double>{a[0], a[1], a[2], a[3]});
    std::vector<Vector<double>> fine;
    std::vector<double> way{0};
    for (int k = 0; k <= 2000; ++k) {
        fine.push_back(coupler_point(a, 0, range.from + k / 2000.0 * (range.to - range.from)));
        if (k == 0) continue;
        const Vector<double> chord = fine.back() - fine[fine.size() - 2];
        way.push_back(way.back() + std::hypot(chord.x, chord.y));
    }
    std::vector<Vector<double>> points;
    for (int k = 0; k < count; ++k) {
        const auto at = std::lower_bound(way.begin(), way.end(), (k + 0.5) / count * way.back());
        points.push_back(fine[static_cast<std::size_t>(at - way.begin())]);
    }
    return points;
}

TEST(WholeCurvesOfLinkages, AreLaidOverPointsFromAPlaceNearTheirs) {
    RandomNumbers random(8);
    CurveWork work;
    int there = 0;
    for (int n = 0; n < 20; ++n) {
        const CurveArguments a = random_linkage(random);
        const Problem problem = problem_of(even_points(a, 60));
        const std::vector<Program> programs = programs_of(problem);
        const auto curve = curve_problem(programs);
        ASSERT_TRUE(curve);
        // The same linkage elsewhere and of another size: its spread and middle are those of the points.
        FittedCurve other{a, 0, 0};
        for (std::size_t i = 0; i < 6; ++i)
            other.arguments[i] *= 0.37 / programs.front().length;
        other.arguments[6] = other.arguments[7] = other.arguments[8] = 0;
        const auto laid_there = laid(*curve, other, CurvePlace{a[8] + 0.05, 1.03, {0.02, -0.03}}, 8, work);
        ASSERT_TRUE(laid_there);
        there += std::sqrt(laid_there->sum / curve->weight) < 0.01 * curve->spread ? 1 : 0;
        const auto turned_round = laid(*curve, other, CurvePlace{a[8] + pi, 3, {0.5, 0.5}}, 0, work);
        EXPECT_TRUE(!turned_round || turned_round->sum > laid_there->sum) << n;
    }
    EXPECT_GE(there, 16);
}

TEST(WholeCurvesOfLinkages, HaveAWayThroughTheirPointsHoweverTheseAreListed) {
    std::vector<Vector<double>> points;
    for (int k = 0; k < 24; ++k) {
        const double angle = 2 * pi * (k * 7 % 24) / 24;
        points.push_back({10 * std::cos(angle), 5 * std::sin(angle)});
    }
    const Problem problem = problem_of(points, "closed = true\n");
    const std::vector<Program> programs = programs_of(problem);
    const auto curve = curve_problem(programs);
    ASSERT_TRUE(curve);
    std::vector<std::pair<double, int>> along;
    for (int k = 0; k < 24; ++k)
        along.emplace_back(curve->way[static_cast<std::size_t>(k)], k * 7 % 24);
    std::sort(along.begin(), along.end());
    for (std::size_t k = 1; k < along.size(); ++k) {
        const int step = (along[k].second - along[k - 1].second + 24) % 24;
        EXPECT_TRUE(step == 1 || step == 23);
        EXPECT_EQ(step, (along[1].second - along[0].second + 24) % 24);
        EXPECT_LT(along[k].first, 1);
    }
}

TEST(WholeCurvesOfLinkages, AreFoundAgainByTheirPoints) {
    // Points of the curves of random linkages, in another order; the least that they can be missed by is rounding.
    RandomNumbers random(99);
    int linkages = 0, found = 0;
    while (linkages < 12) {
        CurveArguments a{};
        for (std::size_t i = 0; i < 4; ++i)
            a[i] = 10 * std::pow(10, random.even());
        a[4] = 10 * random.normal();
        a[5] = 10 * random.normal();
        const CrankRange<double> range = assembled_range(FourBar<double>{a[0], a[1], a[2], a[3]});
        if (!(range.from <= range.to)) continue;
        const auto n = static_cast<std::uint64_t>(linkages++);
        std::vector<Vector<double>> points;
        for (int k = 0; k < 24; ++k) {
            const double part = std::fmod(0.05 + 0.38196601125 * k, 1.0);
            points.push_back(coupler_point(a, n % 2, range.from + part * (range.to - range.from)));
        }
        const Problem problem = problem_of(points);
        const std::vector<Program> own = programs_of(problem);
        const auto curve = curve_problem(own);
        ASSERT_TRUE(curve);
        // A search runs four batches at a time. Points are written with six digits.
        bool again = false;
        for (std::uint64_t k = 0; k < 4 && !again; ++k) {
            const CurveBatch batch = curve_batch(*curve, LaidFirst(k % 2), n + 12 * k, 10000, [] { return false; });
            ASSERT_FALSE(batch.best.empty());
            again = std::sqrt(batch.best.front().sum / curve->weight) < 1e-5 * curve->spread;
        }
        found += again ? 1 : 0;
    }
    EXPECT_EQ(found, 12);
}

TEST(WholeCurvesOfLinkages, TurnFullyWhereTheirPathIsClosed) {
    const Problem problem = problem_of(rounded_square(21), "closed = true\n");
    const std::vector<Program> programs = programs_of(problem);
    const auto curve = curve_problem(programs);
    ASSERT_TRUE(curve);
    const CurveBatch batch = curve_batch(*curve, LaidFirst::by_place, 1, 4000, [] { return false; });
    ASSERT_FALSE(batch.best.empty());
    for (const FittedCurve& best : batch.best) {
        const CurveArguments& a = best.arguments;
        EXPECT_TRUE(assembled_range(FourBar<double>{a[0], a[1], a[2], a[3]}).full_turn);
        EXPECT_GT(grashof_margin(FourBar<double>{a[0], a[1], a[2], a[3]}), 0);
        for (std::size_t i = 0; i < 9; ++i) {
            EXPECT_GE(a[i], curve->lower[i]);
            EXPECT_LE(a[i], curve->upper[i]);
        }
    }
}

}  // namespace
}  // namespace mechwright::whole_curves
