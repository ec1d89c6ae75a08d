// Quantities of linkages in fifty digits, by other means than quantities.cpp: poses by the equations of the joints, a
// scan of the whole motion in doubles, then Newton's method on differences of fifty digits at each extreme of it.

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/mechanism/linkage/scan.h"
#include "synthesis/target/followed/arc.h"
#include "synthesis/target/followed/line.h"

namespace mechwright {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// A quantity's stretch as parts of the motion: one, or two where it runs through the end of a full turn; none where it
/// is not in the motion.
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

/// One function of the input, looked at in doubles and measured in fifty digits.
struct Measured {
    const Scan& scan;
    std::function<double(SignalsAgain<double>&, double)> look;
    /// Its derivative of some order by the input; -1: its integral, where it is a derivative itself.
    std::function<Digits50(SignalsAgain<Digits50>&, int, const Digits50&)> measure;

    double seen(double input, bool finely = false) const {
        SignalsAgain<double> signals = scan.plain(scan.nearest(input));
        signals.finely = finely;
        return look(signals, input);
    }
    Digits50 at(double input, int order = 0) const {
        if (input == scan.from() || input == scan.to()) {
            SignalsAgain<Digits50> end = scan.at_end(input == scan.to());
            return measure(end, order, end.follower.at);
        }
        SignalsAgain<Digits50> signals = scan.precise(scan.nearest(input));
        return measure(signals, order, input);
    }
    /// Between the exact ends of the motion, so close to one of them as it may be.
    Digits50 between(const std::array<Digits50, 2>& ends, const Digits50& input) const {
        SignalsAgain<Digits50> signals = scan.precise(scan.nearest(input.convert_to<double>()));
        if (!scan.full_turn()) {
            signals.first_input = ends[0];
            signals.last_input = ends[1];
        }
        return measure(signals, 0, input);
    }
};

struct Extreme {
    Digits50 at = 0;
    Digits50 value = missing;
};

/// Where the greatest value of f, or of its negative, lies between two inputs: golden section. At a cusp, where a point
/// comes to rest or pins meet, there is no derivative.
Extreme by_golden_section(const Measured& f, SignalsAgain<Digits50>& signals, const Vector<Digits50>& between,
                          double sign) {
    constexpr int steps = 80;
    const Digits50 golden = (3 - sqrt(Digits50(5))) / 2;
    Digits50 from = between.x, to = between.y, a = from + golden * (to - from), b = to - golden * (to - from);
    Digits50 at_a = f.measure(signals, 0, a), at_b = f.measure(signals, 0, b);
    for (int i = 0; i < steps; ++i)
        if (sign * at_a > sign * at_b) {
            to = std::exchange(b, a);
            at_b = at_a;
            a = from + golden * (to - from);
            at_a = f.measure(signals, 0, a);
        } else {
            from = std::exchange(a, b);
            at_a = at_b;
            b = to - golden * (to - from);
            at_b = f.measure(signals, 0, b);
        }
    return sign * at_a > sign * at_b ? Extreme{a, at_a} : Extreme{b, at_b};
}

/// From a sample at which it is extreme among its neighbours to where its derivative vanishes, or to a cusp.
Extreme polished(const Measured& f, double left, double middle, double right, double sign) {
    constexpr double settled = 1e-16, varies = 1e-6;
    SignalsAgain<Digits50> signals = f.scan.precise(f.scan.nearest(middle));
    Digits50 x = middle;
    bool found = false;
    for (int i = 0; i < 8 && !found; ++i) {
        const Digits50 step = f.measure(signals, 1, x) / f.measure(signals, 2, x);
        if (!isfinite(step) || x - step < left || x - step > right) break;
        x -= step;
        found = abs(step) < settled * signals.follower.unit();
    }
    const Extreme smooth{x, f.measure(signals, 0, x)};
    const double low = f.seen(left), high = f.seen(right);
    if (found || !(std::abs(low - f.seen(middle)) > varies * std::abs(low)) ||
        !(std::abs(high - f.seen(middle)) > varies * std::abs(high)))
        return smooth;
    return by_golden_section(f, signals, {left, right}, sign);
}

/// At an end of a part of the motion, or between it and its neighbour among the samples where that is better.
Extreme polished_end(const Measured& f, double end, double neighbour, double sign) {
    const Extreme at_end{end, f.at(end)};
    const double seen_at_end = sign * f.seen(end);
    double best = end, most = seen_at_end;
    for (const double share : {0x1p-12, 0x1p-6, 0.25})
        if (const double at = end + share * (neighbour - end), seen = sign * f.seen(at); seen > most) {
            best = at;
            most = seen;
        }
    if (best == end) return at_end;
    const Extreme inside = polished(f, std::min(end, neighbour), best, std::max(end, neighbour), sign);
    return sign * inside.value > sign * at_end.value || isnan(at_end.value) ? inside : at_end;
}

/// The greatest value over parts of the motion, of f or of its negative.
Extreme extreme(const Measured& f, const std::vector<Vector<double>>& parts, double sign) {
    struct Candidate {
        double left, at, right, seen;
    };
    std::vector<Candidate> candidates;
    double best = -std::numeric_limits<double>::infinity(), worst = -best;
    for (const auto& [from, to] : parts) {
        std::vector<double> x{from};
        for (const double at : f.scan.at)
            if (at > from && at < to) x.push_back(at);
        if (to > from) x.push_back(to);
        std::vector<double> seen;
        for (const double at : x)
            seen.push_back(sign * f.seen(at));
        for (std::size_t i = 0; i < x.size(); ++i) {
            const bool first = i == 0, last = i + 1 == x.size();
            if (std::isfinite(seen[i])) {
                best = std::max(best, seen[i]);
                worst = std::min(worst, seen[i]);
            }
            // At the very ends of a motion doubles may see nothing.
            if (first || last || (!(seen[i] < seen[i - 1]) && !(seen[i] < seen[i + 1])))
                candidates.push_back({first ? x[i] : x[i - 1], x[i], last ? x[i] : x[i + 1], seen[i]});
        }
    }
    // What is constant to rounding has an extreme at every sample: some of them tell what there is to be told.
    constexpr std::size_t some = 24;
    const bool flat = best - worst <= 1e-11 * (1 + std::abs(best));
    const std::size_t every = flat && candidates.size() > some ? candidates.size() / some : 1;
    Extreme found;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        constexpr double near_best = 1e-2;
        const Candidate& c = candidates[i];
        if (c.seen < best - near_best * (best - worst) - 1e-12) continue;
        const bool end = c.left == c.at || c.right == c.at;
        if (!end && i % every != 0) continue;
        const Extreme one = end ? polished_end(f, c.at, c.left == c.at ? c.right : c.left, sign)
                                : polished(f, c.left, c.at, c.right, sign);
        if (!isnan(one.value) && (isnan(found.value) || sign * one.value > sign * found.value)) found = one;
    }
    return found;
}

