#include "synthesis/mechanism/four_bar/function.h"

#include <Eigen/Dense>
#include <limits>
#include <memory>

#include "synthesis/mechanism/four_bar/linkage_again.h"

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

namespace {

/// The structural error at shares of the range, from circle intersection and the expression, in either precision.
struct ErrorAgain {
    const FunctionTarget& f;
    std::span<const Digits50> dimensions;
    again::Linkage<Digits50> fine;
    again::Linkage<double> rough;
    std::unique_ptr<ExpressionValues> y;
    double y_from = 0;
    double height = 1;

    ErrorAgain(const Motion& motion, std::span<const Digits50> d)
        : f(*motion.function),
          dimensions(d),
          fine(again::linkage(motion.assembly, d)),
          rough(again::rounded<double>(fine)) {
        if (!f.parts.empty()) return;
        y = std::make_unique<ExpressionValues>(f.expression);
        y_from = (*y)(f.from);
        height = (*y)(f.to) - y_from;
    }

    double part(double share) { return ((*y)(f.from + share * (f.to - f.from)) - y_from) / height; }

    template <class T>
    T error(const again::Linkage<T>& m, double share, double part_of_way) const {
        using std::atan2, std::cos, std::sin;
        const T input = T(dimensions[input_start]) + T(dimensions[input_range]) * T(share);
        const T asked = T(dimensions[output_start]) + T(dimensions[output_range]) * T(part_of_way);
        const again::Pose<T> p = again::pose(m, input);
        if (!p.assembled()) return std::numeric_limits<T>::quiet_NaN();
        const Vector<T> direction{cos(asked), sin(asked)};
        return atan2(cross(direction, p.rocker), dot(direction, p.rocker));
    }

    double rough_size(double share) { return std::abs(error(rough, share, part(share))); }
    Digits50 size(double share, double part_of_way) const { return abs(error(fine, share, part_of_way)); }
};

/// Where a function is greatest between two shares, by golden section.
template <class Function>
double greatest_between(const Function& f, double left, double right) {
    constexpr double golden = 0.6180339887498949;
    double a = right - golden * (right - left), b = left + golden * (right - left);
    double at_a = f(a), at_b = f(b);
    for (int i = 0; i < 60; ++i) {
        if (at_a > at_b) {
            right = b;
            b = a;
            at_b = at_a;
            a = right - golden * (right - left);
            at_a = f(a);
        } else {
            left = a;
            a = b;
            at_a = at_b;
            b = left + golden * (right - left);
            at_b = f(b);
        }
    }
    return 0.5 * (left + right);
}

}  // namespace

Digits50 function_max_again(const Motion& motion, std::span<const Digits50> dimensions) {
    ErrorAgain e(motion, dimensions);
    Digits50 greatest = 0;
    const auto consider = [&](const Digits50& size) {
        if (!(size <= greatest)) greatest = size;  // NaN stays
    };
    for (const Vector<double>& s : e.f.parts)
        consider(e.size(s.x, s.y));
    if (!e.f.parts.empty()) return greatest;
    constexpr int steps = 1000;
    std::vector<double> sizes(steps + 1);
    for (int i = 0; i <= steps; ++i)
        sizes[static_cast<std::size_t>(i)] = e.rough_size(static_cast<double>(i) / steps);
    const double scanned = *std::max_element(sizes.begin(), sizes.end());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        // What falls short of the greatest by more than neighbours differ cannot become the greatest.
        const double before = i > 0 ? sizes[i - 1] : -1, after = i < steps ? sizes[i + 1] : -1;
        if (std::isnan(sizes[i])) return std::numeric_limits<Digits50>::quiet_NaN();
        if (sizes[i] < before || sizes[i] < after || sizes[i] < 0.9 * scanned) continue;
        const double here = static_cast<double>(i) / steps;
        const double share = greatest_between([&](double s) { return e.rough_size(s); },
                                              std::max(0.0, here - 1.0 / steps), std::min(1.0, here + 1.0 / steps));
        for (const double s : {here, share})
            consider(e.size(s, e.part(s)));
    }
    return greatest;
}

Digits50 function_rms_again(const Motion& motion, std::span<const Digits50> dimensions) {
    ErrorAgain e(motion, dimensions);
    Digits50 sum = 0;
    if (!e.f.parts.empty()) {
        for (const Vector<double>& s : e.f.parts)
            sum += e.size(s.x, s.y) * e.size(s.x, s.y) / static_cast<double>(e.f.parts.size());
        return sqrt(sum);
    }
    // Boole's rule: another than the one that is checked.
    constexpr int panels = 64;
    constexpr std::array<int, 4> weights{14, 32, 12, 32};
    for (int i = 0; i <= 4 * panels; ++i) {
        const double share = static_cast<double>(i) / (4 * panels);
        const int weight = i == 0 || i == 4 * panels ? 7 : weights[static_cast<std::size_t>(i % 4)];
        const Digits50 size = e.size(share, e.part(share));
        sum += Digits50(weight) / 90 / panels * size * size;
    }
    return sqrt(sum);
}

}  // namespace mechwright::four_bar
