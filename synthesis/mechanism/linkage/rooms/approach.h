#pragma once
/// \file
/// How near the path of a point comes to itself: the least length of all chords that stand square to the path at both
/// of their places, or at one where the other is an end of the path from which every way along it leads farther off.
/// Zero where the path crosses itself. (Of closed curves it is called the doubly critical self-distance: R. Litherland,
/// J. Simon, O. Durumeric and E. Rawdon, Thickness of knots, Topology and its Applications 91 (1999), 233-244.)

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "analysis/linkage/measuring/moving_extremes.h"
#include "synthesis/mechanism/linkage/rooms/outline_samples.h"

namespace mechwright::measuring {

/// Half the square of a chord's length, with its slopes by the times of its places, and the slopes of these.
template <class T>
struct ChordSeries {
    T half_square;
    std::array<T, 2> slope;
    std::array<std::array<T, 2>, 2> bend;
};

/// A place of the path with its first two derivatives by the time; these are zero at an end.
template <class T>
struct PlaceOfPath {
    Vector<T> at, velocity, acceleration;
};

template <class T>
ChordSeries<T> chord_between(const PlaceOfPath<T>& one, const PlaceOfPath<T>& other) {
    const Vector<T> chord = one.at - other.at;
    const T mixed = -dot(one.velocity, other.velocity);
    return {T(0.5) * dot(chord, chord),
            {dot(chord, one.velocity), -dot(chord, other.velocity)},
            {{{dot(one.velocity, one.velocity) + dot(chord, one.acceleration), mixed},
              {mixed, dot(other.velocity, other.velocity) - dot(chord, other.acceleration)}}}};
}

/// Places of the only pin of a room: signals 0 and 1 are its coordinates. K must be 2 at least.
template <class T, std::size_t K>
PlaceOfPath<T> path_place(linkage::Measured<T, K>& measured, const Course& course, const Contact& contact,
                          const linkage::MovingEnds<T>& ends) {
    const linkage::Extreme& place = contact.place;
    const Vector<T> still{T(0), T(0)};
    if (!place.stationary) {
        const auto coordinate = [&](std::size_t signal, double at_limit) {
            linkage::Extreme one = place;
            one.value = at_limit;
            return linkage::value_at(measured, {signal, 0}, course, one, ends);
        };
        return {{coordinate(0, contact.at_limit.x), coordinate(1, contact.at_limit.y)}, still, still};
    }
    const linkage::WithinPiece in_piece(measured, place.within);
    const auto near = course.turns.near(place.at);
    const auto x = measured.value(0, place.at, near), y = measured.value(1, place.at, near);
    return {{x.derivative(0), y.derivative(0)}, {x.derivative(1), y.derivative(1)}, {x.derivative(2), y.derivative(2)}};
}

/// The way to where the slopes vanish, by Newton's method; an end stays. The shortest one where many lead there, as
/// about the centre of a circle; nothing where none does.
inline std::optional<std::array<double, 2>> newton_step(const ChordSeries<double>& c,
                                                        const std::array<bool, 2>& moves) {
    constexpr double flat = 1e-12;
    const auto& [a, b] = c.bend;
    if (moves[0] && moves[1]) {
        const double determinant = a[0] * b[1] - a[1] * b[0];
        const double size = std::abs(a[0] * b[1]) + std::abs(a[1] * b[0]);
        const double trace = a[0] + b[1];
        if (!(std::abs(determinant) > flat * size)) {
            if (!(std::abs(trace) > 0)) return {};
            const double scale = -1 / (trace * trace);
            return std::array{scale * (a[0] * c.slope[0] + a[1] * c.slope[1]),
                              scale * (b[0] * c.slope[0] + b[1] * c.slope[1])};
        }
        return std::array{-(b[1] * c.slope[0] - a[1] * c.slope[1]) / determinant,
                          -(a[0] * c.slope[1] - b[0] * c.slope[0]) / determinant};
    }
    std::array<double, 2> step{0, 0};
    for (std::size_t k = 0; k < 2; ++k)
        if (moves[k]) {
            if (!(std::abs(c.bend[k][k]) > 0)) return {};
            step[k] = -c.slope[k] / c.bend[k][k];
        }
    return step;
}

/// The distance of two places as a function of the dimensions, with which they move: to second order, as the slopes by
/// their times are of first order.
template <class T, std::size_t K>
T distance_of(linkage::Measured<T, K>& measured, const Course& course, const Approach& approach,
              const linkage::MovingEnds<T>& ends) {
    using std::sqrt;
    constexpr double crossing = 1e-12;
    const PlaceOfPath<T> one = path_place(measured, course, approach.one, ends),
                         other = path_place(measured, course, approach.other, ends);
    const ChordSeries<T> c = chord_between(one, other);
    const double size =
        std::abs(number_as<double>(value_of(one.at.x))) + std::abs(number_as<double>(value_of(one.at.y)));
    // Where the path crosses itself the distance is no less on either side.
    if (!(approach.distance > crossing * size)) return T(0);
    ChordSeries<double> plain;
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j)
            plain.bend[i][j] = number_as<double>(value_of(c.bend[i][j]));
    T half_square = c.half_square;
    // half_square - g H^-1 g / 2, by columns of H^-1.
    for (std::size_t j = 0; j < 2; ++j) {
        plain.slope = {j == 0 ? -1.0 : 0.0, j == 1 ? -1.0 : 0.0};
        const auto column = newton_step(plain, {approach.one.place.stationary, approach.other.place.stationary});
        for (std::size_t i = 0; column && i < 2; ++i)
            half_square = half_square - T(0.5 * (*column)[i]) * linkage::detail::change_of(c.slope[i]) *
                                            linkage::detail::change_of(c.slope[j]);
    }
    return sqrt(T(T(2) * half_square));
}

