#include "synthesis/mechanism/linkage/again/turned_direction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "synthesis/mechanism/linkage/again/measured.h"

namespace mechwright::again {

namespace {

/// The places of a room's pins along the motion, as series of the input about many of them, in doubles; of a motion
/// with ends these exactly.
class SweptPlaces {
public:
    SweptPlaces(const Scan& scan, const LinkageRoom& room) : scan_(scan) {
        const std::vector<Vector<double>> whole{{scan.from(), scan.to()}};
        const std::vector<Vector<double>> pieces = between_breaks(scan, whole);
        for (const Vector<double>& piece : pieces) {
            const double within = pieces.size() > 1 ? 0.5 * (piece.x + piece.y) : linkage::by_itself;
            const std::vector<double> inputs = inputs_in(piece, pieces.size() > 1);
            for (std::size_t i = 0; i < inputs.size(); ++i) {
                const SeriesSignals* sample = scan.look(inputs[i], within);
                if (sample == nullptr) continue;
                // A series reaches no farther than the limit at which a motion ends.
                const double room_before = scan.full_turn() ? 1 : of_way * (inputs[i] - scan.from()),
                             room_after = scan.full_turn() ? 1 : of_way * (scan.to() - inputs[i]);
                const double reach = std::max(0.0, std::min(room_before, room_after));
                const double back = i > 0 ? std::max(inputs[i - 1] - inputs[i], -reach) : 0,
                             ahead = i + 1 < inputs.size() ? std::min(inputs[i + 1] - inputs[i], reach) : 0;
                for (const std::size_t pin : room.pins)
                    all_.push_back({sample->in_pose().in_drawing(pin), back, ahead, inputs[i], within, pin});
            }
        }
        for (const std::size_t pin : room.pins)
            for (const double end : {scan.from(), scan.to()}) {
                if (scan.full_turn()) break;
                const auto coordinate = [&](bool across) {
                    return of_poses(scan,
                                    [pin, across]<class T>(const PoseSignals<T>& pose) {
                                        const Vector<T> at = pose.in_drawing(pin);
                                        return across ? at.y : at.x;
                                    })
                        .at(end)
                        .template convert_to<double>();
                };
                all_.push_back({{InputSeries(coordinate(false)), InputSeries(coordinate(true))},
                                0,
                                0,
                                end,
                                linkage::by_itself,
                                pin});
            }
    }

    /// How far the farthest of them is in a direction, and where it is across that: by the series, or exactly.
    Vector<double> farthest(double direction, bool exactly) const {
        const double c = std::cos(direction), s = std::sin(direction);
        const auto part = [&](const Place& place, std::size_t k) { return c * place.at.x.c[k] + s * place.at.y.c[k]; };
        double seen = -std::numeric_limits<double>::infinity();
        for (const Place& place : all_)
            seen = std::max(seen, part(place, 0));
        Vector<double> best{-std::numeric_limits<double>::infinity(), 0};
        std::vector<Found> found;
        for (const Place& place : all_) {
            // A neighbour that is nearer to the farthest shows as much.
            const double way = std::max(-place.back, place.ahead), value = part(place, 0);
            if (value + way * (std::abs(part(place, 1)) + way * std::abs(part(place, 2))) < seen) continue;
            const double moved = stationary(place, part);
            double x = 0, y = 0;
            for (std::size_t k = powers_of_input + 1; k-- > 0;) {
                x = x * moved + place.at.x.c[k];
                y = y * moved + place.at.y.c[k];
            }
            const Vector<double> one{c * x + s * y, c * y - s * x};
            if (exactly) found.push_back({&place, place.input + moved, one});
            if (one.x > best.x) best = one;
        }
        if (!exactly) return best;
        // Which of several is the farthest is not seen by series.
        constexpr double as_far = 1e-6;
        const double least = best.x - as_far * (std::abs(best.x) + std::abs(best.y));
        best.x = -std::numeric_limits<double>::infinity();
        for (const Found& one : found)
            if (one.far.x >= least)
                if (const Vector<double> far = exact(one, c, s); far.x > best.x) best = far;
        return best;
    }

private:
    struct Place {
        Vector<InputSeries> at;
        double back, ahead;  ///< to the next places, or as far as the series reaches
        double input, within;
        std::size_t pin;
    };
    static constexpr double of_way = 0.25;

    /// Where a place is farthest by its series.
    struct Found {
        const Place* of;
        double input;
        Vector<double> far;
    };
    /// The same by the pose that is there.
    Vector<double> exact(const Found& found, double c, double s) const {
        constexpr int most_steps = 6;
        Vector<double> far = found.far;
        double input = found.input;
        for (int i = 0; i < most_steps && found.of->back < found.of->ahead; ++i) {
            const SeriesSignals* there = scan_.look(input, found.of->within);
            if (there == nullptr) break;
            const Vector<InputSeries> at = there->in_pose().in_drawing(found.of->pin);
            const double slope = c * at.x.c[1] + s * at.y.c[1], bend = 2 * (c * at.x.c[2] + s * at.y.c[2]);
            far = {c * at.x.c[0] + s * at.y.c[0], c * at.y.c[0] - s * at.x.c[0]};
            const double next =
                std::clamp(input - slope / bend, found.of->input + found.of->back, found.of->input + found.of->ahead);
            if (!(bend < 0) || std::abs(next - input) <= 1e-15 * (1 + std::abs(input))) break;
            input = next;
        }
        return far;
    }

