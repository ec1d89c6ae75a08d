// Smallest cams: closed forms and certified programs against published and derived values, and both solvers against
// them.

#include <cmath>
#include <numbers>

#include "tests/degree.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

struct Turn {
    const char* law;
    double lift, rise, top, fall;  ///< degrees
};

std::string cam_text(const std::string& head, const Turn& t, const std::string& dimensions, const std::string& rest) {
    const auto number = [](double x) { return std::to_string(x); };
    const auto moving = [&](const char* kind, double angle) {
        return std::string("[[segment]]\nkind = \"") + kind + "\"\nangle = " + number(angle) +
               "\nlift = " + number(t.lift) + "\nlaw = \"" + t.law + "\"\n";
    };
    const auto dwell = [&](double angle) {
        return angle > 0 ? "[[segment]]\nkind = \"dwell\"\nangle = " + number(angle) + "\n" : "";
    };
    return "schema = 1\nmechanism = \"cam\"\n[cam]\n" + head + "\n" + moving("rise", t.rise) + dwell(t.top) +
           moving("return", t.fall) + dwell(360 - t.rise - t.top - t.fall) + "[dimensions]\n" + dimensions + rest;
}

std::string at_most(const char* quantity, double limit) {
    return std::string("[[require]]\nquantity = \"") + quantity + "\"\nmax = " + std::to_string(limit) + "\n";
}

std::string rise_and_return(double rise, double fall) {
    return at_most("pressure-angle-rise", rise) + at_most("pressure-angle-return", fall);
}

const std::string with_offset = "prime-radius = { min = 0.01, max = 200 }\noffset = { min = -50, max = 50 }\n";
const std::string in_line = "prime-radius = { min = 0.01, max = 200 }\n";
const std::string knife = "follower = \"knife\"";
const std::string smallest_prime = "[objective]\nminimize = \"prime-radius\"\n";

/// The certified answer, and that both solvers find it.
void expect_size(const std::string& text, const char* dimension, double known, double within) {
    const Solved exact = solved(text);
    ASSERT_EQ(exact.result.status, Status::solved) << text;
    EXPECT_TRUE(exact.result.search.complete()) << text;
    EXPECT_NEAR(exact.dimension(dimension), known, within) << text;
    const double value = exact.dimension(dimension);
    for (const char* method : {"slsqp", "ipopt"}) {
        const Solved found = solved(text, method);
        EXPECT_EQ(found.result.status, Status::solved) << method;
        EXPECT_NEAR(found.dimension(dimension), value, 1e-9 * value) << method;
    }
}

/// P of a cycloidal rise, closed form: (h / pi) (t - atan t), t = 2 pi cot(limit) / angle.
double cycloidal_support(double lift, double angle, double limit) {
    const double t = 2 * std::numbers::pi / std::tan(limit * degree) / (angle * degree);
    return lift / std::numbers::pi * (t - std::atan(t));
}

double harmonic_support(double lift, double angle, double limit) {
    const double t = std::numbers::pi / std::tan(limit * degree) / (angle * degree);
    return lift / 2 * (std::sqrt(1 + t * t) - 1);
}

struct Corner {
    double prime_radius, offset;
};

/// Where both limits bind.
Corner corner(double p, double q, double rise_limit, double fall_limit) {
    const double a = 1 / std::tan(rise_limit * degree), b = 1 / std::tan(fall_limit * degree);
    const double e = (p - q) / (a + b);
    return {std::hypot(e, p - e * a), e};
}

}  // namespace

TEST(CamSize, B1EqualLimitsNeedNoOffset) {
    const std::string text =
        cam_text(knife, {"cycloidal", 20, 90, 90, 90}, with_offset, rise_and_return(30, 30) + smallest_prime);
    expect_size(text, "prime-radius", cycloidal_support(20, 90, 30), 1e-9 * 35);
    EXPECT_NEAR(solved(text).dimension("prime-radius"), 35.018891, 5e-7);
    EXPECT_NEAR(solved(text).dimension("offset"), 0, 1e-9);
}

