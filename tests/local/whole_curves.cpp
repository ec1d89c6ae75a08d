// The fit of a whole coupler curve to points in any order: nearest points against a scan of the curve, derivatives
// against differences, descents against what an optimum is.

#include "tests/local/whole_curves.h"

#include <algorithm>

#include "synthesis/search/curve/batch.h"
#include "synthesis/search/curve/chords.h"
#include "synthesis/search/curve/least_greatest.h"
#include "synthesis/target/path/rows/nearest_point.h"
#include "tests/long_form.h"

namespace mechwright::whole_curves {
namespace {

/// Linkages of every kind, with points near and far; their lengths in units of 10.
std::vector<CurveArguments> linkages(const CurveProblem& problem, std::size_t count) {
    std::vector<CurveArguments> all;
    RandomNumbers random(7);
    CurveWork work;
    while (all.size() < count)
        if (const auto shape = drawn_shape(problem, LaidFirst::by_crank_angles, random, work))
            all.push_back(shape->arguments);
    return all;
}

struct Nearest {
    GroupedTargets local;
    CurveWork work;
};

struct WholeCurves : testing::Test {
    std::vector<Vector<double>> points = rounded_square(21);
    Problem problem = problem_of(points);
    std::vector<Program> programs = programs_of(problem);
    std::optional<CurveProblem> curve = curve_problem(programs);
    CurveWork work;
};

TEST_F(WholeCurves, AreMetAtTheirNearestPoints) {
    ASSERT_TRUE(curve);
    int compared = 0, as_near = 0;
    for (const CurveArguments& a : linkages(*curve, static_cast<std::size_t>(cases_to_try(20, 60))))
        for (std::size_t assembly = 0; assembly < 2; ++assembly) {
            ASSERT_TRUE(find_nearest_points(*curve, InstructionSet::baseline, assembly, a, work));
            for (std::size_t i = 0; i < curve->targets.count; ++i) {
                const Vector<double> target{curve->targets.x[i / 8][i % 8], curve->targets.y[i / 8][i % 8]};
                const double square = work.nearest.square[i / 8][i % 8];
                // The point is one of the curve, so that none is nearer than the nearest.
                const Vector<double> miss = coupler_point(a, assembly, work.nearest.crank_angle[i / 8][i % 8]) - target;
                EXPECT_NEAR(std::sqrt(square), std::sqrt(dot(miss, miss)), 1e-7 * curve->spread);
                const double scan = scanned(a, assembly, target, judged_part);
                ++compared;
                as_near += std::sqrt(square) <= std::sqrt(scan) * (1 + 1e-6) + 1e-7 * curve->spread ? 1 : 0;
            }
        }
    // Where two stretches of the curve are about as near both are looked at, unless a few chords have them both.
    EXPECT_GE(as_near, 0.999 * compared);
}

TEST_F(WholeCurves, AreMetSteadilyWhereTwoStretchesAreAsNear) {
    // As a curve is moved no distance changes by more than it is moved by. Of the nearest chords alone many leap.
    ASSERT_TRUE(curve);
    constexpr double step = 2e-3;
    const auto distances = [&](const NearestOnCurve& nearest) {
        std::vector<double> all;
        for (std::size_t i = 0; i < curve->targets.count; ++i)
            all.push_back(std::sqrt(nearest.square[i / 8][i % 8]));
        return all;
    };
    const auto leaps = [&](const std::vector<double>& from, const std::vector<double>& to) {
        int count = 0;
        for (std::size_t i = 0; i < from.size(); ++i)
            count += std::abs(to[i] - from[i]) > step * (1 + 1e-6) ? 1 : 0;
        return count;
    };
    int of_all = 0, of_chords_alone = 0;
    for (const CurveArguments& a : linkages(*curve, 120)) {
        std::vector<double> before, before_alone;
        for (int k = 0; k < 60; ++k) {
            CurveArguments moved = a;
            moved[6] += step * k;
            ASSERT_TRUE(find_nearest_points(*curve, InstructionSet::baseline, 0, moved, work));
            const std::vector<double> here = distances(work.nearest);
            curve->fit->nearest(InstructionSet::baseline, 0, moved, work.curve, work.chords, work.local, work.nearest);
            const std::vector<double> alone = distances(work.nearest);
            of_all += leaps(before, here);
            of_chords_alone += leaps(before_alone, alone);
            before = here;
            before_alone = alone;
        }
    }
    EXPECT_GT(of_chords_alone, 10);
    EXPECT_LT(3 * of_all, of_chords_alone);
}

double square_to_chord(const SampledCurve& c, std::size_t k, const Vector<double>& from) {
    const Vector<double> begin{c.x[k], c.y[k]}, way{c.x[k + 1] - c.x[k], c.y[k + 1] - c.y[k]};
    const double part = dot(way, way) > 0 ? std::clamp(dot(from - begin, way) / dot(way, way), 0.0, 1.0) : 0;
    const Vector<double> off = from - begin - part * way;
    return dot(off, off);
}

TEST_F(WholeCurves, HaveTheNearestOfAllTheirChords) {
    ASSERT_TRUE(curve);
    for (const CurveArguments& a : linkages(*curve, 60)) {
        ASSERT_TRUE(find_nearest_points(*curve, InstructionSet::baseline, 0, a, work));
        for (std::size_t i = 0; i < curve->targets.count; ++i) {
            const Vector<double> target{work.local.x[i / 8][i % 8], work.local.y[i / 8][i % 8]};
            double least = unlimited;
            for (std::size_t k = 0; k + 1 < work.curve.count; ++k)
                least = std::min(least, square_to_chord(work.curve, k, target));
            const auto chord = static_cast<std::size_t>(work.chords.chord[i / 8][i % 8]);
            const double rounding = 1e-13 * (least + dot(target, target));
            EXPECT_NEAR(work.chords.square[i / 8][i % 8], least, rounding);
            EXPECT_NEAR(square_to_chord(work.curve, chord, target), least, rounding);
        }
    }
}

TEST_F(WholeCurves, AreMetByDesignsWhereAScanSays) {
    ASSERT_TRUE(curve);
    int limited = 0, compared = 0;
    for (const CurveArguments& a : linkages(*curve, 40))
        for (std::size_t assembly = 0; assembly < 2; ++assembly) {
            const std::size_t kind = program_of(programs, a, assembly);
            if (kind == programs.size()) continue;
            Design design = design_at(programs[kind], point_with(programs[kind], a));
            meet_nearest_points(problem, design);
            ++compared;
            limited += assembled_range(FourBar<double>{a[0], a[1], a[2], a[3]}).full_turn ? 0 : 1;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Vector<double> target = programs[kind].targets[i];
                const Vector<double> miss = coupler_point(a, assembly, design.path_angles[i]) - target;
                // Next to the ends of a motion its point goes as the root of what is left of it: half of the digits.
                EXPECT_LE(std::sqrt(dot(miss, miss)),
                          std::sqrt(scanned(a, assembly, target, judged_part)) + 1e-6 * curve->spread);
            }
        }
    EXPECT_GT(compared, 40);
    EXPECT_GT(limited, 10);
}

TEST_F(WholeCurves, HaveTheBitsOfTheBaselineInEveryInstructionSet) {
    ASSERT_TRUE(curve);
    for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
        if (!is_available(set)) continue;
        CurveWork other;
        for (const CurveArguments& a : linkages(*curve, 40)) {
            ASSERT_TRUE(find_nearest_points(*curve, InstructionSet::baseline, 0, a, work));
            ASSERT_TRUE(find_nearest_points(*curve, set, 0, a, other));
            EXPECT_EQ(work.nearest.square, other.nearest.square);
            EXPECT_EQ(work.nearest.crank_angle, other.nearest.crank_angle);
            EXPECT_EQ(work.nearest.gradient, other.nearest.gradient);
            EXPECT_EQ(work.nearest.ends.size(), other.nearest.ends.size());
            // With the point elsewhere on its link, at the crank angles that there are.
            CurveArguments moved = a;
            moved[4] += 0.5;
            ASSERT_EQ(work.curve.count, other.curve.count);
            const double before = work.curve.x[0];
            curve->fit->points(InstructionSet::baseline, 0, moved, work.curve);
            curve->fit->points(set, 0, moved, other.curve);
            EXPECT_NE(work.curve.x[0], before);
            for (std::size_t i = 0; i < work.curve.count; ++i) {
                EXPECT_EQ(work.curve.x[i], other.curve.x[i]);
                EXPECT_EQ(work.curve.y[i], other.curve.y[i]);
            }
        }
    }
}

