#include "synthesis/mechanism/linkage/again/self_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "synthesis/mechanism/linkage/again/measured.h"

namespace mechwright::again {

namespace {

/// A pin at an input with its derivatives by it, in doubles; of the ends of a motion with limits the place alone.
struct SeenPlace {
    double input = 0;
    Vector<double> at, by_input, bend;
    bool end = false;
};

/// Two places that may be near the ends of such a chord.
struct SeenChord {
    SeenPlace one, other;
    double distance = 0;
    double room_of_one = 0, room_of_other = 0;  ///< how far they may be moved
};

class SampledPath {
public:
    SampledPath(const Scan& scan, std::size_t pin) : scan_(scan), pin_(pin) {
        for (const double input : inputs())
            if (const auto place = look(input)) places_.push_back(*place);
        if (scan.full_turn()) return;
        places_.insert(places_.begin(), end_at(scan.from()));
        places_.push_back(end_at(scan.to()));
    }

    /// The least of all chords, in fifty digits.
    Digits50 least() {
        if (places_.size() < 3) return missing;
        std::vector<SeenChord> pairs = seen();
        std::stable_sort(pairs.begin(), pairs.end(),
                         [](const SeenChord& a, const SeenChord& b) { return a.distance < b.distance; });
        std::optional<SeenChord> best;
        for (const SeenChord& pair : pairs)
            if (!best || pair.distance - widest_ < best->distance)
                if (const auto one = settled(pair); one && (!best || one->distance < best->distance)) best = one;
        if (!best && !scan_.full_turn()) best = SeenChord{places_.front(), places_.back()};
        return best ? exactly(*best) : Digits50(missing);
    }

private:
    /// Even ones, and ever closer to limits.
    std::vector<double> inputs() const {
        constexpr int even = 900, of_several_turns = 2700;
        constexpr double closer = 0.8, closest = 1e-9;
        const double way = scan_.to() - scan_.from();
        const int count = scan_.model.turns > 1 ? of_several_turns : even;
        std::vector<double> all;
        for (int i = scan_.full_turn() ? 0 : 1; i < count; ++i)
            all.push_back(scan_.from() + way * i / count);
        for (double share = 0.5 / count; share > closest && !scan_.full_turn(); share *= closer) {
            all.push_back(scan_.from() + share * way);
            all.push_back(scan_.to() - share * way);
        }
        std::sort(all.begin(), all.end());
        return all;
    }
    std::optional<SeenPlace> look(double input) const {
        const SeriesSignals* there = scan_.look(input);
        if (there == nullptr) return {};
        const Vector<InputSeries> at = there->in_pose().in_drawing(pin_);
        return SeenPlace{input, {at.x.c[0], at.y.c[0]}, {at.x.c[1], at.y.c[1]}, {2 * at.x.c[2], 2 * at.y.c[2]}};
    }
    Digits50 coordinate(double input, bool across) const {
        const std::size_t pin = pin_;
        return of_poses(scan_,
                        [pin, across]<class T>(const PoseSignals<T>& pose) {
                            const Vector<T> at = pose.in_drawing(pin);
                            return across ? at.y : at.x;
                        })
            .at(input);
    }
    SeenPlace end_at(double input) const {
        const auto rounded = [&](bool across) { return coordinate(input, across).convert_to<double>(); };
        return {input, {rounded(false), rounded(true)}, {0, 0}, {0, 0}, true};
    }
    Digits50 exactly(const SeenChord& pair) const {
        const Digits50 x = coordinate(pair.one.input, false) - coordinate(pair.other.input, false),
                       y = coordinate(pair.one.input, true) - coordinate(pair.other.input, true);
        // Where the path crosses itself doubles say where to their last digit.
        constexpr double crossing = 1e-13;
        const Digits50 distance = sqrt(x * x + y * y);
        return distance > crossing * size() ? distance : Digits50(0);
    }
    double size() const {
        double greatest = 0;
        for (const SeenPlace& place : places_)
            greatest = std::max({greatest, std::abs(place.at.x), std::abs(place.at.y)});
        return greatest;
    }

    std::size_t next(std::size_t i) const { return i + 1 < places_.size() ? i + 1 : 0; }
    double way_between(double a, double b) const {
        const double way = std::abs(a - b), period = scan_.to() - scan_.from();
        return scan_.full_turn() ? std::min(way, period - way) : way;
    }
    double room_of(std::size_t i) const { return way_between(places_[i].input, places_[next(i)].input); }

