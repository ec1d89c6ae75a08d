// How many slider-cranks, and inverted ones, pass eight places, or poses and points: that no solution is missing, by
// the trace test.
//
// As the parameters go along a line, p + t q, the solutions run along a curve. A line of the plane of projections (a,
// a') of the crank's pivot, brought to general position, and t make it a curve of space, which a plane meets in as many
// points as its degree says. The sum of their coordinates is linear in a shift of the plane if and only if no point is
// missing, the curve being irreducible, as monodromy shows. (A. J. Sommese, J. Verschelde and C. W. Wampler, "Symmetric
// functions applied to decomposing solution sets of polynomial systems", 2002; for a product of spaces: A. Leykin,
// J. I. Rodriguez and F. Sottile, "Trace test", 2018.) Where the plane becomes t = 0 and what is infinitely far away,
// the points of all solutions at the parameters p are among them.

#include <gtest/gtest.h>

#include <complex>
#include <optional>
#include <random>

#include "synthesis/exact/homotopy/guidance_start.h"
#include "tests/long_form.h"

namespace mechwright::homotopy {
namespace {

/// The curve, cut by c.(a, a') (1 + g t) + e t (1 + l.(a, a')) - f (1 + l.(a, a')) (1 + g t) = 0. Its parameters are
/// c, e and f.
struct CutCurve {
    static constexpr std::size_t size = GuidanceSystem::size + 1;
    static constexpr std::size_t parameters = 4;
    static constexpr std::size_t t = size - 1;

    template <class T>
    using Parameters = std::array<Complex<T>, parameters>;
    template <class T>
    using Point = std::array<Complex<T>, size>;

    GuidanceSystem system;
    GuidanceParameters from{}, along{};
    std::array<Complex<double>, 2> l{};
    Complex<double> g{};

