#pragma once
/// \file
/// The motion of a drive that follows another one as a follower follows its cam: the segments of a turn
/// (analysis/cam/segment.h), over and over. It is analytic between its breaks, where a derivative may jump, so that one
/// of its pieces is asked for: by an input that lies inside it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

#include "analysis/cam/segment.h"
#include "analysis/numbers/dual.h"
#include "analysis/numbers/second_dual.h"
#include "analysis/numbers/series.h"

namespace mechwright::linkage {

/// R is the type of its numbers: double, or fifty digits to verify with.
template <class R>
struct DriveMotion {
    std::vector<cam::Segment<R>> segments{};
    std::vector<R> begin{};  ///< of each segment: the angle of the master from the start of the turn
    std::vector<R> start{};  ///< and the lift there; of the turn 0
    R net{0};                ///< what a turn adds
};

/// Precondition: the segments' angles are positive, and add up to a full turn but for rounding.
template <class R>
DriveMotion<R> drive_motion(std::vector<cam::Segment<R>> segments) {
    DriveMotion<R> made;
    R angle(0), lift(0);
    for (const cam::Segment<R>& segment : segments) {
        made.begin.push_back(angle);
        made.start.push_back(lift);
        angle += segment.angle;
        lift += cam::net_lift(segment);
    }
    made.net = lift;
    made.segments = std::move(segments);
    return made;
}

namespace detail {

/// A piece of a segment of some turn.
template <class R>
struct MotionPiece {
    std::size_t segment = 0;
    std::size_t piece = 0;
    R from{0};  ///< the master's angle where the segment begins; a turn before where a table's last piece goes on
    R lift{0};  ///< there
};

/// The piece in which an angle of the master lies; at a break the later one.
template <class R>
MotionPiece<R> piece_at(const DriveMotion<R>& motion, const R& master) {
    using std::floor;
    const R turn = R(2) * pi<R>(), turns = floor(R(master / turn)), rest = master - turns * turn;
    MotionPiece<R> found;
    while (found.segment + 1 < motion.begin.size() && rest >= motion.begin[found.segment + 1])
        ++found.segment;
    const cam::Segment<R>& segment = motion.segments[found.segment];
    found.from = turns * turn + motion.begin[found.segment];
    found.lift = turns * motion.net + motion.start[found.segment];
    R part = (rest - motion.begin[found.segment]) / segment.angle;
    // The pieces of a table begin at its first angle.
    if (part < R(cam::break_before(segment, 0))) {
        part += R(1);
        found.from -= segment.angle;
    }
    while (found.piece + 1 < cam::pieces(segment) && part >= R(cam::break_before(segment, found.piece + 1)))
        ++found.piece;
    return found;
}

/// How many powers of what is no plain value in a number do not vanish.
template <class T>
struct Powers {
    static constexpr std::size_t count = 0;
};
template <class T, std::size_t N>
struct Powers<Dual<T, N>> {
    static constexpr std::size_t count = 1 + Powers<T>::count;
};
template <class T, std::size_t N>
struct Powers<SecondDual<T, N>> {
    static constexpr std::size_t count = 2 + Powers<T>::count;
};
template <class T, std::size_t K>
struct Powers<Series<T, K>> {
    static constexpr std::size_t count = K + Powers<T>::count;
};

/// As many powers as a number has, one more for the rate of an input, and few sorts of series in all.
template <class T>
using MotionSeries = Series<double, Powers<T>::count + 1 <= 3   ? 3
                                    : Powers<T>::count + 1 <= 6 ? 6
                                                                : 10>;

/// The lift as a series about an angle of the master, by the formula of a piece.
template <class Value>
Value series_of(const DriveMotion<double>& motion, const MotionPiece<double>& at, double master) {
    const cam::Segment<double>& from = motion.segments[at.segment];
    cam::Segment<Value> segment;
    segment.kind = from.kind;
    segment.law = from.law;
    segment.angle = from.angle;
    segment.lift = from.lift;
    segment.table = from.table;
    segment.boundary.start_count = from.boundary.start_count;
    segment.boundary.end_count = from.boundary.end_count;
    segment.boundary.shape_count = from.boundary.shape_count;
    std::copy(from.boundary.start.begin(), from.boundary.start.end(), segment.boundary.start.begin());
    std::copy(from.boundary.end.begin(), from.boundary.end.end(), segment.boundary.end.begin());
    std::copy(from.boundary.shape.begin(), from.boundary.shape.end(), segment.boundary.shape.begin());
    const Value part = Value::variable((master - at.from) / from.angle, 1 / from.angle);
    return cam::lift_at(segment, at.piece, part, Value(at.lift)).s;
}

/// A series about the plain value of a number, at that number; `slope`: its derivative there.
template <class T>
T composed(const MotionSeries<T>& series, const T& x, bool slope) {
    constexpr std::size_t count = Powers<T>::count;
    static_assert(count + 1 < std::tuple_size_v<std::remove_cvref_t<decltype(series.c)>>);
    const auto coefficient = [&](std::size_t k) {
        return slope ? static_cast<double>(k + 1) * series.c[k + 1] : series.c[k];
    };
    const T away = x - T(number_as<double>(value_of(x)));
    T sum(coefficient(count));
    for (std::size_t k = count; k-- > 0;)
        sum = sum * away + T(coefficient(k));
    return sum;
}

/// The lift or its derivative by the master's angle, by the formula of the piece in which `within` lies.
template <class T>
T motion_at(const DriveMotion<Constant<T>>& motion, const T& master, const Constant<T>& within, bool slope) {
    const auto at = piece_at(motion, within);
    if constexpr (std::is_same_v<T, Constant<T>>) {
        const cam::Segment<T>& segment = motion.segments[at.segment];
        const cam::Lift<T> lift = cam::lift_at(segment, at.piece, T((master - at.from) / segment.angle), at.lift);
        return slope ? lift.v : lift.s;
    } else {
        return composed(series_of<MotionSeries<T>>(motion, at, number_as<double>(value_of(master))), master, slope);
    }
}

}  // namespace detail

/// Where a derivative may jump, in [0, 2 pi), rising.
template <class R>
std::vector<R> breaks_of(const DriveMotion<R>& motion) {
    using std::floor;
    const R turn = R(2) * pi<R>();
    std::vector<R> breaks;
    for (std::size_t i = 0; i < motion.segments.size(); ++i) {
        const cam::Segment<R>& segment = motion.segments[i];
        for (std::size_t piece = 0; piece < cam::pieces(segment); ++piece) {
            const R at = motion.begin[i] + segment.angle * R(cam::break_before(segment, piece));
            breaks.push_back(at - turn * floor(R(at / turn)));
        }
    }
    std::sort(breaks.begin(), breaks.end());
    return breaks;
}

}  // namespace mechwright::linkage
