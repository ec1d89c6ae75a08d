#pragma once
/// \file
/// The curves of what a blade sweeps as functions of the dimensions, in any number type.

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "analysis/linkage/measuring/at_limit.h"
#include "analysis/linkage/measuring/moving_extremes.h"
#include "synthesis/mechanism/linkage/rooms/swept/outline.h"

namespace mechwright::measuring {

/// Both ends of the blade as series of the time.
template <class T, std::size_t K>
struct Blade {
    using Value = Series<T, K>;
    Vector<Value> first, second;

    Vector<Value> along() const { return second - first; }
    /// How fast its ends leave its line, to the right, times its length.
    Value first_across() const { return cross(slope_of(first), along()); }
    Value second_across() const { return cross(slope_of(second), along()); }
    /// The share of it at which a point moves along it: the foot of the perpendicular from the instantaneous centre.
    Value foot() const {
        const Value a = first_across(), b = second_across();
        return a / (a - b);
    }
    Vector<Value> on(SweptCurve::Kind kind) const {
        if (kind == SweptCurve::Kind::first_path) return first;
        if (kind == SweptCurve::Kind::second_path) return second;
        return first + foot() * along();
    }

private:
    static Vector<Value> slope_of(const Vector<Value>& at) {
        return {mechwright::slope_of(at.x), mechwright::slope_of(at.y)};
    }
};

/// The blade at an input: signals 0 to 3 are the coordinates of its ends.
template <class T, std::size_t K>
Blade<T, K> blade_at(linkage::Measured<T, K>& measured, const linkage::Course& course, double input, double within) {
    const linkage::WithinPiece in_piece(measured, within);
    const auto near = course.turns.near(input);
    const auto coordinate = [&](std::size_t signal) { return measured.value(signal, input, near); };
    return {{coordinate(0), coordinate(1)}, {coordinate(2), coordinate(3)}};
}

/// The curves of an outline. K must be 4 at least.
template <class T, std::size_t K>
class SweptCurves {
public:
    using Place = Vector<Series<T, K>>;

    SweptCurves(linkage::Measured<T, K>& measured, const linkage::Course& course, const SweptOutline& outline,
                const linkage::MovingEnds<T>& ends)
        : measured_(measured), course_(course), outline_(outline), ends_(ends) {}

    double rate() const { return measured_.rate(); }

    /// A place of a curve as series of the time, or of its share.
    Place at(const SweptCurve& curve, double input) {
        if (!curve.is_straight())
            return blade_at(measured_, course_, input, outline_.pieces[curve.piece].within).on(curve.kind);
        const auto [start, end] = ends_of(curve);
        const auto share = Series<T, K>::variable(T(input));
        const auto between = [&](const T& a, const T& b) { return Series<T, K>(a) + share * Series<T, K>(T(b - a)); };
        return {between(start.x, end.x), between(start.y, end.y)};
    }
    /// Both ends of a straight curve.
    std::pair<Vector<T>, Vector<T>> ends_of(const SweptCurve& curve) {
        if (curve.kind == SweptCurve::Kind::side)
            return {{T(curve.start.x), T(curve.start.y)}, {T(curve.end.x), T(curve.end.y)}};
        const SweptCorner& corner = outline_.corners[curve.place];
        if (corner.place.limit.exists()) {
            const auto coordinate = [&](std::size_t signal) {
                linkage::Extreme place = corner.place;
                place.value = corner.at_limit[signal];
                return linkage::value_at(measured_, {signal, 0}, course_, place, ends_);
            };
            return {{coordinate(0), coordinate(1)}, {coordinate(2), coordinate(3)}};
        }
        const T shift = shift_of_input(corner);
        const Blade<T, K> blade = blade_of(corner);
        return {moved(blade.first, 0, shift), moved(blade.second, 0, shift)};
    }
    /// By how much the time, or the share, of a corner on a curve changes with the dimensions.
    T shift(std::size_t corner, std::size_t curve) {
        const SweptCorner& c = outline_.corners[corner];
        if (c.kind == SweptCorner::Kind::crossing) return shift_of_crossing(c, curve);
        if (c.kind == SweptCorner::Kind::passed_again) return shift_of_pass(c, outline_.curves[curve]);
        if (outline_.curves[curve].is_straight()) return c.kind == SweptCorner::Kind::foot ? shift_of_foot(c) : T(0);
        return shift_of_input(c.kind == SweptCorner::Kind::foot ? outline_.corners[c.of] : c);
    }
    /// The same of an end of a piece that is a limit at which places become infinitely fast; else 0.
    T shift_of_limit(std::size_t piece, bool last) {
        const SweptPiece& of = outline_.pieces[piece];
        if (!(last ? of.stretch.root_at_to : of.stretch.root_at_from)) return T(0);
        const linkage::Extreme end{last ? of.stretch.to : of.stretch.from, 0, false,
                                   last ? course_.travel.last : course_.travel.first, of.within};
        return linkage::shift_of(measured_, {0, 0}, course_, end, ends_);
    }