    template <class T>
    void linearise(const Point<T>& u, const Parameters<T>& cut, const Parameters<T>* moved,
                   Augmented<T, size>& out) const {
        GuidanceSystem::Point<T> solution;
        std::copy_n(u.begin(), solution.size(), solution.begin());
        GuidanceSystem::Parameters<T> p, q;
        for (std::size_t i = 0; i < p.size(); ++i) {
            q[i] = wide<T>(along[i]);
            p[i] = wide<T>(from[i]) + u[t] * q[i];
        }
        Augmented<T, GuidanceSystem::size> at, by_t;
        system.linearise(solution, p, static_cast<const GuidanceSystem::Parameters<T>*>(nullptr), at);
        system.linearise(solution, p, &q, by_t);
        for (std::size_t i = 0; i < GuidanceSystem::size; ++i) {
            std::copy_n(at[i].begin(), GuidanceSystem::size, out[i].begin());
            out[i][t] = -by_t[i][GuidanceSystem::size];
            out[i][size] = moved == nullptr ? at[i][GuidanceSystem::size] : Complex<T>{T(0.0), T(0.0)};
        }
        const Complex<T> one{T(1.0), T(0.0)}, &a = u[GuidanceSystem::a], &ac = u[GuidanceSystem::a_conjugate];
        const Complex<T> first = wide<T>(l[0]), second = wide<T>(l[1]), slope = wide<T>(g);
        const Complex<T> far = one + first * a + second * ac, late = one + slope * u[t];
        const Complex<T> rest = cut[2] * u[t] - cut[3] * late;
        const auto value = [&](const Parameters<T>& c) {
            return (c[0] * a + c[1] * ac) * late + (c[2] * u[t] - c[3] * late) * far;
        };
        out[t].fill({T(0.0), T(0.0)});
        out[t][GuidanceSystem::a] = cut[0] * late + rest * first;
        out[t][GuidanceSystem::a_conjugate] = cut[1] * late + rest * second;
        out[t][t] = (cut[0] * a + cut[1] * ac) * slope + (cut[2] - cut[3] * slope) * far;
        out[t][size] = -value(moved == nullptr ? cut : *moved);
    }

private:
    template <class T>
    static Complex<T> wide(const Complex<double>& z) {
        return {T(z.re), T(z.im)};
    }
};

using CutValues = CutCurve::Point<double>;
using Cut = CutCurve::Parameters<double>;
using CutPath = TrackedPath<CutCurve>;

class Randomly {
public:
    explicit Randomly(unsigned seed) : random_(seed) {}
    Complex<double> next() { return {normal_(random_), normal_(random_)}; }
    Cut cut() { return {next(), next(), next(), next()}; }

private:
    std::mt19937_64 random_;
    std::normal_distribution<double> normal_;
};

std::vector<CutValues> carried(const CutCurve& curve, const std::vector<CutValues>& points, const Cut& from,
                               const Cut& to, const TrackingOptions& options) {
    std::vector<CutPath> starts(points.size()), out(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        starts[i].point = points[i];
    std::ptrdiff_t next = 0;
    Tracker<CutCurve, Lanes<2>, 2> tracker(curve, from, to, options);
    tracker.run(
        starts, [&] { return next < static_cast<std::ptrdiff_t>(points.size()) ? next++ : -1; }, RunEnd{}, out);
    std::vector<CutValues> ends;
    for (const CutPath& path : out)
        if (path.end == PathEnd::reached) ends.push_back(path.point);
    return ends;
}

/// Newton's corrections to the last digits.
void refine_on(const CutCurve& curve, const Cut& cut, CutValues& u) {
    Augmented<double, CutCurve::size> matrix;
    for (int k = 0; k < 3; ++k) {
        curve.linearise(u, cut, static_cast<const Cut*>(nullptr), matrix);
        solve(matrix);
        for (std::size_t i = 0; i < u.size(); ++i)
            u[i] = u[i] + matrix[i][CutCurve::size];
    }
}

OrbitKey key_of(const CutValues& u) {
    return {u[GuidanceSystem::a] + u[CutCurve::t], u[GuidanceSystem::a_conjugate] + u[CutCurve::t]};
}

std::vector<CutValues> different(const CutCurve& curve, const Cut& cut, std::vector<CutValues> points) {
    SeenOrbits seen;
    std::vector<CutValues> kept;
    for (CutValues& u : points) {
        refine_on(curve, cut, u);
        if (!seen.find_or_keep(key_of(u), kept.size())) kept.push_back(u);
    }
    return kept;
}

/// All points on a cut, by loops of cuts from those that are known, until several loops find no new one.
std::vector<CutValues> points_on(const CutCurve& curve, const Cut& cut, std::vector<CutValues> points,
                                 Randomly& random) {
    constexpr int enough = 12;
    constexpr TrackingOptions sure{1e-6, 1e-8, 1e-12, 20000};
    for (int without = 0; without < enough;) {
        const Cut second = random.cut(), third = random.cut();
        std::vector<CutValues> round = carried(curve, points, cut, second, sure);
        round = carried(curve, carried(curve, round, second, third, sure), third, cut, sure);
        const std::size_t before = points.size();
        points.insert(points.end(), round.begin(), round.end());
        points = different(curve, cut, std::move(points));
        without = points.size() > before ? 0 : without + 1;
    }
    return points;
}

/// The sum over the points of a linear function of their coordinates in general position.
std::complex<double> trace(const CutCurve& curve, const std::vector<CutValues>& points) {
    std::complex<double> sum = 0;
    for (const CutValues& u : points) {
        const auto& a = u[GuidanceSystem::a];
        const auto& ac = u[GuidanceSystem::a_conjugate];
        const Complex<double> far = Complex<double>{1, 0} + curve.l[0] * a + curve.l[1] * ac;
        const Complex<double> late = Complex<double>{1, 0} + curve.g * u[CutCurve::t];
        const Complex<double> value = Complex<double>{0.3, 0.8} * (a / far) + Complex<double>{-0.9, 0.2} * (ac / far) +
                                      Complex<double>{0.4, -0.7} * (u[CutCurve::t] / late);
        sum += std::complex<double>(value.re, value.im);
    }
    return sum;
}

/// By how much the trace of the points of a cut bends as the cut is shifted twice, in parts of the sums, and by how
/// much it would without the first point. `points` and `cut` become those of the last shift.
struct Bends {
    double of_all, without_one;
};

Bends bends_of(const CutCurve& curve, std::vector<CutValues>& points, Cut& cut, Randomly& random) {
    constexpr TrackingOptions careful{1e-7, 1e-9, 1e-12, 20000};
    const Complex<double> shift{2.1, -1.3};
    std::complex<double> bend = 0, without_one = 0;
    double size = 0;
    for (const double weight : {1.0, -2.0, 1.0}) {
        const std::complex<double> sum = trace(curve, points);
        bend += weight * sum;
        without_one += weight * trace(curve, {points.begin() + 1, points.end()});
        size = std::max(size, std::abs(sum));
        Cut next = cut;
        next[3] = next[3] + shift;
        const std::size_t before = points.size();
        points = different(curve, next, carried(curve, points, cut, next, careful));
        cut = next;
        if (points.size() < before) points = points_on(curve, next, std::move(points), random);  // some got lost
        if (points.size() != before) return {1, 1};
    }
    size += static_cast<double>(points.size());
    return {std::abs(bend) / size, std::abs(without_one) / size};
}

/// How many solutions there are at the parameters of the start system, from a cut on which no point is missing; nothing
/// where the loops from one have not found all.
std::optional<std::size_t> counted_by_trace(const GuidanceSystem& system, unsigned seed) {
    Randomly random(seed);
    const StartSystem& start = start_system(system);
    CutCurve curve{system, start.parameters, {}, {random.next(), random.next()}, random.next()};
    for (std::size_t i = 0; i < curve.from.size(); ++i)
        if (norm(curve.from[i]) > 0) curve.along[i] = random.next();
    std::vector<CutValues> points(start.solutions.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        std::copy_n(start.solutions[i].begin(), GuidanceSystem::size, points[i].begin());
    const Cut at_zero{Complex<double>{0, 0}, {0, 0}, {1, 0}, {0, 0}};
    Cut cut = random.cut();
    points = points_on(curve, cut, different(curve, cut, carried(curve, points, at_zero, cut, {})), random);
    const Bends bends = bends_of(curve, points, cut, random);
    if (!(bends.of_all < 1e-11)) return {};
    EXPECT_GT(bends.without_one, 1e6 * bends.of_all);
    // Of all points, those that come to t = 0 are the solutions there; the others go to where a or a' was infinite.
    std::size_t at_start = 0;
    for (const CutValues& u : different(curve, at_zero, carried(curve, points, cut, at_zero, {})))
        at_start += norm(u[CutCurve::t]) < 1e-16;
    return at_start;
}

class SliderCrankCount : public ::testing::TestWithParam<GuidanceSystem> {
protected:
    GuidanceSystem system = GetParam();
};

// Of the others, of more solutions, loops in doubles do not find all points of a cut within minutes.
INSTANTIATE_TEST_SUITE_P(Of, SliderCrankCount,
                         ::testing::Values(GuidanceSystem{3, SecondDyad::ram}, GuidanceSystem{4, SecondDyad::ram},
                                           GuidanceSystem{4, SecondDyad::block}),
                         [](const auto& tested) {
                             return (tested.param.second == SecondDyad::ram ? "Ram" : "Block") +
                                    std::to_string(tested.param.poses);
                         });

TEST_P(SliderCrankCount, IsWholeByTheTraceTest) {
    if (!(system == GuidanceSystem{4, SecondDyad::ram}) && !in_long_form()) GTEST_SKIP() << "of the long form";
    std::optional<std::size_t> count;
    for (unsigned seed = 41; seed < 49 && !count; ++seed)
        count = counted_by_trace(system, seed);
    ASSERT_TRUE(count) << "points of all cuts are missing";
    EXPECT_EQ(*count, orbits_of(system));
    EXPECT_EQ(evidence_of(system), "monodromy and a trace test");
}

}  // namespace
}  // namespace mechwright::homotopy
