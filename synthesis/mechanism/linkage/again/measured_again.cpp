// Quantities of linkages in fifty digits, by other means than quantities.cpp: poses by the equations of the joints, a
// scan of the whole motion in doubles, then Newton's method on differences of fifty digits at each extreme of it.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <type_traits>
#include <vector>

#include "analysis/numbers/golden_section.h"
#include "synthesis/mechanism/linkage/again/measured.h"
#include "synthesis/mechanism/linkage/again/rooms_again.h"
#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/mechanism/over_range.h"
#include "synthesis/target/followed/arc.h"
#include "synthesis/target/followed/line.h"

namespace mechwright {

namespace {

using again::extreme, again::least_of_poses, again::Measured, again::measured, again::missing, again::of_poses,
    again::parts_of;

Digits50 reduced(const Measured& f, const LinkageMeasure& q) {
    using Kind = LinkageMeasure::Kind;
    if (q.kind == Kind::at) {
        const auto parts = parts_of(f.scan, std::array{q.input, q.input});
        if (parts.empty()) return missing;
        // Where drives come to another piece of their motions it is the one after.
        const std::vector<Vector<double>> whole{{f.scan.from(), f.scan.to()}};
        const std::vector<Vector<double>> pieces = again::between_breaks(f.scan, whole);
        constexpr double rounding_of_input = 1e-12;
        for (const Vector<double>& piece : pieces)
            if (pieces.size() > 1 && parts[0].x >= piece.x - rounding_of_input &&
                (parts[0].x < piece.y - rounding_of_input || piece.y == whole[0].y))
                return f.on(piece).at(parts[0].x);
        return f.at(parts[0].x);
    }
    const auto parts = parts_of(f.scan, q.stretch);
    if (parts.empty()) return missing;
    switch (q.kind) {
        case Kind::least: return extreme(f, parts, -1).value;
        case Kind::greatest: return extreme(f, parts, 1).value;
        case Kind::range: return extreme(f, parts, 1).value - extreme(f, parts, -1).value;
        case Kind::deviation: return (extreme(f, parts, 1).value - extreme(f, parts, -1).value) / 2;
        case Kind::mean:
            if (q.asked.derivative > 0) return again::mean_of_derivative(f, parts);
            return again::mean_power(f, parts, 1);
        case Kind::rms: return sqrt(again::mean_power(f, parts, 2));
        case Kind::time_ratio: {
            if (!f.scan.full_turn()) return missing;
            const Digits50 period = f.scan.to() - f.scan.from();
            const Digits50 way = abs(extreme(f, parts, 1).at - extreme(f, parts, -1).at), back = period - way;
            return way > back ? way / back : back / way;
        }
        default: break;
    }
    return missing;
}

/// The signals that are sizes by which a signal, or a derivative of it, goes; a distance alone is no more than least
/// where it vanishes.
void add_sizes(const std::vector<linkage::Signal>& signals, std::size_t signal, bool alone,
               std::vector<std::size_t>& sizes) {
    using Kind = linkage::Signal::Kind;
    const linkage::Signal& s = signals[signal];
    if (s.kind == Kind::speed || s.kind == Kind::acceleration || (s.kind == Kind::distance && !alone))
        sizes.push_back(signal);
    if (s.kind == Kind::ratio)
        for (const std::size_t of : {s.of, s.to})
            add_sizes(signals, of, false, sizes);
    for (const linkage::Signal::Term& term : s.terms)
        add_sizes(signals, term.signal, false, sizes);
}

/// A derivative of a signal by the time.
Measured of_one(const Scan& scan, const linkage::Signal& signal, int derivative) {
    return {scan, [signal, derivative](const SeriesSignals& s) { return s.by_time(signal, derivative); },
            [signal, derivative](SignalsAgain<Digits50>& s, int order, const Digits50& x) {
                return Digits50(s.by_input(signal, derivative + order, x) / pow(s.rate(), order));
            }};
}
/// The speed of the point of whose path a signal is the curvature.
Measured speed_of(const Scan& scan, std::size_t curvature) {
    Measured f = of_one(scan, {.kind = linkage::Signal::Kind::speed, .of = scan.model.signals[curvature].of}, 0);
    f.sizes.push_back(curvature);
    return f;
}

/// Whether what something is divided by vanishes where it is measured, to rounding: it has no value then.
bool vanishes(const Measured& divisor, const LinkageMeasure& q) {
    constexpr double rounding = 1e-12;  // of the greatest, or of the input
    if (q.kind == LinkageMeasure::Kind::at) {
        const auto parts = parts_of(divisor.scan, std::array{q.input, q.input});
        return !parts.empty() && !(abs(divisor.at(parts[0].x)) > rounding * abs(divisor.at(parts[0].x, 1)));
    }
    const auto parts = parts_of(divisor.scan, q.stretch);
    const Digits50 least = extreme(divisor, parts, -1).value, greatest = extreme(divisor, parts, 1).value;
    const Digits50 size = std::max<Digits50>(isfinite(least) ? abs(least) : Digits50(0),
                                             isfinite(greatest) ? abs(greatest) : Digits50(0));
    return !(least > rounding * size) && !(greatest < -rounding * size);
}

Digits50 of_signal(const Scan& scan, const LinkageMeasure& q) {
    const auto divides_by_zero = [&](std::size_t divisor) { return vanishes(measured(scan, divisor, 0), q); };
    const auto comes_to_rest = [&](std::size_t curvature) { return vanishes(speed_of(scan, curvature), q); };
    if (linkage::any_divisor(scan.model.signals, q.asked.signal, divides_by_zero) ||
        linkage::any_curvature(scan.model.signals, q.asked.signal, comes_to_rest))
        return missing;
    const Measured f = measured(scan, q.asked.signal, static_cast<int>(q.asked.derivative));
    // At a corner a derivative has two values; where drives move by pieces it is the one after.
    const auto& drives = scan.model.drives;
    const bool by_pieces =
        std::any_of(drives.begin(), drives.end(), [](const auto& drive) { return drive.motion != nullptr; });
    if (q.kind == LinkageMeasure::Kind::at && q.asked.derivative > 0 && !by_pieces)
        for (const Vector<double>& part : parts_of(scan, std::array{q.input, q.input}))
            if (again::has_corner_at(f, part.x)) return missing;
    return reduced(f, q);
}

/// The distance of the guided point from what it follows at its greatest, or how far it follows.
template <class Shape>
Digits50 of_followed(const Motion& motion, std::span<const Digits50> arguments) {
    const std::size_t dimensions = arguments.size() - 2 - Shape::parameters;
    const Scan scan(within_input(motion, arguments.subspan(dimensions, 2)), arguments.first(dimensions));
    if (scan.empty()) return missing;
    const LinkageMeasure& of = *static_cast<const LinkageMeasure*>(motion.of);
    const std::size_t pin = scan.model.guided[scan.model.over_input[of.over_input].of].pin;
    std::array<Digits50, Shape::parameters> shape;
    std::copy_n(arguments.last(shape.size()).begin(), shape.size(), shape.begin());
    if (of.kind == LinkageMeasure::Kind::extent) {
        const auto at_end = [&](bool last) {
            const auto coordinate = [&](auto part) {
                return of_poses(scan,
                                [pin, part]<class T>(const PoseSignals<T>& p) {
                                    return p.in_drawing(pin).*part.template operator()<T>();
                                })
                    .at(last ? scan.to() : scan.from());
            };
            return Vector<Digits50>{coordinate([]<class T>() { return &Vector<T>::x; }),
                                    coordinate([]<class T>() { return &Vector<T>::y; })};
        };
        return Shape::extent(shape, at_end(false), at_end(true));
    }
    const Measured distance = of_poses(scan, [pin, shape]<class T>(const PoseSignals<T>& p) {
        std::array<T, Shape::parameters> own;
        std::transform(shape.begin(), shape.end(), own.begin(), [](const Digits50& number) -> T {
            if constexpr (std::is_same_v<T, Digits50>)
                return number;
            else
                return T(number.convert_to<double>());
        });
        return Shape::distance(own, p.in_drawing(pin));
    });
    const std::vector<Vector<double>> whole{{scan.from(), scan.to()}};
    return std::max<Digits50>(abs(extreme(distance, whole, 1).value), abs(extreme(distance, whole, -1).value));
}

Digits50 worst_transmission(const Scan& scan) {
    Digits50 worst = std::numeric_limits<double>::infinity();
    for (const linkage::Group& group : scan.model.order.groups) {
        if (linkage::margin_of(scan.model.order, group) == linkage::none) continue;
        for (const bool folded : {false, true}) {
            const Digits50 least = least_of_poses(scan, [&]<class T>(const PoseSignals<T>& p) {
                const T angle = p.transmission_angle(group);
                return folded ? T(pi<T>() - angle) : angle;
            });
            worst = std::min(worst, least);
        }
    }
    return isfinite(worst) ? worst : Digits50(missing);
}

Digits50 least_joint_distance(const Scan& scan) {
    const auto& pins = scan.model.structure.pins;
    Digits50 least = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < pins.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            if (!linkage::is_joint(scan.model.structure, a) || !linkage::is_joint(scan.model.structure, b) ||
                linkage::share_link(pins[a], pins[b]))
                continue;
            least = std::min(least,
                             least_of_poses(scan, [&]<class T>(const PoseSignals<T>& p) { return p.distance(a, b); }));
        }
    return isfinite(least) ? least : Digits50(missing);
}

/// Distances of links' origins to their pins, in the drawing.
std::vector<Digits50> lengths_of(const LinkageModel& model, std::span<const Digits50> dimensions) {
    const std::vector<Digits50> numbers = numbers_of(model, dimensions);
    const Digits50 scale = model.scale.at(dimensions);
    std::vector<Digits50> lengths;
    for (std::size_t i = 0; i < model.structure.pins.size(); ++i)
        for (const linkage::Point& point : model.structure.pins[i].points) {
            const Vector<Digits50> at = linkage::place_of<Digits50>(point.at, numbers);
            const Digits50 length = scale * sqrt(dot(at, at));
            if (linkage::is_joint(model.structure, i) && length > 0) lengths.push_back(length);
        }
    return lengths;
}

/// The least margin of any dyad over the cycle of the drive, in fifty digits by the dyads' own formulas where it does
/// not close: there is no pose. A dyad counts where all before it close.
Digits50 full_turn_margin(const LinkageModel& model, std::size_t assembly, std::span<const Digits50> dimensions) {
    if (model.turns < 1) return missing;
    const std::vector<Digits50> numbers = numbers_of(model, dimensions);
    linkage::Driven<Digits50> precise(model.structure, model.order, std::span<const Digits50>(numbers),
                                      model.sides[assembly], laws_again_of(model));
    std::vector<double> rounded;
    for (const Digits50& d : dimensions)
        rounded.push_back(d.convert_to<double>());
    linkage::Driven<double> plain = driven(model, rounded, assembly);
    precise.set_ways(ways_of(model, rounded, assembly));
    const auto least_at = [&]<class T>(linkage::Driven<T>& moving, const T& at) {
        T least(std::numeric_limits<double>::infinity());
        const bool whole = moving.place(at);
        for (std::size_t i = 0; i < model.order.margins; ++i) {
            const T one = std::min(moving.pose.margins[i].outer, moving.pose.margins[i].inner);
            if (linkage::is_length(model.order, i)) least = std::min<T>(least, one);
            if (!whole && !(one >= T(0))) break;
        }
        return least;
    };
    const double period = 2 * std::numbers::pi * model.turns;
    const int samples = 3600 * model.turns;
    std::vector<double> seen;
    for (int i = 0; i < samples; ++i)
        seen.push_back(least_at(plain, period * i / samples));
    const double best = *std::min_element(seen.begin(), seen.end());
    const double greatest = *std::max_element(seen.begin(), seen.end());
    std::vector<int> valleys, lowest;  // of the second to rounding: a margin that is constant has many
    for (int i = 0; i < samples; ++i) {
        const double before = seen[(i + samples - 1) % samples], after = seen[(i + 1) % samples];
        constexpr double near_best = 1e-3, rounding = 1e-13;
        if (seen[i] > before || seen[i] > after || seen[i] > best + near_best * (greatest - best)) continue;
        (seen[i] <= best + rounding * size_of(plain) ? lowest : valleys).push_back(i);
    }
    constexpr std::size_t some = 24;
    for (std::size_t i = 0; i < lowest.size(); i += 1 + lowest.size() / some)
        valleys.push_back(lowest[i]);
    Digits50 least = std::numeric_limits<double>::infinity();
    for (const int i : valleys) {
        // Golden section: at a corner, where two margins are equal, there is no derivative.
        constexpr int steps = 80;
        const auto negative = [&](const Digits50& at) { return Digits50(-least_at(precise, at)); };
        const Digits50 from = period * (i - 1) / samples, to = period * (i + 1) / samples;
        least = std::min<Digits50>(least, least_at(precise, greatest_between(negative, from, to, steps)));
    }
    return least * model.scale.at(dimensions);
}

}  // namespace

