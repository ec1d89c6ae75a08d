// Quantities of linkages in fifty digits, by other means than quantities.cpp: poses by the equations of the joints, a
// scan of the whole motion in doubles, then Newton's method on differences of fifty digits at each extreme of it.

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/again.h"
#include "synthesis/mechanism/linkage/follow.h"
#include "synthesis/mechanism/linkage/quantities.h"

namespace mechwright {

namespace {

using linkage::Signal;

/// How far apart the inputs of a difference stand: in doubles for a first look, in fifty digits for all of them.
template <class T>
T difference_step() {
    return T(std::is_same_v<T, double> ? 1e-2 : 1e-9);
}

/// Signals of a linkage at poses of its joints' equations.
template <class T>
class SignalsAgain {
public:
    /// `start_turns`: those of all links at the start of motion.
    SignalsAgain(const LinkageModel& model, std::span<const T> dimensions, std::vector<double> start_turns)
        : model_(model),
          start_turns_(std::move(start_turns)),
          follower(model, numbers_of(model, dimensions)),
          origin_{model.placement[0].at(dimensions), model.placement[1].at(dimensions)},
          tilt_(linkage::detail::unit_at(model.placement[2].at(dimensions))),
          scale_(model.scale.at(dimensions)),
          rate_(model.drives.front().speed ? *model.drives.front().speed * std::numbers::pi / 30 : 1) {}

    /// At the pose of an input near that where the follower stands, which it leaves as it was.
    T value(std::size_t signal, const T& input) { return by_input(signal, 0, input); }

    /// The derivative of some order by the time, in which the input grows by its speed.
    T by_input(std::size_t signal, int order, const T& input) {
        const Signal& s = model_.signals[signal];
        if (s.kind == Signal::Kind::sum) {
            T sum(0);
            for (const Signal::Term& term : s.terms)
                sum += T(term.factor) * by_input(term.signal, order, input);
            return sum;
        }
        T by = difference([&](const T& at) { return plain_value(s, at); }, order, input);
        for (int i = 0; i < order; ++i)
            by *= rate_;
        return by;
    }

    /// The angle at which a dyad passes its force on, in [0, pi].
    T transmission_angle(const linkage::Group& group, const LoopPose<T>& pose) const {
        using std::abs, std::acos, std::atan2;
        using Kind = linkage::Group::Kind;
        const Loop<T>& loop = follower.loop;
        if (group.pin == linkage::none || group.outer[0] == linkage::none) {
            const auto [a, b] = two_lines(group, pose);
            return atan2(T(abs(cross(a, b))), dot(a, b));
        }
        const Vector<T> inner = loop.pin(group.pin, pose), first = inner - loop.pin(group.outer[0], pose);
        Vector<T> other;
        if (group.kind == Kind::rrr) {
            other = inner - loop.pin(group.outer[1], pose);
        } else {
            const linkage::Structure& s = model_.structure;
            other =
                left_of(loop.direction(group.by_slide ? s.slides[group.joint].line : s.slots[group.joint].line, pose));
        }
        return atan2(T(abs(cross(first, other))), dot(first, other));
    }

    /// Calls use(at, pose) with the pose at an input near that of the follower; false where there is none.
    template <class Use>
    bool at_pose(const T& input, const Use& use) {
        Follower<T> there = follower;
        if (!(there.at == input) && !there.step(input) && !there.start(input, follower.pose)) return false;
        use(there.pose);
        return true;
    }

    const T& rate() const { return rate_; }
    T distance(std::size_t a, std::size_t b, const LoopPose<T>& pose) const {
        const Vector<T> apart = follower.loop.pin(a, pose) - follower.loop.pin(b, pose);
        return scale_ * hypotenuse(apart.x, apart.y);
    }
    const T& scale() const { return scale_; }

private:
    /// The central difference of some order.
    template <class Function>
    static T difference(const Function& f, int order, const T& at) {
        const T h = difference_step<T>();
        T sum(0), power(1);
        double binomial = 1;
        for (int k = 0; k <= order; ++k) {
            const T there = order == 0 ? at : T(at + T(0.5 * order - k) * h);
            sum += T(k % 2 == 0 ? binomial : -binomial) * f(there);
            binomial = binomial * (order - k) / (k + 1);
        }
        for (int k = 0; k < order; ++k)
            power *= h;
        return sum / power;
    }

