#pragma once
/// \file
/// The four-bar as a function generator: its rocker angle against the function asked for. Angles are counted from the
/// ground link.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "analysis/extremes.h"
#include "analysis/four_bar.h"
#include "analysis/numbers/dual.h"
#include "synthesis/mechanism/four_bar/formulas.h"
#include "synthesis/mechanism/function_target.h"

namespace mechwright::four_bar {

/// Where the scales stand among the dimensions.
enum ScaleIndex : std::size_t { input_start = 10, input_range, output_start, output_range, function_reads };

template <class T>
using FunctionDimensions = std::array<T, function_reads>;

/// The structural error, rocker angle less the angle that the function asks for, in (-pi, pi].
template <class T>
T structural_error(const FunctionDimensions<T>& x, Assembly assembly, const T& share, const T& part) {
    using std::atan2, std::cos, std::sin;
    const auto p = pose(FourBar<T>{x[0], x[1], x[2], x[3]}, T(x[input_start] + x[input_range] * share), assembly);
    const T asked = x[output_start] + x[output_range] * part;
    const Vector<T> direction{cos(asked), sin(asked)};
    return atan2(cross(direction, p.rocker), dot(direction, p.rocker));
}

/// All extremes of the error in their order along the range: its ends, and where its slope vanishes.
inline std::vector<ErrorExtreme> error_extremes(const FunctionTarget& f, const FunctionDimensions<double>& x,
                                                Assembly assembly) {
    std::vector<ErrorExtreme> found;
    if (!f.parts.empty()) {
        for (const Vector<double>& s : f.parts)
            found.push_back({s.x, s.y, structural_error(x, assembly, s.x, s.y), false});
        return found;
    }
    using D = Dual<double, 1>;
    const auto error = [&](double share) { return structural_error(x, assembly, share, part_at(f, share)); };
    FunctionDimensions<D> constant;
    std::copy(x.begin(), x.end(), constant.begin());
    const auto slope = [&](double share) {
        const D at = D::variable(share, 0);
        return structural_error(constant, assembly, at, part_at(f, at)).partial[0];
    };
    constexpr int steps = 128;
    found.push_back({0, 0, error(0), false});
    double left = 0, at_left = slope(0);
    for (int i = 1; i <= steps; ++i) {
        const double right = static_cast<double>(i) / steps, at_right = slope(right);
        if ((at_left > 0) != (at_right > 0)) {
            const double share = zero_between(slope, left, right, at_left, at_right);
            found.push_back({share, 0, error(share), true});
        }
        left = right;
        at_left = at_right;
    }
    found.push_back({1, 1, error(1), false});
    return found;
}

/// The greatest of so many, by size, in their order along the range; fewer are filled up with the last.
inline void keep_greatest(std::vector<ErrorExtreme>& found, std::size_t count) {
    while (found.size() > count)
        found.erase(std::min_element(found.begin(), found.end(), [](const ErrorExtreme& a, const ErrorExtreme& b) {
            return std::abs(a.error) < std::abs(b.error);
        }));
    while (found.size() < count)
        found.push_back(found.back());
}

/// The greatest size of the structural error over the range: every extreme of it with the sign that makes it positive.
struct FunctionMax {
    static constexpr std::size_t reads = function_reads;
    static constexpr std::size_t most = 16;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        FunctionDimensions<double> plain;
        std::transform(x.begin(), x.end(), plain.begin(), [](const T& v) { return value_of(v); });
        const Assembly assembly = assembly_of(motion);
        const FunctionTarget& f = *motion.function;
        auto extremes = error_extremes(f, plain, assembly);
        keep_greatest(extremes, most);
        for (std::size_t k = 0; k < most; ++k) {
            const ErrorExtreme& e = extremes[k];
            const auto along = [&]<class U>(const std::array<U, reads>& d, const U& share) {
                return structural_error(d, assembly, share, f.parts.empty() ? part_at(f, share) : U(e.part));
            };
            const T error = e.stationary ? at_stationary(x, e.share, along) : along(x, T(e.share));
            out[k] = e.error < 0 ? T(-error) : error;
        }
        return most;
    }
};

