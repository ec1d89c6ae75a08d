// Laws of motion: boundary values, peaks in closed form, derivatives, identities; polynomials by boundary conditions
// and periodic splines.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/cam/boundary_polynomial.h"
#include "analysis/cam/periodic_spline.h"
#include "analysis/cam/segment.h"
#include "analysis/numbers/extremes.h"
#include "tests/analysis/precise.h"

namespace mechwright::cam {

namespace {

constexpr double pi = std::numbers::pi;

constexpr std::array all_laws{
    Law::constant_velocity, Law::parabolic,          Law::harmonic,        Law::double_harmonic,
    Law::cycloidal,         Law::modified_trapezoid, Law::modified_sine,   Law::modified_constant_velocity,
    Law::polynomial_345,    Law::polynomial_4567,    Law::kloomok_muffley, Law::half_parabolic,
    Law::half_harmonic,     Law::half_cycloidal};

struct Peaks {
    double v = 0, a = 0, j = 0;
};

/// Greatest sizes over all pieces: at their ends, and where the next derivative is zero.
Peaks peaks(Law law) {
    Peaks p;
    for (std::size_t piece = 0; piece < pieces(law); ++piece) {
        const double from = break_before(law, piece), to = break_before(law, piece + 1);
        const auto offer = [&](double u) {
            const auto f = lift_at(law, piece, u);
            p.v = std::max(p.v, std::abs(f.v));
            p.a = std::max(p.a, std::abs(f.a));
            p.j = std::max(p.j, std::abs(f.j));
        };
        std::vector<double> grid;
        for (int i = 0; i <= 64; ++i)
            grid.push_back(from + (to - from) * i / 64);
        offer(from);
        offer(to);
        zeros_on_grid([&](double u) { return lift_at(law, piece, u).a; }, grid, offer);
        zeros_on_grid([&](double u) { return lift_at(law, piece, u).j; }, grid, offer);
        zeros_on_grid([&](double u) { return lift_at(law, piece, Dual<double, 1>::variable(u, 0)).j.partial[0]; }, grid,
                      offer);
    }
    return p;
}

void expect_peaks(Law law, double v, double a, double j) {
    const Peaks p = peaks(law);
    EXPECT_NEAR(p.v, v, 1e-12 * v);
    EXPECT_NEAR(p.a, a, 1e-12 * a);
    EXPECT_NEAR(p.j, j, 1e-12 * j);
}

}  // namespace

// Closed forms, by derivation from each law; they give the usual handbook figures (1.7596, 5.5280, 69.466, ...).
TEST(CamLaws, HaveTheirPeaks) {
    expect_peaks(Law::parabolic, 2, 4, 0);
    expect_peaks(Law::harmonic, pi / 2, pi * pi / 2, pi * pi * pi / 2);
    expect_peaks(Law::cycloidal, 2, 2 * pi, 4 * pi * pi);
    const double trapezoid = 8 * pi / (2 + pi);
    expect_peaks(Law::modified_trapezoid, 2, trapezoid, 4 * pi * trapezoid);
    const double sine = 4 * pi * pi / (4 + pi);
    expect_peaks(Law::modified_sine, sine / pi, sine, 4 * pi * sine);
    const double constant = 1 / (5 / (16 * pi) + 1 / (4 * pi * pi));
    expect_peaks(Law::modified_constant_velocity, constant / (2 * pi), constant, 8 * pi * constant);
    expect_peaks(Law::polynomial_345, 1.875, 10 / std::sqrt(3.0), 60);
    // The acceleration is 420 w^2 (1 - 2u) with w = u (1 - u); greatest where w = 1/5.
    const double u = 0.5 - std::sqrt(0.05);
    expect_peaks(Law::polynomial_4567, 2.1875, 420 * u * u * (1 - u) * (1 - u) * (1 - 2 * u), 52.5);
}

TEST(CamLaws, GiveTheFiguresOfTheHandbooks) {
    const auto near = [](Law law, double v, double a, double j) {
        const Peaks p = peaks(law);
        EXPECT_NEAR(p.v, v, 6e-5);
        EXPECT_NEAR(p.a, a, 6e-5);
        EXPECT_NEAR(p.j, j, 6e-4);
    };
    near(Law::modified_trapezoid, 2.0000, 4.8881, 61.426);
    near(Law::modified_sine, 1.7596, 5.5280, 69.466);
    near(Law::modified_constant_velocity, 1.2753, 8.0127, 201.381);
    near(Law::polynomial_4567, 2.1875, 7.5132, 52.500);
    const Peaks km = peaks(Law::kloomok_muffley);
    EXPECT_NEAR(km.v, 1.776661, 6e-7);
    EXPECT_NEAR(km.a, 5.268300, 6e-7);
    EXPECT_NEAR(km.j, 36.5853, 1e-5);
}

TEST(CamLaws, RiseFromZeroToOneAndJoinAtBreaks) {
    for (const Law law : all_laws) {
        EXPECT_EQ(lift_at(law, 0, 0.0).s, 0);
        EXPECT_NEAR(lift_at(law, pieces(law) - 1, 1.0).s, 1, 4e-15);
        for (std::size_t piece = 1; piece < pieces(law); ++piece) {
            const double u = break_before(law, piece);
            const auto before = lift_at(law, piece - 1, u), after = lift_at(law, piece, u);
            EXPECT_NEAR(before.s, after.s, 1e-15);
            EXPECT_NEAR(before.v, after.v, 1e-15);
            EXPECT_NEAR(before.a, after.a, law == Law::parabolic ? 8 : 1e-13);
        }
    }
}

TEST(CamLaws, HaveTheirDerivatives) {
    for (const Law law : all_laws)
        for (std::size_t piece = 0; piece < pieces(law); ++piece)
            for (const double part : {0.0, 0.1, 0.37, 0.5, 0.83, 1.0}) {
                const double from = break_before(law, piece), to = break_before(law, piece + 1);
                const auto f = lift_at(law, piece, Dual<double, 1>::variable(from + part * (to - from), 0));
                EXPECT_NEAR(f.s.partial[0], f.v.value, 1e-13);
                EXPECT_NEAR(f.v.partial[0], f.a.value, 1e-12);
                EXPECT_NEAR(f.a.partial[0], f.j.value, 1e-11);
            }
}

TEST(CamLaws, AreTheSameInFiftyDigits) {
    for (const Law law : all_laws)
        for (std::size_t piece = 0; piece < pieces(law); ++piece) {
            const double u = 0.5 * (break_before(law, piece) + break_before(law, piece + 1));
            const auto f = lift_at(law, piece, u);
            const auto precise = lift_at(law, piece, test::Precise(u));
            EXPECT_NEAR(f.s, static_cast<double>(precise.s), 4e-15);
            EXPECT_NEAR(f.a, static_cast<double>(precise.a), 1e-13);
        }
}

// Kloomok and Muffley's return P-2 is the mirror image of their rise P-1.
TEST(CamLaws, KloomokMuffleyReturnMirrorsTheRise) {
    for (int i = 0; i <= 100; ++i) {
        const double u = i / 100.0;
        const double return_lift =
            1 + u * u * (-2.63415 + u * u * u * (2.78055 + u * (3.17060 + u * (-6.87795 + u * 2.56095))));
        EXPECT_NEAR(lift_at(Law::kloomok_muffley, 0, 1 - u).s, return_lift, 1e-14);
    }
}

TEST(CamSegments, HalfLawsEndAtSpeedOrBeginThere) {
    Segment<double> half{SegmentKind::rise, {SegmentLaw::Form::law, Law::half_harmonic, true}, 2, 10};
    const auto begin = lift_at(half, 0, 0.0, 5.0), end = lift_at(half, 0, 1.0, 5.0);
    EXPECT_NEAR(begin.s, 5, 4e-15);
    EXPECT_NEAR(begin.v, pi / 2 * 10 / 2, 1e-14);
    EXPECT_NEAR(begin.a, 0, 1e-14);
    EXPECT_NEAR(end.s, 15, 1e-14);
    EXPECT_NEAR(end.v, 0, 1e-14);
    EXPECT_NEAR(end.a, -pi * pi / 4 * 10 / 4, 1e-14);
    half.law = {SegmentLaw::Form::law, Law::half_cycloidal, false};
    EXPECT_NEAR(lift_at(half, 0, 1.0, 0.0).v, 2 * 10 / 2.0, 1e-14);
    EXPECT_NEAR(lift_at(half, 0, 0.0, 0.0).v, 0, 1e-15);
}

TEST(CamSegments, AReturnIsARiseBackward) {
    for (const Law law : all_laws) {
        const Segment<double> rise{SegmentKind::rise, {SegmentLaw::Form::law, law, false}, 1.5, 20};
        const Segment<double> fall{SegmentKind::fall, {SegmentLaw::Form::law, law, false}, 1.5, 20};
        const std::size_t n = pieces(rise);
        for (std::size_t piece = 0; piece < n; ++piece) {
            const double u = 0.3 * break_before(rise, piece) + 0.7 * break_before(rise, piece + 1);
            const auto up = lift_at(rise, piece, u, 0.0), down = lift_at(fall, n - 1 - piece, 1 - u, 20.0);
            EXPECT_NEAR(up.s, down.s, 1e-13);
            EXPECT_NEAR(up.v, -down.v, 1e-12);
            EXPECT_NEAR(up.a, down.a, 1e-11);
            EXPECT_NEAR(up.j, -down.j, 1e-10);
        }
    }
}

TEST(BoundaryPolynomials, OfRestAreTheOnesWithNames) {
    BoundaryPolynomial<double> p;
    for (const double u : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        EXPECT_NEAR(lift_at(p, 1.0, u).s, lift_at(Law::polynomial_345, 0, u).s, 1e-15);
        EXPECT_NEAR(lift_at(p, 1.0, u).j, lift_at(Law::polynomial_345, 0, u).j, 1e-12);
    }
    p.start_count = p.end_count = 3;
    for (const double u : {0.0, 0.2, 0.5, 0.9, 1.0})
        EXPECT_NEAR(lift_at(p, 1.0, u).a, lift_at(Law::polynomial_4567, 0, u).a, 1e-12);
}

TEST(BoundaryPolynomials, MeetTheirEnds) {
    BoundaryPolynomial<double> p{{0.3, -2, 5, 0}, {1.1, 0.7, 0, 0}, 3, 2, {0.4, -0.2, 0.1}, 3};
    const auto start = lift_at(p, 2.5, 0.0), end = lift_at(p, 2.5, 1.0);
    EXPECT_NEAR(start.s, 0, 1e-15);
    EXPECT_NEAR(start.v, 0.3, 1e-14);
    EXPECT_NEAR(start.a, -2, 1e-13);
    EXPECT_NEAR(start.j, 5, 1e-12);
    EXPECT_NEAR(end.s, 2.5, 1e-14);
    EXPECT_NEAR(end.v, 1.1, 1e-12);
    EXPECT_NEAR(end.a, 0.7, 1e-10);
}

TEST(RiseSplines, AreAtRestAtBothEndsAndSmoothBetween) {
    const std::vector<double> free{1, 6, 12, 19};
    for (const SegmentKind kind : {SegmentKind::rise, SegmentKind::fall}) {
        Segment<double> s{kind, {SegmentLaw::Form::spline, Law::polynomial_345, false}, 1.5, 20};
        std::copy(free.begin(), free.end(), s.boundary.shape.begin());
        if (kind == SegmentKind::fall) std::reverse(s.boundary.shape.begin(), s.boundary.shape.begin() + 4);
        s.boundary.shape_count = 4;
        const double from = kind == SegmentKind::rise ? 5 : 25;
        ASSERT_EQ(pieces(s), 5u);
        const auto begin = lift_at(s, 0, 0.0, from), end = lift_at(s, 4, 1.0, from);
        EXPECT_NEAR(begin.s, from, 1e-14);
        EXPECT_NEAR(end.s, 30 - from, 1e-14);
        for (const double rest : {begin.v, begin.a, end.v, end.a})
            EXPECT_NEAR(rest, 0, 1e-12);
        for (std::size_t piece = 1; piece < 5; ++piece) {
            const double u = break_before(s, piece);
            const auto before = lift_at(s, piece - 1, u, from), after = lift_at(s, piece, u, from);
            EXPECT_NEAR(before.s, after.s, 1e-13);
            EXPECT_NEAR(before.v, after.v, 1e-12);
            EXPECT_NEAR(before.a, after.a, 1e-11);
            EXPECT_NEAR(before.j, after.j, 1e-10);
        }
    }
    // Without free coefficients it is the polynomial of fifth degree.
    const Segment<double> plain{SegmentKind::rise, {SegmentLaw::Form::spline, Law::polynomial_345, false}, 1, 1};
    EXPECT_NEAR(lift_at(plain, 0, 0.3, 0.0).s, lift_at(Law::polynomial_345, 0, 0.3).s, 1e-15);
}

// A sine wave, which the spline follows to the fourth order of its steps.
TEST(PeriodicSplines, FollowASineWave) {
    double before = 0;
    for (const int n : {16, 32, 64}) {
        std::vector<double> knot, value;
        for (int i = 0; i < n; ++i) {
            knot.push_back((i + 0.3 * std::sin(i)) / n);
            value.push_back(std::sin(2 * pi * knot.back()));
        }
        if (knot[0] < 0) knot[0] = 0;
        const auto spline = periodic_spline<double>(knot, value);
        double error = 0;
        for (std::size_t piece = 0; piece < spline.pieces(); ++piece) {
            const double u = 0.5 * (spline.begin(piece) + spline.begin(piece + 1));
            error = std::max(error, std::abs(lift_at(spline, piece, u).s - std::sin(2 * pi * u)));
            const auto end = lift_at(spline, piece, spline.begin(piece + 1));
            const std::size_t next = piece + 1 == spline.pieces() ? 0 : piece + 1;
            const auto begin = lift_at(spline, next, spline.begin(next));
            EXPECT_NEAR(end.s, begin.s, 1e-13);
            EXPECT_NEAR(end.v, begin.v, 1e-11);
            EXPECT_NEAR(end.a, begin.a, 1e-9);
        }
        EXPECT_TRUE(before == 0 || error < before / 8);
        before = error;
    }
    EXPECT_LT(before, 1e-4);
}

}  // namespace mechwright::cam
