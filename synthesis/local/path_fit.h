#pragma once
/// \file
/// A path and the rows beside it as one sum of squares, linearised at a point: what Levenberg and Marquardt's method
/// takes its steps from.

#include <Eigen/Core>
#include <vector>

#include "synthesis/program/program.h"

namespace mechwright {

/// A point with what a step from it needs.
struct PathPlace {
    Eigen::VectorXd x;
    PathResiduals path;
    RowsBesidePath beside;
    Eigen::VectorXd missed;  ///< [row beside the path] by how much it misses its limits, once shifted by its multiplier
    double sum = unlimited;  ///< of the path's weighted squared distances
    double merit = unlimited;  ///< the sum, and `weight` times the squares of what is missed
};

/// The rows go along by an augmented Lagrangian (Powell, Hestenes, Rockafellar): a row c is shifted by its multiplier
/// over the weight, and what it then misses its limits by is one more residual.
class PathFit {
public:
    explicit PathFit(const Program& program);

    /// Values and derivatives at at.x. False where the mechanism does not assemble at a point of the path.
    bool evaluate(PathPlace& at);

    /// The step that makes the linearised residuals least, with steps in scaled variables weighed by root(damping). The
    /// crank angles of an untimed path are eliminated point by point by orthogonal transformations, but for those at
    /// the ends of the stretch where a row depends on them.
    Eigen::VectorXd step(const PathPlace& at, double damping);

    /// A step with half the acceleration of the path of least squares that begins with it, where that is short against
    /// it: geodesic acceleration (Transtrum and Sethna, Improvements to the Levenberg-Marquardt algorithm for nonlinear
    /// least-squares minimization, 2012). The second derivative of the residuals along the step is that of a
    /// difference.
    Eigen::VectorXd bent(const PathPlace& at, const Eigen::VectorXd& step, double damping);

    /// The merit that the linearised residuals promise after a change.
    double promised(const PathPlace& at, const Eigen::VectorXd& change) const;

    /// How far the rows lie outside their limits: the greatest, and the sum of squares.
    double greatest_excess(const PathPlace& at) const;
    double excess_squares(const PathPlace& at) const;

    /// Sets the multipliers to what the point says of them, and the weight greater where the last change of multipliers
    /// did not do; the merit of the point changes with them.
    void sharpen(PathPlace& at);

private:
    struct Columns {
        std::vector<Eigen::Index> dense;  ///< free variables that rows of several points depend on
        std::vector<bool> eliminated;     ///< [point] whether its crank angle is free and is eliminated
    };

    Columns columns(const PathPlace& at) const;
    Eigen::VectorXd solved(const PathPlace& at, double damping, const Eigen::VectorXd& residuals,
                           const Eigen::VectorXd& missed);
    Eigen::VectorXd change_of_residuals(const PathPlace& at, const Eigen::VectorXd& step) const;
    double scaled_norm(const Eigen::VectorXd& step) const { return step.cwiseProduct(scale_).norm(); }
    std::vector<bool> kept_angles(const PathPlace& at) const;
    double entry(const PathPlace& at, Eigen::Index residual, Eigen::Index variable) const;
    bool held(Eigen::Index variable, double x, double slope) const;
    double excess(const PathPlace& at, Eigen::Index row, double shift) const;
    void weigh(PathPlace& at) const;
    Eigen::Index angle_variable(Eigen::Index point) const;

    const Program& program_;
    Eigen::Index points_;
    Eigen::Index each_;  ///< residuals of a point
    Eigen::Index dimensions_;
    bool untimed_;
    std::vector<std::size_t> rows_;
    Eigen::VectorXd multipliers_;
    double weight_ = 1;
    double excess_before_ = unlimited;
    Eigen::VectorXd scale_;    ///< by variable: the greatest norm of its column so far
    Eigen::MatrixXd stacked_;  ///< rows of the linear problem, right-hand side last
    PathResiduals ahead_;      ///< a part of a step ahead
};

}  // namespace mechwright
