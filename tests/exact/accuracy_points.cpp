// Accuracy points: textbook values, and four and five points against an elimination of another kind.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"
#include "synthesis/target/function/function_target.h"
#include "tests/degree.h"
#include "tests/exact/all_solutions.h"

namespace mechwright {
namespace {

Problem function_problem(const std::string& function, const std::string& ground = "1") {
    const ReadProblem read = parse_problem(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground   = )" + ground + R"(
crank    = { min = 0, max = 100000 }
coupler  = { min = 0, max = 100000 }
rocker   = { min = 0, max = 100000 }
assembly = "either"
[function]
)" + function + R"(
[objective]
minimize = "function-max"
[solver]
method = "exact"
)",
                                           "p.toml");
    EXPECT_TRUE(read.ok()) << (read.messages.empty() ? "" : read.messages.front().text);
    return read.problem;
}

struct Textbook {
    const char* name;
    const char* function;
    const char* ground;
    double crank, coupler, rocker, greatest_error;  ///< degrees
};

/// Theory of Machines, chapter 9: example 9-2 and exercises 9-3 and 9-4, each digit as computed from the data. The
/// source counts angles from the other direction of the ground link; where its crank and rocker come out negative they
/// point the other way.
TEST(AccuracyPoints, OfTheTextbookGiveItsLinkages) {
    const std::vector<Textbook> cases{
        {"9-2",
         "expression = \"x^1.5\"\nx = [1, 4]\naccuracy_points = 3\ninput = { start = 210, range = 90 }\n"
         "output = { start = 270, range = 90 }",
         "5", 8.499825, 14.051129, 11.119001, 0.831477},
        {"9-3",
         "expression = \"tan(x)\"\nx = [0, 0.7853981633974483]\naccuracy_points = 3\n"
         "input = { start = 225, range = 90 }\noutput = { start = 270, range = 90 }",
         "3", 3.367953, 5.924621, 4.800064, 0.322467},
        {"9-4",
         "expression = \"1/x\"\nx = [1, 2]\naccuracy_points = [1, 1.5, 2]\ninput = { start = 30, range = 100 }\n"
         "output = { start = 120, range = 90 }",
         "5", 6.553323, 14.330188, 16.656684, 3.805537},
        {"9-4 by Chebyshev",
         "expression = \"1/x\"\nx = [1, 2]\naccuracy_points = 3\ninput = { start = 30, range = 100 }\n"
         "output = { start = 120, range = 90 }",
         "5", 0, 0, 0, 5.336221},
    };
    for (const Textbook& c : cases) {
        const Result result = all_solutions(function_problem(c.function, c.ground));
        ASSERT_EQ(result.status, Status::solved) << c.name;
        const auto& d = result.best->design.dimensions;
        if (c.crank > 0) {
            EXPECT_NEAR(d[1], c.crank, 5e-7) << c.name;
            EXPECT_NEAR(d[2], c.coupler, 5e-7) << c.name;
            EXPECT_NEAR(d[3], c.rocker, 5e-7) << c.name;
        }
        EXPECT_NEAR(result.best->objective, c.greatest_error, 5e-7) << c.name;
        EXPECT_TRUE(result.search.complete()) << c.name;
        EXPECT_EQ(result.search.solutions->certified, 1u) << c.name;
    }
}

/// The accuracy points themselves: example 9-2.
TEST(AccuracyPoints, AreSpreadAsTheZerosOfChebyshev) {
    const Problem p = function_problem(
        "expression = \"x^1.5\"\nx = [1, 4]\naccuracy_points = 3\ninput = { start = 210, range = 90 }\n"
        "output = { start = 270, range = 90 }");
    const auto& x = p.function->accuracy_points;
    ASSERT_EQ(x.size(), 3u);
    EXPECT_NEAR(x[0], 1.200962, 5e-7);
    EXPECT_NEAR(x[1], 2.5, 1e-15);
    EXPECT_NEAR(x[2], 3.799038, 5e-7);
}

TEST(AccuracyPoints, ThatTurnACrankTheOtherWayAreADefectWithItsReason) {
    const Result result = all_solutions(function_problem(
        "expression = \"1/x\"\nx = [1, 2]\naccuracy_points = [1, 1.5, 2]\ninput = { start = 210, range = 100 }\n"
        "output = { start = 300, range = 90 }"));
    EXPECT_EQ(result.status, Status::infeasible);
    ASSERT_EQ(result.excluded.size(), 1u);
    EXPECT_NE(result.excluded[0].defect.find("put-start"), std::string::npos) << result.excluded[0].defect;
}

/// Freudenstein's equation at accuracy points, as rows of a matrix that must lose rank.
struct Rows {
    std::vector<double> input, output;  ///< differences from the starts

