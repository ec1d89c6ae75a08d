#pragma once
/// \file
/// A lower bound on the sum of squared distances from a timed path over all four-bars.
///
/// With complex numbers the coupler point at crank angle th_i is O + A p_i + B w_i: p_i the direction of the crank, w_i
/// that of the coupler. With the crank 1 - t and the ground t long (t in [0, 1]), D_i = t - (1 - t) exp(i th_i) runs
/// from crank pin to rocker pivot, and w_i stands at the angle +-alpha_i from it, cos alpha_i = L_i / |D_i|, where
/// L_i = (|D_i|^2 + coupler^2 - rocker^2) / (2 coupler) is linear in cos th_i: it is known from the angles alpha and
/// alpha' at two of the targets, those with the least and the greatest cosine of the crank angle. As |D|^2 is linear
/// and L^2 convex in that cosine, the linkage is then assembled at all targets between, and stands at a toggle at none.
/// So every four-bar, whatever its size, is a point of the box (t, alpha, alpha', start of the crank), and O, A and B
/// follow by linear least squares: the least sum is the squared distance of the targets from a plane that turns with
/// the w_i.
///
/// Over a small box the w_i differ from those in its middle by first-order terms, whose derivatives are enclosed in
/// intervals, and a remainder. The distance is bounded by letting the design move along the first-order terms as far as
/// it likes (linear least squares again), or within the box, less the remainder. A turn that is common to all w_i
/// counts for nothing: B undoes it. Sizes matter only where the w_i hardly turn at all and B would have to be large:
/// there the greatest point and ground link that the problem allows bound the sum.
///
/// Limits on ratios, margins and placement are not looked at: the bound holds without them.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "synthesis/problem/problem.h"
#include "synthesis/proof/branch_and_bound.h"

namespace mechwright::four_bar {

struct CouplerTurn;

struct TimedPathBound {
    /// Only for problems that `why_not` has nothing against.
    explicit TimedPathBound(const Problem& problem);

    /// Why a problem is not one of a timed path of a four-bar; empty if it is.
    static std::string why_not(const Problem& problem);

    /// Boxes that hold all designs.
    std::vector<Box> boxes() const;

    /// The bound of the weighted sum of squares over a box.
    BoxBound operator()(const Box& box) const;

private:
    struct Part {
        double side;           ///< +1 open, -1 crossed
        std::size_t least;     ///< the target with the least cosine of the crank angle
        std::size_t greatest;  ///< and with the greatest
    };

    /// The targets of some weights, and what O and A can do about them; complex numbers as real ones, real parts first.
    struct Plane {
        Eigen::VectorXd root_weights;
        Eigen::MatrixXd origin;                ///< orthonormal columns: all that O can do
        Eigen::MatrixXd fixed;                 ///< and A too
        Eigen::VectorXd target_beyond_origin;  ///< less what O can do
        Eigen::VectorXd target;                ///< less what A can do too
        double crank_beyond_origin;            ///< norm of the p_i less what O can do
    };
    Plane plane_of(const Eigen::VectorXd& root_weights) const;

    double distance_over(const Plane& plane, const std::vector<CouplerTurn>& turns, const Box& box,
                         double greatest_crank, std::size_t& split) const;

    std::vector<double> angles_;  ///< of the crank, less the start where it is free
    bool free_start_, free_tilt_, free_origin_;
    double start_from_, start_to_;
    std::vector<Vector<double>> points_, cranks_;
    Plane plane_;
    double greatest_point_;  ///< |B|
    double greatest_ground_;
    double greatest_crank_;
    std::vector<Part> parts_;
    std::vector<Box> boxes_;
};

}  // namespace mechwright::four_bar
