#pragma once
/// \file
/// The area within the outline of what a blade sweeps, as a function of the dimensions: Green's theorem, arc by arc,
/// each of which moves with its corners.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "analysis/numbers/resolved.h"
#include "synthesis/mechanism/linkage/rooms/swept/curves.h"

namespace mechwright::measuring {

/// Twice the area between a panel of an arc and the origin, by places alone: beside a limit slopes are rounding, of
/// which places have but little.
template <class T, class Place>
T twice_area_by_places(const Panel& panel, const Place& place_at) {
    std::array<T, Panel::nodes> x, y;
    for (std::size_t i = 0; i < Panel::nodes; ++i) {
        const Vector<T> place = place_at(panel.at(i));
        x[i] = place.x;
        y[i] = place.y;
    }
    T sum(0);
    for (std::size_t i = 0; i < Panel::nodes; ++i)
        sum = sum + T(panel.weight(i)) * (x[i] * panel.slope_at(i, y) - y[i] * panel.slope_at(i, x));
    return sum;
}

/// By how much times along an arc are moved so that its ends are where they move with the dimensions. A piece moves
/// with the limits at its ends, as places of a share do not become infinitely fast; along it shares are moved in
/// proportion.
template <class T>
class ShiftAlong {
public:
    template <class Curves>
    ShiftAlong(Curves& curves, std::size_t piece, const Stretch& stretch, double rate,
               const std::array<double, 2>& shares, const std::array<T, 2>& shifts)
        : stretch_(stretch),
          rate_(rate),
          from_(shares[0]),
          of_piece_{curves.shift_of_limit(piece, false), curves.shift_of_limit(piece, true)} {
        std::array<T, 2> of_share{T(0), T(0)};
        for (const std::size_t end : {0u, 1u})
            if (stretch.speed(shares[end]) > 0)
                of_share[end] = (shifts[end] - with_piece(shares[end])) / T(stretch.speed(shares[end]) / rate);
        first_ = of_share[0];
        growth_ = (of_share[1] - of_share[0]) / T(shares[1] - shares[0]);
    }

    T at(double s) const { return with_piece(s) + T(stretch_.speed(s) / rate_) * of_share(s); }
    /// By the share.
    T slope(double s) const {
        const double speed = stretch_.speed(s) / rate_;
        return T(stretch_.speed(s) / stretch_.length()) * (of_piece_[1] - of_piece_[0]) +
               T(stretch_.speed_slope(s) / rate_) * of_share(s) + T(speed) * growth_;
    }

private:
    T with_piece(double s) const {
        const double part = (stretch_.at(s) - stretch_.from) / stretch_.length();
        return T(1 - part) * of_piece_[0] + T(part) * of_piece_[1];
    }
    T of_share(double s) const { return first_ + T(s - from_) * growth_; }

    const Stretch& stretch_;
    double rate_, from_;
    std::array<T, 2> of_piece_;
    T first_{}, growth_{};
};

/// Twice the area between an arc and the origin, against the clock. `plain` are the same curves in doubles: they say
/// how many panels an arc needs.
template <class T, std::size_t K>
T twice_area_of(SweptCurves<T, K>& curves, SweptCurves<double, K>& plain, const SweptOutline& outline,
                const SweptArc& arc) {
    const SweptCurve& curve = outline.curves[arc.curve];
    const T first = curves.shift(arc.first, arc.curve), last = curves.shift(arc.last, arc.curve);
    if (curve.is_straight()) {
        const auto [start, end] = curves.ends_of(curve);
        const Vector<T> along = end - start;
        return cross(Vector<T>(start + T(T(arc.from) + first) * along), Vector<T>(start + T(T(arc.to) + last) * along));
    }
    // By the share of the whole piece, in which what grows like the root of the way from a limit is smooth. Beside a
    // limit slopes are rounding of the input, and places have but little of it.
    const Stretch& stretch = outline.pieces[curve.piece].stretch;
    double from = stretch.share_of(arc.from), to = stretch.share_of(arc.to);
    constexpr double beside = 0x1p-6;
    std::vector<Panel> by_places;
    if (stretch.root_at_from && from == 0) {
        by_places.push_back({0, std::min(beside, 0.5 * to)});
        from = by_places.back().to;
    }
    if (stretch.root_at_to && to == 1) {
        by_places.push_back({std::max(1 - beside, 0.5 * (from + 1)), 1});
        to = by_places.back().from;
    }
    const double rate = plain.rate();
    const auto f = [&](double s) {
        const auto at = plain.at(curve, stretch.at(s));
        return (at.x.c[0] * at.y.c[1] - at.y.c[0] * at.x.c[1]) * stretch.speed(s) / rate;
    };
    const bool rough = stretch.root_at_from || stretch.root_at_to;
    const Panels panels(f, from, to, {.within = rough ? 1e-12 : 1e-13, .most = 256, .everywhere = true});
    if (!panels.finite()) return T(NAN);
    const ShiftAlong<T> shift(curves, curve.piece, stretch, rate,
                              {stretch.share_of(arc.from), stretch.share_of(arc.to)}, {first, last});
    const auto place_at = [&](double s, std::size_t derivative) {
        return curves.moved(curves.at(curve, stretch.at(s)), derivative, shift.at(s));
    };
    T sum(0);
    if constexpr (std::is_same_v<T, double>) {
        sum = panels.integral();
    } else {
        for (const Panel& panel : panels.all())
            for (std::size_t i = 0; i < Panel::nodes; ++i) {
                const double s = panel.at(i);
                sum = sum + T(panel.weight(i)) * (T(stretch.speed(s) / rate) + shift.slope(s)) *
                                cross(place_at(s, 0), place_at(s, 1));
            }
    }
    for (const Panel& panel : by_places)
        sum = sum + twice_area_by_places<T>(panel, [&](double s) { return place_at(s, 0); });
    return sum;
}

template <class T, std::size_t K>
T area_within(linkage::Measured<T, K>& measured, linkage::Measured<double, K>& plain_measured,
              const linkage::Course& course, const SweptOutline& outline, const linkage::MovingEnds<T>& ends) {
    SweptCurves<T, K> curves(measured, course, outline, ends);
    SweptCurves<double, K> plain(plain_measured, course, outline, {});
    T twice(0);
    for (const SweptArc& arc : outline.arcs) {
        const T one = twice_area_of(curves, plain, outline, arc);
        twice = arc.backward ? T(twice - one) : T(twice + one);
    }
    return T(0.5) * twice;
}

}  // namespace mechwright::measuring