    static Vector<T> moved(const Place& place, std::size_t derivative, const T& shift) {
        return {linkage::detail::after_shift(place.x, derivative, shift),
                linkage::detail::after_shift(place.y, derivative, shift)};
    }

private:
    Blade<T, K> blade_of(const SweptCorner& corner) {
        return blade_at(measured_, course_, corner.place.at, outline_.pieces[corner.piece].within);
    }
    T shift_of_input(const SweptCorner& corner) {
        using At = SweptCorner::Kind;
        const auto zero_of = [&](const Series<T, K>& f, std::size_t derivative) {
            return linkage::detail::shift_of_zero(f, derivative, measured_.rate());
        };
        if (corner.kind == At::end) return linkage::shift_of(measured_, {0, 0}, course_, corner.place, ends_);
        if (corner.kind == At::first_folds) return zero_of(blade_of(corner).first_across(), 0);
        if (corner.kind == At::second_folds) return zero_of(blade_of(corner).second_across(), 0);
        if (corner.kind != At::rest) return T(0);
        // Both ends rest at once: the velocities along their accelerations vanish.
        const Blade<T, K> blade = blade_of(corner);
        Series<T, K> way(T(0));
        for (const Series<T, K>* f : {&blade.first.x, &blade.first.y, &blade.second.x, &blade.second.y})
            way = way + T(number_as<double>(value_of(f->derivative(2)))) * *f;
        return zero_of(way, 1);
    }
    /// The foot at a rest is that of the accelerations, at a limit what feet beside it tend to.
    T shift_of_foot(const SweptCorner& foot) {
        const SweptCorner& corner = outline_.corners[foot.of];
        const T shift = shift_of_input(corner);
        if (corner.place.limit.is_singular()) {
            constexpr double width = 0x1p-4;
            const SweptPiece& piece = outline_.pieces[corner.piece];
            const bool last = corner.place.at == piece.stretch.to;
            const auto beside = [&](double s) {
                const double input = piece.stretch.at(last ? 1 - s : s);
                return linkage::detail::after_shift(blade_at(measured_, course_, input, piece.within).foot(), 0, shift);
            };
            return linkage::detail::change_of(linkage::detail::from_nodes<T>(beside, width));
        }
        const Blade<T, K> blade = blade_of(corner);
        const std::size_t order = corner.kind == SweptCorner::Kind::rest ? 2 : 1;
        const Vector<T> along = moved(blade.along(), 0, shift);
        const T a = cross(moved(blade.first, order, shift), along), b = cross(moved(blade.second, order, shift), along);
        return linkage::detail::change_of(T(a / (a - b)));
    }
    /// By how much the time changes at which a path passes a corner of itself again: Newton's method along it.
    T shift_of_pass(const SweptCorner& pass, const SweptCurve& curve) {
        const SweptCorner& corner = outline_.corners[pass.of];
        const Vector<T> there = moved(blade_of(corner).on(curve.kind), 0, shift_of_input(corner));
        const Place path = at(curve, pass.place.at);
        T shift(0);
        for (int i = 0; i < 2; ++i) {
            const Vector<T> way = moved(path, 1, shift), apart = there - moved(path, 0, shift);
            shift = linkage::detail::change_of(T(shift + dot(apart, way) / dot(way, way)));
        }
        return shift;
    }
    /// Newton's method on both curves, whose second step makes second derivatives right.
    T shift_of_crossing(const SweptCorner& corner, std::size_t curve) {
        const Place a = at(outline_.curves[corner.one], corner.at_one),
                    b = at(outline_.curves[corner.other], corner.at_other);
        T by_one(0), by_other(0);
        const Vector<T> u = moved(a, 1, T(0)), v = moved(b, 1, T(0));
        const T determinant = cross(u, v);
        for (int i = 0; i < 2; ++i) {
            const Vector<T> apart = moved(b, 0, by_other) - moved(a, 0, by_one);
            by_one = linkage::detail::change_of(T(by_one + cross(apart, v) / determinant));
            by_other = linkage::detail::change_of(T(by_other + cross(apart, u) / determinant));
        }
        return curve == corner.one ? by_one : by_other;
    }

    linkage::Measured<T, K>& measured_;
    const linkage::Course& course_;
    const SweptOutline& outline_;
    linkage::MovingEnds<T> ends_;
};

}  // namespace mechwright::measuring
