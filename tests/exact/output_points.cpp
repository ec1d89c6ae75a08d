// The dyad that ends on the output of a linkage, through accuracy points: every one, against circumcentres. Seen from
// the lever the outer pin of the rod goes along a circle about the inner one, whose centre follows from three places of
// it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "synthesis/exact/exact.h"
#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"
#include "synthesis/target/function/function_target.h"
#include "tests/degree.h"

namespace mechwright {
namespace {

using Place = std::complex<double>;

/// Lengths of a four-bar with pivots in 0 and on the x axis, and the pin that a rod hangs on: from the rocker's pivot
/// towards its pin, or (of the coupler) from the crank's pin towards the rocker's.
struct FourBarBefore {
    double ground, crank, coupler, rocker;
    bool left;
    Place pin;
    bool of_coupler;

    Place outer(double crank_angle) const {
        const Place at = std::polar(crank, crank_angle), to = ground - at;
        const double apart = std::abs(to), along = (apart * apart + coupler * coupler - rocker * rocker) / (2 * apart);
        const Place other =
            at + to / apart * Place(along, (left ? 1 : -1) * std::sqrt(coupler * coupler - along * along));
        return of_coupler ? at + pin * (other - at) / coupler : ground + pin * (other - ground) / rocker;
    }
};

const FourBarBefore of_watt{5, 8.96, 14.56, 11.72, false, {12, 0}, false};
const FourBarBefore of_stephenson{4, 1, 3.5, 3, true, {1.5, 1.2}, true};

/// The outer pin and the turn of the lever at each point.
struct Known {
    std::vector<Place> outer;
    std::vector<double> turns;