TEST(CamSize, B2B3B4WithAnOffset) {
    struct Case {
        Turn turn;
        double rise_limit, fall_limit, prime_radius, offset;
    };
    for (const Case& c : {Case{{"cycloidal", 20, 90, 90, 90}, 30, 45, 24.512289, 6.586450},
                          Case{{"cycloidal", 20, 120, 60, 80}, 30, 50, 18.794634, 3.346178},
                          Case{{"harmonic", 20, 90, 90, 90}, 30, 45, 18.082023, 5.012657}}) {
        const auto support = std::string(c.turn.law) == "harmonic" ? harmonic_support : cycloidal_support;
        const Corner known = corner(support(c.turn.lift, c.turn.rise, c.rise_limit),
                                    support(c.turn.lift, c.turn.fall, c.fall_limit), c.rise_limit, c.fall_limit);
        EXPECT_NEAR(known.prime_radius, c.prime_radius, 5e-7);
        EXPECT_NEAR(known.offset, c.offset, 5e-7);
        const std::string text =
            cam_text(knife, c.turn, with_offset, rise_and_return(c.rise_limit, c.fall_limit) + smallest_prime);
        expect_size(text, "prime-radius", known.prime_radius, 1e-9 * known.prime_radius);
        EXPECT_NEAR(solved(text).dimension("offset"), known.offset, 1e-9 * known.prime_radius);
        EXPECT_NE(solved(text).result.search.proof->argument.find("none negative"), std::string::npos);
    }
}

// Lift 1, limits 30 and 45 deg: the offset examples of the textbook digest.
TEST(CamSize, OffsetExamplesOfUnitLift) {
    struct Case {
        const char* law;
        double angle, prime_radius, offset;
    };
    for (const Case& c : {Case{"cycloidal", 60, 2.029600, 0.503681}, Case{"cycloidal", 90, 1.225614, 0.329323},
                          Case{"harmonic", 90, 0.904101, 0.250633}}) {
        const Solved s = solved(
            cam_text(knife, {c.law, 1, c.angle, 60, c.angle}, with_offset, rise_and_return(30, 45) + smallest_prime));
        EXPECT_NEAR(s.dimension("prime-radius"), c.prime_radius, 5.1e-7);
        EXPECT_NEAR(s.dimension("offset"), c.offset, 5.1e-7);
    }
}

// R0_min / L at 30 deg, radial follower: every printed digit of the table.
TEST(CamSize, TableOfSixLaws) {
    struct Row {
        const char* law;
        double at45, at60, at90, at120;
    };
    for (const Row& row : {Row{"cycloidal", 3.933563, 2.838509, 1.750945, 1.214506},
                           Row{"harmonic", 3.000000, 2.145751, 1.302776, 0.891941},
                           Row{"parabolic", 3.910631, 2.807973, 1.705316, 1.153987},
                           Row{"kloomok-muffley", 3.453786, 2.483318, 1.521569, 1.049060},
                           Row{"3-4-5", 3.661465, 2.636484, 1.620065, 1.120165},
                           Row{"constant-velocity", 2.205316, 1.653987, 1.102658, 0.826993}}) {
        const std::pair<double, double> columns[] = {{45, row.at45}, {60, row.at60}, {90, row.at90}, {120, row.at120}};
        for (const auto& [angle, known] : columns) {
            const Solved s = solved(cam_text(knife, {row.law, 1, angle, 90, angle}, in_line,
                                             at_most("pressure-angle-rise", 30) + smallest_prime));
            EXPECT_NEAR(s.dimension("prime-radius"), known, 5.1e-7) << row.law << " " << angle;
            EXPECT_TRUE(s.result.search.complete());
        }
    }
}