/// Finds the nearest approaches of the path of a room's only pin to itself.
template <std::size_t K>
class ApproachSearch {
public:
    ApproachSearch(const Over& over, const LinkageRoom& room, linkage::Measured<double, K>& plain, const Course& course,
                   std::span<const double> dimensions)
        : measured_(plain), course_(course) {
        OutlineSamples outline = sampled_outline(over, room, plain, course, dimensions);
        closes = !outline.samples.empty();
        if (outline.samples.size() > 1) thin(outline.samples);
    }

    /// The nearest ones first, `most` at most; of a path without any its ends, where it has some.
    std::vector<Approach> found(std::size_t most) {
        if (samples_.size() < 3) return {};
        collect();
        std::stable_sort(seen_.begin(), seen_.end(),
                         [](const Seen& a, const Seen& b) { return a.distance < b.distance; });
        std::vector<Approach> all;
        int settled_from = 0;
        constexpr int most_settled = 64;
        for (const Seen& seen : seen_) {
            if (settled_from++ == most_settled) break;
            if (all.size() >= most && seen.distance - seen.within > all[most - 1].distance) break;
            const auto one = settled(seen);
            if (!one || std::any_of(all.begin(), all.end(), [&](const Approach& a) { return is_same(a, *one); }))
                continue;
            all.push_back(*one);
            std::stable_sort(all.begin(), all.end(),
                             [](const Approach& a, const Approach& b) { return a.distance < b.distance; });
        }
        if (all.size() > most) all.resize(most);
        if (all.empty() && !course_.travel.whole)
            all.push_back(measured_between(samples_.front().contact, samples_.back().contact));
        return all;
    }

    bool closes = true;

private:
    struct Sample {
        Contact contact;
        Vector<double> at, along;
    };
    /// Two places between samples, or an end and one of these, between which there may be such a chord.
    struct Seen {
        Contact one, other;
        double distance, within;
        double cell_of_one, cell_of_other;  ///< how far they may be moved
    };