    std::size_t count() const { return outer.size(); }
    /// The outer pin as it is seen from the lever.
    Place seen(const Place& pivot, std::size_t i) const { return (outer[i] - pivot) * std::polar(1.0, -turns[i]); }
    /// The place that is equally far from the first three of these.
    Place arm(const Place& pivot) const {
        const Place a = seen(pivot, 0), b = seen(pivot, 1) - a, c = seen(pivot, 2) - a;
        return a + Place(0, 1) * (b * std::norm(c) - c * std::norm(b)) / (2 * (std::conj(b) * c).imag());
    }
    /// 0 where the first three places and another one are on a circle, or a line: a cubic of the pivot's coordinates.
    double determinant(const Place& pivot, std::size_t other) const {
        Eigen::Matrix4d rows;
        for (int i = 0; i < 4; ++i) {
            const Place at = seen(pivot, i < 3 ? static_cast<std::size_t>(i) : other);
            rows.row(i) << std::norm(at), at.real(), at.imag(), 1;
        }
        return rows.determinant();
    }
    /// Whether two of the first three places are one.
    bool is_pole(const Place& pivot) const {
        const Place a = seen(pivot, 0), b = seen(pivot, 1), c = seen(pivot, 2);
        return std::min({std::abs(a - b), std::abs(b - c), std::abs(c - a)}) < 1e-5 * (1 + std::abs(pivot));
    }
};

Known known_of(const FourBarBefore& before, const Problem& problem) {
    const std::size_t scales = problem.mechanism->input->start;
    Known known;
    for (const Vector<double>& point : at_accuracy_points(*problem.function).parts) {
        known.outer.push_back(
            before.outer(problem.dimensions[scales].min + problem.dimensions[scales + 1].min * point.x));
        known.turns.push_back(problem.dimensions[scales + 3].min * point.y);
    }
    return known;
}

ReadProblem read_dyad(const std::string& frame, const std::string& function, bool stephenson,
                      const std::string& numbers) {
    const std::string links = stephenson
                                  ? "crank = { A = [0, 0], B = [1, 0] }\n"
                                    "coupler = { B = [0, 0], C = [3.5, 0], E = [1.5, 1.2] }\n"
                                    "rocker = { D = [0, 0], C = [3, 0] }\n"
                                  : "crank = { A = [0, 0], B = [8.96, 0] }\ncoupler = { B = [0, 0], C = [14.56, 0] }\n"
                                    "rocker = { D = [0, 0], C = [11.72, 0], E = [12, 0] }\n";
    return parse_problem(
        fmt::format("schema = 1\nmechanism = \"linkage\"\n[dimensions]\nrod = {{ min = 0, max = 1e5 }}\n"
                    "output = {{ min = 0, max = 1e5 }}\n{}\n[links]\nframe = {{ A = [0, 0], D = [{}, 0], G = {} }}\n{}"
                    "rod = {{ E = [0, 0], F = [\"rod\", 0] }}\noutput = {{ G = [0, 0], F = [\"output\", 0] }}\n"
                    "[drive]\nlink = \"crank\"\n[assembly]\nC = \"{}\"\nF = \"either\"\n[signals]\n"
                    "angle = {{ angle = \"output\" }}\n[function]\nsignal = \"angle\"\n{}\n[objective]\n"
                    "minimize = \"function-max\"\n[solver]\nmethod = \"exact\"\nstarts = 2\n",
                    numbers, stephenson ? 4 : 5, frame, links, stephenson ? "left" : "right", function),
        "p.toml");
}

const std::string anywhere_x = "gx = { min = -1e5, max = 1e5 }", anywhere_y = "\ngy = { min = -1e5, max = 1e5 }";

const std::string any_start = "{ start = { min = -180, max = 180 }, range = ";

std::string power(int points, int input) {
    return fmt::format(
        "expression = \"x^1.5\"\nx = [1, 4]\naccuracy_points = {}\n"
        "input = {{ start = {}, range = 90 }}\noutput = {}90 }}",
        points, input, any_start);
}
std::string logarithm(int points, int input, const std::string& output = any_start) {
    return fmt::format(
        "expression = \"log10(x)\"\nx = [1, 2]\naccuracy_points = {}\n"
        "input = {{ start = {}, range = 60 }}\noutput = {}60 }}",
        points, input, output);
}

ExactDesigns dyads_found(const Problem& problem) {
    RunOptions options;
    options.jobs = 2;
    return exact_designs(problem, options, {});
}

/// Every design that was found, with a defect or without.
std::vector<std::vector<double>> found_designs(const ExactDesigns& result) {
    std::vector<std::vector<double>> all;
    for (const Solution& s : result.designs)
        all.push_back(s.design.dimensions);
    for (const ExcludedDesign& e : result.excluded)
        all.push_back(e.solution.design.dimensions);
    return all;
}

double value_of(const Problem& problem, const std::vector<double>& design, const char* name) {
    return design[static_cast<std::size_t>(find_dimension(*problem.mechanism, name))];
}

/// That the rod keeps its length at the points, by the numbers of the design alone.
void expect_met(const Problem& problem, const Known& known, const std::vector<double>& design, const Place& pivot) {
    const double start = value_of(problem, design, "output-start"), rod = value_of(problem, design, "rod"),
                 lever = value_of(problem, design, "output");
    for (std::size_t i = 0; i < known.count(); ++i)
        EXPECT_NEAR(std::abs(pivot + std::polar(lever, start + known.turns[i]) - known.outer[i]), rod,
                    1e-12 * (rod + lever + std::abs(pivot)));
}

void expect_pivots(const Problem& problem, const Known& known, const ExactDesigns& result,
                   const std::vector<Place>& expected) {
    const auto designs = found_designs(result);
    ASSERT_EQ(designs.size(), expected.size());
    for (const Place& pivot : expected)
        EXPECT_TRUE(std::any_of(designs.begin(), designs.end(), [&](const auto& design) {
            const Place found(value_of(problem, design, "gx"), value_of(problem, design, "gy"));
            return std::abs(found - pivot) < 1e-7 * (1 + std::abs(pivot));
        })) << pivot;
    for (const auto& design : designs)
        expect_met(problem, known, design, {value_of(problem, design, "gx"), value_of(problem, design, "gy")});
}

/// Pivots for which two more places are on the circle of the first three: Newton's method from many starts. Two cubics
/// have nine points in common: two at infinity, three poles, and the dyads.
std::vector<Place> pivots_of_five(const Known& known) {
    std::vector<Place> roots;
    const auto value = [&](const Place& pivot) {
        return Place(known.determinant(pivot, 3), known.determinant(pivot, 4));
    };
    for (int k = 0; k < 400; ++k) {
        Place at = std::polar(0.02 * std::exp(0.025 * k), 2.399963 * k);
        double moved = 1;
        for (int step = 0; step < 80 && moved > 1e-13; ++step) {
            const double h = 1e-5 * (1 + std::abs(at));
            const Place here = value(at), along = (value(at + h) - value(at - h)) / (2 * h),
                        across = (value(at + Place(0, h)) - value(at - Place(0, h))) / (2 * h);
            const double slopes = (std::conj(along) * across).imag();
            const Place by((std::conj(here) * across).imag() / slopes, (std::conj(along) * here).imag() / slopes);
            at -= by;
            moved = std::abs(by) / (1 + std::abs(at));
        }
        const bool is_root =
            moved <= 1e-9 && std::abs(at) < 1e5 && !known.is_pole(at) && std::abs(known.arm(at)) > 1e-5;
        const bool is_new = std::all_of(roots.begin(), roots.end(), [&](const Place& other) {
            return std::abs(other - at) > 1e-6 * (1 + std::abs(at));
        });
        if (is_root && is_new) roots.push_back(at);
    }
    return roots;
}

TEST(OutputPoints, FiveAreThoseOfNewtonsMethod) {
    std::size_t real = 0;
    for (const bool stephenson : {false, true}) {
        for (const int input : {60, 160}) {
            const ReadProblem read = read_dyad("[\"gx\", \"gy\"]", stephenson ? logarithm(5, input) : power(5, input),
                                               stephenson, anywhere_x + anywhere_y);
            ASSERT_TRUE(read.ok()) << read.messages.front().text;
            const Known known = known_of(stephenson ? of_stephenson : of_watt, read.problem);
            const ExactDesigns result = dyads_found(read.problem);
            EXPECT_TRUE(result.proof);
            ASSERT_TRUE(result.counts);
            // A lever of no length on the rocker's pivot meets any function: one of four.
            EXPECT_EQ(result.counts->tracked, stephenson ? 4U : 3U);
            EXPECT_EQ(result.counts->certified, result.counts->real);
            real += result.counts->real;
            expect_pivots(read.problem, known, result, pivots_of_five(known));
        }
    }
    EXPECT_GE(real, 4U);
}

/// The real roots of a polynomial of degree 4 at most, from its values.
std::vector<double> real_roots_of(const std::function<double(double)>& polynomial) {
    Eigen::Matrix<double, 5, 5> powers;
    Eigen::Matrix<double, 5, 1> values;
    for (int i = 0; i < 5; ++i) {
        const double x = i - 2;
        powers.row(i) << 1, x, x * x, x * x * x, x * x * x * x;
        values[i] = polynomial(x);
    }
    const Eigen::Matrix<double, 5, 1> c = powers.fullPivLu().solve(values);
    int degree = 4;
    while (degree > 0 && std::abs(c[degree]) < 1e-9 * c.cwiseAbs().maxCoeff())
        --degree;
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
    for (int i = 0; i < degree; ++i) {
        if (i > 0) companion(i, i - 1) = 1;
        companion(i, degree - 1) = -c[i] / c[degree];
    }
    std::vector<double> roots;
    for (const auto& root : companion.eigenvalues())
        if (std::abs(root.imag()) < 1e-8 * (1 + std::abs(root))) roots.push_back(root.real());
    return roots;
}

/// Four places are on a circle, or a line, where a determinant vanishes: a cubic of the pivot's place along a line.
TEST(OutputPoints, FourAreThoseOfACubic) {
    std::size_t real = 0;
    for (const int input : {20, 100, 180}) {
        const ReadProblem read = read_dyad("[\"gx\", 1.5]", logarithm(4, input), true, anywhere_x);
        ASSERT_TRUE(read.ok()) << read.messages.front().text;
        const Known known = known_of(of_stephenson, read.problem);
        const auto determinant = [&](double x) { return known.determinant({x, 1.5}, 3); };
        std::vector<Place> expected;
        for (const double x : real_roots_of(determinant))
            expected.emplace_back(x, 1.5);
        const ExactDesigns result = dyads_found(read.problem);
        EXPECT_TRUE(result.proof);
        real += expected.size();
        ASSERT_EQ(result.counts->real, expected.size());
        const auto designs = found_designs(result);
        ASSERT_EQ(designs.size(), expected.size());
        for (const auto& design : designs) {
            const double x = value_of(read.problem, design, "gx");
            EXPECT_TRUE(std::any_of(expected.begin(), expected.end(),
                                    [&](const Place& p) { return std::abs(p.real() - x) < 1e-7 * (1 + std::abs(x)); }));
            expect_met(read.problem, known, design, {x, 1.5});
        }
    }
    EXPECT_GT(real, 3U);
}

/// With the start of the output given, too, the arm has a direction: a quadratic equation.
TEST(OutputPoints, ThreeOfAGivenStartAreThoseOfAQuadraticEquation) {
    for (const int input : {20, 60, 100, 140}) {
        const ReadProblem read =
            read_dyad("[\"gx\", 1.5]", logarithm(3, input, "{ start = 25, range = "), true, anywhere_x);
        ASSERT_TRUE(read.ok()) << read.messages.front().text;
        const Known known = known_of(of_stephenson, read.problem);
        const auto across = [&](double x) {
            const Place a = known.seen({x, 1.5}, 0), b = known.seen({x, 1.5}, 1) - a, c = known.seen({x, 1.5}, 2) - a;
            const Place arm = known.arm({x, 1.5}) * std::polar(1.0, -25 * degree);
            return arm.imag() * (std::conj(b) * c).imag();
        };
        const std::vector<double> expected = real_roots_of(across);
        const ExactDesigns result = dyads_found(read.problem);
        EXPECT_TRUE(result.proof);
        ASSERT_EQ(result.counts->real, expected.size());
        for (const auto& design : found_designs(result)) {
            const double x = value_of(read.problem, design, "gx");
            EXPECT_TRUE(std::any_of(expected.begin(), expected.end(),
                                    [&](double e) { return std::abs(e - x) < 1e-7 * (1 + std::abs(x)); }));
        }
    }
}

TEST(OutputPoints, ThreeOfAGivenPivotAreOneCircumcentre) {
    const ReadProblem read = read_dyad("[6, 3]", logarithm(3, 60), true, "");
    ASSERT_TRUE(read.ok()) << read.messages.front().text;
    const Known known = known_of(of_stephenson, read.problem);
    const ExactDesigns result = dyads_found(read.problem);
    EXPECT_TRUE(result.proof);
    const auto designs = found_designs(result);
    ASSERT_EQ(designs.size(), 1U);
    expect_met(read.problem, known, designs.front(), {6, 3});
    EXPECT_NEAR(value_of(read.problem, designs.front(), "output"), std::abs(known.arm({6, 3})), 1e-10);
}

/// Points that a given linkage passes: it is found again.
TEST(OutputPoints, FindTheLinkageThatMadeThem) {
    const Place pivot(6, 3);
    std::string samples;
    double before = 0, first = 0, last = 0;
    for (int i = 0; i < 5; ++i) {
        const double input = 20 + 30 * i;
        const Place from = of_stephenson.outer(input * degree), to = pivot - from;
        const double apart = std::abs(to), along = (apart * apart + 4.5 * 4.5 - 9) / (2 * apart);
        const Place pin = from + to / apart * Place(along, std::sqrt(4.5 * 4.5 - along * along));
        double angle = std::arg(pin - pivot) / degree;
        if (i > 0) angle = before + std::remainder(angle - before, 360);
        before = angle;
        if (i == 0) first = angle;
        last = angle;
        samples += fmt::format("{}[{}, {:.17g}]", i > 0 ? ", " : "", input, angle);
    }
    const ReadProblem read =
        read_dyad("[\"gx\", \"gy\"]",
                  fmt::format("samples = [{}]\ninput = {{ start = 20, range = 120 }}\noutput = {}{:.17g} }}", samples,
                              any_start, last - first),
                  true, anywhere_x + anywhere_y);
    ASSERT_TRUE(read.ok()) << read.messages.front().text;
    const ExactDesigns result = dyads_found(read.problem);
    EXPECT_TRUE(result.proof);
    const auto designs = found_designs(result);
    EXPECT_TRUE(std::any_of(designs.begin(), designs.end(), [&](const auto& design) {
        const auto is = [&](const char* name, double value) {
            return std::abs(value_of(read.problem, design, name) - value) < 1e-8 * (1 + std::abs(value));
        };
        return is("gx", 6) && is("gy", 3) && is("rod", 4.5) && is("output", 3) && is("output-start", first * degree);
    }));
}

TEST(OutputPoints, OfTheShippedProblemsAreKnown) {
    struct Shipped {
        const char* file;
        FourBarBefore before;
        std::size_t dyads, real;
        double greatest_error;  ///< degrees
    };
    const Shipped watt{"watt-two", {4, 3, 4, 4, false, std::polar(2.0, -30 * degree), false}, 3, 3, 0.008015420410871},
        stephenson{"stephenson-three", {5, 2, 5, 4, true, {4, 2}, true}, 4, 2, 0.016501046966824};
    for (const Shipped& shipped : {watt, stephenson}) {
        const ReadProblem read =
            read_problem(fmt::format("{}/problems/exact/{}-five-points.toml", MECHWRIGHT_SOURCE_DIR, shipped.file));
        ASSERT_TRUE(read.ok()) << shipped.file;
        const ExactDesigns result = dyads_found(read.problem);
        ASSERT_FALSE(result.designs.empty());
        EXPECT_TRUE(result.proof);
        EXPECT_EQ(result.counts->tracked, shipped.dyads);
        EXPECT_EQ(result.counts->certified, shipped.real);
        EXPECT_NEAR(result.designs.front().objective, shipped.greatest_error, 1e-10);
        const Known known = known_of(shipped.before, read.problem);
        const auto designs = found_designs(result);
        EXPECT_EQ(designs.size(), shipped.real);
        for (const auto& design : designs)
            expect_met(read.problem, known, design,
                       {value_of(read.problem, design, "pivot-x"), value_of(read.problem, design, "pivot-y")});
    }
}

/// Of a slide the squares of the rod at three points are equal where two linear equations hold.
TEST(OutputPoints, OfASlideFollowFromLinearEquations) {
    const ReadProblem read = read_problem(MECHWRIGHT_SOURCE_DIR "/problems/exact/rod-and-slide-three-points.toml");
    ASSERT_TRUE(read.ok());
    const ExactDesigns result = dyads_found(read.problem);
    EXPECT_TRUE(result.proof);
    ASSERT_EQ(result.designs.size(), 1U);
    EXPECT_EQ(result.counts->tracked, 1U);
    EXPECT_EQ(result.counts->certified, 1U);
    const FourBarBefore before{5, 2, 5, 4, true, {4, 2}, true};
    const Known known = known_of(before, read.problem);  // of a slide the turns are ways
    Eigen::Matrix2d factors;
    Eigen::Vector2d values;
    for (std::size_t i = 1; i < 3; ++i) {
        const Place e = known.outer[i], first = known.outer[0];
        const double s = known.turns[i], s1 = known.turns[0];
        // |e - (start + s) - i offset|^2 less the same of the first
        factors.row(static_cast<Eigen::Index>(i - 1)) << 2 * (s - e.real()) - 2 * (s1 - first.real()),
            -2 * (e.imag() - first.imag());
        values[static_cast<Eigen::Index>(i - 1)] =
            std::norm(first) - 2 * s1 * first.real() + s1 * s1 - std::norm(e) + 2 * s * e.real() - s * s;
    }
    const Eigen::Vector2d found = factors.fullPivLu().solve(values);
    const auto& design = result.designs.front().design.dimensions;
    EXPECT_NEAR(value_of(read.problem, design, "output-start"), found[0], 1e-11);
    EXPECT_NEAR(value_of(read.problem, design, "offset"), found[1], 1e-11);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(std::abs(known.outer[i] - Place(found[0] + known.turns[i], found[1])),
                    value_of(read.problem, design, "rod"), 1e-11);
}

/// Fewer points than numbers: the best that is found of a family, each member of which meets them.
TEST(OutputPoints, FewerThanNumbersLeaveAFamily) {
    const ReadProblem read = read_dyad("[\"gx\", -14]", power(3, 210), false, "gx = { min = -30, max = 30 }");
    ASSERT_TRUE(read.ok()) << read.messages.front().text;
    const ExactDesigns result = dyads_found(read.problem);
    ASSERT_FALSE(result.designs.empty());
    EXPECT_FALSE(result.proof);
    EXPECT_FALSE(result.counts);
    const Known known = known_of(of_watt, read.problem);
    const auto& design = result.designs.front().design.dimensions;
    expect_met(read.problem, known, design, {value_of(read.problem, design, "gx"), -14});
}

TEST(OutputPoints, SayWhyTheyDoNotApply) {
    const auto why = [](const std::string& frame, const std::string& function, const std::string& numbers) {
        const ReadProblem read = read_dyad(frame, function, true, numbers);
        EXPECT_TRUE(read.ok()) << read.messages.front().text;
        return why_not_applicable("exact", read.problem);
    };
    const auto has = [](const std::string& text, std::string_view part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    has(why("[6, 3]", logarithm(4, 60), ""), "3 of them have one");
    has(why("{ length = 5, angle = \"turn\" }", logarithm(4, 60), "turn = { min = -180, max = 180 }"),
        "the distance of 'G' is given and its angle is not");
    has(why("[\"output\", \"gy\"]", logarithm(4, 60), "gy = { min = -9, max = 9 }"),
        "'output' stands in several coordinates");
}

}  // namespace
}  // namespace mechwright
