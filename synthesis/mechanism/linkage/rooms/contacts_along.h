#pragma once
/// \file
/// The sides of a box about parts of a linkage in any direction, by the places at which they are touched. The farthest
/// place of a motion in a direction u(d) = (cos d, sin d) is a support function of the swept places; the width is the
/// sum of two of these, the area a product of two widths.

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "analysis/linkage/measuring/moving_extremes.h"
#include "synthesis/mechanism/linkage/rooms/contacts.h"

namespace mechwright::measuring {

using linkage::Course;
using linkage::Extreme;

/// How far places of contact are out of a direction, and across it, where the direction may be any number. Signals 2 k
/// and 2 k + 1 are the coordinates of the k-th pin.
template <class T, std::size_t K>
class ContactsAlong {
public:
    ContactsAlong(linkage::Measured<T, K>& measured, const Course& course, const linkage::MovingEnds<T>& ends)
        : measured_(measured), course_(course), ends_(ends) {}

    struct Far {
        T out, across;  ///< of these two the second is the slope of the first by the direction
        T bend;         ///< the slope of the second
    };

    Far of(const Contact& contact, const T& direction) {
        const auto [s, c] = sine_and_cosine(direction);
        const Extreme& place = contact.place;
        if (!place.stationary) {
            const auto coordinate = [&](std::size_t signal, double at_limit) {
                Extreme one = place;
                one.value = at_limit;
                return linkage::value_at(measured_, {signal, 0}, course_, one, ends_);
            };
            const T x = coordinate(2 * contact.pin, contact.at_limit.x),
                    y = coordinate(2 * contact.pin + 1, contact.at_limit.y);
            const T out = c * x + s * y;
            return {out, c * y - s * x, -out};
        }
        const auto [out, across] = series(contact, direction);
        const T shift = linkage::detail::shift_of_zero(out, 1, measured_.rate());
        const T value = linkage::detail::after_shift(out, 0, shift);
        const T slope = across.derivative(1);
        return {value, linkage::detail::after_shift(across, 0, shift), T(-(slope * slope) / out.derivative(2)) - value};
    }

    /// The same as series of the time at the place of a contact: out and across.
    auto series(const Contact& contact, const T& direction) {
        const auto [s, c] = sine_and_cosine(direction);
        const Extreme& place = contact.place;
        const linkage::WithinPiece in_piece(measured_, place.within);
        const auto near = course_.turns.near(place.at);
        const auto x = measured_.value(2 * contact.pin, place.at, near),
                   y = measured_.value(2 * contact.pin + 1, place.at, near);
        return std::pair(c * x + s * y, c * y - s * x);
    }

private:
    linkage::Measured<T, K>& measured_;
    const Course& course_;
    const linkage::MovingEnds<T>& ends_;
};

/// Width and height of a box, their slopes by its direction, and the slopes of these.
template <class T>
struct BoxSides {
    std::array<T, 2> size, slope, bend;
};

template <class T, std::size_t K>
BoxSides<T> sides_of(ContactsAlong<T, K>& along, const Contacts& contacts, const T& direction) {
    BoxSides<T> sides;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto far = [&](std::size_t side) { return along.of(contacts[side], direction + T(turn_of_side(side))); };
        const auto one = far(2 * i), other = far(2 * i + 1);
        sides.size[i] = one.out + other.out;
        sides.slope[i] = one.across + other.across;
        sides.bend[i] = one.bend + other.bend;
    }
    return sides;
}

/// The slope of what is to be least, and the slope of that.
template <class T>
std::pair<T, T> slope_of_least(const BoxSides<T>& s, bool area) {
    if (!area) return {s.slope[0], s.bend[0]};
    return {s.slope[0] * s.size[1] + s.size[0] * s.slope[1],
            s.bend[0] * s.size[1] + T(2) * s.slope[0] * s.slope[1] + s.size[0] * s.bend[1]};
}

}  // namespace mechwright::measuring