    /// The inputs of the samples in a piece, and ever closer ones to limits at the ends of the motion.
    std::vector<double> inputs_in(const Vector<double>& piece, bool of_several) const {
        constexpr double closer = 0.8, closest = 1e-9;
        std::vector<double> inputs;
        if (of_several || scan_.full_turn()) inputs = {piece.x, piece.y};
        for (const double input : scan_.at)
            if (input > piece.x && input < piece.y) inputs.push_back(input);
        const double way = scan_.to() - scan_.from();
        for (double share = 0.5; share > closest && !scan_.full_turn(); share *= closer)
            for (const double input : {scan_.from() + share * way, scan_.to() - share * way})
                if (input > piece.x && input < piece.y) inputs.push_back(input);
        std::sort(inputs.begin(), inputs.end());
        return inputs;
    }
    /// The input from that of a place where it is farthest, up to the next places.
    template <class Part>
    static double stationary(const Place& place, const Part& part) {
        double moved = 0;
        for (int i = 0; i < 12; ++i) {
            double slope = 0, bend = 0;
            for (std::size_t k = powers_of_input; k > 0; --k) {
                slope = slope * moved + static_cast<double>(k) * part(place, k);
                if (k > 1) bend = bend * moved + static_cast<double>(k * (k - 1)) * part(place, k);
            }
            const double step = bend < 0 ? -slope / bend : slope > 0 ? place.ahead : place.back;
            const double next = std::clamp(moved + step, place.back, place.ahead);
            if (next == moved) break;
            moved = next;
        }
        return moved;
    }
    const Scan& scan_;
    std::vector<Place> all_{};
};

/// Directions between which the slope of a box changes from falling to rising, and its size there.
struct Lowest {
    double low, high, size;

    template <class SlopeAt>
    void halve(const SlopeAt& slope_at, double narrowest) {
        while (high - low > narrowest) {
            const double middle = 0.5 * (low + high);
            if (!(middle > low && middle < high)) break;
            (slope_at(middle) < 0 ? low : high) = middle;
        }
    }
};

}  // namespace

/// The direction in which the box of a room is least: of all directions those between which its slope changes from
/// falling to rising, halved to their last digit.
double turned_direction(const Scan& scan, const LinkageRoom& room) {
    constexpr std::size_t directions = 720;
    constexpr double beside = 1e-5;
    const bool area = room.turn == LinkageRoom::Turn::least_area;
    const double quarter = std::numbers::pi / 2, period = area ? quarter : 2 * quarter;
    const SweptPlaces swept(scan, room);
    struct Box {
        double size, slope;
    };
    bool exactly = false;
    const auto width = [&](double direction) {
        const Vector<double> one = swept.farthest(direction, exactly),
                             other = swept.farthest(direction + 2 * quarter, exactly);
        return Box{one.x + other.x, one.y + other.y};
    };
    const auto box = [&](double direction) {
        const Box along = width(direction);
        if (!area) return along;
        const Box across = width(direction + quarter);
        return Box{along.size * across.size, along.slope * across.size + along.size * across.slope};
    };
    std::vector<Box> seen;
    for (std::size_t i = 0; i <= directions; ++i)
        seen.push_back(box(period * static_cast<double>(i) / directions));
    const auto slope_at = [&](double direction) { return box(direction).slope; };
    std::vector<Lowest> all;
    for (std::size_t i = 0; i < directions; ++i) {
        if (!(seen[i].slope <= 0) || !(seen[i + 1].slope >= 0)) continue;
        const double step = period / directions;
        Lowest one{step * static_cast<double>(i), step * static_cast<double>(i + 1), 0};
        one.halve(slope_at, beside);
        one.size = box(one.high).size;
        all.push_back(one);
    }
    // What the series leave is far less; of boxes that are least everywhere a few are enough.
    constexpr double as_small = 1e-6;
    constexpr std::size_t most = 6;
    std::stable_sort(all.begin(), all.end(), [](const Lowest& a, const Lowest& b) { return a.size < b.size; });
    exactly = true;
    double best = std::numeric_limits<double>::infinity(), found = 0;
    for (std::size_t i = 0; i < std::min(most, all.size()); ++i) {
        Lowest one = all[i];
        if (one.size > all.front().size + as_small * std::abs(all.front().size)) break;
        one.low -= beside;
        one.high += beside;
        one.halve(slope_at, 0);
        const double size = box(one.high).size;
        if (!(size < best)) continue;
        best = size;
        found = one.high;
    }
    return found;
}

}  // namespace mechwright::again