TEST_F(WholeCurves, AreDrawnByRelativesOfTheirLinkages) {
    ASSERT_TRUE(curve);
    int cognates = 0, other_drives = 0;
    for (const CurveArguments& a : linkages(*curve, 20))
        for (std::size_t assembly = 0; assembly < 2; ++assembly)
            for (const bool other_drive : {false, true}) {
                CurveArguments relative = a;
                std::size_t side = assembly;
                ASSERT_TRUE(curve->fit->kin->to_relative(other_drive, side, relative));
                const CrankRange<double> range = assembled_range(FourBar<double>{a[0], a[1], a[2], a[3]});
                for (int k = 1; k < 4; ++k) {
                    const double angle = range.from + k / 4.0 * (range.to - range.from);
                    const Vector<double> point = coupler_point(a, assembly, angle);
                    if (!other_drive) {
                        const Vector<double> off = coupler_point(relative, side, angle) - point;
                        EXPECT_LT(std::sqrt(dot(off, off)), 1e-9 * curve->spread);
                        ++cognates;
                        continue;
                    }
                    // The rocker is its crank, and the axis points the other way; one of its sides closes it so.
                    const auto p = pose(FourBar<double>{a[0], a[1], a[2], a[3]}, angle,
                                        assembly == 0 ? Assembly::open : Assembly::crossed);
                    const double other_angle = std::atan2(-p.rocker.y, -p.rocker.x);
                    double off = unlimited;
                    for (const std::size_t closed : {0, 1}) {
                        const Vector<double> miss = coupler_point(relative, closed, other_angle) - point;
                        off = std::min(off, std::sqrt(dot(miss, miss)));
                    }
                    EXPECT_LT(off, 1e-7 * curve->spread);
                    ++other_drives;
                }
            }
    EXPECT_EQ(cognates, 120);
    EXPECT_EQ(other_drives, 120);
}

