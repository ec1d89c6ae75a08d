#pragma once
/// \file
/// A variant of a problem as a nonlinear program
///
///     minimise f(x)  subject to  lower <= c(x) <= upper  and bounds on x,
///
/// with exact first and second derivatives. Lengths are divided by the size of the problem, angles are radians, so that
/// every number a solver meets is of order one, and the same whatever unit the file is written in; each constraint is
/// scaled so that its violation is the relative one that the problem's tolerance speaks of.
///
/// Objective and constraints are linear in the variables and in *outputs*: smooth components of quantities, and
/// measures of the path.

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "synthesis/program/result.h"
#include "synthesis/program/variant.h"

namespace mechwright {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

struct Variable {
    std::string name;
    double lower;
    double upper;
};

struct LinearTerm {
    std::size_t index;
    double factor;
};

struct LinearForm {
    std::vector<LinearTerm> outputs;
    std::vector<LinearTerm> variables;
    double constant = 0;
};

struct Row {
    std::string name;
    LinearForm form;
    double lower = -unlimited;
    double upper = unlimited;
    bool requirement = false;  ///< stands in the problem, and is not a condition for the rest to make sense
    bool equality() const { return lower == upper; }
};

/// The components of one quantity as outputs first, first + 1, ...
struct QuantityBlock {
    const Quantity* quantity;
    Motion motion;
    std::size_t first;
    std::size_t count;
    /// Over the stretch from the first to the last target, as margins of assembly are: its start and range are the last
    /// arguments (target/path/rows/stretch.h).
    bool along_stretch = false;
};

/// The measures of the path as outputs; those not asked for have no place.
struct PathBlock {
    /// Of all points, or of those of one of several targets.
    struct Mean {
        std::size_t of_target = every_target;
        std::optional<std::size_t> sum{};  ///< weighted sum of squared distances
        std::optional<std::size_t> rms{};  ///< root of its weighted mean; not smooth at zero
    };
    std::vector<Mean> means{{}};           ///< of all points first, then of targets by themselves
    std::optional<std::size_t> squares;    ///< squared distances, one per point
    std::optional<std::size_t> distances;  ///< distances, one per point; not smooth at zero
    std::optional<std::size_t> misses;     ///< `residuals_per_point` per point, not weighted: those of a point are next
                                           ///< to each other
};

/// A variable that bounds outputs from one side so that the worst of them can be optimised smoothly.
struct Epigraph {
    std::size_t variable;
    bool above;  ///< variable >= each output, else <= each
    std::vector<LinearTerm> outputs;
};

struct Program {
    const Problem* problem = nullptr;
    Variant variant;
    double length = 1;  ///< by which lengths are divided
    Model model{};      ///< the mechanism's, with its own lengths divided so, too

    std::vector<double> dimensions;                ///< scaled; to those that follow from variables these are added
    std::vector<std::ptrdiff_t> variable_of;       ///< by dimension: its own variable, or -1
    std::vector<std::vector<LinearTerm>> follows;  ///< by dimension: its own variable, those of others where it is tied
    std::vector<Variable> variables;               ///< dimensions, then path angles, then epigraphs
    std::size_t dimension_variables = 0;           ///< the first of them
    std::size_t first_path_angle = 0;              ///< of as many as there are points, for an untimed path
    std::vector<Vector<double>> targets;           ///< scaled
    std::vector<QuantityBlock> blocks;
    std::optional<PathBlock> path;
    std::vector<Epigraph> epigraphs;
    std::size_t outputs = 0;

    LinearForm objective;
    bool closest_to_reference = false;  ///< no objective: the least squared distance from `reference`
    Eigen::VectorXd reference;
    std::vector<Row> rows;

