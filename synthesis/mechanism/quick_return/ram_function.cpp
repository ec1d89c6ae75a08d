#include "synthesis/mechanism/quick_return/ram_function.h"

#include <Eigen/Dense>

namespace mechwright::quick_return {

bool fit_ram_function(const FunctionTarget& f, std::span<double> dimensions, bool turns_input, bool) {
    Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for_each_node(f, [&](double share, double part, double weight) {
        const double input = dimensions[input_start] + dimensions[input_range] * share;
        const double output = dimensions[output_start] + dimensions[output_range] * part;
        const Eigen::Vector3d row(output * std::cos(input), std::sin(input), 1);
        square += weight * row * row.transpose();
        right += weight * output * output * row;
    });
    const Eigen::Vector3d k = square.colPivHouseholderQr().solve(right);
    if (!k.allFinite() || k[0] == 0 || (k[0] < 0 && !turns_input)) return false;
    const double crank = k[0] / 2, offset = k[1] / k[0];
    const double rod_square = k[2] + crank * crank + offset * offset;
    if (!(rod_square > 0)) return false;
    dimensions[0] = std::abs(crank);
    dimensions[1] = std::sqrt(rod_square);
    dimensions[2] = offset;
    if (k[0] < 0) dimensions[input_start] += std::numbers::pi;
    return true;
}

}  // namespace mechwright::quick_return
