#include "synthesis/search/compact.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "synthesis/mechanism/mechanism.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/variant.h"

namespace mechwright {

namespace {

constexpr double feasible_within = 1e-7;  ///< rows and bounds of a program
constexpr double rank_from = 1e-8;        ///< of the greatest column

/// The room that a search along the family gets, as a part of the length that programs are scaled by.
constexpr double room = 1e-9;

/// A point's residuals by the dimensions; of an untimed point those across the way that its own crank angle moves it.
void put_rows_of_point(const PathResiduals& path, Eigen::Index first, Eigen::Index each, bool untimed,
                       Eigen::MatrixXd& rows) {
    Eigen::MatrixXd of_point = path.jacobian.middleRows(first, each);
    if (untimed) {
        const Eigen::VectorXd along = path.by_angle.segment(first, each).normalized();
        of_point -= along * (along.transpose() * of_point);
    }
    rows.middleRows(first, each) = of_point;
}

/// The gradients of what is required to have a value.
std::vector<Eigen::RowVectorXd> equality_rows(const Program& program, const Eigen::VectorXd& x) {
    std::vector<std::size_t> equalities;
    for (const std::size_t row : rows_beside_path(program))
        if (program.rows[row].equality()) equalities.push_back(row);
    RowsBesidePath values;
    std::vector<Eigen::RowVectorXd> gradients;
    if (equalities.empty() || !evaluate_beside_path(program, equalities, x, true, values)) return gradients;
    for (Eigen::Index i = 0; i < values.jacobian.rows(); ++i)
        gradients.emplace_back(values.jacobian.row(i));
    return gradients;
}

std::size_t free_numbers(const Program& program, const Eigen::VectorXd& x) {
    PathResiduals path;
    const auto dimensions = static_cast<Eigen::Index>(program.dimension_variables);
    if (dimensions == 0 || !path_residuals(program, x, true, path)) return 0;
    const auto each = static_cast<Eigen::Index>(residuals_per_point(program));
    const auto required = equality_rows(program, x);
    Eigen::MatrixXd rows(path.value.size() + static_cast<Eigen::Index>(required.size()), dimensions);
    for (Eigen::Index first = 0; first < path.value.size(); first += each)
        put_rows_of_point(path, first, each, program.untimed_path(), rows);
    for (std::size_t i = 0; i < required.size(); ++i)
        rows.row(path.value.size() + static_cast<Eigen::Index>(i)) = required[i].head(dimensions);
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(rows);
    factors.setThreshold(rank_from);
    const auto rank = static_cast<std::size_t>(factors.rank());
    return program.dimension_variables - rank;
}

/// The programs of a problem that a design can be a point of.
template <class Use>
void for_programs_of(const Problem& problem, const Design& design, const Use& use) {
    for (const Variant& variant : variants(problem))
        if (variant.assembly == design.assembly) {
            const Program program = build_program(problem, variant);
            ProgramValues values;
            const Eigen::VectorXd x = point_of(program, design);
            evaluate(program, x, false, values);
            if (violation(program, x, values) <= feasible_within) use(program, x);
        }
}

}  // namespace

std::size_t free_numbers(const Problem& problem, const Design& design) {
    std::size_t most = 0;
    for_programs_of(problem, design, [&](const Program& program, const Eigen::VectorXd& x) {
        most = std::max(most, free_numbers(program, x));
    });
    return most;
}

std::optional<Problem> along_family(const Problem& problem, const Design& design) {
    const int length = find_quantity(*problem.mechanism, "total-length");
    if (length < 0) return std::nullopt;
    Problem along = problem;
    along.text.clear();  // which asks for something else
    along.objective = Objective{{{static_cast<std::size_t>(length), false, 1}}, false};
    const std::size_t error = problem.objective->terms.front().quantity;
    double distance = 0;
    for_programs_of(problem, design,
                    [&](const Program& program, const Eigen::VectorXd&) { distance = room * program.length; });
    const bool squared = problem.mechanism->quantities[error].unit == Unit::area;
    along.requirements.push_back({error, {}, {}, squared ? distance * distance : distance});
    return along;
}

Solution met_exactly(const Problem& problem, const Design& design, const LocalLimits& limits, long& evaluations) {
    Solution best = assess(problem, design);
    for (const Variant& variant : variants(problem)) {
        if (variant.assembly != design.assembly) continue;
        const Program program = build_program(problem, variant);
        const LocalOutcome outcome = levenberg_marquardt(program, point_of(program, design), limits);
        evaluations += outcome.evaluations;
        if (outcome.x.size() == 0) continue;
        Solution met = assess(problem, design_at(program, outcome.x));
        if (preferred(problem, met, best)) best = std::move(met);
    }
    return best;
}

}  // namespace mechwright