TEST(CamSize, FlatFaces) {
    const std::string flat = "follower = \"flat\"", base = "base-radius = { min = 0.01, max = 300 }\n";
    const std::string task =
        "[[require]]\nquantity = \"profile-radius-min\"\nmin = 5\n[objective]\nminimize = \"base-radius\"\n";
    for (const double angle : {60.0, 90.0, 120.0}) {
        const double beta = angle * degree, pi = std::numbers::pi;
        const double harmonic = 5 + 20 * std::max(0.0, pi * pi / (2 * beta * beta) - 1);
        expect_size(cam_text(flat, {"harmonic", 20, angle, 60, angle}, base, task), "base-radius", harmonic,
                    1e-9 * harmonic);
        const double k = beta * beta / (4 * pi * pi - beta * beta);
        const double cycloidal = 5 + 20 / (2 * pi) * (std::sqrt(1 - k * k) / k + std::acos(-k) - 2 * pi);
        expect_size(cam_text(flat, {"cycloidal", 20, angle, 60, angle}, base, task), "base-radius", cycloidal,
                    1e-9 * cycloidal);
    }
}

// C_min / L, rounded in the digest to six decimals.
TEST(CamSize, FlatFacesOfUnitLift) {
    struct Row {
        const char* law;
        double at60, at90, at120;
    };
    for (const Row& row :
         {Row{"parabolic", 3.147563, 1.121139, 0.411891}, Row{"harmonic", 3.5, 1.0, 0.125},
          Row{"cycloidal", 4.822697, 1.642631, 0.533200}, Row{"kloomok-muffley", 3.805068, 1.139598, 0.214024},
          Row{"3-4-5", 4.333690, 1.411385, 0.391765}}) {
        const std::pair<double, double> columns[] = {{60, row.at60}, {90, row.at90}, {120, row.at120}};
        for (const auto& [angle, known] : columns) {
            const Solved s = solved(cam_text("follower = \"flat\"", {row.law, 1, angle, 60, angle},
                                             "base-radius = { min = 0.01, max = 300 }\n",
                                             "[objective]\nminimize = \"base-radius\"\n"));
            EXPECT_NEAR(s.dimension("base-radius"), known, 5.1e-7) << row.law << " " << angle;
        }
    }
}

TEST(CamSize, OscillatingRollers) {
    const std::string arm = "follower = \"roller\"\nmotion = \"oscillating\"\nrotation = ";
    const auto dimensions = [](double length) {
        return "prime-radius = { min = 5, max = 200 }\npivot-distance = { min = 20, max = 200 }\narm-length = " +
               std::to_string(length) + "\nroller-radius = 3\n";
    };
    const Turn even{"cycloidal", 25, 120, 30, 120};
    const std::string pivot = "[objective]\nminimize = \"pivot-distance\"\n";
    // The greatest of l (1 + v) cos(limit), with v = 2 lift / angle.
    expect_size(cam_text(arm + "\"ccw\"", even, dimensions(80), at_most("pressure-angle-max", 35) + pivot),
                "pivot-distance", 80 * (1 + 2 * 25 / 120.0) * std::cos(35 * degree), 1e-9 * 92);
    for (const char* rotation : {"\"ccw\"", "\"cw\""})
        expect_size(cam_text(arm + rotation, even, dimensions(80), at_most("pressure-angle-max", 35) + smallest_prime),
                    "prime-radius", 34.478422, 5.1e-7);
    // Turning alike, the peak is on the return: 60 (1 + v) cos 45 deg.
    expect_size(
        cam_text(arm + "\"cw\"", {"cycloidal", 30, 100, 40, 140}, dimensions(60), rise_and_return(30, 45) + pivot),
        "pivot-distance", 60 * (1 + 2 * 30 / 140.0) * std::cos(45 * degree), 1e-9 * 60);
    EXPECT_NEAR(60 * (1 + 2 * 30 / 140.0) * std::cos(45 * degree), 60.609153, 5e-7);
}