    std::size_t size() const { return variables.size(); }
    Form form(std::size_t guided_target = 0) const { return {model.data(), variant.assembly, guided_target}; }
    bool untimed_path() const { return path && !problem->path->prescribed_timing; }
};

/// Builds the program of a variant. `problem` must outlive it.
Program build_program(const Problem& problem, const Variant& variant);

/// The same program asking for the least greatest violation of the required inequalities, as its last variable;
/// equalities and conditions of motion are kept.
Program relaxed(Program program);

/// The same program with its objective, and what bounds the objective's outputs, in units of `size`: for an objective
/// that is small against what the program was scaled for.
Program magnified(Program program, double size);

/// The same program of an untimed path with a limit on the distances of its points, in terms of what is missed: nothing
/// along the curve, and no more than the limit along the normal that the curve has at x. Its variables are the same,
/// and its feasible points are feasible for the program. Nothing where there is no such limit, or the curve has a cusp
/// at a point.
std::optional<Program> met_along_normals(const Program& program, const Eigen::VectorXd& x);

/// The outputs at a point, and what they are computed from. Kept with the values, so that the next evaluation of the
/// same program finds its memory and allocates none.
struct Outputs {
    bool assembled = true;
    std::vector<double> dimensions;  ///< those that are variables taken from the point
    Eigen::VectorXd value;
    Eigen::MatrixXd jacobian;        ///< [output][variable]; only where asked for
    Eigen::VectorXd path_sums;       ///< weighted sums of squared distances: [mean of the path]
    Eigen::MatrixXd path_gradients;  ///< their gradients: [variable][mean of the path]; only where asked for
};

/// Objective and rows at a point.
struct ProgramValues {
    bool assembled = false;  ///< false: the mechanism does not close where it is needed; nothing else is then valid
    double objective = 0;
    Eigen::VectorXd rows;
    Eigen::VectorXd gradient;  ///< of the objective; only where asked for
    Eigen::MatrixXd jacobian;  ///< [row][variable]; only where asked for
    Outputs outputs;           ///< what objective and rows are linear in
};

/// Evaluates the program at x. Derivatives cost a few times the values and are computed only if asked for; values are
/// the same bits either way. Where `out` has held values of the same program before, nothing is allocated.
void evaluate(const Program& program, const Eigen::VectorXd& x, bool derivatives, ProgramValues& out);

/// How many residuals a point of the path has: two, the weighted miss in x and y; for a guided body four, those of the
/// direction in which it faces, times its length, too.
std::size_t residuals_per_point(const Program& program);

/// The path as a least-squares problem. The residuals of a point follow each other; they depend on the dimensions,
/// which are the first variables of the program, and in an untimed path on the point's own crank angle.
struct PathResiduals {
    Eigen::VectorXd value;           ///< [residual]
    Eigen::MatrixXd jacobian;        ///< [residual][dimension variable]
    Eigen::VectorXd by_angle;        ///< derivative by the point's own crank angle; only in an untimed path
    std::vector<double> dimensions;  ///< what they are computed from
};

/// The residuals at x; derivatives only where asked for. False where the mechanism does not assemble. Allocates as
/// `evaluate` does.
bool path_residuals(const Program& program, const Eigen::VectorXd& x, bool derivatives, PathResiduals& out);

/// The rows that speak neither of the path's distances nor of the crank angles of its points: conditions of motion,
/// margins of assembly, requirements on other quantities.
std::vector<std::size_t> rows_beside_path(const Program& program);

struct RowsBesidePath {
    Eigen::VectorXd value;     ///< [row of those asked for]
    Eigen::MatrixXd jacobian;  ///< [row][variable]; only where asked for
    Outputs outputs;
};

/// Those rows at x, without the path. False where one has no value. Allocates as `evaluate` does.
bool evaluate_beside_path(const Program& program, std::span<const std::size_t> rows, const Eigen::VectorXd& x,
                          bool derivatives, RowsBesidePath& out);

/// A Hessian, and what it is computed from.
struct LagrangianHessian {
    Eigen::MatrixXd value;  ///< [variable][variable], full symmetric
    std::vector<double> dimensions;
    Eigen::VectorXd weights;         ///< [output]
    Eigen::MatrixXd path_gradients;  ///< of the weighted sums of squared distances: [variable][mean of the path]
    Eigen::VectorXd path_roots;      ///< root mean squares, those that count: [mean of the path]
    std::vector<double> components;  ///< of one quantity: values, gradients, Hessians
};

/// The Hessian of weight f(x) + sum multipliers[i] c_i(x). Allocates as `evaluate` does.
void lagrangian_hessian(const Program& program, const Eigen::VectorXd& x, double weight,
                        const Eigen::VectorXd& multipliers, LagrangianHessian& out);

/// The greatest violation of rows and bounds; infinite where the mechanism does not assemble.
double violation(const Program& program, const Eigen::VectorXd& x, const ProgramValues& values);

/// x with every variable that leaves its range at the end of it.
Eigen::VectorXd within_bounds(const Program& program, Eigen::VectorXd x);

/// Sets the epigraph variables of x to the worst of what they bound.
void settle_epigraphs(const Program& program, Eigen::VectorXd& x);

/// The angle less or more whole turns, so that it lies in a range; in a range of less than a turn perhaps at its end.
double into_range(double angle, double least, double greatest);

/// The point of the program as a design in the user's lengths, and the other way round (for a design of this variant).
Design design_at(const Program& program, const Eigen::VectorXd& x);
Eigen::VectorXd point_of(const Program& program, const Design& design);

}  // namespace mechwright
