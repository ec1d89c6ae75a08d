#include "synthesis/proof/coupler_turn.h"

#include <algorithm>
#include <numbers>

namespace mechwright::four_bar {

namespace {

constexpr std::size_t parameters = Box::most;
constexpr double pi = std::numbers::pi;
/// Where the coupler's direction may turn faster than this with a parameter, boxes are divided as if it did not.
constexpr double steepest = 10;

/// L = share L_greatest + (1 - share) L_least: |D| times the derivatives of L / |D| by the parameters, and |D| + L and
/// |D| - L, which never cancel: as |D|^2 is linear in the cosine of the crank angle, |D| lies above its chord between
/// the bases by share (1 - share) (|D|_greatest - |D|_least)^2 / (|D| + chord), and at a base they are 2 |D| cos^2
/// (alpha / 2) and 2 |D| sin^2 (alpha / 2).
template <class T>
struct Between {
    T sum, difference;  ///< of |D| and L
    std::array<T, parameters> slope;
};

template <class T>
Between<T> between(const T& t, const Diagonal<T>& d, const Base<T>& least, const Base<T>& greatest, bool obtuse) {
    const T one(1.0), two(2.0);
    const T whole = greatest.diagonal.cosine - least.diagonal.cosine;
    const T part = d.cosine - least.diagonal.cosine;
    const T share = part / whole, rest = one - share;
    const T share_slope =
        ((least.diagonal.sine - d.sine) * whole - part * (least.diagonal.sine - greatest.diagonal.sine)) /
        square(whole);
    // |D|_greatest - |D|_least, and from it L_greatest - L_least.
    const T steep = T(-2.0) * t * (one - t) * whole / (greatest.diagonal.length + least.diagonal.length);
    const T cosines = two * (greatest.diagonal.length * square(greatest.half_cosine) -
                             least.diagonal.length * square(least.half_cosine));
    const T sines =
        two * (greatest.diagonal.length * square(greatest.half_sine) - least.diagonal.length * square(least.half_sine));
    const T rise = obtuse ? T(cosines - steep) : T(steep - sines);
    const T chord = share * greatest.diagonal.length + rest * least.diagonal.length;
    const T above = share * rest * square(steep) / (d.length + chord);
    Between<T> l;
    l.sum = above + two * (share * greatest.diagonal.length * square(greatest.half_cosine) +
                           rest * least.diagonal.length * square(least.half_cosine));
    l.difference = above + two * (share * greatest.diagonal.length * square(greatest.half_sine) +
                                  rest * least.diagonal.length * square(least.half_sine));
    const T ratio = (l.sum - l.difference) / (two * d.length);
    l.slope = {(two * t - one) * (share * greatest.cosine * greatest.diagonal.by_t +
                                  rest * least.cosine * least.diagonal.by_t - ratio * d.by_t),
               -(rest * least.diagonal.length * least.sine), -(share * greatest.diagonal.length * greatest.sine),
               share_slope * rise + t * (one - t) *
                                        (share * greatest.cosine * greatest.diagonal.by_angle +
                                         rest * least.cosine * least.diagonal.by_angle - ratio * d.by_angle)};
    return l;
}

/// Derivatives of the direction of D by t and by the crank angle.
template <class T>
std::array<T, parameters> slopes_of_diagonal(const T& t, const Diagonal<T>& d) {
    const T one(1.0);
    return {d.sine / d.square, T(0.0), T(0.0), (one - t) * ((one - t) - t * d.cosine) / d.square};
}

/// Those of the direction of w at a target that is not a base: cos alpha = L / |D|.
template <class T>
std::array<T, parameters> slopes_between(double side, const T& t, const Diagonal<T>& d, const Between<T>& l,
                                         const T& root) {
    std::array<T, parameters> slope = slopes_of_diagonal(t, d);
    const T per = T(-side) / (root * d.length);
    for (std::size_t k = 0; k < parameters; ++k)
        slope[k] = slope[k] + per * l.slope[k];
    return slope;
}

/// alpha from |D| + L and |D| - L.
double alpha_of(double sum, double difference) {
    return 2 * std::atan2(std::sqrt(std::max(0.0, difference)), std::sqrt(std::max(0.0, sum)));
}

}  // namespace

CouplerTurn coupler_turn(const Ranges& over, double crank_angle, Role role) {
    CouplerTurn result;
    const double t = over.middle[0];
    const Diagonal<Interval> wide = diagonal_at(over.t, Interval(over.start + Interval(crank_angle)));
    const Diagonal<double> here = diagonal_at(t, over.middle[3] + crank_angle);
    const double direction = std::atan2(-(1 - t) * here.sine, t - (1 - t) * here.cosine);
    const bool short_diagonal = !(wide.square.low > 0);
    std::array<Interval, parameters> slope{};
    std::array<double, parameters> slope_here{};
    bool has_slopes = !short_diagonal && here.square > 0;
    double by_range = pi;
    if (role != Role::between) {
        const std::size_t own = role == Role::least ? 1 : 2;
        result.angle = direction + over.side * over.middle[own];
        if (has_slopes) {
            slope = slopes_of_diagonal(over.t, wide);
            slope_here = slopes_of_diagonal(t, here);
            slope[own] = slope_here[own] = over.side;
        }
    } else {
        const Between<Interval> l = between(over.t, wide, over.least, over.greatest, over.obtuse);
        const Between<double> l_here = between(t, here, over.least_here, over.greatest_here, over.obtuse);
        const double alpha = alpha_of(l_here.sum, l_here.difference);
        result.angle = direction + over.side * alpha;
        const double root_here = std::sqrt(std::max(0.0, l_here.sum) * std::max(0.0, l_here.difference)) / here.length;
        const Interval root = sqrt(l.sum * l.difference) / wide.length;
        if (!short_diagonal) {
            const double low = alpha_of(l.sum.high, l.difference.low), high = alpha_of(l.sum.low, l.difference.high);
            const Interval range = detail::outward(low, high, 8);
            const auto of_diagonal = slopes_of_diagonal(over.t, wide);
            by_range = of_diagonal[0].size() * over.half[0] + of_diagonal[3].size() * over.half[3] +
                       std::max(range.high - alpha, alpha - range.low);
        }
        has_slopes = has_slopes && root.low > 0 && root_here > 0;
        if (has_slopes) {
            slope = slopes_between(over.side, over.t, wide, l, root);
            slope_here = slopes_between(over.side, t, here, l_here, root_here);
        }
    }
    result.astray = std::min(by_range, pi);
    for (std::size_t k = 0; k < parameters; ++k)
        result.doubt[k] = std::min(over.half[k], result.astray);
    if (!has_slopes) return result;
    double by_slopes = 0;
    for (std::size_t k = 0; k < parameters; ++k) {
        if (!(over.half[k] > 0)) continue;
        result.doubt[k] = over.half[k] * std::min(slope[k].size(), steepest);
        by_slopes += over.half[k] * (slope[k] - Interval(slope_here[k])).size();
    }
    if (!(by_slopes < result.astray)) return result;
    result.astray = by_slopes;
    for (std::size_t k = 0; k < parameters; ++k)
        result.slope[k] = over.half[k] > 0 ? slope_here[k] : 0;
    return result;
}

}  // namespace mechwright::four_bar
