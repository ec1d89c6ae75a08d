#include "synthesis/mechanism/four_bar/function.h"

#include <Eigen/Dense>

namespace mechwright::four_bar {

bool fit_function(const FunctionTarget& f, std::span<double> dimensions, bool turns_input, bool turns_output) {
    Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for_each_node(f, [&](double share, double part, double weight) {
        const double input = dimensions[input_start] + dimensions[input_range] * share;
        const double output = dimensions[output_start] + dimensions[output_range] * part;
        const Eigen::Vector3d row(std::cos(output), -std::cos(input), 1);
        square += weight * row * row.transpose();
        right += weight * std::cos(input - output) * row;
    });
    const Eigen::Vector3d k = square.colPivHouseholderQr().solve(right);
    if (!k.allFinite() || k[0] == 0 || k[1] == 0) return false;
    if ((k[0] < 0 && !turns_input) || (k[1] < 0 && !turns_output)) return false;
    const double ground = dimensions[0];
    const double crank = ground / k[0], rocker = ground / k[1];
    const double coupler_square = ground * ground + crank * crank + rocker * rocker - 2 * crank * rocker * k[2];
    if (!(coupler_square > 0)) return false;
    dimensions[1] = std::abs(crank);
    dimensions[2] = std::sqrt(coupler_square);
    dimensions[3] = std::abs(rocker);
    if (k[0] < 0) dimensions[input_start] += std::numbers::pi;
    if (k[1] < 0) dimensions[output_start] += std::numbers::pi;
    return true;
}

}  // namespace mechwright::four_bar
