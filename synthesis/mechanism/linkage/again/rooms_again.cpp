#include "synthesis/mechanism/linkage/again/rooms_again.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/again/measured.h"

namespace mechwright::again {

namespace {

using Kind = LinkageMeasure::Kind;

template <class T>
Vector<T> as(const Vector<double>& at) {
    return {T(at.x), T(at.y)};
}

/// The least over the motion of several functions of a pose, of(k, pose) for k < count: of those that come near to the
/// least at the samples.
template <class Of>
Digits50 least_of_several(const Scan& scan, std::size_t count, const Of& of) {
    constexpr double near_best = 2e-2, infinity = std::numeric_limits<double>::infinity();
    std::vector<double> seen(count, infinity);
    double best = infinity, worst = -infinity;
    for (const double input : scan.at) {
        const SeriesSignals* sample = scan.look(input);
        for (std::size_t k = 0; sample && k < count; ++k) {
            const double one = of(k, sample->in_pose()).c[0];
            seen[k] = std::min(seen[k], one);
            best = std::min(best, one);
            worst = std::max(worst, one);
        }
    }
    Digits50 least = infinity;
    for (std::size_t k = 0; k < count; ++k)
        if (seen[k] <= best + near_best * (worst - best))
            least = std::min<Digits50>(
                least, least_of_poses(scan, [&of, k]<class T>(const PoseSignals<T>& pose) { return of(k, pose); }));
    return isfinite(least) ? least : Digits50(missing);
}

/// How far the farthest pins of a room are apart along its width or its height, all over the motion.
Digits50 side_of(const Scan& scan, const LinkageRoom& room, bool across) {
    const auto farthest = [&](int sign) {
        return least_of_several(scan, room.pins.size(),
                                [&room, across, sign]<class T>(std::size_t k, const PoseSignals<T>& pose) {
                                    using std::cos, std::sin;
                                    Vector<T> way{T(cos(T(room.direction))), T(sin(T(room.direction)))};
                                    if (across) way = left_of(way);
                                    return T(T(sign) * dot(pose.in_drawing(room.pins[k]), way));
                                });
    };
    return -(farthest(1) + farthest(-1));
}

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

/// How far a point is inside of a region; negative outside, then by how much it is beyond a border.
template <class T>
T inside_by(const Vector<T>& at, const LinkageRegion& region) {
    using std::cos, std::sin;
    if (region.shape == LinkageRegion::Shape::circle) {
        const Vector<T> from = at - as<T>(region.places.front());
        return T(region.radius) - hypotenuse(from.x, from.y);
    }
    if (region.shape == LinkageRegion::Shape::half_plane)
        return cross(Vector<T>{cos(T(region.direction)), sin(T(region.direction))}, at - as<T>(region.places.front()));
    T least(0);
    for (std::size_t i = 0; i < region.places.size(); ++i) {
        const Vector<T> corner = as<T>(region.places[i]),
                        side = as<T>(region.places[(i + 1) % region.places.size()]) - corner;
        const T one = T(cross(side, at - corner) / hypotenuse(side.x, side.y));
        if (i == 0 || one < least) least = one;
    }
    return least;
}

/// The margin of a region where it is that of points.
Digits50 margin_of_points(const Scan& scan, const LinkageRegion& region) {
    std::vector<std::size_t> pins;
    for (const auto& part : region.parts)
        pins.insert(pins.end(), part.begin(), part.end());
    return least_of_several(scan, pins.size(), [&]<class T>(std::size_t k, const PoseSignals<T>& pose) {
        const T by = inside_by(pose.in_drawing(pins[k]), region);
        return region.inside ? by : T(-by);
    });
}

/// The distance of a point from a segment.
template <class T>
T distance_from_segment(const Vector<T>& at, const Vector<T>& a, const Vector<T>& b) {
    const Vector<T> side = b - a, way = at - a;
    const T square = dot(side, side), along = dot(side, way);
    const Vector<T> from = !(along > T(0)) ? way : along < square ? way - T(along / square) * side : at - b;
    return hypotenuse(from.x, from.y);
}

/// How far the hulls of two sets of points are apart, by all pairs of points of each: overlapping, by all directions
/// across these; else the least distance of a point from a segment.
template <class T>
T apart(const std::vector<Vector<T>>& first, const std::vector<Vector<T>>& second) {
    T deepest(-std::numeric_limits<double>::infinity()), nearest(std::numeric_limits<double>::infinity());
    for (const auto& [one, other] : {std::pair(&first, &second), {&second, &first}})
        for (const Vector<T>& a : *one)
            for (const Vector<T>& b : *one) {
                for (const Vector<T>& at : *other)
                    nearest = std::min<T>(nearest, distance_from_segment(at, a, b));
                const Vector<T> side = b - a;
                const T length = hypotenuse(side.x, side.y);
                if (!(length > T(0))) continue;
                T least(std::numeric_limits<double>::infinity()), most = -least;
                for (const Vector<T>& at : *other)
                    least = std::min<T>(least, cross(side, at - a) / length);
                for (const Vector<T>& at : *one)
                    most = std::max<T>(most, cross(side, at - a) / length);
                deepest = std::max<T>(deepest, least - most);
            }
    return deepest < T(0) && (first.size() > 1 || second.size() > 1) ? deepest : nearest;
}

/// Whether a place is inside of a polygon: a ray from it crosses an odd number of sides.
template <class T>
bool is_inside(const Vector<T>& at, const std::vector<Vector<T>>& polygon) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector<T>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.y > at.y) == (b.y > at.y)) continue;
        if ((cross(b - a, at - a) > T(0)) == (b.y > a.y)) inside = !inside;
    }
    return inside;
}

