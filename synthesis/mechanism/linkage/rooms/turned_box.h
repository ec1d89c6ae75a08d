#pragma once
/// \file
/// The box about parts of a linkage over its motion that is turned so that its width, or its area, is least. The
/// farthest place of a motion in a direction u(d) = (cos d, sin d) is a support function of the swept places; the width
/// is the sum of two of these, the area a product of two widths. Their slopes jump up only, where a side of the box
/// lies on two places at once (H. Freeman and R. Shapira, Determining the minimum-area encasing rectangle for an
/// arbitrary closed curve, Communications of the ACM 18 (1975), 409-413): a least one is there, or where the slope is
/// zero.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "analysis/geometry/separation.h"
#include "synthesis/mechanism/linkage/rooms/contacts.h"
#include "synthesis/mechanism/linkage/targets/found_places.h"

namespace mechwright::measuring {

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
        using std::cos, std::sin;
        const T c = cos(direction), s = sin(direction);
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
        using std::cos, std::sin;
        const T c = cos(direction), s = sin(direction);
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

/// Finds the turned box of some pins over a motion.
template <std::size_t K>
class TurnedBoxSearch {
public:
    TurnedBoxSearch(const Over& over, const LinkageRoom& room, linkage::Measured<double, K>& plain,
                    const Course& course, std::span<const double> dimensions)
        : measured_(plain),
          course_(course),
          area_(room.turn == LinkageRoom::Turn::least_area),
          along_(plain, course, ends_) {
        linkage::PlacedPins placed(over.driven(dimensions), placing_of<double>(over, dimensions, {}), course);
        sample(over, room, placed);
        closes_ = placed.closes && !samples_.empty();
    }