/// An integral, how far it may be off, and that of the integrand's size.
struct Integral {
    double value = 0, missed = 0, of_sizes = 0;
};

/// By one rule of Gauss and Kronrod. Over [-1, 1], where the library's error is that of the integral.
template <class Term>
Integral by_one_rule(const Term& term, double from, double to) {
    const double middle = (from + to) / 2, half = (to - from) / 2;
    Integral found;
    found.value = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
        [&](double t) { return half * term(middle + half * t); }, -1.0, 1.0, 0, 0.0, &found.missed, &found.of_sizes);
    return found;
}

/// By halves for so long as it may be off by more than is allowed, and as halves are left.
template <class Term>
Integral bisected(const Term& term, double from, double to, const Integral& whole, double allowed, int halves) {
    if (halves == 0 || !(whole.missed > allowed)) return whole;
    const double middle = (from + to) / 2;
    const Integral one = bisected(term, from, middle, by_one_rule(term, from, middle), allowed / 2, halves - 1),
                   two = bisected(term, middle, to, by_one_rule(term, middle, to), allowed / 2, halves - 1);
    return {one.value + two.value, one.missed + two.missed, one.of_sizes + two.of_sizes};
}

/// The integral over a part of the motion of a power of it. Ends are approached as the square of the way, so that what
/// has a root there is smooth: the way from them is exact, as rounding of the input itself would be noise. Not a number
/// where it does not settle, as what grows beyond all bounds does not.
double integral_of_power(const Measured& f, const Vector<double>& part, const std::array<Digits50, 2>& ends,
                         int power) {
    constexpr int deepest = 16;
    constexpr double within = 1e-10, settled = 1e-9;
    const bool by_slide = f.scan.model.driven_by_slide();
    const double way = part.y - part.x, turns = by_slide ? 1 : std::ceil(way / (2 * std::numbers::pi));
    const Digits50 from = part.x == f.scan.from() ? ends[0] : Digits50(part.x),
                   to = part.y == f.scan.to() ? ends[1] : Digits50(part.y);
    // Beside an end differences of doubles have no digits left.
    const double beside = 1e-3 * (by_slide ? way : 1);
    const auto term = [&](double u) -> double {
        const double rest = 1 - u, passed = way * u * u * (3 - 2 * u), left = way * rest * rest * (1 + 2 * u);
        const double value = std::min(passed, left) < beside
                                 ? f.between(ends, passed < left ? from + passed : to - left).convert_to<double>()
                                 : f.seen(part.x + passed, true);
        return (power == 2 ? value * value : value) * 6 * u * rest * way;
    };
    Integral sum;
    for (double turn = 0; turn < turns; ++turn) {
        const double first = turn / turns, last = (turn + 1) / turns;
        const Integral whole = by_one_rule(term, first, last);
        const Integral one = bisected(term, first, last, whole, within * whole.of_sizes, deepest);
        sum = {sum.value + one.value, sum.missed + one.missed, sum.of_sizes + one.of_sizes};
    }
    return sum.missed <= settled * sum.of_sizes ? sum.value : missing;
}

