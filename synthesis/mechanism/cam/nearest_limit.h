#pragma once
/// \file
/// In words what keeps a cam from existing, or what it comes nearest to, where that is and what would help.

#include <fmt/format.h>

#include <numbers>
#include <string>
#include <string_view>

#include "synthesis/mechanism/cam/quantities.h"

namespace mechwright::cam {

namespace detail {

/// What happens at a limit, and what leads away from it.
struct LimitWords {
    std::string_view what, help;
};

template <template <class> class F>
constexpr LimitWords words_of_release() {
    if constexpr (Layout<F>::roller)
        return {"the pressure angle reaches 90 deg and the cam cannot hold the follower",
                "a larger cam, or a greater angle or less lift of that segment, would help"};
    else
        return {"the face turns with the cam, not against it, and no cam can guide it",
                "a greater angle or less lift of that segment would help"};
}

template <template <class> class F>
constexpr LimitWords words_of_undercut() {
    if constexpr (Layout<F>::roller)
        return {"the cam is undercut", "a larger cam or a smaller roller would help"};
    else if constexpr (Layout<F>::oscillating)
        return {"the cam is undercut: it would be hollow, which a flat face cannot follow",
                "a larger base-radius or a greater start-angle would help"};
    else
        return {"the cam is undercut: it would be hollow, which a flat face cannot follow",
                "a larger base-radius would help"};
}

constexpr LimitWords words_of_lever{
    "the contact passes over the follower's pivot and the cam cannot drive the face",
    "start-angle and lift together must be less than 90 deg: a greater pivot-distance, less lift, or a smaller "
    "base-radius or face-offset would help"};

/// The cam angle of a place, in degrees.
template <template <class> class F>
double degrees_of(const Motion& motion, std::span<const double> d, const SegmentPlace& place) {
    constexpr double degree = std::numbers::pi / 180;
    const Segment<double> segment = placed_segment<F>(motion, d, place.segment).segment;
    if (segment.law.form == SegmentLaw::Form::contour) {
        const auto ends = piece_angles(segment.contour);
        const double part = place.u * static_cast<double>(pieces(segment)) - static_cast<double>(place.piece);
        return (ends[place.piece] + part * (ends[place.piece + 1] - ends[place.piece])) / degree;
    }
    double begin = 0;
    for (std::size_t i = 0; i < place.segment; ++i)
        begin += d[slots<F>.angle(i)];
    // The pieces of a table begin at its first point and pass the end of the turn.
    return (begin + (place.u > 1 ? place.u - 1 : place.u) * segment.angle) / degree;
}

}  // namespace detail

/// As Mechanism::nearest_limit. A follower that is not held comes first: what else is measured of such a cam means
/// nothing.
template <template <class> class F>
std::string nearest_limit(const Motion& motion, std::span<const double> d) {
    using detail::LimitWords;
    struct Limit {
        LimitWords words;
        SegmentPlace place;
        double margin;
    };
    const auto limit = [&]<class Margin>(const LimitWords& words, Margin, double size) {
        const SegmentPlace place = least_place<F, Margin>(motion, d);
        return Limit{words, place, size * value_at<F, Margin>(motion, d, place)};
    };
    Limit nearest = limit(detail::words_of_release<F>(), FollowMargin{}, 1);
    if (nearest.margin > 0) {
        const Limit undercut = limit(detail::words_of_undercut<F>(), UndercutMargin{}, d[0]);
        if (undercut.margin < nearest.margin) nearest = undercut;
        if constexpr (ExistenceMargin<F>::has_lever) {
            const Limit lever = limit(detail::words_of_lever, LeverMargin{}, 1);
            if (lever.margin <= 0 || lever.margin < nearest.margin) nearest = lever;
        }
    }
    // The smallest cams stand at a limit but for rounding.
    const double rounding = 1e-9 * d[0], angle = detail::degrees_of<F>(motion, d, nearest.place);
    if (nearest.margin > -rounding)
        return fmt::format("the cam comes near to where {}, at cam angle {:.4g} deg", nearest.words.what, angle);
    return fmt::format("there is no such cam: at cam angle {:.4g} deg {}; {}", angle, nearest.words.what,
                       nearest.words.help);
}

}  // namespace mechwright::cam
