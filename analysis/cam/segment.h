#pragma once
/// \file
/// The motion program of a cam: segments one after another that make up a full turn, and the follower's lift anywhere
/// in them. Lift is a length, or for an oscillating follower an angle; derivatives are with respect to the cam angle.

#include <cstddef>
#include <span>

#include "analysis/cam/boundary_polynomial.h"
#include "analysis/cam/contour.h"
#include "analysis/cam/law.h"
#include "analysis/cam/periodic_spline.h"
#include "analysis/cam/rise_spline.h"

namespace mechwright::cam {

enum class SegmentKind {
    rise,
    fall,  ///< "return" in problem files
    dwell,
    cycle  ///< a whole turn, from a table or the contour of the cam
};

/// How a segment moves, but for its size.
struct SegmentLaw {
    enum class Form { law, polynomial, spline, table, contour };
    Form form = Form::law;
    Law law = Law::cycloidal;
    bool to_rest = false;  ///< of a half law: it comes to rest at its end; else it starts from rest
};

template <class T>
struct Segment {
    SegmentKind kind = SegmentKind::dwell;
    SegmentLaw law{};
    T angle{};
    T lift{};  ///< > 0 for a rise and for a return; 0 for a dwell
    /// Derivatives with respect to the cam angle. Of a spline the shape alone counts: coefficients over its lowest end.
    BoundaryPolynomial<T> boundary{};
    const PeriodicSpline<Constant<T>>* table = nullptr;  ///< of a cycle
    Contour<T> contour{};
};

/// A segment in another number type over the same constants.
template <class To, class From>
Segment<To> converted(const Segment<From>& segment) {
    Segment<To> to;
    to.kind = segment.kind;
    to.law = segment.law;
    to.angle = number_as<To>(segment.angle);
    to.lift = number_as<To>(segment.lift);
    to.table = segment.table;
    const auto& boundary = segment.boundary;
    to.boundary.start_count = boundary.start_count;
    to.boundary.end_count = boundary.end_count;
    to.boundary.shape_count = boundary.shape_count;
    to.contour = {segment.contour.kind,
                  number_as<To>(segment.contour.base_radius),
                  number_as<To>(segment.contour.nose_radius),
                  number_as<To>(segment.contour.centre_distance),
                  number_as<To>(segment.contour.flank_radius),
                  number_as<To>(segment.contour.roller_radius),
                  segment.contour.roller,
                  number_as<To>(segment.contour.rise),
                  number_as<To>(segment.contour.flank)};
    const auto number = [](const From& x) { return number_as<To>(x); };
    std::transform(boundary.start.begin(), boundary.start.end(), to.boundary.start.begin(), number);
    std::transform(boundary.end.begin(), boundary.end.end(), to.boundary.end.begin(), number);
    std::transform(boundary.shape.begin(), boundary.shape.end(), to.boundary.shape.begin(), number);
    return to;
}

/// How many analytic pieces a segment has.
template <class T>
std::size_t pieces(const Segment<T>& segment) {
    if (segment.kind == SegmentKind::dwell) return 1;
    if (segment.law.form == SegmentLaw::Form::table) return segment.table->pieces();
    if (segment.law.form == SegmentLaw::Form::contour) return pieces(segment.contour.kind);
    if (segment.law.form == SegmentLaw::Form::spline) return spline_pieces(segment.boundary.shape_count);
    return segment.law.form == SegmentLaw::Form::law ? pieces(segment.law.law) : 1;
}

/// Where a piece begins, as a part of the segment; for the number of pieces, where the last one ends.
template <class T>
double break_before(const Segment<T>& segment, std::size_t piece) {
    if (segment.law.form == SegmentLaw::Form::table) return static_cast<double>(segment.table->begin(piece));
    if (segment.law.form == SegmentLaw::Form::contour)
        return static_cast<double>(piece) / static_cast<double>(pieces(segment.contour.kind));
    if (segment.law.form == SegmentLaw::Form::spline)
        return static_cast<double>(piece) / static_cast<double>(pieces(segment));
    if (segment.kind == SegmentKind::dwell || segment.law.form == SegmentLaw::Form::polynomial)
        return piece == 0 ? 0 : 1;
    const Law law = segment.law.law;
    const bool backward = (segment.kind == SegmentKind::fall) != segment.law.to_rest;
    return backward ? 1 - break_before(law, pieces(law) - piece) : break_before(law, piece);
}

namespace detail {

/// The part of the lift that has been done at u, between 0 and 1. A return is the mirror image in time of a rise.
template <class T>
Lift<T> normalised(const Segment<T>& segment, std::size_t piece, const T& u) {
    const SegmentLaw& law = segment.law;
    const bool backward = (segment.kind == SegmentKind::fall) != law.to_rest;
    if (!backward) return lift_at(law.law, piece, u);
    return reversed(lift_at(law.law, pieces(law.law) - 1 - piece, T(T(Constant<T>(1)) - u)));
}

/// The same with derivatives at the ends in the cam angle turned into those in u.
template <class T>
BoundaryPolynomial<T> in_parts(const BoundaryPolynomial<T>& p, const T& angle) {
    BoundaryPolynomial<T> q = p;
    T power = angle;
    for (std::size_t i = 0; i < p.most_conditions; ++i, power = power * angle) {
        q.start[i] = p.start[i] * power;
        q.end[i] = p.end[i] * power;
    }
    return q;
}

}  // namespace detail

/// The follower at part u of a segment (of a contour: in even parts for its pieces) that starts at lift `start`, by the
/// formula of the given piece. Precondition: the segment's angle is positive.
template <class T>
Lift<T> lift_at(const Segment<T>& segment, std::size_t piece, const T& u, const T& start) {
    if (segment.kind == SegmentKind::dwell) return {start, T(), T(), T()};
    if (segment.law.form == SegmentLaw::Form::contour) {
        const double count = static_cast<double>(pieces(segment.contour.kind));
        return lift_at(segment.contour, piece,
                       T(u * T(Constant<T>(count)) - T(Constant<T>(static_cast<double>(piece)))));
    }
    const T per_angle = T(Constant<T>(1)) / segment.angle;
    const auto scaled = [&](const Lift<T>& f, const T& by) {
        const T v = by * per_angle, a = v * per_angle;
        return Lift<T>{start + by * f.s, v * f.v, a * f.a, a * per_angle * f.j};
    };
    if (segment.law.form == SegmentLaw::Form::table) return scaled(lift_at(*segment.table, piece, u), segment.lift);
    if (segment.law.form == SegmentLaw::Form::spline) {
        const bool rises = segment.kind == SegmentKind::rise;
        const T low = rises ? start : start - segment.lift;
        const Lift<T> f = spline_lift<T>(rises ? T() : segment.lift, rises ? segment.lift : T(),
                                         {segment.boundary.shape.data(), segment.boundary.shape_count}, piece, u);
        const T square = per_angle * per_angle;
        return {low + f.s, per_angle * f.v, square * f.a, square * per_angle * f.j};
    }
    const T rise = segment.kind == SegmentKind::rise ? segment.lift : -segment.lift;
    if (segment.law.form == SegmentLaw::Form::polynomial)
        return scaled(lift_at(detail::in_parts(segment.boundary, segment.angle), rise, u), T(Constant<T>(1)));
    return scaled(detail::normalised(segment, piece, u), rise);
}

/// The cam angle that the whole segment would take at the rate of one piece: that of the segment, but for contours,
/// whose pieces have even parts.
template <class T>
T angle_per_part(const Segment<T>& segment, std::size_t piece) {
    if (segment.law.form != SegmentLaw::Form::contour) return segment.angle;
    const auto angles = piece_angles(segment.contour);
    const double count = static_cast<double>(pieces(segment.contour.kind));
    return T(Constant<T>(count)) * (angles[piece + 1] - angles[piece]);
}

/// What a segment adds to the lift.
template <class T>
T net_lift(const Segment<T>& segment) {
    switch (segment.kind) {
        case SegmentKind::rise: return segment.lift;
        case SegmentKind::fall: return -segment.lift;
        default: return T();
    }
}

/// The lift at which segment number `index` starts, of segments that start at lift 0.
template <class T>
T start_lift(std::span<const Segment<T>> segments, std::size_t index) {
    T lift{};
    for (std::size_t i = 0; i < index; ++i)
        lift += net_lift(segments[i]);
    return lift;
}

}  // namespace mechwright::cam