namespace again {

std::vector<Vector<double>> parts_of(const Scan& scan, const std::optional<std::array<double, 2>>& stretch) {
    if (!stretch) return {{scan.from(), scan.to()}};
    constexpr double turn = 2 * std::numbers::pi;
    double first = (*stretch)[0], last = (*stretch)[1];
    if (last < first && !scan.model.driven_by_slide()) last += turn * std::ceil((first - last) / turn);
    if (!scan.full_turn()) {
        if (!scan.model.driven_by_slide() && (first < scan.from() || first > scan.to())) {
            const double shift = turn * std::ceil((scan.from() - first) / turn - 1e-12);
            first += shift;
            last += shift;
        }
        if (first < scan.from() || last > scan.to()) return {};
        return {{first, last}};
    }
    const double period = scan.to() - scan.from();
    const auto inside = [&](double x) { return x - period * std::floor((x - scan.from()) / period); };
    if (last - first == period) return {{scan.from(), scan.to()}};
    first = inside(first);
    last = inside(last);
    if (first <= last) return {{first, last}};
    return {{first, scan.to()}, {scan.from(), last}};
}

Measured measured(const Scan& scan, std::size_t signal, int derivative) {
    Measured f = of_one(scan, scan.model.signals[signal], derivative);
    add_sizes(scan.model.signals, signal, derivative == 0, f.sizes);
    return f;
}

}  // namespace again