    /// Where a chord's slopes by both of its ends change their signs, or by one where the other is an end of the path
    /// that leads away from it.
    std::vector<SeenChord> seen() {
        const std::size_t n = places_.size(), cells = scan_.full_turn() ? n : n - 1;
        std::vector<SeenChord> pairs;
        const auto chord = [&](std::size_t i, std::size_t j) { return places_[i].at - places_[j].at; };
        for (std::size_t i = 0; i < cells; ++i)
            for (std::size_t j = i + 2; j < cells; ++j) {
                bool up = false, down = false, up_of_other = false, down_of_other = false, ends = false;
                for (const std::size_t a : {i, next(i)})
                    for (const std::size_t b : {j, next(j)}) {
                        ends = ends || places_[a].end || places_[b].end;
                        const double one = dot(chord(a, b), places_[a].by_input),
                                     other = dot(chord(a, b), places_[b].by_input);
                        up = up || one >= 0;
                        down = down || one <= 0;
                        up_of_other = up_of_other || other >= 0;
                        down_of_other = down_of_other || other <= 0;
                    }
                const double far = 2 * std::max(room_of(i), room_of(j));
                if (ends || !up || !down || !up_of_other || !down_of_other ||
                    way_between(places_[i].input, places_[j].input) <= far)
                    continue;
                add(pairs, places_[i], places_[j], room_of(i), room_of(j));
            }
        if (!scan_.full_turn()) add_ends(pairs);
        return pairs;
    }
    void add(std::vector<SeenChord>& pairs, const SeenPlace& one, const SeenPlace& other, double room_of_one,
             double room_of_other) {
        pairs.push_back(
            {one, other, std::hypot(one.at.x - other.at.x, one.at.y - other.at.y), room_of_one, room_of_other});
        widest_ = std::max(widest_, room_of_one * std::hypot(one.by_input.x, one.by_input.y) +
                                        room_of_other * std::hypot(other.by_input.x, other.by_input.y));
    }
    void add_ends(std::vector<SeenChord>& pairs) {
        const std::size_t last = places_.size() - 1;
        const auto leads_away = [&](std::size_t end, std::size_t from) {
            const Vector<double> inwards = places_[end == 0 ? 1 : last - 1].at - places_[end].at;
            return dot(places_[end].at - places_[from].at, inwards) >= 0;
        };
        for (const std::size_t end : {std::size_t{0}, last})
            for (std::size_t j = 1; j + 1 < last; ++j) {
                const auto nears = [&](std::size_t k) {
                    return dot(places_[end].at - places_[k].at, places_[k].by_input);
                };
                const std::size_t beside = end == 0 ? j : last - j - 1;
                if (beside < 2 || !(nears(j) >= 0 && nears(j + 1) <= 0) || !leads_away(end, j)) continue;
                add(pairs, places_[end], places_[j], 0, room_of(j));
            }
        if (leads_away(0, last) && leads_away(last, 0)) add(pairs, places_[0], places_[last], 0, 0);
    }

    /// Put where it stands square, by Newton's method; nothing where that leads elsewhere.
    std::optional<SeenChord> settled(SeenChord pair) const {
        constexpr int most_steps = 40;
        constexpr double farthest = 3, flat = 1e-12, small = 4e-16;
        const SeenChord start = pair;
        for (int i = 0; i < most_steps; ++i) {
            const Vector<double> chord = pair.one.at - pair.other.at, &v = pair.one.by_input, &w = pair.other.by_input;
            const double slope = dot(chord, v), slope_of_other = -dot(chord, w);
            const double a = pair.one.end ? 1 : dot(v, v) + dot(chord, pair.one.bend),
                         d = pair.other.end ? 1 : dot(w, w) - dot(chord, pair.other.bend), b = -dot(v, w);
            double determinant = a * d - b * b;
            double step = -(d * slope - b * slope_of_other) / determinant,
                   step_of_other = -(a * slope_of_other - b * slope) / determinant;
            // Many chords are as long about a centre: the shortest way to one of them.
            if (std::abs(determinant) <= flat * (std::abs(a * d) + b * b)) {
                determinant = (a + d) * (a + d);
                step = -(a * slope + b * slope_of_other) / determinant;
                step_of_other = -(b * slope + d * slope_of_other) / determinant;
            }
            step = std::clamp(step, -start.room_of_one, start.room_of_one);
            step_of_other = std::clamp(step_of_other, -start.room_of_other, start.room_of_other);
            if (!moved(pair.one, step) || !moved(pair.other, step_of_other)) return {};
            if (!(std::abs(pair.one.input - start.one.input) <= farthest * start.room_of_one) ||
                !(std::abs(pair.other.input - start.other.input) <= farthest * start.room_of_other))
                return {};
            if (std::abs(step) <= small * (1 + std::abs(pair.one.input)) &&
                std::abs(step_of_other) <= small * (1 + std::abs(pair.other.input)))
                break;
        }
        const bool both = !pair.one.end && !pair.other.end;
        if (both && way_between(pair.one.input, pair.other.input) <= std::max(start.room_of_one, start.room_of_other))
            return {};
        pair.distance = std::hypot(pair.one.at.x - pair.other.at.x, pair.one.at.y - pair.other.at.y);
        return pair;
    }
    bool moved(SeenPlace& place, double by) const {
        if (place.end || by == 0) return true;
        const auto there = look(place.input + by);
        if (there) place = *there;
        return there.has_value();
    }

    const Scan& scan_;
    std::size_t pin_;
    std::vector<SeenPlace> places_{};
    double widest_ = 0;  ///< by as much a chord may be shorter than where it is seen
};

}  // namespace

Digits50 self_distance(const Scan& scan, std::size_t pin) { return SampledPath(scan, pin).least(); }

}  // namespace mechwright::again
