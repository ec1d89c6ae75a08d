#include "tests/fuzz/evaluation.h"

#include <algorithm>
#include <cstring>

#include "synthesis/program/assess.h"
#include "synthesis/program/program.h"
#include "synthesis/search/starts.h"
#include "tests/fuzz/require.h"

namespace mechwright::test {

namespace {

/// What takes long to evaluate shows nothing that less of it does not show.
constexpr std::size_t most_points = 40;
constexpr std::size_t most_variants = 3;

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool same_bits(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) { return same_bits(x, y); });
}

void check_sizes(const Program& program, const ProgramValues& at) {
    const auto variables = static_cast<Eigen::Index>(program.size());
    const auto rows = static_cast<Eigen::Index>(program.rows.size());
    require(at.rows.size() == rows, "every row has a value");
    require(at.gradient.size() == variables, "there is a derivative by every variable");
    require(at.jacobian.rows() == rows && at.jacobian.cols() == variables, "every row has its derivatives");
}

void check_hessian(const Program& program, const Eigen::VectorXd& x) {
    const Eigen::VectorXd multipliers = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(program.rows.size()));
    LagrangianHessian of;
    lagrangian_hessian(program, x, 1, multipliers, of);
    const Eigen::MatrixXd& hessian = of.value;
    require(hessian.rows() == x.size() && hessian.cols() == x.size(), "the Hessian is square");
    require(!hessian.allFinite() || hessian == hessian.transpose(), "the Hessian is symmetric");
}

void check_values(const Program& program, const Eigen::VectorXd& x) {
    ProgramValues at;
    evaluate(program, x, true, at);
    ProgramValues plain;
    evaluate(program, x, false, plain);
    // Where a derivative is infinite, as at a toggle, an optimiser is told that nothing assembles.
    require(!at.assembled || plain.assembled, "what assembles with derivatives does so without");
    if (!at.assembled) return;
    check_sizes(program, at);
    require(same_bits(at.objective, plain.objective) && same_bits(at.rows, plain.rows),
            "derivatives do not change values");
    check_hessian(program, x);
}

void check_program(const Problem& problem, const Program& program) {
    constexpr int candidates = 2;
    const Eigen::VectorXd x = start_point(program, problem.solver.seed, 0, candidates);
    require(x.size() == static_cast<Eigen::Index>(program.size()), "a start has every variable");
    if (program.size() > 0) check_values(program, x);  // else there is nothing to differentiate by
    const Solution solution = assess(problem, design_at(program, x));
    require(solution.violation >= 0, "a violation is not negative");
    require(!solution.feasible || solution.violation <= problem.solver.tolerance, "what is feasible violates nothing");
}

}  // namespace

void check_evaluation(const Problem& problem) {
    if (problem.path && problem.path->points.size() > most_points) return;
    // Linkages of one's own, rooms and regions take a hundred times as long: one in sixteen, the same every time.
    if (!problem.mechanism->made_from.empty() && !problem.sha256.starts_with('0')) return;
    const std::vector<Variant> all = variants(problem);
    for (std::size_t i = 0; i < std::min(all.size(), most_variants); ++i)
        check_program(problem, build_program(problem, all[i]));
}

}  // namespace mechwright::test
