#pragma once
/// \file
/// The search for the box about parts of a linkage over its motion that is turned so that its width, or its area, is
/// least. Their slopes by its direction jump up only, where a side of the box lies on two places at once (H. Freeman
/// and R. Shapira, Determining the minimum-area encasing rectangle for an arbitrary closed curve, Communications of the
/// ACM 18 (1975), 409-413): a least one is there, or where the slope is zero.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <tuple>

#include "synthesis/mechanism/linkage/rooms/farthest_places.h"

namespace mechwright::measuring {

/// Finds the turned box of some pins over a motion.
template <std::size_t K>
class TurnedBoxSearch {
public:
    TurnedBoxSearch(const Over& over, const LinkageRoom& room, linkage::Measured<double, K>& plain,
                    const Course& course, std::span<const double> dimensions)
        : measured_(plain),
          area_(room.turn == LinkageRoom::Turn::least_area),
          outline_(sampled_outline(over, room, plain, course, dimensions)),
          places_(plain, course, outline_) {}

    TurnedBox found() {
        if (outline_.samples.empty()) return {.possible = false};
        TurnedBox best;
        double least = std::numeric_limits<double>::infinity();
        for (const double direction : directions_of_hull(outline_.samples, area_)) {
            const TurnedBox one = refined(direction);
            const double value = value_of_box(one.contacts, one.direction);
            if (!(value < least)) continue;
            least = value;
            best = one;
        }
        best.possible = std::isfinite(least);
        return best;
    }

private:
    double value_of_box(const Contacts& contacts, double direction) {
        const BoxSides<double> sides = sides_of(places_.along(), contacts, direction);
        return area_ ? sides.size[0] * sides.size[1] : sides.size[0];
    }