// Everything scales with the arm: the shortest one makes the smallest cam.
TEST(CamSize, AnArmOfFreeLengthIsTheShortest) {
    const auto text = [](const char* arm) {
        return cam_text(
            "follower = \"roller\"\nmotion = \"oscillating\"", {"cycloidal", 25, 120, 30, 120},
            std::string(
                "prime-radius = { min = 5, max = 200 }\npivot-distance = { min = 20, max = 200 }\narm-length = ") +
                arm + "\nroller-radius = 3\n",
            at_most("pressure-angle-max", 35) + smallest_prime);
    };
    const Solved exact = solved(text("{ min = 60, max = 100 }"));
    EXPECT_TRUE(exact.result.search.complete());
    EXPECT_EQ(exact.dimension("arm-length"), 60);
    EXPECT_NEAR(exact.dimension("prime-radius"), solved(text("80")).dimension("prime-radius") * 0.75, 1e-12 * 30);
    EXPECT_NEAR(solved(text("{ min = 60, max = 100 }"), "slsqp").dimension("prime-radius"),
                exact.dimension("prime-radius"), 1e-8 * 30);
}

// 5 over the least of sin(p)(1 + 2v)/(1 + v)^2 + cos(p) a/(1 + v)^3 over the motion, found in thirty digits elsewhere.
TEST(CamSize, OscillatingFlatFace) {
    const Solved s = solved(shipped("oscillating-flat.toml", "cam"));
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_TRUE(s.result.search.complete());
    EXPECT_NEAR(s.dimension("pivot-distance"), 38.3565087485219572843622429632, 1e-9 * 38);
    for (const char* method : {"slsqp", "ipopt"}) {
        const Solved other = solved(shipped("oscillating-flat.toml", "cam"), method);
        EXPECT_NEAR(other.dimension("pivot-distance"), 38.3565087485219572843622429632, 1e-9 * 38) << method;
    }
    std::string steep = shipped("oscillating-flat.toml", "cam");
    steep.replace(steep.find("= 40\n"), 5, "= 30\n");
    const Solved none = solved(steep);
    EXPECT_EQ(none.result.status, Status::infeasible);
    EXPECT_TRUE(none.result.search.complete());
    EXPECT_NE(none.result.search.proof->argument.find("no pivot distance"), std::string::npos);
}

TEST(CamSize, TooSmallACircleIsProvenImpossible) {
    const Solved s = solved(shipped("not-possible.toml", "cam"));
    EXPECT_EQ(s.result.status, Status::infeasible);
    EXPECT_TRUE(s.result.search.complete());
    EXPECT_NE(s.result.search.proof->argument.find("56.7701748"), std::string::npos) << s.result.search.proof->argument;
}

// Every combination of laws: the best of them all.
TEST(CamSize, ALawIsChosen) {
    const Solved s = solved(shipped("choice-of-law.toml", "cam"));
    ASSERT_EQ(s.result.status, Status::solved);
    double best = 1e300;
    for (const char* law : {"cycloidal", "modified-sine", "modified-trapezoid", "3-4-5"})
        best = std::min(
            best, solved(cam_text("follower = \"roller\"", {law, 20, 90, 90, 90}, with_offset + "roller-radius = 5\n",
                                  rise_and_return(30, 45) + smallest_prime))
                      .dimension("prime-radius"));
    EXPECT_LE(s.dimension("prime-radius"), best * (1 + 1e-12));
}

// The least prime radius for a least radius of curvature of the pitch curve: known to four decimals. For harmonic
// motion the rise alone would need 13.1174, but the dwell is an arc of the prime circle itself.
TEST(CamSize, UnderALimitOnCurvatureAlone) {
    const std::string task = "[[require]]\nquantity = \"pitch-radius-min\"\nmin = 15\n" + smallest_prime;
    for (const auto& [law, known] : {std::pair{"cycloidal", 16.0120}, {"harmonic", 15.0}, {"3-4-5", 15.0289}})
        for (const char* method : {"slsqp", "ipopt"}) {
            const Solved s =
                solved(cam_text(knife, {law, 20, 90, 90, 90}, "prime-radius = { min = 5, max = 200 }\n", task), method);
            ASSERT_EQ(s.result.status, Status::solved) << law;
            EXPECT_NEAR(s.dimension("prime-radius"), known, 5.1e-5) << law << " " << method;
        }
}