    Vector<T> pin_at(std::size_t pin, const T& input) {
        Vector<T> at{T(std::numeric_limits<double>::quiet_NaN()), T(0)};
        at_pose(input, [&](const LoopPose<T>& pose) { at = follower.loop.pin(pin, pose); });
        return at;
    }
    T magnitude(std::size_t pin, int order, const T& input) {
        Vector<T> by;
        by.x = difference([&](const T& x) { return pin_at(pin, x).x; }, order, input);
        by.y = difference([&](const T& x) { return pin_at(pin, x).y; }, order, input);
        return scale_ * hypotenuse(by.x, by.y);
    }

    T plain_value(const Signal& s, const T& input) {
        using Kind = Signal::Kind;
        if (s.kind == Kind::speed) return rate_ * magnitude(s.of, 1, input);
        if (s.kind == Kind::acceleration) return rate_ * rate_ * magnitude(s.of, 2, input);
        if (s.kind == Kind::ratio) return value(s.of, input) / value(s.to, input);
        T found(std::numeric_limits<double>::quiet_NaN());
        at_pose(input, [&](const LoopPose<T>& pose) { found = of_pose(s, pose); });
        return found;
    }

    Vector<T> coordinates(const Signal& s, const LoopPose<T>& pose) const {
        using std::cos, std::sin;
        const Vector<T> at = follower.loop.pin(s.of, pose);
        if (s.on == linkage::none) return origin_ + scale_ * turned(at, tilt_);
        const T back = -pose.turns[s.on];
        return scale_ * turned(at - pose.origins[s.on], Vector<T>{cos(back), sin(back)});
    }

    T of_pose(const Signal& s, const LoopPose<T>& pose) const {
        using std::cos, std::sin;
        using Kind = Signal::Kind;
        const Loop<T>& loop = follower.loop;
        switch (s.kind) {
            case Kind::angle: return pose.turns[s.of] - pose.turns[s.to] + T(2) * pi<T>() * T(whole_turns_of(s));
            case Kind::x: return coordinates(s, pose).x;
            case Kind::y: return coordinates(s, pose).y;
            case Kind::along: return dot(coordinates(s, pose), Vector<T>{cos(T(s.number)), sin(T(s.number))});
            case Kind::distance: return distance(s.of, s.to, pose);
            case Kind::from_line: {
                const Vector<T> start = loop.pin(s.to, pose), line = loop.pin(s.end, pose) - start;
                return scale_ * cross(line, loop.pin(s.of, pose) - start) / hypotenuse(line.x, line.y);
            }
            case Kind::slide: return scale_ * loop.displacement(s.of, pose);
            case Kind::transmission_angle:
                for (const linkage::Group& group : model_.order.groups)
                    if (linkage::margin_of(model_.order, group) == s.of) return transmission_angle(group, pose);
                break;
            default: break;
        }
        return T(std::numeric_limits<double>::quiet_NaN());
    }

    std::pair<Vector<T>, Vector<T>> two_lines(const linkage::Group& group, const LoopPose<T>& pose) const {
        const std::size_t margin = linkage::margin_of(model_.order, group);
        const linkage::Structure& s = model_.structure;
        const auto line = [&](const linkage::Locus& locus) {
            const bool slide =
                locus.kind != linkage::Locus::Kind::slot &&
                (locus.tie.kind == linkage::Tie::Kind::slides || locus.tie.kind == linkage::Tie::Kind::carries);
            return follower.loop.direction(slide ? s.slides[locus.tie.joint].line : s.slots[locus.tie.joint].line,
                                           pose);
        };
        for (const linkage::Step& step : model_.order.steps)
            if (step.margin == margin) return {line(step.first), line(step.second)};
        return {};
    }

    /// Angles are counted so that at the start of motion each is in (near - pi, near + pi].
    double whole_turns_of(const Signal& s) const {
        if (start_turns_.empty()) return 0;
        const double angle = start_turns_[s.of] - start_turns_[s.to];
        return -std::ceil((angle - s.number) / (2 * std::numbers::pi) - 0.5);
    }

    const LinkageModel& model_;
    std::vector<double> start_turns_;

public:
    Follower<T> follower;

private:
    Vector<T> origin_, tilt_;
    T scale_;
    T rate_;  ///< of the input, by time
};

/// A motion as it is sampled: inputs and poses in doubles.
class Scan {
public:
    Scan(const Motion& motion, std::span<const Digits50> dimensions)
        : model(linkage_of(motion.model)), motion_(motion), dimensions_(dimensions.begin(), dimensions.end()) {
        for (const Digits50& d : dimensions)
            rounded_.push_back(d.convert_to<double>());
        follow();
    }

