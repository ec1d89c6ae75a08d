#include "synthesis/local/linear_program.h"

#include <Eigen/QR>
#include <algorithm>
#include <limits>
#include <vector>

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What remains of a cost of size one after projection, or of a multiplier, below this is rounding.
constexpr double zero_pivot = 1e-11;
constexpr int most_steps = 400;
/// After so many steps the constraint that is let go is the first and not the worst, which ends circles.
constexpr int steps_before_caution = 200;

struct ActiveSet {
    const LinearProgram& program;
    std::vector<Index> rows{};
    VectorXd multipliers{};  ///< by active row, of the costs as they balance best

    /// The steepest way down the cost along the active constraints; sets the multipliers. The way is made of directions
    /// that are orthogonal to the constraints: what is left of the cost less its multipliers is not, by rounding.
    VectorXd way_down() {
        const auto count = static_cast<Index>(rows.size());
        if (count == 0) return -program.cost;
        MatrixXd normals(program.cost.size(), count);
        for (Index k = 0; k < count; ++k)
            normals.col(k) = program.rows.row(rows[static_cast<std::size_t>(k)]).normalized();
        Eigen::ColPivHouseholderQR<MatrixXd> qr(normals);
        qr.setThreshold(zero_pivot);
        multipliers = qr.solve(-program.cost);
        VectorXd along = qr.householderQ().transpose() * -program.cost;
        along.head(qr.rank()).setZero();
        return qr.householderQ() * along;
    }

    /// Lets a constraint go that holds the cost up; false if none does.
    bool release(bool cautious) {
        Index worst = -1;
        for (Index k = 0; k < multipliers.size(); ++k) {
            if (multipliers[k] >= -zero_pivot) continue;
            if (worst < 0 || multipliers[k] < multipliers[worst]) worst = k;
            if (cautious) break;
        }
        if (worst < 0) return false;
        rows.erase(rows.begin() + worst);
        return true;
    }

    bool holds(Index row) const { return std::find(rows.begin(), rows.end(), row) != rows.end(); }
};

/// How far one can go, and what blocks the way.
struct Block {
    double length = std::numeric_limits<double>::infinity();
    Index row = -1;
};

Block first_block(const ActiveSet& active, const VectorXd& z, const VectorXd& way) {
    const LinearProgram& p = active.program;
    Block block;
    for (Index i = 0; i < p.rows.rows(); ++i) {
        const double slope = p.rows.row(i).dot(way);
        if (slope <= zero_pivot * p.rows.row(i).norm() * way.norm() || active.holds(i)) continue;
        const double length = std::max(0.0, p.limit[i] - p.rows.row(i).dot(z)) / slope;
        if (length < block.length) block = {length, i};
    }
    return block;
}

}  // namespace

VectorXd solution_of(const LinearProgram& program, VectorXd z) {
    ActiveSet active{program};
    const double size = program.cost.norm();
    for (int step = 0; step < most_steps; ++step) {
        const VectorXd way = active.way_down();
        if (way.norm() <= zero_pivot * size || active.rows.size() >= static_cast<std::size_t>(z.size())) {
            if (active.rows.empty() || !active.release(step >= steps_before_caution)) break;
            continue;
        }
        const Block block = first_block(active, z, way);
        if (block.row < 0) break;
        z += block.length * way;
        active.rows.push_back(block.row);
    }
    return z;
}

}  // namespace mechwright