bool is_at_end(const NearestOnCurve& nearest, std::size_t target) {
    return std::any_of(nearest.ends.begin(), nearest.ends.end(),
                       [&](const NearestEnd& end) { return end.target == target; });
}

TEST_F(WholeCurves, HaveTheDerivativesOfDifferences) {
    ASSERT_TRUE(curve);
    int compared = 0, ends = 0;
    for (const CurveArguments& a : linkages(*curve, 60)) {
        ASSERT_TRUE(find_nearest_points(*curve, InstructionSet::baseline, 0, a, work));
        const NearestOnCurve here = work.nearest;
        for (std::size_t i = 0; i < 9; ++i) {
            const double step = 1e-6 * std::max(1.0, std::abs(a[i]));
            std::array<NearestOnCurve, 2> beside;
            bool both = true;
            for (const std::size_t side : {0, 1}) {
                CurveArguments moved = a;
                moved[i] += side == 0 ? -step : step;
                both = both && find_nearest_points(*curve, InstructionSet::baseline, 0, moved, work);
                beside[side] = work.nearest;
            }
            if (!both) continue;
            for (std::size_t k = 0; k < curve->targets.count; ++k) {
                const auto at = [&](const std::vector<Group>& groups) { return groups[k / 8][k % 8]; };
                // What is far along the curve is met elsewhere; so may be what is met at an end on one side alone.
                if (std::abs(at(beside[1].crank_angle) - at(beside[0].crank_angle)) > 1e-2) continue;
                if (is_at_end(beside[0], k) != is_at_end(here, k) || is_at_end(beside[1], k) != is_at_end(here, k))
                    continue;
                const double difference = (at(beside[1].square) - at(beside[0].square)) / (2 * step);
                double derivative = 2 * at(here.miss) * at(here.gradient[i]);
                for (const NearestEnd& end : here.ends)
                    if (end.target == k) {
                        derivative = 2 * (end.miss.x * end.x[i] + end.miss.y * end.y[i]);
                        ++ends;
                    }
                const double bend = (at(beside[1].square) - 2 * at(here.square) + at(beside[0].square)) / (step * step);
                if (std::abs(bend) > 1e4) continue;  // next to a toggle
                // At an end the point is known to half of the digits.
                const double rounding = is_at_end(here, k) ? 3e-8 * std::sqrt(at(here.square)) / step : 0;
                EXPECT_NEAR(difference, derivative, 1e-5 * (1 + std::abs(derivative) + std::abs(bend)) + rounding)
                    << "argument " << i << " target " << k;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 5000);
    EXPECT_GT(ends, 100);
}

TEST_F(WholeCurves, HaveTheDerivativesOfTheirEndsNextToChangePoints) {
    // Where the diagonal is short at the end of the motion the coupler is not quite along it, and turns as that grows.
    ASSERT_TRUE(curve);
    const CurveArguments kite{0.8774599, 0.8775381, 3.1513783, 3.1515085, -0.0851140, 0.3974404, 0, 0, 0};
    constexpr double step = 1e-8;
    int compared = 0;
    for (int turn = 0; turn < 12; ++turn) {
        CurveArguments a = kite;
        a[8] = turn * pi / 6;
        ASSERT_TRUE(find_nearest_points(*curve, InstructionSet::baseline, 1, a, work));
        const std::vector<NearestEnd> ends = work.nearest.ends;
        for (std::size_t i = 0; i < 4; ++i) {
            std::array<NearestOnCurve, 2> beside;
            for (const std::size_t side : {0, 1}) {
                CurveArguments moved = a;
                moved[i] += side == 0 ? -step : step;
                ASSERT_TRUE(find_nearest_points(*curve, InstructionSet::baseline, 1, moved, work));
                beside[side] = work.nearest;
            }
            for (const NearestEnd& end : ends) {
                if (!is_at_end(beside[0], end.target) || !is_at_end(beside[1], end.target)) continue;
                const auto square = [&](std::size_t side) {
                    return beside[side].square[end.target / 8][end.target % 8];
                };
                const double difference = (square(1) - square(0)) / (2 * step);
                const double size = 2 * std::hypot(end.miss.x, end.miss.y) * std::hypot(end.x[i], end.y[i]);
                EXPECT_NEAR(2 * (end.miss.x * end.x[i] + end.miss.y * end.y[i]), difference, 1e-4 * size)
                    << "argument " << i << " target " << end.target << " turn " << turn;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 20);
}

TEST_F(WholeCurves, AreLeftByDescentsWhereNothingIsToBeGained) {
    ASSERT_TRUE(curve);
    RandomNumbers random(3);
    int balanced = 0, descents = 0;
    while (descents < 40) {
        auto shape = drawn_shape(*curve, LaidFirst::by_place, random, work);
        if (!shape) continue;
        ++descents;
        FittedCurve before = *shape;
        ASSERT_TRUE(descend(*curve, before, 1, 0, work));
        ASSERT_TRUE(descend(*curve, *shape, 2000, 1e-12, work));
        EXPECT_LE(shape->sum, before.sum);
        FittedCurve again = *shape;
        ASSERT_TRUE(descend(*curve, again, 200, 1e-12, work));
        // Along borders and narrow valleys the last steps gain little each.
        balanced += again.sum >= (1 - 1e-2) * shape->sum ? 1 : 0;
    }
    EXPECT_GE(balanced, 36);
}

TEST_F(WholeCurves, ComeNearerToTheTargetThatIsFarthestAway) {
    ASSERT_TRUE(curve);
    RandomNumbers random(11);
    int designs = 0, nearer = 0;
    while (designs < 20) {
        auto shape = drawn_shape(*curve, LaidFirst::by_place, random, work);
        if (!shape || !descend(*curve, *shape, 400, 1e-9, work)) continue;
        ++designs;
        const auto least = towards_least_greatest(*curve, *shape, work);
        ASSERT_TRUE(least);
        const double before = greatest_distance(*curve, *shape, work);
        EXPECT_NEAR(least->distance, greatest_distance(*curve, least->design, work), 1e-9 * before);
        EXPECT_LE(least->distance, before * (1 + 1e-9));
        nearer += least->distance < 0.95 * before ? 1 : 0;
    }
    EXPECT_GE(nearer, 12);
}

}  // namespace
}  // namespace mechwright::whole_curves
