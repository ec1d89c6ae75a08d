// Bounds of timed paths: never above what a linkage of the box reaches, by the analysis of the linkage and least
// squares of their own; and the literature's cases, proven.

#include <Eigen/Dense>
#include <complex>
#include <random>

#include "analysis/four_bar.h"
#include "synthesis/proof/timed_path_bound.h"
#include "synthesis/verify/proofs/proof_checks.h"
#include "synthesis/verify/verify.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using four_bar::TimedPathBound;
using testing::shipped;
using testing::solved;
using Complex = std::complex<double>;

Complex complex(const Vector<double>& v) { return {v.x, v.y}; }

/// The least squares of P - O - A p - B w over complex O, A, B as far as they are free (`real_size`: A is real), by
/// projections one after the other.
struct Fitted {
    double sum;
    double crank;  ///< |A|
};

/// How far links and points may reach in both cases.
constexpr double reach = 50;

/// The least squares of P - O - A p - B w over complex O, A and B as far as they are free (`real_size`: A is real). A
/// point farther off than may be is brought within reach, and O and A are fitted again: what is left is then no
/// optimum, but a design all the same.
Fitted fitted(const Problem& problem, const std::vector<Complex>& p, const std::vector<Complex>& w, bool origin,
              bool real_size) {
    const auto n = static_cast<Eigen::Index>(p.size());
    const Complex i1(0, 1);
    Eigen::MatrixXd columns(2 * n, 0);
    const auto add = [&](auto value) {
        columns.conservativeResize(2 * n, columns.cols() + 1);
        for (Eigen::Index i = 0; i < n; ++i) {
            const Complex z = value(static_cast<std::size_t>(i));
            columns(2 * i, columns.cols() - 1) = z.real();
            columns(2 * i + 1, columns.cols() - 1) = z.imag();
        }
    };
    if (origin) {
        add([](std::size_t) { return Complex(1); });
        add([&](std::size_t) { return i1; });
    }
    add([&](std::size_t i) { return p[i]; });
    if (!real_size) add([&](std::size_t i) { return i1 * p[i]; });
    const Eigen::Index placed = columns.cols();
    add([&](std::size_t i) { return w[i]; });
    add([&](std::size_t i) { return i1 * w[i]; });
    Eigen::VectorXd target(2 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        target[2 * i] = problem.path->points[static_cast<std::size_t>(i)].x;
        target[2 * i + 1] = problem.path->points[static_cast<std::size_t>(i)].y;
    }
    Eigen::VectorXd x = columns.completeOrthogonalDecomposition().solve(target);
    if (const double point = x.tail(2).norm(); point > reach) {
        x.tail(2) *= reach / point;
        const Eigen::VectorXd left = target - columns.rightCols(2) * x.tail(2);
        x.head(placed) = columns.leftCols(placed).completeOrthogonalDecomposition().solve(left);
    }
    const double crank = real_size ? std::abs(x[placed - 1]) : std::hypot(x[placed - 2], x[placed - 1]);
    return {(target - columns * x).squaredNorm(), crank};
}

/// The linkage of a point of a box, or nothing: ground, crank, coupler, rocker.
std::optional<FourBar<double>> linkage_at(const Problem& problem, const std::array<double, 4>& at) {
    const double t = at[0];
    std::size_t least = 0, greatest = 0;
    const auto cosine = [&](std::size_t i) { return std::cos(at[3] + problem.path->crank_angles[i]); };
    for (std::size_t i = 0; i < problem.path->points.size(); ++i) {
        if (cosine(i) < cosine(least)) least = i;
        if (cosine(i) > cosine(greatest)) greatest = i;
    }
    const auto diagonal = [&](double c) { return std::sqrt(t * t + (1 - t) * (1 - t) - 2 * t * (1 - t) * c); };
    const double low = diagonal(cosine(least)) * std::cos(at[1]), high = diagonal(cosine(greatest)) * std::cos(at[2]);
    const double fall = (low - high) / (cosine(greatest) - cosine(least));
    if (!(fall > 0)) return std::nullopt;
    const double coupler = t * (1 - t) / fall;
    const double square = std::pow(diagonal(cosine(least)), 2) + coupler * coupler - 2 * coupler * low;
    if (!(square > 0)) return std::nullopt;
    return FourBar<double>{t, 1 - t, coupler, std::sqrt(square)};
}

