// Geared five-bars through points at given crank angles, and at any where their cranks turn alike: the one that made
// the points is found again, all that is found meets them, and what does not apply says why.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <optional>
#include <random>
#include <vector>

#include "synthesis/exact/exact.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/quantity_value.h"
#include "tests/degree.h"
#include "tests/long_form.h"

namespace mechwright {
namespace {

struct FiveBar {
    std::complex<double> a, e;  ///< the pivots of the crank that drives and of the other one
    double first, second, left, right, speed, lead;

    /// The common pin; nothing where it does not close.
    std::optional<std::complex<double>> at(double angle) const {
        const std::complex<double> b = a + std::polar(first, angle), d = e + std::polar(second, lead + speed * angle);
        const double distance = std::abs(d - b);
        const double along = (distance * distance + left * left - right * right) / (2 * distance);
        if (!(std::abs(along) < 0.98 * left)) return {};
        return b + std::complex<double>(along, std::sqrt(left * left - along * along)) * (d - b) / distance;
    }
};

constexpr double angle_of_first_point = 40 * degree;

FiveBar random_five_bar(std::mt19937_64& random, double speed, double span) {
    std::uniform_real_distribution<double> part(0, 1);
    for (;;) {
        const FiveBar bars{{-10 * part(random), 10 * part(random)},
                           {40 + 40 * part(random), 20 * part(random)},
                           20 + 20 * part(random),
                           20 + 20 * part(random),
                           50 + 40 * part(random),
                           50 + 40 * part(random),
                           speed,
                           2 * part(random)};
        bool closes = true;
        for (int i = 0; i <= 360 && closes; ++i)
            closes = bars.at(angle_of_first_point + span * i / 360).has_value();
        if (closes) return bars;
    }
}

/// So many points over a span of crank angles, as a path.
std::string points_of(const FiveBar& bars, int count, double span, bool timed) {
    std::string points, angles;
    for (int i = 0; i < count; ++i) {
        const double turned = span * i / count;
        const auto p = *bars.at(angle_of_first_point + turned);
        points += fmt::format("[{:.17g}, {:.17g}], ", p.real(), p.imag());
        angles += fmt::format("{:.17g}, ", turned / degree);
    }
    return "[path]\npoint = \"P\"\npoints = [" + points + "]\n" +
           (timed ? "timing = \"prescribed\"\ncrank_angles = [" + angles + "]\ncrank-start = { min = 0, max = 360 }\n"
                  : "timing = \"free\"\n");
}

const std::string free_pivots =
    "a-x = { min = -500, max = 500 }\na-y = { min = -500, max = 500 }\n"
    "e-x = { min = -500, max = 500 }\ne-y = { min = -500, max = 500 }\n";
const std::string free_links =
    "first = { min = 0, max = 500 }\nsecond = { min = 0, max = 500 }\n"
    "left = { min = 0, max = 500 }\nright = { min = 0, max = 500 }\n"
    "lead = { min = 0, max = 360 }\n";

const std::string any_phase = free_links.substr(0, free_links.find("lead")) + "lead = { min = -720, max = 720 }\n";

std::string geared(const std::string& ratio, const std::string& path, const std::string& dimensions) {
    return "schema = 1\nmechanism = \"linkage\"\n[dimensions]\n" + dimensions +
           "[links]\nframe = { A = [\"a-x\", \"a-y\"], E = [\"e-x\", \"e-y\"] }\n"
           "first = { A = [0, 0], B = [\"first\", 0] }\nsecond = { E = [0, 0], D = [\"second\", 0] }\n"
           "left = { B = [0, 0], P = [\"left\", 0] }\nright = { D = [0, 0], P = [\"right\", 0] }\n"
           "[[gear]]\n" +
           ratio + "phase = \"lead\"\n[drive]\nlink = \"first\"\n[assembly]\nP = \"either\"\n" + path +
           "[objective]\nmaximize = \"transmission-angle-worst\"\n[solver]\nmethod = \"exact\"\nstarts = 2\n";
}

std::string ratio_of(double speed) { return fmt::format("links = [\"first\", \"second\"]\nratio = {}\n", speed); }

Problem read_geared(const std::string& text) {
    const ReadProblem read = parse_problem(text, "p.toml");
    EXPECT_TRUE(read.ok()) << (read.messages.empty() ? "" : read.messages.front().text);
    return read.problem;
}

double size_in(const Problem& problem, const Solution& solution, const char* name) {
    return solution.design.dimensions[static_cast<std::size_t>(find_dimension(*problem.mechanism, name))];
}

ExactDesigns found_for(const Problem& problem) {
    RunOptions options;
    options.jobs = 2;
    return exact_designs(problem, options, {});
}

bool is_there(const Problem& problem, const ExactDesigns& result, const FiveBar& bars) {
    for (const Solution& s : result.designs) {
        const auto off = [&](const char* name, double value) { return std::abs(size_in(problem, s, name) - value); };
        if (off("a-x", bars.a.real()) + off("a-y", bars.a.imag()) + off("e-x", bars.e.real()) +
                off("e-y", bars.e.imag()) + off("first", bars.first) + off("second", bars.second) +
                off("left", bars.left) + off("right", bars.right) <
            1e-5)
            return true;
    }
    return false;
}

void expect_all_met(const Problem& problem, const ExactDesigns& result) {
    for (const Solution& s : result.designs) {
        const auto values = path_values(problem, s.design);
        ASSERT_TRUE(values);
        EXPECT_LT(values->greatest, 1e-8 * (100 + size_in(problem, s, "left") + size_in(problem, s, "first")));
    }
}

TEST(GearedFiveBars, ThatMadeFiveTimedPointsAreFoundAgain) {
    std::mt19937_64 random(5);
    for (int k = 0; k < cases_to_try(1, 20); ++k)
        for (const double speed : {1.0, -1.0, 2.0, -2.0, 0.5}) {
            const double span = 200 * degree;
            const FiveBar bars = random_five_bar(random, speed, span);
            const Problem problem =
                read_geared(geared(ratio_of(speed), points_of(bars, 5, span, true), free_pivots + free_links));
            const ExactDesigns result = found_for(problem);
            EXPECT_TRUE(result.proof) << speed << ": " << result.note;
            ASSERT_TRUE(result.counts);
            EXPECT_EQ(result.counts->distinct + result.counts->at_infinity, 8U);
            EXPECT_EQ(result.counts->certified, result.counts->real);
            EXPECT_TRUE(is_there(problem, result, bars)) << speed;
            expect_all_met(problem, result);
        }
}

// The crank that drives may be either of the gear, and where it turns twice for once of the other one it is in two
// places of a cycle in each direction.
TEST(GearedFiveBars, AreDrivenByEitherGear) {
    std::mt19937_64 random(7);
    const double span = 200 * degree;
    for (const double speed : {2.0, 0.5, -0.5}) {
        const FiveBar bars = random_five_bar(random, speed, span);
        const Problem problem =
            read_geared(geared(fmt::format("links = [\"second\", \"first\"]\nratio = {}\n", 1 / speed),
                               points_of(bars, 5, span, true), free_pivots + any_phase));
        const ExactDesigns result = found_for(problem);
        EXPECT_TRUE(is_there(problem, result, bars)) << speed;
        expect_all_met(problem, result);
    }
}

// Cranks that turn alike: what passes the points are the four-bars through them, seen in another way.
TEST(GearedFiveBars, WithCranksThatTurnAlikePassNinePoints) {
    std::mt19937_64 random(11);
    const double span = 320 * degree;
    const FiveBar bars = random_five_bar(random, 1, span);
    const Problem problem = read_geared(geared(ratio_of(1), points_of(bars, 9, span, false), free_pivots + free_links));
    const ExactDesigns result = found_for(problem);
    ASSERT_TRUE(result.counts);
    EXPECT_EQ(result.counts->tracked, 1442U);
    EXPECT_TRUE(is_there(problem, result, bars));
    expect_all_met(problem, result);
}

TEST(GearedFiveBars, OfAFamilyPassFewerPoints) {
    std::mt19937_64 random(13);
    const double span = 200 * degree;
    const FiveBar bars = random_five_bar(random, -2, span);
    if (in_long_form()) {
        const Problem four =
            read_geared(geared(ratio_of(-2), points_of(bars, 4, span, true), free_pivots + free_links));
        const ExactDesigns of_four = found_for(four);
        EXPECT_FALSE(of_four.designs.empty());
        expect_all_met(four, of_four);
    }
    // The pivots are given: three points leave one.
    const std::string pivots = fmt::format("a-x = {:.17g}\na-y = {:.17g}\ne-x = {:.17g}\ne-y = {:.17g}\n",
                                           bars.a.real(), bars.a.imag(), bars.e.real(), bars.e.imag());
    const Problem three = read_geared(geared(ratio_of(-2), points_of(bars, 3, span, true), pivots + free_links));
    const ExactDesigns of_three = found_for(three);
    EXPECT_TRUE(is_there(three, of_three, bars));
}

TEST(GearedFiveBars, SayWhyTheyAreNotFound) {
    std::mt19937_64 random(17);
    const FiveBar bars = random_five_bar(random, -1, 200 * degree);
    const auto why = [&](const std::string& ratio, int count, bool timed, const std::string& dimensions) {
        return why_not_exact(read_geared(geared(ratio, points_of(bars, count, 200 * degree, timed), dimensions)));
    };
    EXPECT_NE(why(ratio_of(-1), 9, false, free_pivots + free_links).find("ratio = 1"), std::string::npos);
    EXPECT_NE(why(ratio_of(-1), 6, true, free_pivots + free_links).find("up to five points"), std::string::npos);
    std::string given = free_links;
    given.replace(0, given.find('\n'), "first = 30");
    EXPECT_NE(why(ratio_of(-1), 4, true, free_pivots + given).find("8 of the 9 numbers"), std::string::npos);
    EXPECT_EQ(why(ratio_of(-1), 5, true, free_pivots + given), "");
    EXPECT_EQ(why(ratio_of(-1), 4, true, free_pivots + free_links), "");
    EXPECT_EQ(why(ratio_of(1), 8, false, free_pivots + free_links), "");
    const std::string pivots = "a-x = 0\na-y = 0\ne-x = 60\ne-y = 5\n";
    EXPECT_EQ(why(ratio_of(-1), 3, true, pivots + free_links), "");
    EXPECT_NE(why(ratio_of(-1), 4, true, pivots + free_links).find("at most three"), std::string::npos);
}

}  // namespace
}  // namespace mechwright