/// Nodes and weights of Gauss and Legendre's rule with eight points on [0, 1] (Abramowitz and Stegun, table 25.4).
struct GaussNode {
    double at;
    double weight;
};
inline constexpr std::array<double, 4> gauss_nodes{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                                   0.9602898564975363};
inline constexpr std::array<double, 4> gauss_weights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                                     0.1012285362903763};

/// Calls use(share, part, weight) so that the weighted sum is the mean over the range: of samples the mean of them,
/// else the integral by the composite rule.
template <class Use>
void for_each_node(const FunctionTarget& f, const Use& use) {
    if (!f.parts.empty()) {
        for (const Vector<double>& s : f.parts)
            use(s.x, s.y, 1.0 / static_cast<double>(f.parts.size()));
        return;
    }
    constexpr int panels = 8;
    for (int panel = 0; panel < panels; ++panel)
        for (std::size_t k = 0; k < gauss_nodes.size(); ++k)
            for (const double side : {-1.0, 1.0}) {
                const double share = (panel + 0.5 + 0.5 * side * gauss_nodes[k]) / panels;
                use(share, part_at(f, share), 0.5 * gauss_weights[k] / panels);
            }
}

struct FunctionRms {
    static constexpr std::size_t reads = function_reads;
    static constexpr std::size_t most = 1;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        using std::sqrt;
        T sum(0.0);
        for_each_node(*motion.function, [&](double share, double part, double weight) {
            const T error = structural_error(x, assembly_of(motion), T(share), T(part));
            sum += T(weight) * error * error;
        });
        out[0] = sqrt(sum);
        return 1;
    }
};

/// What must be >= 0 for the linkage to assemble over the whole input range: both margins at its ends, and where the
/// crank passes the ground line.
struct FunctionMargin {
    static constexpr std::size_t reads = function_reads;
    static constexpr std::size_t most = 8;
    template <class T>
    static std::size_t components(const Motion&, const std::array<T, reads>& x, Components<T> out) {
        const FourBar<T> m{x[0], x[1], x[2], x[3]};
        const T first = x[input_start], last = x[input_start] + x[input_range];
        const double low = std::min(value_of(first), value_of(last)), high = std::max(value_of(first), value_of(last));
        constexpr double turn = 2 * std::numbers::pi;
        const auto passes = [&](double angle) { return std::ceil((low - angle) / turn) * turn + angle <= high; };
        const std::array<HalfTurn<T>, 4> at{half_turn(first), half_turn(last),
                                            passes(0) ? HalfTurn<T>{T(1), T(0)} : half_turn(first),
                                            passes(turn / 2) ? HalfTurn<T>{T(0), T(1)} : half_turn(last)};
        for (std::size_t k = 0; k < at.size(); ++k) {
            const auto margins = assembly_margins(m, at[k]);
            out[2 * k] = margins.stretch;
            out[2 * k + 1] = margins.fold;
        }
        return most;
    }
};

/// Lengths for given scales by least squares of Freudenstein's equation
///
///     k1 cos(output) - k2 cos(input) + k3 = cos(input - output),  k1 = ground / crank, k2 = ground / rocker,
///
/// (Theory of Machines, chapter 9), which is linear in k1, k2 and k3 = (ground^2 + crank^2 - coupler^2 + rocker^2) /
/// (2 crank rocker). A negative k means that crank or rocker point the other way: its scale is then turned by half a
/// turn where `turns_input` or `turns_output` allow. The ground link is kept. Returns false where no lengths follow.
bool fit_function(const FunctionTarget& f, std::span<double> dimensions, bool turns_input, bool turns_output);

/// function-max and function-rms measured again by the pose of linkage_again.h and the expression itself.
Digits50 function_max_again(const Motion& motion, std::span<const Digits50> dimensions);
Digits50 function_rms_again(const Motion& motion, std::span<const Digits50> dimensions);

}  // namespace mechwright::four_bar