    bool empty() const { return at.empty(); }
    SignalsAgain<double> plain(std::size_t sample) const {
        SignalsAgain<double> signals(model, std::span<const double>(rounded_), poses.front().turns);
        signals.follower.start(at[sample], poses[sample]);
        return signals;
    }
    SignalsAgain<Digits50> precise(std::size_t sample) const {
        SignalsAgain<Digits50> signals(model, std::span<const Digits50>(dimensions_), poses.front().turns);
        signals.follower.start(at[sample], pose_as<Digits50>(poses[sample]));
        return signals;
    }
    std::size_t nearest(double input) const {
        const auto next = static_cast<std::size_t>(std::lower_bound(at.begin(), at.end(), input) - at.begin());
        if (next == 0) return 0;
        return next == at.size() || input - at[next - 1] < at[next] - input ? next - 1 : next;
    }

    const LinkageModel& model;
    std::vector<double> at;
    std::vector<LoopPose<double>> poses;

    /// The pose at an end of the motion, or where it ends by itself before it or a little after it.
    SignalsAgain<Digits50> at_end(bool last) const {
        SignalsAgain<Digits50> signals = precise(last ? at.size() - 1 : 0);
        Follower<Digits50>& follower = signals.follower;
        const double unit = model.driven_by_slide() ? follower.loop.size().convert_to<double>() : 1;
        const Digits50 end = last ? motion_.to : motion_.from, way = last ? 1 : -1, little = 1e-9 * unit;
        Follower<Digits50> beyond = follower;
        if (follower.at == end || (beyond.step(end) && follower.step(end) && beyond.step(end + way * little)))
            return signals;
        for (Digits50 step = 2 * little + abs(end - follower.at); step > 1e-42 * unit; step /= 2)
            follower.step(follower.at + way * step);
        return signals;
    }
    double from() const { return motion_.from; }
    double to() const { return motion_.to; }
    bool full_turn() const { return motion_.full_turn; }

private:
    /// From some input in both senses to the ends of the motion, as far as doubles come.
    void follow() {
        linkage::Driven<double> moving = driven(model, rounded_, motion_.assembly);
        Follower<double> follower(model, numbers_of(model, std::span<const double>(rounded_)));
        constexpr double golden = 0.38196601125010515, least = 1e-9;
        std::optional<LoopPose<double>> start;
        double input = 0;
        for (int i = 1; i <= 64 && !start; ++i) {
            input = motion_.from + (motion_.to - motion_.from) * std::fmod(i * golden, 1.0);
            start = pose_of_dyads(moving, input);
        }
        if (!start || !follower.start(input, *start)) return;
        const LoopPose<double> here = follower.pose;
        const auto keep = [&](const Follower<double>& f) {
            at.push_back(f.at);
            poses.push_back(f.pose);
        };
        follower.follow(motion_.from, least, keep);
        std::reverse(at.begin(), at.end());
        std::reverse(poses.begin(), poses.end());
        follower.start(input, here);
        keep(follower);
        follower.follow(motion_.to, least, keep);
    }