TEST(CamSize, RadiiOfCurvatureAndInLineSizes) {
    const auto at = [](double radius) {
        return solved(cam_text(knife, {"cycloidal", 20, 90, 90, 90}, "prime-radius = " + std::to_string(radius) + "\n",
                               ""))
            .value("pitch-radius-min");
    };
    EXPECT_NEAR(at(24.512289), 20.4625, 5.1e-5);
    EXPECT_NEAR(at(35.018891), 27.8822, 5.1e-5);
    for (const auto& [law, known] : {std::pair{"3-4-5", 32.4013},
                                     {"4-5-6-7", 39.0632},
                                     {"modified-sine", 30.0010},
                                     {"modified-trapezoid", 34.6984}})
        EXPECT_NEAR(solved(cam_text(knife, {law, 20, 90, 90, 90}, in_line, rise_and_return(30, 30) + smallest_prime))
                        .dimension("prime-radius"),
                    known, 5.1e-5)
            << law;
}

// The least s + s'' of a rise of 20 in 90 deg, by the base radius that makes the radius of curvature zero.
TEST(CamSize, LeastSumsUnderFlatFaces) {
    for (const auto& [law, known] : {std::pair{"parabolic", 22.4228},
                                     {"modified-trapezoid", 25.0593},
                                     {"modified-sine", 25.2649},
                                     {"3-4-5", 28.2277},
                                     {"cycloidal", 32.8526},
                                     {"4-5-6-7", 42.9365},
                                     {"modified-constant-velocity", 45.0978}})
        EXPECT_NEAR(
            solved(cam_text("follower = \"flat\"", {law, 20, 90, 90, 90}, "base-radius = { min = 0.01, max = 300 }\n",
                            "[objective]\nminimize = \"base-radius\"\n"))
                .dimension("base-radius"),
            known, 5.1e-5)
            << law;
}

// Size and curvature and envelope together: the certified size where it is enough, else the general program.
TEST(CamSize, WithCurvatureAndEnvelope) {
    const std::string limits = rise_and_return(30, 45) + "[[require]]\nquantity = \"profile-radius-min\"\nmin = ";
    const std::string dimensions = with_offset + "roller-radius = 5\n";
    const Turn turn{"cycloidal", 20, 90, 90, 90};
    const Solved loose = solved(cam_text("follower = \"roller\"", turn, dimensions, limits + "10\n" + smallest_prime));
    EXPECT_TRUE(loose.result.search.complete());
    const Solved tight = solved(cam_text("follower = \"roller\"", turn, dimensions, limits + "25\n" + smallest_prime));
    ASSERT_EQ(tight.result.status, Status::solved);
    EXPECT_FALSE(tight.result.search.complete());
    EXPECT_NEAR(tight.value("profile-radius-min"), 25, 1e-7);
    EXPECT_GT(tight.dimension("prime-radius"), loose.dimension("prime-radius"));
    const Solved other =
        solved(cam_text("follower = \"roller\"", turn, dimensions, limits + "25\n" + smallest_prime), "ipopt");
    EXPECT_NEAR(other.dimension("prime-radius"), tight.dimension("prime-radius"), 1e-8 * 40);
    const Solved narrow =
        solved(cam_text("follower = \"roller\"", turn, dimensions,
                        limits + "25\n[[require]]\nquantity = \"cam-size\"\nmax = 40\n" + smallest_prime));
    EXPECT_EQ(narrow.result.status, Status::infeasible);
}

// Between the parabola's 4, which no motion undercuts, and the 3-4-5's 5.774 h / beta^2.
TEST(CamMotion, ASplineHasALowerPeakOfAcceleration) {
    const double unit = 20 / std::pow(std::numbers::pi / 2, 2);
    const std::string few = shipped("spline-peak.toml", "cam") + "\n[solver]\nstarts = 6\n";
    const Solved a = solved(few, "slsqp", 1, 2, 2), b = solved(few, "ipopt", 1, 2, 2);
    ASSERT_EQ(a.result.status, Status::solved);
    EXPECT_GT(a.value("acceleration-max"), 4 * unit);
    EXPECT_LT(a.value("acceleration-max"), 5.2 * unit);
    EXPECT_NEAR(a.value("acceleration-max"), b.value("acceleration-max"), 1e-5 * unit);
}

}  // namespace mechwright
