// Random six-bars, found again from thirty timed points of their own path, with every dimension, the placement and the
// crank angle of the first point unknown: the points come from circles that meet, by other formulas than the program's.

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string>

#include "synthesis/bench/profiles/random_six_bar.h"
#include "synthesis/search/drawn_starts.h"
#include "tests/known_optima/solved.h"
#include "tests/long_form.h"

namespace mechwright {

namespace {

using bench::Complex;
using bench::SixBar;
using bench::turn;
using testing::Solved;
using testing::solved;

constexpr int points_on_path = 30;

class RandomSixBars {
public:
    explicit RandomSixBars(unsigned seed) : random_(seed) {}

    SixBar next(bool watt) {
        for (;;) {
            const SixBar made{watt,
                              length(40, 160),
                              length(15, 60),
                              length(40, 160),
                              length(40, 160),
                              length(40, 200),
                              length(40, 200),
                              place(-100, 150),
                              place(-100, 150),
                              place(-100, 200),
                              side(),
                              side()};
            if (made.turns()) return made;
        }
    }
    double between(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }

private:
    double length(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    Complex place(double low, double high) {
        const double along = between(low, high);
        return {along, between(-100, 100)};
    }
    double side() { return between(-1, 1) < 0 ? -1 : 1; }

    std::mt19937 random_;
};

std::string side_word(double side) { return side > 0 ? "left" : "right"; }

std::string problem_of(const SixBar& six_bar, double start, double tilt, const Complex& origin) {
    std::string points, angles;
    for (int i = 0; i < points_on_path; ++i) {
        const double angle = turn * i / points_on_path;
        const Complex at = origin + std::polar(1.0, tilt) * *six_bar.point(start + angle);
        points += fmt::format("{}[{}, {}]", i ? ", " : "", at.real(), at.imag());
        angles += fmt::format("{}{}", i ? ", " : "", 360.0 * i / points_on_path);
    }
    std::string text = "schema = 1\nmechanism = \"linkage\"\n[dimensions]\n";
    for (const char* name : {"ground", "crank", "coupler", "rocker", "rod", "last"})
        text += fmt::format("{} = {{ min = 5, max = 400 }}\n", name);
    for (const char* name : {"e-x", "e-y", "f-x", "f-y", "p-x", "p-y"})
        text += fmt::format("{} = {{ min = -400, max = 400 }}\n", name);
    const std::string f = ", F = [\"f-x\", \"f-y\"]";
    return text + fmt::format(R"([placement]
origin-x = {{ min = -400, max = 400 }}
origin-y = {{ min = -400, max = 400 }}
tilt = {{ min = -180, max = 180 }}
[links]
frame = {{ A = [0, 0], D = ["ground", 0]{} }}
crank = {{ A = [0, 0], B = ["crank", 0] }}
coupler = {{ B = [0, 0], C = ["coupler", 0], E = ["e-x", "e-y"] }}
rocker = {{ D = [0, 0], C = ["rocker", 0]{} }}
rod = {{ E = [0, 0], G = ["rod", 0], P = ["p-x", "p-y"] }}
last = {{ F = [0, 0], G = ["last", 0] }}
[drive]
link = "crank"
[assembly]
C = {{ side = "{}", from = "B", to = "D" }}
G = {{ side = "{}", from = "E", to = "F" }}
[path]
point = "P"
points = [{}]
timing = "prescribed"
crank_angles = [{}]
crank-start = {{ min = 0, max = 360 }}
[objective]
minimize = "path-rms"
)",
                              six_bar.watt ? "" : f, six_bar.watt ? f : "", side_word(six_bar.side_c),
                              side_word(six_bar.side_g), points, angles);
}

/// Of so many random six-bars of a kind.
void expect_found_again(bool watt, unsigned seed, int count) {
    RandomSixBars random(seed);
    for (int i = 0; i < count; ++i) {
        const SixBar six_bar = random.next(watt);
        const Complex origin(random.between(-100, 100), random.between(-100, 100));
        const double start = random.between(0, turn), tilt = random.between(-3, 3);
        // Fewer starts would take longer: more of them would have to be drawn anew.
        const Solved s = solved(problem_of(six_bar, start, tilt, origin), "auto", 1, 2, 32);
        ASSERT_EQ(s.result.status, Status::solved) << i;
        EXPECT_LT(s.result.best->objective, 1e-10) << i;
        EXPECT_TRUE(s.result.search.complete()) << i;
        EXPECT_GT(s.result.search.drawn, s.result.search.assembled) << i;
        EXPECT_GE(s.result.search.assembled, s.result.search.optimised) << i;
        EXPECT_GE(s.result.search.optimised, s.result.search.starts) << i;
        EXPECT_GE(s.result.search.starts, 1) << i;
    }
}

TEST(SixBars, OfWattsFirstKindAreFoundAgain) { expect_found_again(true, 7, cases_to_try(1, 4)); }

TEST(SixBars, OfStephensonsThirdKindAreFoundAgain) { expect_found_again(false, 7, cases_to_try(1, 4)); }

/// Starts that are drawn close at every target, whatever the round, and the same come from the same seed.
TEST(SixBars, StartsAssemble) {
    RandomSixBars random(3);
    const ReadProblem read = parse_problem(problem_of(random.next(true), 1, 0.5, {20, -30}), "six-bar.toml");
    ASSERT_TRUE(read.messages.empty());
    const Program program = build_program(read.problem, variants(read.problem).front());
    for (const int round : {0, 1, 5}) {
        DrawCounts counts;
        const auto starts = DrawnStarts(program, 1).of_round(round, 3, 4, 4000, counts);
        ASSERT_EQ(starts.size(), 3u);
        EXPECT_GE(counts.drawn, counts.assembled);
        EXPECT_GE(counts.assembled, 3);
        double before = 0;
        for (const Eigen::VectorXd& x : starts) {
            PathResiduals rest;
            ASSERT_TRUE(path_residuals(program, x, false, rest));
            EXPECT_GE(rest.value.squaredNorm(), before);
            before = rest.value.squaredNorm();
        }
        DrawCounts again;
        EXPECT_EQ(DrawnStarts(program, 1).of_round(round, 3, 4, 4000, again), starts);
        EXPECT_EQ(again.drawn, counts.drawn);
    }
}

}  // namespace

}  // namespace mechwright