    Motion motion_;
    std::vector<Digits50> dimensions_;
    std::vector<double> rounded_;
};

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// A quantity's stretch as parts of the motion: one, or two where it runs through the end of a full turn; none where it
/// is not in the motion.
std::vector<Vector<double>> parts_of(const Scan& scan, const std::optional<std::array<double, 2>>& stretch) {
    if (!stretch) return {{scan.from(), scan.to()}};
    double first = (*stretch)[0], last = (*stretch)[1];
    if (!scan.full_turn()) {
        constexpr double turn = 2 * std::numbers::pi;
        if (!scan.model.driven_by_slide()) {
            if (last < first) last += turn;
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
    /// Its derivative of some order by the input.
    std::function<Digits50(SignalsAgain<Digits50>&, int, const Digits50&)> measure;

    double seen(double input) const {
        SignalsAgain<double> signals = scan.plain(scan.nearest(input));
        return look(signals, input);
    }
    Digits50 at(double input) const {
        if (input == scan.from() || input == scan.to()) {
            SignalsAgain<Digits50> end = scan.at_end(input == scan.to());
            return measure(end, 0, end.follower.at);
        }
        SignalsAgain<Digits50> signals = scan.precise(scan.nearest(input));
        return measure(signals, 0, input);
    }
};

struct Extreme {
    Digits50 at = 0;
    Digits50 value = missing;
};

/// From a sample at which it is extreme among its neighbours to where its derivative vanishes.
Extreme polished(const Measured& f, double left, double middle, double right) {
    SignalsAgain<Digits50> signals = f.scan.precise(f.scan.nearest(middle));
    Digits50 x = middle;
    for (int i = 0; i < 8; ++i) {
        const Digits50 step = f.measure(signals, 1, x) / f.measure(signals, 2, x);
        if (!isfinite(step) || x - step < left || x - step > right) break;
        x -= step;
        if (abs(step) < 1e-16) break;
    }
    return {x, f.measure(signals, 0, x)};
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
    Extreme found;
    for (const Candidate& c : candidates) {
        constexpr double near_best = 1e-2;
        if (c.seen < best - near_best * (best - worst) - 1e-12) continue;
        const bool end = c.left == c.at || c.right == c.at;
        const Extreme one = end ? Extreme{c.at, f.at(c.at)} : polished(f, c.left, c.at, c.right);
        if (isfinite(one.value) && (!isfinite(found.value) || sign * one.value > sign * found.value)) found = one;
    }
    return found;
}

/// The integral of a power of it over the parts, over their length. Ends are approached as the square of the way, so
/// that what has a root there is smooth.
double mean_power(const Measured& f, const std::vector<Vector<double>>& parts, int power) {
    constexpr int panels = 48;
    double sum = 0, length = 0;
    for (const auto& [from, to] : parts) {
        length += to - from;
        for (int k = 0; k < panels; ++k)
            sum += boost::math::quadrature::gauss<double, 15>::integrate(
                [&, start = from, way = to - from](double u) {
                    return std::pow(f.seen(start + way * u * u * (3 - 2 * u)), power) * 6 * u * (1 - u) * way;
                },
                static_cast<double>(k) / panels, static_cast<double>(k + 1) / panels);
    }
    return sum / length;
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
        case Kind::mean: return mean_power(f, parts, 1);
        case Kind::rms: return std::sqrt(mean_power(f, parts, 2));
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

/// The least over the motion of something that a pose has.
template <class OfPose>
Digits50 least_of_poses(const Scan& scan, const OfPose& of_pose) {
    const auto at = [of_pose]<class T>(SignalsAgain<T>& s, const T& x) {
        T value(missing);
        s.at_pose(x, [&](const LoopPose<T>& pose) { value = of_pose(s, pose); });
        return value;
    };
    const Measured f{scan, [at](SignalsAgain<double>& s, double x) { return at(s, x); },
                     [at](SignalsAgain<Digits50>& s, int order, const Digits50& x) -> Digits50 {
                         const Digits50 h = difference_step<Digits50>();
                         if (order == 0) return at(s, x);
                         const Digits50 before = at(s, Digits50(x - h)), after = at(s, Digits50(x + h));
                         if (order == 1) return (after - before) / (2 * h);
                         return (after - 2 * at(s, x) + before) / (h * h);
                     }};
    return extreme(f, {{scan.from(), scan.to()}}, -1).value;
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
                                      model.sides[assembly], laws_of(model.drives));
    std::vector<double> rounded;
    for (const Digits50& d : dimensions)
        rounded.push_back(d.convert_to<double>());
    linkage::Driven<double> plain = driven(model, rounded, assembly);
    const auto least_at = [&]<class T>(linkage::Driven<T>& moving, const T& at) {
        T least(std::numeric_limits<double>::infinity());
        const bool whole = moving.place(at);
        for (std::size_t i = 0; i < model.order.margins; ++i) {
            const T one = std::min(moving.pose.margins[i].outer, moving.pose.margins[i].inner);
            if (!linkage::is_of_lines(model.order, i)) least = std::min<T>(least, one);
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
    const Scan scan(motion, dimensions);
    if (scan.empty()) return missing;
    if (q.kind == Kind::transmission_angle_worst) return worst_transmission(scan);
    if (q.kind == Kind::joint_distance_least) return least_joint_distance(scan);
    return of_signal(scan, q);
}

}  // namespace mechwright