    TurnedBox found() {
        if (!closes_) return {.possible = false};
        TurnedBox best;
        double least = std::numeric_limits<double>::infinity();
        for (const double direction : candidates()) {
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
    static constexpr double turn = 2 * std::numbers::pi;

    struct Sample {
        Contact contact;
        Vector<double> at;
        bool first, last;  ///< of a part of the motion, or the only one of a pin that stands still
    };

    void sample(const Over& over, const LinkageRoom& room, linkage::PlacedPins& placed) {
        constexpr double of_radian = 64;
        constexpr std::size_t fewest = 64, most = 1 << 14;
        const linkage::Travel& travel = course_.travel;
        const Stretch all = linkage::detail::stretch_of(course_, travel.from, travel.to);
        const auto parts = linkage::parts_of(placed.laws(), all);
        for (const linkage::MotionPart& part : parts) {
            placed.follow_within(part.within);
            const Stretch& stretch = part.stretch;
            const auto count = std::clamp<std::size_t>(
                static_cast<std::size_t>(std::ceil(of_radian * stretch.length() / measured_.unit_of_input())), fewest,
                most);
            for (std::size_t k = 0; k < room.pins.size(); ++k) {
                const bool fixed = linkage::is_on(over.model.structure.pins[room.pins[k]], 0);
                if (fixed && &part != &parts.front()) continue;
                for (std::size_t i = fixed ? count / 2 : 0; i <= (fixed ? count / 2 : count); ++i) {
                    const double share = static_cast<double>(i) / static_cast<double>(count);
                    const double input = stretch.at(stretch.first() + (stretch.last() - stretch.first()) * share);
                    const auto places = placed.at(input);
                    if (places.empty()) return;
                    const bool first = fixed || i == 0, last = fixed || i == count;
                    const bool inside =
                        (first && !fixed && stretch.from > travel.from) || (last && !fixed && stretch.to < travel.to);
                    const linkage::Limit limit = fixed || inside ? linkage::Limit{}
                                                 : first         ? travel.first
                                                 : last          ? travel.last
                                                                 : linkage::Limit{};
                    Vector<double> at = places[room.pins[k]];
                    if (limit.exists())
                        at = {linkage::value_at_limit(measured_, {2 * k, 0}, course_, !first),
                              linkage::value_at_limit(measured_, {2 * k + 1, 0}, course_, !first)};
                    samples_.push_back({{k, {input, 0, !first && !last, limit, part.within}, at}, at, first, last});
                }
            }
        }
        seamless_ = travel.whole && parts.size() == 1;
    }

    /// Directions near those in which a box about the samples is least: with a side along one of their hull's, of these
    /// such as are close to the least.
    std::vector<double> candidates() {
        constexpr double close = 2e-3;
        constexpr std::size_t most = 6;
        std::vector<Vector<double>> points;
        for (const Sample& sample : samples_)
            points.push_back(sample.at);
        const std::vector<std::size_t> hull = convex_hull(points);
        const double period = area_ ? turn / 4 : turn / 2;
        std::vector<std::pair<double, double>> all;  // a direction, and what is least in it
        for (std::size_t i = 0; i < hull.size() && hull.size() > 1; ++i) {
            const Vector<double> side = points[hull[(i + 1) % hull.size()]] - points[hull[i]];
            double direction = std::atan2(-side.x, side.y);
            direction -= period * std::floor(direction / period);
            const auto width = [&](double d) {
                const Vector<double> way{std::cos(d), std::sin(d)};
                double low = std::numeric_limits<double>::infinity(), high = -low;
                for (const std::size_t corner : hull) {
                    const double far = dot(points[corner], way);
                    low = std::min(low, far);
                    high = std::max(high, far);
                }
                return high - low;
            };
            all.push_back({direction, area_ ? width(direction) * width(direction + turn / 4) : width(direction)});
        }
        if (all.empty()) return {0};
        std::sort(all.begin(), all.end());
        const std::size_t n = all.size();
        std::vector<std::pair<double, double>> lowest;
        for (std::size_t i = 0; i < n; ++i)
            if (all[i].second <= all[(i + 1) % n].second && all[i].second <= all[(i + n - 1) % n].second)
                lowest.push_back({all[i].second, all[i].first});
        std::sort(lowest.begin(), lowest.end());
        std::vector<double> found;
        for (const auto& [value, direction] : lowest)
            if (found.size() < most && value <= lowest.front().first * (1 + close)) found.push_back(direction);
        return found;
    }

    /// The farthest place in a direction next to a sample that is as far as its neighbours: where it is stationary
    /// between these, or an end.
    Contact settled(std::size_t index, double direction, double& value) {
        const Sample& sample = samples_[index];
        value = along_.of(sample.contact, direction).out;
        if (is_fixed(index)) return sample.contact;
        const bool is_end = !seamless_ && (sample.first || sample.last);
        const double here = sample.contact.place.at,
                     step = std::abs(samples_[sample.first ? index + 1 : index - 1].contact.place.at - here);
        const double low = !sample.first ? samples_[index - 1].contact.place.at
                           : is_end      ? here
                                         : here - step,
                     high = !sample.last ? samples_[index + 1].contact.place.at
                            : is_end     ? here
                                         : here + step;
        Contact contact = sample.contact;
        contact.place.stationary = true;
        contact.place.limit = {};
        if (!find_stationary(contact, direction, low, high)) return sample.contact;
        const double found = along_.of(contact, direction).out;
        if (is_end && !(found > value)) return sample.contact;
        value = found;
        return contact;
    }
    /// Puts a contact where it is farthest between two inputs: by Newton's method, by halves where that leaves them, by
    /// quarters next to a limit. False where that is at one of them.
    bool find_stationary(Contact& contact, double direction, double low, double high) {
        constexpr int most_steps = 80;
        constexpr double settled_within = 1e-15, end_within = 1e-12;
        const double first = low, last = high, rate = measured_.rate();
        const linkage::Travel& travel = course_.travel;
        const auto between = [&] {
            const double share = first == travel.from && travel.first.exists() ? 0.25
                                 : last == travel.to && travel.last.exists()   ? 0.75
                                                                               : 0.5;
            return low + share * (high - low);
        };
        double& at = contact.place.at;
        if (!(at > low && at < high)) at = between();
        for (int i = 0; i < most_steps; ++i) {
            const auto [out, across] = along_.series(contact, direction);
            const double slope = out.derivative(1) / rate, bend = out.derivative(2) / (rate * rate);
            (slope > 0 ? low : high) = at;
            double next = at - slope / bend;
            const bool newton = bend < 0 && next > low && next < high;
            if (!newton) next = between();
            const double moved = std::abs(next - at);
            if (newton || next != at) at = next;
            if (moved <= settled_within * (1 + std::abs(at))) break;
        }
        return at - first > end_within * (last - first) && last - at > end_within * (last - first);
    }
    bool is_fixed(std::size_t i) const { return samples_[i].first && samples_[i].last; }
    double farthest() const { return 0.1 * measured_.unit_of_input(); }

    /// The farthest place of all in a direction: of samples that are farther than their neighbours and near the
    /// farthest.
    Contact farthest_in(double direction) {
        const Vector<double> way{std::cos(direction), std::sin(direction)};
        far_.clear();
        double best = -std::numeric_limits<double>::infinity();
        for (const Sample& sample : samples_)
            best = std::max(best, far_.emplace_back(dot(sample.at, way)));
        Contact farthest;
        double value = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const double here = far_[i], before = samples_[i].first ? -1e300 : far_[i - 1],
                         after = samples_[i].last ? -1e300 : far_[i + 1];
            if (here < before || here < after) continue;
            // Between samples a parabola is no more above them than a quarter of their second difference.
            const double rises =
                (before > -1e300 ? std::abs(here - before) : 0) + (after > -1e300 ? std::abs(here - after) : 0);
            if (here + rises < best) continue;
            double settled_value = 0;
            const Contact one = settled(i, direction, settled_value);
            if (!(settled_value > value)) continue;
            value = settled_value;
            farthest = one;
        }
        return farthest;
    }

    Contacts contacts_in(double direction) {
        Contacts contacts;
        for (std::size_t side = 0; side < contacts.size(); ++side)
            contacts[side] = farthest_in(direction + turn_of_side(side));
        return contacts;
    }
    double value_of_box(const Contacts& contacts, double direction) {
        const BoxSides<double> sides = sides_of(along_, contacts, direction);
        return area_ ? sides.size[0] * sides.size[1] : sides.size[0];
    }

    /// A direction with what is touched there, and the slope of what is to be least.
    struct Look {
        double direction = 0, slope = 0, bend = 0;
        Contacts contacts{};
    };
    Look look(double direction) {
        Look one{direction, 0, 0, contacts_in(direction)};
        std::tie(one.slope, one.bend) = slope_of_least(sides_of(along_, one.contacts, direction), area_);
        return one;
    }
    bool is_same(const Contact& a, const Contact& b) const {
        if (a.pin != b.pin || a.place.stationary != b.place.stationary) return false;
        double way = std::abs(a.place.at - b.place.at);
        if (seamless_) way = std::min(way, std::abs(way - course_.period()));
        return way < 0.5 * farthest();
    }

    /// The box of two looks between which its slope changes sign where a side lies on two places; absent where it does
    /// not there, or the farthest places are others.
    std::optional<TurnedBox> on_two_places(const Look& low, const Look& high) {
        constexpr int most_steps = 12;
        constexpr double rounding = 1e-13;
        std::size_t side = 4;
        for (std::size_t i = 0; i < (area_ ? 4u : 2u); ++i)
            if (!is_same(low.contacts[i], high.contacts[i])) {
                if (side < 4) return {};
                side = i;
            }
        if (side == 4) return {};
        Contact one = low.contacts[side], other = high.contacts[side];
        double direction = 0.5 * (low.direction + high.direction);
        for (int i = 0; i < most_steps; ++i) {
            const double outward = direction + turn_of_side(side);
            resettle(one, outward);
            resettle(other, outward);
            const auto a = along_.of(one, outward), b = along_.of(other, outward);
            const double step = -(a.out - b.out) / (a.across - b.across);
            if (!std::isfinite(step)) return {};
            direction += step;
            if (std::abs(step) < 1e-15) break;
        }
        if (!(direction >= low.direction && direction <= high.direction)) return {};
        TurnedBox box{true, direction, contacts_in(direction), side, other};
        resettle(one, direction + turn_of_side(side));
        resettle(*box.beside, direction + turn_of_side(side));
        const double outward = direction + turn_of_side(side), farthest = along_.of(box.contacts[side], outward).out;
        const double within = rounding * (std::abs(farthest) + size_of(measured_.driven()));
        for (const Contact& contact : {one, *box.beside})
            if (!(std::abs(farthest - along_.of(contact, outward).out) <= within)) return {};
        // The slope need not change its sign there.
        const auto slope_with = [&](const Contact& contact) {
            box.contacts[side] = contact;
            return slope_of_least(sides_of(along_, box.contacts, direction), area_).first;
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
            if (is_same(low.contacts[side], high.contacts[side])) continue;
            const double outward = direction + turn_of_side(side);
            const double length = std::abs(along_.of(low.contacts[side], outward).across -
                                           along_.of(high.contacts[side], outward).across);
            if (!(length > longest)) continue;
            longest = length;
            box.contacts = low.contacts;
            box.side = side;
            box.beside = high.contacts[side];
        }
        if (!box.beside) return box;
        for (std::size_t side = 0; side < box.contacts.size(); ++side)
            resettle(box.contacts[side], direction + turn_of_side(side));
        resettle(*box.beside, direction + turn_of_side(box.side));
        return box;
    }
    /// Goes on with a contact to another direction nearby.
    void resettle(Contact& contact, double direction) {
        constexpr int most_steps = 6;
        for (int i = 0; contact.place.stationary && i < most_steps; ++i) {
            const auto [out, across] = along_.series(contact, direction);
            const double step = -out.derivative(1) / out.derivative(2) * measured_.rate();
            if (!(std::abs(step) < farthest())) return;
            contact.place.at += step;
            if (std::abs(step) < 1e-15 * (1 + std::abs(contact.place.at))) return;
        }
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
        if (!(low.slope < 0) || !(high.slope > 0)) return {true, direction, contacts_in(direction), 0, {}};
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
                if (step < 1e-15) return {true, next, here.contacts, 0, {}};
            }
            if (here.slope == 0) return {true, here.direction, here.contacts, 0, {}};
            (here.slope < 0 ? low : high) = here;
        }
        return at_corner(high.direction, high.contacts);
    }

    linkage::Measured<double, K>& measured_;
    const Course& course_;
    const bool area_;
    const linkage::MovingEnds<double> ends_{};
    ContactsAlong<double, K> along_;
    std::vector<Sample> samples_{};
    std::vector<double> far_{};
    bool seamless_ = false, closes_ = false;
};

}  // namespace mechwright::measuring