    /// Every so many samples, each with the way from the one before it to the next.
    void thin(const std::vector<OutlineSample>& all) {
        constexpr std::size_t most = 1024;
        const std::size_t every = (all.size() + most - 1) / most;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool same_place = course_.travel.whole && all[i].last && i + 1 == all.size();
            if (same_place || (i % every != 0 && !all[i].first && !all[i].last)) continue;
            samples_.push_back({all[i].contact, all[i].at, {0, 0}});
        }
        const std::size_t n = samples_.size();
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t before = i > 0                  ? i - 1
                                       : course_.travel.whole ? n - 1
                                                              : 0,
                              after = i + 1 < n              ? i + 1
                                      : course_.travel.whole ? 0
                                                             : n - 1;
            samples_[i].along = samples_[after].at - samples_[before].at;
        }
    }

    /// How far two inputs are apart along the motion.
    double way_between(double a, double b) const {
        const double way = std::abs(a - b);
        return course_.travel.whole ? std::min(way, std::abs(course_.period() - way)) : way;
    }
    double input(std::size_t i) const { return samples_[i].contact.place.at; }
    std::size_t next(std::size_t i) const { return (i + 1) % samples_.size(); }
    std::size_t cells() const { return samples_.size() - (course_.travel.whole ? 0 : 1); }
    double cell(std::size_t i) const { return way_between(input(i), input(next(i))); }
    /// Amid a cell.
    Contact amid(std::size_t i) const {
        Contact contact = samples_[i].contact;
        contact.place.at += 0.5 * cell(i);
        contact.place.stationary = true;
        contact.place.limit = {};
        return contact;
    }

    void collect() {
        const std::size_t n = samples_.size();
        const auto slopes = [&](std::size_t i, std::size_t j) {
            const Vector<double> chord = samples_[i].at - samples_[j].at;
            return Vector<double>{dot(chord, samples_[i].along), dot(chord, samples_[j].along)};
        };
        std::vector<Vector<double>> row(n), next_row(n);
        const auto fill = [&](std::size_t i, std::vector<Vector<double>>& into) {
            for (std::size_t j = 0; j < n; ++j)
                into[j] = slopes(i, j);
        };
        fill(0, row);
        for (std::size_t i = 0; i < cells(); ++i) {
            fill(next(i), next_row);
            for (std::size_t j = i + 2; j < cells(); ++j) {
                const Vector<double>&a = row[j], &b = row[next(j)], &c = next_row[j], &d = next_row[next(j)];
                if (std::min({a.x, b.x, c.x, d.x}) > 0 || std::max({a.x, b.x, c.x, d.x}) < 0 ||
                    std::min({a.y, b.y, c.y, d.y}) > 0 || std::max({a.y, b.y, c.y, d.y}) < 0)
                    continue;
                add_cells(i, j);
            }
            std::swap(row, next_row);
        }
        if (!course_.travel.whole) collect_at_ends(slopes);
    }
    void add_cells(std::size_t i, std::size_t j) {
        const double far = 2 * std::max(cell(i), cell(j));
        const Contact one = amid(i), other = amid(j);
        if (way_between(one.place.at, other.place.at) <= far) return;  // neighbours
        const Vector<double> from = middle(i), to = middle(j);
        seen_.push_back(
            {one, other, std::hypot(from.x - to.x, from.y - to.y), length(i) + length(j), cell(i), cell(j)});
    }
    Vector<double> middle(std::size_t i) const { return 0.5 * (samples_[i].at + samples_[next(i)].at); }
    double length(std::size_t i) const {
        const Vector<double> way = samples_[next(i)].at - samples_[i].at;
        return std::hypot(way.x, way.y);
    }
    /// Chords from an end of the path, from which it leads away from the other place.
    template <class Slopes>
    void collect_at_ends(const Slopes& slopes) {
        const std::size_t last = samples_.size() - 1;
        const auto leads_away = [&](std::size_t end, std::size_t from) {
            return slopes(end, from).x * (end == 0 ? 1 : -1) >= 0;
        };
        for (const std::size_t end : {std::size_t{0}, last})
            for (std::size_t j = 0; j < cells(); ++j) {
                if (j + 1 >= end && j <= end + 1) continue;
                const double a = slopes(end, j).y, b = slopes(end, j + 1).y;
                // Nearest, not farthest: on the way there it comes nearer.
                if (!(a >= 0 && b <= 0) || !leads_away(end, j)) continue;
                const Vector<double> to = middle(j);
                seen_.push_back({samples_[end].contact, amid(j),
                                 std::hypot(samples_[end].at.x - to.x, samples_[end].at.y - to.y), length(j), 0,
                                 cell(j)});
            }
        if (leads_away(0, last) && leads_away(last, 0)) {
            const Approach ends = measured_between(samples_[0].contact, samples_[last].contact);
            seen_.push_back({ends.one, ends.other, ends.distance, 0, 0, 0});
        }
    }

    PlaceOfPath<double> place_of(const Contact& contact) { return path_place(measured_, course_, contact, {}); }
    Approach measured_between(const Contact& one, const Contact& other) {
        const Vector<double> chord = place_of(one).at - place_of(other).at;
        return {one, other, std::hypot(chord.x, chord.y)};
    }

    /// Newton's method from where a chord was seen; nothing where that leaves its surroundings.
    std::optional<Approach> settled(const Seen& seen) {
        constexpr int most_steps = 30;
        constexpr double small = 1e-15, farthest = 3;
        Contact one = seen.one, other = seen.other;
        const std::array<bool, 2> moves{one.place.stationary, other.place.stationary};
        for (int i = 0; i < most_steps && (moves[0] || moves[1]); ++i) {
            const auto step = newton_step(chord_between(place_of(one), place_of(other)), moves);
            if (!step) return {};
            // No farther in one step than a cell is wide.
            const double limit_of_one = seen.cell_of_one, limit_of_other = seen.cell_of_other;
            const double by_one = std::clamp((*step)[0] * measured_.rate(), -limit_of_one, limit_of_one),
                         by_other = std::clamp((*step)[1] * measured_.rate(), -limit_of_other, limit_of_other);
            one.place.at += by_one;
            other.place.at += by_other;
            if (!(std::abs(one.place.at - seen.one.place.at) <= farthest * limit_of_one) ||
                !(std::abs(other.place.at - seen.other.place.at) <= farthest * limit_of_other) || !is_in_motion(one) ||
                !is_in_motion(other))
                return {};
            if (std::abs(by_one) <= small * (1 + std::abs(one.place.at)) &&
                std::abs(by_other) <= small * (1 + std::abs(other.place.at)))
                break;
        }
        if (moves[0] && moves[1] &&
            way_between(one.place.at, other.place.at) <= std::max(seen.cell_of_one, seen.cell_of_other))
            return {};
        return measured_between(one, other);
    }
    bool is_in_motion(const Contact& contact) const {
        const linkage::Travel& travel = course_.travel;
        return travel.whole || (contact.place.at >= travel.from && contact.place.at <= travel.to);
    }
    bool is_same(const Approach& a, const Approach& b) const {
        constexpr double same = 1e-7;
        const auto is_close = [&](const Contact& p, const Contact& q) {
            return way_between(p.place.at, q.place.at) < same * measured_.unit_of_input();
        };
        return (is_close(a.one, b.one) && is_close(a.other, b.other)) ||
               (is_close(a.one, b.other) && is_close(a.other, b.one));
    }

    linkage::Measured<double, K>& measured_;
    const Course& course_;
    std::vector<Sample> samples_{};
    std::vector<Seen> seen_{};
};

}  // namespace mechwright::measuring
