#pragma once
/// \file
/// Where boxes and regions are touched along a motion, found for one design.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "analysis/linkage/measuring/closest.h"
#include "synthesis/mechanism/linkage/targets/found_places.h"

namespace mechwright::measuring {

using linkage::ClosestPlace;

inline constexpr std::size_t most_of_area = 2;  ///< extremes of either sort on each of two ways

/// Puts the place of a term exactly where it is stationary, or where both of its signals say the same, and measures it
/// there. Not a number where lines become parallel.
template <std::size_t K>
void settle(linkage::Measured<double, K>& plain, const Course& course, Term& term) {
    constexpr int most_steps = 6;
    constexpr double farthest = 0.05, settled = 1e-15;
    Extreme& place = term.place;
    const linkage::WithinPiece in_piece(plain, place.within);
    const auto value = [&](std::size_t signal) { return plain.value(signal, place.at, course.turns.near(place.at)); };
    if (place.limit.exists()) {
        place.value = linkage::value_at_limit(plain, term.asked, course, place.at == course.travel.to);
        return;
    }
    const double start = place.at;
    // By the share of the motion, in which what goes like the root of the way from a limit is smooth.
    const Stretch stretch = linkage::detail::stretch_of(course, course.travel.from, course.travel.to);
    if constexpr (K >= 2)
        for (int i = 0; place.stationary && i < most_steps; ++i) {
            const double share = stretch.share_of(place.at), speed = stretch.speed(share) / plain.rate();
            const auto f = value(term.asked.signal);
            double step =
                -f.derivative(1) * speed /
                (f.derivative(2) * speed * speed + f.derivative(1) * stretch.speed_slope(share) / plain.rate());
            if (term.also) {
                const auto other = value(term.also->signal);
                const double apart =
                    (term.factor * f.c[0] + term.constant) - (term.also->factor * other.c[0] + term.also->constant);
                step = -apart / ((term.factor * f.derivative(1) - term.also->factor * other.derivative(1)) * speed);
            }
            const double next = stretch.at(std::clamp(share + step, 0.0, 1.0)), way = next - place.at;
            if (!(std::abs(next - start) < farthest)) break;
            place.at = next;
            if (std::abs(way) < settled * (1 + std::abs(start))) break;
        }
    place.value = value(term.asked.signal).c[0];
}

/// The least or greatest of these, exactly: of some more than are kept.
template <std::size_t K, class Keep>
void settle_some(linkage::Measured<double, K>& plain, const Course& course, std::vector<Term>& terms, std::size_t count,
                 const Keep& keep) {
    keep(terms, count + 2);
    for (Term& term : terms)
        settle(plain, course, term);
    keep(terms, count);
}

/// Whether a signal is of a pin that stands still.
inline bool is_at_rest(const Over& over, const Signal& signal) {
    return linkage::is_on(over.model.structure.pins[signal.of], 0);
}

/// Adds terms for the places at which a signal of one pin, times a sign, may be least; one for a pin that stands still:
/// at the start, or amid a motion that begins at a limit. of(place) is the signal's value where the pin stands.
template <class Of>
void add_lowest(const Over& over, linkage::PlacedPins& placed, const Signal& signal, std::size_t index, double sign,
                const Of& of, const Term& like, Found& found) {
    Term term = like;
    term.asked = {index, 0};
    const linkage::Travel& travel = placed.course().travel;
    if (is_at_rest(over, signal)) {
        const double at = travel.from + (travel.first.exists() ? 0.5 * placed.course().period() : 0);
        const auto places = placed.at(at);
        if (!places.empty()) {
            term.place = {at, of(places[signal.of]), false};
            found.plus.push_back(term);
        }
    } else {
        for (const ClosestPlace& one : linkage::lowest_places(
                 placed,
                 [&](std::span<const Vector<double>> places) { return Separation{sign * of(places[signal.of])}; },
                 true)) {
            term.place = one.place;
            term.place.value = sign * one.place.value;
            found.plus.push_back(term);
        }
    }
    found.possible = found.possible && placed.closes;
}

/// The greatest and the least values of some signals along one direction.
struct Farthest {
    Found greatest{};
    Found least{};
};

template <std::size_t K>
Farthest farthest_of(const Over& over, linkage::Measured<double, K>& plain, linkage::PlacedPins& placed,
                     std::size_t first, std::size_t count, std::size_t keep) {
    Farthest found;
    for (std::size_t i = first; i < first + count && placed.closes; ++i) {
        const Signal& signal = plain.signals()[i];
        const Vector<double> way{std::cos(signal.number), std::sin(signal.number)};
        const auto along = [&](const Vector<double>& at) { return dot(at, way); };
        add_lowest(over, placed, signal, i, -1, along, {}, found.greatest);
        add_lowest(over, placed, signal, i, 1, along, {}, found.least);
    }
    if (!placed.closes) return found;
    settle_some(plain, placed.course(), found.greatest.plus, keep, keep_greatest);
    settle_some(plain, placed.course(), found.least.plus, keep, keep_least);
    return found;
}

/// What the width, height or area of a room is of. Of an area the height's terms are `plus_across`, `minus_across`.
template <std::size_t K>
Found found_of_room(const Over& over, linkage::Measured<double, K>& plain, const Course& course,
                    std::span<const double> dimensions) {
    const bool area = over.measure.kind == Kind::room_area;
    const std::size_t count = plain.signals().size() / (area ? 2 : 1);
    linkage::PlacedPins placed(over.driven(dimensions), placing_of<double>(over, dimensions, {}), course);
    Farthest along = farthest_of(over, plain, placed, 0, count, area ? most_of_area : most_of_range);
    Found found{.plus = std::move(along.greatest.plus), .minus = std::move(along.least.plus)};
    if (area && placed.closes) {
        Farthest across = farthest_of(over, plain, placed, count, count, most_of_area);
        found.plus_across = std::move(across.greatest.plus);
        found.minus_across = std::move(across.least.plus);
    }
    found.possible = placed.closes && count > 0;
    return found;
}

/// What the margin of a region is of where it is that of points.
template <std::size_t K>
Found found_of_points(const Over& over, linkage::Measured<double, K>& plain, const Course& course,
                      std::span<const double> dimensions) {
    const LinkageRegion& region = over.model.regions[over.measure.of_room];
    const double unit = over.model.unit;
    const std::vector<StraightBorder> borders = borders_of(region);
    linkage::PlacedPins placed(over.driven(dimensions), placing_of<double>(over, dimensions, {}), course);
    Found found;
    for (std::size_t i = 0; i < plain.signals().size() && placed.closes; ++i) {
        const Signal& signal = plain.signals()[i];
        Term term;
        if (borders.empty()) {
            term.factor = -1;
            term.constant = region.radius / unit;
            add_lowest(
                over, placed, signal, i, -1,
                [&](const Vector<double>& at) { return std::hypot(at.x - signal.place.x, at.y - signal.place.y); },
                term, found);
        } else {
            const StraightBorder& border = borders[i % borders.size()];
            term.constant = -dot(border.inward, border.through) / unit;
            add_lowest(
                over, placed, signal, i, 1, [&](const Vector<double>& at) { return dot(at, border.inward); }, term,
                found);
        }
    }
    found.possible = found.possible && !found.plus.empty();
    if (found.possible) settle_some(plain, course, found.plus, most_extremes, keep_least);
    return found;
}

}  // namespace mechwright::measuring
