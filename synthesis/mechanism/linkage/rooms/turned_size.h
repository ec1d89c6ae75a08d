#pragma once
/// \file
/// The width or area of a box that is turned so that it is least, in any number type.

#include <array>
#include <cmath>

#include "synthesis/mechanism/linkage/rooms/contacts_along.h"

namespace mechwright::measuring {

/// What of a turned box is least as a function of the dimensions, with which its direction turns.
template <class T, std::size_t K>
T least_size(linkage::Measured<T, K>& measured, const Course& course, const TurnedBox& box, bool area,
             const linkage::MovingEnds<T>& ends) {
    ContactsAlong<T, K> along(measured, course, ends);
    constexpr double flat = 1e-9;
    T direction(box.direction);
    const BoxSides<T> at_first = sides_of(along, box.contacts, direction);
    const double size = number_as<double>(value_of(area ? T(at_first.size[0] * at_first.size[1]) : at_first.size[0]));
    double slope = 0;
    // Newton's method: each step has one order more.
    for (int step = 0; step < 2; ++step) {
        T missed;
        if (box.beside) {
            const T outward = direction + T(turn_of_side(box.side));
            const auto one = along.of(box.contacts[box.side], outward), other = along.of(*box.beside, outward);
            missed = one.out - other.out;
            if (step == 0) slope = number_as<double>(value_of(T(one.across - other.across)));
        } else {
            const auto [by_direction, again] = slope_of_least(sides_of(along, box.contacts, direction), area);
            missed = by_direction;
            if (step == 0) slope = number_as<double>(value_of(again));
        }
        // Where it is as wide in all directions nearby the direction may stay.
        const double least = box.beside ? 0 : flat * size;
        if (std::abs(slope) > least) direction = direction - linkage::detail::change_of(T(missed / T(slope)));
    }
    const BoxSides<T> sides = sides_of(along, box.contacts, direction);
    return area ? T(sides.size[0] * sides.size[1]) : sides.size[0];
}

}  // namespace mechwright::measuring
