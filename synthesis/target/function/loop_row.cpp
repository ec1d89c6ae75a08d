#include "synthesis/target/function/loop_row.h"

#include <Eigen/Dense>

#include "synthesis/target/function/formulas.h"

namespace mechwright {

std::optional<std::array<double, 3>> loop_constants(const FunctionTarget& f, std::span<const double> scales,
                                                    LoopRow<double> (*row)(const double& input, const double& output)) {
    Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for_each_node(f, [&](double share, double part, double weight) {
        const auto at = row(scales[0] + scales[1] * share, scales[2] + scales[3] * part).value;
        const Eigen::Vector3d left(at[0], at[1], at[2]);
        square += weight * left * left.transpose();
        right += weight * at[3] * left;
    });
    const Eigen::Vector3d k = square.colPivHouseholderQr().solve(right);
    if (!k.allFinite()) return std::nullopt;
    return std::array{k[0], k[1], k[2]};
}

}  // namespace mechwright
