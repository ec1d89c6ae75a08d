// How many slider-cranks pass eight places, or poses and points: that no solution is missing, by the trace test.
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
    constexpr int enough = 8;
    for (int without = 0; without < enough;) {
        const Cut second = random.cut(), third = random.cut();
        std::vector<CutValues> round = carried(curve, points, cut, second, {});
        round = carried(curve, carried(curve, round, second, third, {}), third, cut, {});
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

class SliderCrankCount : public ::testing::TestWithParam<std::size_t> {
protected:
    GuidanceSystem system{GetParam(), SecondDyad::ram};
};

INSTANTIATE_TEST_SUITE_P(ByPoses, SliderCrankCount, ::testing::Values(1, 2, 3, 4),
                         [](const auto& tested) { return "Poses" + std::to_string(tested.param); });

TEST_P(SliderCrankCount, IsWholeByTheTraceTest) {
    if (system.poses < 4 && !in_long_form()) GTEST_SKIP() << "of the long form";
    Randomly random(41);
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

    // The sums at three cuts, each shifted from the one before.
    constexpr TrackingOptions careful{1e-8, 1e-10, 1e-12, 20000};
    std::array<std::complex<double>, 3> sums;
    std::complex<double> with_one_missing = 0;
    const Complex<double> shift{2.1, -1.3};
    std::vector<CutValues> now = points;
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const double weight = k == 1 ? -2 : 1;
        sums[k] = trace(curve, now);
        with_one_missing += weight * trace(curve, {now.begin() + 1, now.end()});
        Cut next = cut;
        next[3] = next[3] + shift;
        now = different(curve, next, carried(curve, now, cut, next, careful));
        cut = next;
        ASSERT_EQ(now.size(), points.size());
    }
    const double size = std::abs(sums[0]) + static_cast<double>(points.size());
    const double bent = std::abs(sums[0] - 2.0 * sums[1] + sums[2]);
    EXPECT_LT(bent, 1e-9 * size);
    EXPECT_GT(std::abs(with_one_missing), 1e3 * bent);

    // Of all points, those that come to the cut t = 0 are the solutions at the first parameters.
    std::size_t at_start = 0;
    for (const CutValues& u : different(curve, at_zero, carried(curve, now, cut, at_zero, {})))
        at_start += norm(u[CutCurve::t]) < 1e-16;
    EXPECT_EQ(at_start, orbits_of(system));
}

}  // namespace
}  // namespace mechwright::homotopy