    double entry(std::size_t row, int column, double phi, double psi) const {
        const double a = phi + input[row], b = psi + output[row];
        return column == 0 ? std::cos(b) : column == 1 ? -std::cos(a) : column == 2 ? 1 : std::cos(a - b);
    }
    Eigen::Matrix4d four(const std::array<std::size_t, 4>& which, double phi, double psi) const {
        Eigen::Matrix4d m;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                m(i, j) = entry(which[static_cast<std::size_t>(i)], j, phi, psi);
        return m;
    }
    /// The determinant as a cos^2 + b cos sin + c sin^2 of psi, from three values.
    Eigen::Vector3d form(const std::array<std::size_t, 4>& which, double phi) const {
        const double a = four(which, phi, 0).determinant(), c = four(which, phi, std::numbers::pi / 2).determinant();
        const double middle = four(which, phi, std::numbers::pi / 4).determinant();
        return {a, 2 * middle - a - c, c};
    }
    /// crank, coupler and rocker for ground 1.
    Eigen::Vector3d links(double phi, double psi) const {
        Eigen::Matrix3d m;
        Eigen::Vector3d right;
        for (std::size_t i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j)
                m(static_cast<int>(i), j) = entry(i, j, phi, psi);
            right[static_cast<int>(i)] = entry(i, 3, phi, psi);
        }
        const Eigen::Vector3d k = m.fullPivLu().solve(right);
        const double crank = 1 / k[0], rocker = 1 / k[1];
        return {std::abs(crank), std::sqrt(1 + crank * crank + rocker * rocker - 2 * crank * rocker * k[2]),
                std::abs(rocker)};
    }
};

Rows rows_of(const Problem& p, double input_range, double output_range) {
    Rows rows;
    for (const Vector<double>& part : at_accuracy_points(*p.function).parts) {
        rows.input.push_back(part.x * input_range);
        rows.output.push_back(part.y * output_range);
    }
    return rows;
}

/// Every linkage that the program found, with a defect or without.
std::vector<Eigen::Vector3d> found_links(const Result& result) {
    std::vector<Eigen::Vector3d> all;
    const auto add = [&](const Solution& s) {
        const auto& d = s.design.dimensions;
        all.emplace_back(d[1] / d[0], d[2] / d[0], d[3] / d[0]);
    };
    if (result.best) add(*result.best);
    for (const VerifiedDesign& d : result.alternatives)
        add(d.solution);
    for (const ExcludedDesign& e : result.excluded)
        add(e.solution);
    return all;
}

void expect_same(std::vector<Eigen::Vector3d> a, std::vector<Eigen::Vector3d> b, double within) {
    const auto before = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) { return p[0] < q[0]; };
    std::sort(a.begin(), a.end(), before);
    std::sort(b.begin(), b.end(), before);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_LT((a[i] - b[i]).norm(), within * (1 + b[i].norm())) << a[i].transpose() << " | " << b[i].transpose();
}

const std::string free_start = "{ start = { min = -180, max = 180 }, range = ";

TEST(AccuracyPoints, FourWithOneStartAreThoseOfAQuadraticEquation) {
    int real = 0;
    for (int k = 0; k < 40; ++k) {
        const double start = 10 + 8.5 * k;
        const Problem p = function_problem(
            "expression = \"log10(x)\"\nx = [1, 2]\naccuracy_points = 4\n"
            "input = { start = " +
            std::to_string(start) + ", range = 60 }\noutput = " + free_start + "90 }");
        const Rows rows = rows_of(p, 60 * degree, 90 * degree);
        const Eigen::Vector3d f = rows.form({0, 1, 2, 3}, start * degree);
        std::vector<Eigen::Vector3d> expected;
        const double discriminant = f[1] * f[1] - 4 * f[0] * f[2];
        for (const double sign : {1.0, -1.0})
            if (discriminant > 0)
                expected.push_back(
                    rows.links(start * degree, std::atan2(-f[1] + sign * std::sqrt(discriminant), 2 * f[2])));
        real += static_cast<int>(expected.size());
        const Result result = all_solutions(p);
        EXPECT_TRUE(result.search.complete());
        expect_same(found_links(result), expected, 1e-6);
    }
    EXPECT_GT(real, 40);
}