    /// A direction with what is touched there, and the slope of what is to be least.
    struct Look {
        double direction = 0, slope = 0, bend = 0;
        Contacts contacts{};
    };
    Look look(double direction) {
        Look one{direction, 0, 0, places_.contacts_in(direction)};
        std::tie(one.slope, one.bend) = slope_of_least(sides_of(places_.along(), one.contacts, direction), area_);
        return one;
    }
    /// The box of two looks between which its slope changes sign where a side lies on two places; absent where it does
    /// not there, or the farthest places are others.
    std::optional<TurnedBox> on_two_places(const Look& low, const Look& high) {
        constexpr int most_steps = 12;
        constexpr double rounding = 1e-13;
        std::size_t side = 4;
        for (std::size_t i = 0; i < (area_ ? 4u : 2u); ++i)
            if (!places_.is_same(low.contacts[i], high.contacts[i])) {
                if (side < 4) return {};
                side = i;
            }
        if (side == 4) return {};
        Contact one = low.contacts[side], other = high.contacts[side];
        double direction = 0.5 * (low.direction + high.direction);
        for (int i = 0; i < most_steps; ++i) {
            const double outward = direction + turn_of_side(side);
            places_.resettle(one, outward);
            places_.resettle(other, outward);
            const auto a = places_.along().of(one, outward), b = places_.along().of(other, outward);
            const double step = -(a.out - b.out) / (a.across - b.across);
            if (!std::isfinite(step)) return {};
            direction += step;
            if (std::abs(step) < 1e-15) break;
        }
        if (!(direction >= low.direction && direction <= high.direction)) return {};
        TurnedBox box{true, direction, places_.contacts_in(direction), side, other};
        places_.resettle(one, direction + turn_of_side(side));
        places_.resettle(*box.beside, direction + turn_of_side(side));
        const double outward = direction + turn_of_side(side),
                     farthest = places_.along().of(box.contacts[side], outward).out;
        const double within = rounding * (std::abs(farthest) + size_of(measured_.driven()));
        for (const Contact& contact : {one, *box.beside})
            if (!(std::abs(farthest - places_.along().of(contact, outward).out) <= within)) return {};
        // The slope need not change its sign there.
        const auto slope_with = [&](const Contact& contact) {
            box.contacts[side] = contact;
            return slope_of_least(sides_of(places_.along(), box.contacts, direction), area_).first;
        };
        if (!(slope_with(*box.beside) >= 0) || !(slope_with(one) <= 0)) return {};
        return box;
    }
    /// The box of a direction at which its slope changes sign, to rounding. Where several of its sides lie on two
    /// places, as those that stay parallel do, the longest of these tells how it turns. What is touched is seen beside
    /// it.
    TurnedBox at_corner(double direction, const Contacts& contacts) {
        constexpr double beside = 1e-7;
        const Look low = look(direction - beside), high = look(direction + beside);
        TurnedBox box{true, direction, contacts, 0, {}};
        double longest = 0;
        for (std::size_t side = 0; side < (area_ ? 4u : 2u); ++side) {
            if (places_.is_same(low.contacts[side], high.contacts[side])) continue;
            const double outward = direction + turn_of_side(side);
            const double length = std::abs(places_.along().of(low.contacts[side], outward).across -
                                           places_.along().of(high.contacts[side], outward).across);
            if (!(length > longest)) continue;
            longest = length;
            box.contacts = low.contacts;
            box.side = side;
            box.beside = high.contacts[side];
        }
        if (!box.beside) return box;
        for (std::size_t side = 0; side < box.contacts.size(); ++side)
            places_.resettle(box.contacts[side], direction + turn_of_side(side));
        places_.resettle(*box.beside, direction + turn_of_side(box.side));
        return box;
    }
    /// The box of a direction at which Newton's method ends. Where something goes straight along a side, what the side
    /// touches moves far while the box hardly turns, so that steps are short though the slope is not 0: a corner.
    TurnedBox at_end(const Look& here) {
        const double size = size_of(measured_.driven());
        const double small = 1e-8 * (area_ ? size * size : size);
        const bool is_smooth = here.bend > 0 && std::abs(here.slope) <= small;
        return is_smooth ? TurnedBox{true, here.direction, here.contacts, 0, {}}
                         : at_corner(here.direction, here.contacts);
    }
    /// The least box near one with a side along the samples' hull.
    TurnedBox refined(double direction) {
        constexpr int most_steps = 100;
        constexpr double narrowest = 1e-4, widest = 0.3;
        Look low = look(direction - narrowest), high = look(direction + narrowest);
        for (double apart = 2 * narrowest; !(low.slope < 0) && apart < widest; apart *= 2)
            low = look(direction - apart);
        for (double apart = 2 * narrowest; !(high.slope > 0) && apart < widest; apart *= 2)
            high = look(direction + apart);
        if (!(low.slope < 0) || !(high.slope > 0)) return {true, direction, places_.contacts_in(direction), 0, {}};
        for (int i = 0; i < most_steps; ++i) {
            if (const auto box = on_two_places(low, high)) return *box;
            // Newton's method from the middle of them, where it stays between them.
            const double middle = 0.5 * (low.direction + high.direction);
            Look here = look(middle);
            if (!(middle > low.direction && middle < high.direction)) return at_corner(high.direction, high.contacts);
            for (int k = 0; k < 12 && here.bend > 0; ++k) {
                const double next = here.direction - here.slope / here.bend;
                if (!(next > low.direction && next < high.direction)) break;
                const double step = std::abs(next - here.direction);
                (here.slope < 0 ? low : high) = here;
                here = look(next);
                if (step < 1e-15) return at_end(here);
            }
            if (here.slope == 0) return at_end(here);
            (here.slope < 0 ? low : high) = here;
        }
        return at_corner(high.direction, high.contacts);
    }

    linkage::Measured<double, K>& measured_;
    const bool area_;
    const OutlineSamples outline_;
    FarthestPlaces<K> places_;
};

}  // namespace mechwright::measuring