Digits50 measure_linkage_again(const Motion& motion, std::span<const Digits50> dimensions) {
    using Kind = LinkageMeasure::Kind;
    const LinkageModel& model = linkage_of(motion.model);
    const LinkageMeasure& q = *static_cast<const LinkageMeasure*>(motion.of);
    if (q.kind == Kind::total_length || q.kind == Kind::link_ratio) {
        const std::vector<Digits50> lengths = lengths_of(model, dimensions);
        if (lengths.empty()) return missing;
        if (q.kind == Kind::total_length) return std::accumulate(lengths.begin(), lengths.end(), Digits50(0));
        const auto [least, greatest] = std::minmax_element(lengths.begin(), lengths.end());
        return *greatest / *least;
    }
    if (q.kind == Kind::full_turn_margin) return full_turn_margin(model, motion.assembly, dimensions);
    if (q.kind == Kind::distance_greatest || q.kind == Kind::extent)
        return model.over_input[q.over_input].followed == Followed::line ? of_followed<LineShape>(motion, dimensions)
                                                                         : of_followed<ArcShape>(motion, dimensions);
    const Scan scan(motion, dimensions);
    if (scan.empty()) return missing;
    if (q.kind == Kind::transmission_angle_worst) return worst_transmission(scan);
    if (q.kind == Kind::joint_distance_least) return least_joint_distance(scan);
    if (again::is_of_place(q)) return again::of_place(scan, q);
    return of_signal(scan, q);
}

}  // namespace mechwright