/// For each start of the input two quadratic equations in the start of the output: where their resultant vanishes.
TEST(AccuracyPoints, FiveAreThoseOfAResultant) {
    for (const auto& [expression, from, to] :
         {std::tuple{"log10(x)", "1", "2"}, std::tuple{"x^2", "1", "2"}, std::tuple{"exp(x)", "0", "1"},
          std::tuple{"sin(x)", "0", "1.5"}, std::tuple{"1/x", "1", "2"}}) {
        for (const double input_range : {60.0, 100.0}) {
            const Problem p = function_problem(std::string("expression = \"") + expression + "\"\nx = [" + from + ", " +
                                               to + "]\naccuracy_points = 5\ninput = " + free_start +
                                               std::to_string(input_range) + " }\noutput = " + free_start + "80 }");
            const Rows rows = rows_of(p, input_range * degree, 80 * degree);
            const auto resultant = [&](double phi) {
                const Eigen::Vector3d f = rows.form({0, 1, 2, 3}, phi), g = rows.form({0, 1, 2, 4}, phi);
                const double ac = f[0] * g[2] - g[0] * f[2], ab = f[0] * g[1] - g[0] * f[1],
                             bc = f[1] * g[2] - g[1] * f[2];
                return ac * ac - ab * bc;
            };
            std::vector<Eigen::Vector3d> expected;
            constexpr int steps = 40000;
            for (int i = 0; i < steps; ++i) {
                double low = std::numbers::pi * i / steps, high = std::numbers::pi * (i + 1) / steps;
                const bool rises = resultant(low) < 0;
                if (rises == (resultant(high) < 0)) continue;
                for (int bisection = 0; bisection < 60; ++bisection) {
                    const double middle = 0.5 * (low + high);
                    (rises == (resultant(middle) < 0) ? low : high) = middle;
                }
                // The common root of both quadratics; roots at which three rows alone lose rank are none of ours.
                const Eigen::Vector3d f = rows.form({0, 1, 2, 3}, low), g = rows.form({0, 1, 2, 4}, low);
                const double psi = std::atan2(-(f[0] * g[2] - g[0] * f[2]), f[1] * g[2] - g[1] * f[2]);
                Eigen::Matrix<double, 5, 4> all;
                for (std::size_t r = 0; r < 5; ++r)
                    for (int c = 0; c < 4; ++c)
                        all(static_cast<int>(r), c) = rows.entry(r, c, low, psi);
                const Eigen::JacobiSVD<Eigen::MatrixXd> svd(all);
                const auto& s = svd.singularValues();
                if (s[3] > 1e-9 * s[0]) continue;
                const Eigen::Vector3d links = rows.links(low, psi);
                if (links.allFinite() && links.minCoeff() > 1e-6 && links.maxCoeff() < 1e5) expected.push_back(links);
            }
            const Result result = all_solutions(p);
            EXPECT_TRUE(result.search.complete()) << expression;
            expect_same(found_links(result), expected, 1e-4);
        }
    }
}

/// Fewer points than freedoms: the best of a family, which a minimax optimum bounds.
TEST(AccuracyPoints, FewerThanTheFreeScalesLeaveAFamily) {
    const Result four = all_solutions(
        function_problem("expression = \"log10(x)\"\nx = [1, 2]\naccuracy_points = 4\ninput = " + free_start +
                         "60 }\noutput = " + free_start + "90 }"));
    ASSERT_EQ(four.status, Status::solved);
    EXPECT_FALSE(four.search.complete());
    EXPECT_FALSE(four.search.solutions);
    EXPECT_LT(four.best->objective, 0.0097);
    EXPECT_GT(four.best->objective, 0.0069708);  // the least error that any such four-bar has
}

TEST(AccuracyPoints, SayWhyTheyDoNotApply) {
    const auto why = [](const std::string& function) {
        return why_not_applicable("exact", function_problem(function));
    };
    const std::string given = "input = { start = 30, range = 60 }\noutput = { start = 90, range = 90 }";
    EXPECT_NE(why("expression = \"x^2\"\nx = [1, 2]\n" + given).find("accuracy_points"), std::string::npos);
    EXPECT_NE(why("expression = \"x^2\"\nx = [1, 2]\naccuracy_points = 4\n" + given).find("four accuracy points need"),
              std::string::npos);
    EXPECT_NE(why("expression = \"x^2\"\nx = [1, 2]\naccuracy_points = 5\ninput = " + free_start +
                  "60 }\noutput = { start = 90, range = 90 }")
                  .find("five accuracy points need"),
              std::string::npos);
    EXPECT_NE(why("samples = [[0, 0], [1, 1], [2, 3], [3, 4], [4, 7], [5, 8]]\n" + given).find("there are 6"),
              std::string::npos);
    EXPECT_EQ(why("samples = [[0, 0], [1, 1], [2, 3]]\n" + given), "");
}

}  // namespace
}  // namespace mechwright