template <class T>
bool do_cross(const Vector<T>& a, const Vector<T>& b, const Vector<T>& from, const Vector<T>& to) {
    const auto are_apart = [](const Vector<T>& one, const Vector<T>& other, const Vector<T>& p, const Vector<T>& q) {
        return (cross(other - one, p - one) > T(0)) != (cross(other - one, q - one) > T(0));
    };
    return are_apart(a, b, from, to) && are_apart(from, to, a, b);
}

/// How deep a part is in convex parts of what has to be free: in that in which it is deepest.
template <class T>
T deepest_in_pieces(const std::vector<Vector<T>>& part, const LinkageRegion& region) {
    T least(std::numeric_limits<double>::infinity());
    for (const auto& piece : region.pieces) {
        std::vector<Vector<T>> outline;
        for (const Vector<double>& corner : piece)
            outline.push_back(as<T>(corner));
        if (outline.size() > 2) {
            least = std::min<T>(least, apart(part, outline));
            continue;
        }
        const Vector<T> along = outline.back() - outline.front();
        for (const Vector<T>& at : part)
            least = std::min<T>(least, cross(at - outline.front(), along) / hypotenuse(along.x, along.y));
    }
    return least;
}

/// How far a part is from what of a polygon has to be free, by its border alone where
/// nothing overlaps: nothing crosses the border, and a place is on the right side of it.
template <class T>
T free_of_polygon(const std::vector<Vector<T>>& part, const LinkageRegion& region) {
    std::vector<Vector<T>> polygon;
    for (const Vector<double>& corner : region.places)
        polygon.push_back(as<T>(corner));
    const std::size_t n = polygon.size();
    bool overlaps = is_inside(part.front(), polygon) != region.inside ||
                    (!region.inside && part.size() > 2 && apart(part, std::vector{polygon.front()}) < T(0));
    T nearest(std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < n; ++i)
        for (const Vector<T>& a : part)
            for (const Vector<T>& b : part) {
                const Vector<T>&from = polygon[i], &to = polygon[(i + 1) % n];
                overlaps = overlaps || do_cross(a, b, from, to);
                nearest = std::min<T>(nearest, distance_from_segment(a, from, to));
                nearest = std::min<T>(nearest, distance_from_segment(from, a, b));
            }
    return overlaps ? deepest_in_pieces(part, region) : nearest;
}

/// Where links keep out of a polygon, a circle or another link, or in a polygon that is not convex.
Digits50 margin_outside(const Scan& scan, const LinkageRegion& region) {
    return least_of_several(scan, region.parts.size(), [&region]<class T>(std::size_t k, const PoseSignals<T>& pose) {
        std::vector<Vector<T>> part, outline;
        for (const std::size_t pin : region.parts[k])
            part.push_back(pose.in_drawing(pin));
        if (!region.pieces.empty()) return free_of_polygon(part, region);
        for (const Vector<double>& place : region.places)
            outline.push_back(as<T>(place));
        for (const std::size_t pin : region.pins)
            outline.push_back(pose.in_drawing(pin));
        return T(apart(part, outline) - T(region.radius));
    });
}

}  // namespace

bool is_of_place(const LinkageMeasure& measure) {
    return measure.kind == Kind::room_width || measure.kind == Kind::room_height || measure.kind == Kind::room_area ||
           measure.kind == Kind::turned_width || measure.kind == Kind::turned_area ||
           measure.kind == Kind::region_margin;
}

Digits50 of_place(const Scan& scan, const LinkageMeasure& measure) {
    if (measure.kind == Kind::region_margin) {
        const LinkageRegion& region = scan.model.regions[measure.of_room];
        return region.is_by_points() ? margin_of_points(scan, region) : margin_outside(scan, region);
    }
    LinkageRoom room = scan.model.rooms[measure.of_room];
    if (room.turn != LinkageRoom::Turn::given) room.direction = turned_direction(scan, room);
    if (measure.kind == Kind::room_width || measure.kind == Kind::turned_width) return side_of(scan, room, false);
    if (measure.kind == Kind::room_height) return side_of(scan, room, true);
    return side_of(scan, room, false) * side_of(scan, room, true);
}

}  // namespace mechwright::again