/// That over the parts, over their length.
Digits50 mean_power(const Measured& f, const std::vector<Vector<double>>& parts, int power) {
    const std::array<Digits50, 2> ends{f.scan.exact_end(false), f.scan.exact_end(true)};
    Digits50 sum = 0, length = 0;
    for (const Vector<double>& part : parts) {
        length += part.y - part.x;
        sum += integral_of_power(f, part, ends, power);
    }
    return sum / length;
}

/// The mean of a derivative: what its integral grows by, over the way.
Digits50 mean_of_derivative(const Measured& f, const std::vector<Vector<double>>& parts) {
    Digits50 grown = 0, length = 0;
    for (const auto& [from, to] : parts) {
        grown += f.at(to, -1) - f.at(from, -1);
        length += to - from;
    }
    return grown / length;
}

Digits50 reduced(const Measured& f, const LinkageMeasure& q) {
    using Kind = LinkageMeasure::Kind;
    if (q.kind == Kind::at) {
        const auto parts = parts_of(f.scan, std::array{q.input, q.input});
        return parts.empty() ? Digits50(missing) : f.at(parts[0].x);
    }
    const auto parts = parts_of(f.scan, q.stretch);
    if (parts.empty()) return missing;
    switch (q.kind) {
        case Kind::least: return extreme(f, parts, -1).value;
        case Kind::greatest: return extreme(f, parts, 1).value;
        case Kind::range: return extreme(f, parts, 1).value - extreme(f, parts, -1).value;
        case Kind::deviation: return (extreme(f, parts, 1).value - extreme(f, parts, -1).value) / 2;
        case Kind::mean:
            if (q.asked.derivative > 0) return mean_of_derivative(f, parts);
            return mean_power(f, parts, 1);
        case Kind::rms: return sqrt(mean_power(f, parts, 2));
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

Digits50 of_signal(const Scan& scan, const LinkageMeasure& q) {
    return reduced({scan,
                    [&](SignalsAgain<double>& s, double x) {
                        return s.by_input(q.asked.signal, static_cast<int>(q.asked.derivative), x);
                    },
                    [&](SignalsAgain<Digits50>& s, int order, const Digits50& x) {
                        return s.by_input(q.asked.signal, static_cast<int>(q.asked.derivative) + order, x) /
                               pow(s.rate(), order);
                    }},
                   q);
}

/// Something that a pose has, along the motion.
template <class OfPose>
Measured of_poses(const Scan& scan, const OfPose& of_pose) {
    const auto at = [of_pose]<class T>(SignalsAgain<T>& s, const T& x) {
        T value(missing);
        s.at_pose(x, [&](const LoopPose<T>& pose) { value = of_pose(s, pose); });
        return value;
    };
    return {scan, [at](SignalsAgain<double>& s, double x) { return at(s, x); },
            [at](SignalsAgain<Digits50>& s, int order, const Digits50& x) -> Digits50 {
                const Digits50 h = s.difference_step();
                if (order == 0) return at(s, x);
                const Digits50 before = at(s, Digits50(x - h)), after = at(s, Digits50(x + h));
                if (order == 1) return (after - before) / (2 * h);
                return (after - 2 * at(s, x) + before) / (h * h);
            }};
}

/// The least over the motion of something that a pose has.
template <class OfPose>
Digits50 least_of_poses(const Scan& scan, const OfPose& of_pose) {
    return extreme(of_poses(scan, of_pose), {{scan.from(), scan.to()}}, -1).value;
}

/// The distance of the guided point from what it follows at its greatest, or how far it follows.
template <class Shape>
Digits50 of_followed(const Scan& scan, std::span<const Digits50> numbers, LinkageMeasure::Kind kind) {
    const std::size_t pin = scan.model.guided->pin;
    std::array<Digits50, Shape::parameters> shape;
    std::copy_n(numbers.begin(), shape.size(), shape.begin());
    if (kind == LinkageMeasure::Kind::extent) {
        const auto at_end = [&](bool last) {
            const auto coordinate = [&](auto part) {
                return of_poses(scan,
                                [pin, part]<class T>(const SignalsAgain<T>& s, const LoopPose<T>& pose) {
                                    return s.in_drawing(pin, pose).*part.template operator()<T>();
                                })
                    .at(last ? scan.to() : scan.from());
            };
            return Vector<Digits50>{coordinate([]<class T>() { return &Vector<T>::x; }),
                                    coordinate([]<class T>() { return &Vector<T>::y; })};
        };
        return Shape::extent(shape, at_end(false), at_end(true));
    }
    const Measured distance = of_poses(scan, [pin, shape]<class T>(const SignalsAgain<T>& s, const LoopPose<T>& pose) {
        std::array<T, Shape::parameters> own;
        std::transform(shape.begin(), shape.end(), own.begin(),
                       [](const Digits50& number) { return number_as<T>(number); });
        return Shape::distance(own, s.in_drawing(pin, pose));
    });
    const std::vector<Vector<double>> whole{{scan.from(), scan.to()}};
    return std::max<Digits50>(abs(extreme(distance, whole, 1).value), abs(extreme(distance, whole, -1).value));
}

Digits50 worst_transmission(const Scan& scan) {
    Digits50 worst = std::numeric_limits<double>::infinity();
    for (const linkage::Group& group : scan.model.order.groups) {
        if (linkage::margin_of(scan.model.order, group) == linkage::none) continue;
        for (const bool folded : {false, true}) {
            const Digits50 least = least_of_poses(scan, [&]<class T>(SignalsAgain<T>& s, const LoopPose<T>& pose) {
                const T angle = s.transmission_angle(group, pose);
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
            least = std::min(least, least_of_poses(scan, [&]<class T>(SignalsAgain<T>& s, const LoopPose<T>& pose) {
                                 return s.distance(a, b, pose);
                             }));
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
    const std::vector<Digits50> numbers = numbers_of(model, dimensions);
    linkage::Driven<Digits50> precise(model.structure, model.order, std::span<const Digits50>(numbers),
                                      model.sides[assembly], laws_of(model));
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
    Digits50 least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < samples; ++i) {
        const double before = seen[(i + samples - 1) % samples], after = seen[(i + 1) % samples];
        constexpr double near_best = 1e-3;
        if (seen[i] > before || seen[i] > after || seen[i] > best + near_best * (greatest - best)) continue;
        // Golden section: at a corner, where two margins are equal, there is no derivative.
        Digits50 from = period * (i - 1) / samples, to = period * (i + 1) / samples;
        const Digits50 golden = (3 - sqrt(Digits50(5))) / 2;
        for (int k = 0; k < 80; ++k) {
            const Digits50 a = from + golden * (to - from), b = to - golden * (to - from);
            (least_at(precise, a) < least_at(precise, b) ? to : from) =
                least_at(precise, a) < least_at(precise, b) ? b : a;
        }
        least = std::min<Digits50>(least, least_at(precise, Digits50((from + to) / 2)));
    }
    return least * model.scale.at(dimensions);
}

}  // namespace

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
    const bool followed = q.kind == Kind::distance_greatest || q.kind == Kind::extent;
    const bool line = model.followed == Followed::line;
    const std::size_t of_shape = followed ? (line ? LineShape::parameters : ArcShape::parameters) : 0;
    const Scan scan(motion, dimensions.first(dimensions.size() - (followed ? 2 : 0) - of_shape));
    if (scan.empty()) return missing;
    if (followed)
        return line ? of_followed<LineShape>(scan, dimensions.last(of_shape), q.kind)
                    : of_followed<ArcShape>(scan, dimensions.last(of_shape), q.kind);
    if (q.kind == Kind::transmission_angle_worst) return worst_transmission(scan);
    if (q.kind == Kind::joint_distance_least) return least_joint_distance(scan);
    return of_signal(scan, q);
}

}  // namespace mechwright