void expect_no_bound_above_a_linkage(const std::string& file, bool origin, bool real_size) {
    ReadProblem read = parse_problem(shipped(file, "path"), MECHWRIGHT_SOURCE_DIR "/problems/path/p.toml");
    ASSERT_TRUE(read.messages.empty());
    Problem& problem = read.problem;
    const TimedPathBound bound(problem);
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    int compared = 0, positive = 0;
    for (int i = 0; i < 40000; ++i) {
        const auto all = bound.boxes();
        Box box = all[static_cast<std::size_t>(i) % all.size()];
        const Box whole = box;
        const double size = std::pow(10, -4 * unit(random));
        for (std::size_t k = 0; k < Box::most; ++k) {
            box.half[k] = whole.half[k] * size * unit(random);
            box.middle[k] = whole.middle[k] + (2 * unit(random) - 1) * (whole.half[k] - box.half[k]);
        }
        const double least = bound(box).least;
        for (int draw = 0; draw < 3; ++draw) {
            std::array<double, 4> at{};
            for (std::size_t k = 0; k < at.size(); ++k)
                at[k] = box.middle[k] + (2 * unit(random) - 1) * box.half[k];
            // With a start of its own the part's base targets may differ from those of the point: skip those.
            const auto m = linkage_at(problem, at);
            if (!m) continue;
            const Assembly assembly =
                box.part < all.size() / problem.assemblies.size() ? Assembly::open : Assembly::crossed;
            std::vector<Complex> p, w;
            bool assembled = true;
            for (const double angle : problem.path->crank_angles) {
                const auto pose_at = pose(*m, at[3] + angle, assembly);
                assembled = assembled && pose_at.assembled();
                p.push_back(std::polar(1.0, at[3] + angle));
                w.push_back(complex(pose_at.coupler));
            }
            if (!assembled) continue;
            const bool same_bases = [&] {
                const auto extreme = [&](double start, double sign) {
                    std::size_t best = 0;
                    for (std::size_t j = 0; j < problem.path->crank_angles.size(); ++j)
                        if (sign * std::cos(start + problem.path->crank_angles[j]) >
                            sign * std::cos(start + problem.path->crank_angles[best]))
                            best = j;
                    return best;
                };
                return extreme(at[3], 1) == extreme(whole.middle[3], 1) &&
                       extreme(at[3], -1) == extreme(whole.middle[3], -1);
            }();
            if (!same_bases) continue;
            const Fitted best = fitted(problem, p, w, origin, real_size);
            if (best.crank > reach || best.crank * at[0] > reach * (1 - at[0])) continue;
            ++compared;
            positive += least > 0;
            EXPECT_LE(least, best.sum * (1 + 1e-9) + 1e-12) << file << " " << i;
        }
    }
    EXPECT_GT(compared, 40000);
    EXPECT_GT(positive, 30000);
}

TEST(TimedPathBound, IsNeverAboveALinkageOfGivenStart) { expect_no_bound_above_a_linkage("case-2.toml", false, true); }

TEST(TimedPathBound, IsNeverAboveALinkageOfFreeStart) { expect_no_bound_above_a_linkage("case-3.toml", true, false); }

TEST(TimedPathBound, ProvesTheSecondCaseOfTheLiterature) {
    const auto s = solved(shipped("case-2.toml", "path"), "branch-and-bound");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_TRUE(s.result.search.complete());
    EXPECT_FALSE(s.result.search.proof->argument.empty());
    EXPECT_NEAR(s.result.best->objective, 7.41575130678e-7, 1e-16);
    EXPECT_GE(*s.result.search.bound, s.result.best->objective * (1 - 1.1e-6));
    EXPECT_LE(*s.result.search.bound, s.result.best->objective);
    // A bound below the objective of a worse design, without a certificate: another four-bar may come below it.
    nlohmann::ordered_json json = document(s.problem, s.result);
    json["search"]["complete"] = false;
    json["search"].erase("certificate");
    json["objective"]["value"] = 2e-6;
    for (const double bound : {7.415e-7, 1.9e-6}) {
        json["search"]["bound"] = bound;
        EXPECT_EQ(all_passed(check_proof(json)), bound < 7.4157e-7) << bound;
    }
}

/// A range that makes the best design worse leaves a gap: the bound does not know it.
TEST(TimedPathBound, LeavesAGapWhereARangeIsActive) {
    std::string text = shipped("case-2.toml", "path");
    text.replace(text.find("rocker       = { min = 0, max = 50 }"), 36, "rocker       = { min = 0, max = 2.5 }");
    text += in_long_form() ? "[solver]\ntime_limit = 6\n" : "[solver]\ntime_limit = 4\n";
    const auto s = solved(text, "branch-and-bound");
    EXPECT_EQ(s.result.status, Status::limit);
    EXPECT_FALSE(s.result.search.complete());
    ASSERT_TRUE(s.result.search.bound);
    EXPECT_LE(*s.result.search.bound, 7.41575130678e-7);
    EXPECT_GT(s.result.best->objective, 7.42e-7);
    nlohmann::ordered_json json = document(s.problem, s.result);
    EXPECT_TRUE(all_passed(check_proof(json)));
    json["search"]["bound"] = s.result.best->objective * 1.001;
    EXPECT_FALSE(all_passed(check_proof(json)));
}

}  // namespace

}  // namespace mechwright
