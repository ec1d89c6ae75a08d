#include "synthesis/mechanism/linkage/quantities.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "analysis/linkage/margins.h"
#include "synthesis/mechanism/linkage/model.h"

namespace mechwright {

namespace {

using Kind = LinkageMeasure::Kind;
using linkage::Asked;
using linkage::Course;
using linkage::Extreme;
using linkage::Signal;

constexpr double turn = 2 * std::numbers::pi;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_extremes = 6;  ///< components of a least or greatest value
constexpr std::size_t most_of_range = 3;  ///< extremes of either sort in a range

/// The linkage and the motion that a quantity is measured over.
struct Over {
    const LinkageModel& model;
    const LinkageMeasure& measure;
    const Motion& motion;
    std::vector<linkage::DriveLaw> laws = laws_of(model.drives);
    double rate = 1;

    explicit Over(const Motion& over)
        : model(linkage_of(over.model)), measure(*static_cast<const LinkageMeasure*>(over.of)), motion(over) {
        if (!model.driven_by_slide() && model.drives.front().speed) rate = *model.drives.front().speed * turn / 60;
    }
    const std::vector<std::int8_t>& sides() const { return model.sides[motion.assembly]; }
    linkage::Driven<double> driven(std::span<const double> dimensions) const {
        return mechwright::driven(model, dimensions, motion.assembly);
    }
    double period() const { return turn * model.turns; }
    linkage::Travel travel() const {
        return {motion.from, motion.full_turn ? motion.from + period() : motion.to, motion.full_turn};
    }
};

/// The signals that a ready-made quantity is of.
std::vector<Signal> own_signals(const LinkageModel& model, Kind kind) {
    const linkage::Structure& s = model.structure;
    std::vector<Signal> signals;
    if (kind == Kind::transmission_angle_worst)
        for (std::size_t margin = 0; margin < model.order.margins; ++margin)
            signals.push_back({Signal::Kind::transmission_angle, margin});
    if (kind != Kind::joint_distance_least) return signals;
    for (std::size_t a = 0; a < s.pins.size(); ++a)
        for (std::size_t b = a + 1; b < s.pins.size(); ++b)
            if (linkage::is_joint(s, a) && linkage::is_joint(s, b) && !linkage::share_link(s.pins[a], s.pins[b]))
                signals.push_back({Signal::Kind::distance, a, b});
    return signals;
}

template <class T, std::size_t K>
linkage::Measured<T, K> measured(const Over& over, std::span<const T> dimensions, std::span<const Signal> signals) {
    const LinkageModel& m = over.model;
    return {m.structure,
            m.order,
            numbers_of(m, dimensions),
            over.sides(),
            over.laws,
            signals,
            {{m.placement[0].at(dimensions), m.placement[1].at(dimensions)},
             m.placement[2].at(dimensions),
             m.scale.at(dimensions)},
            over.rate};
}

/// One smooth part of a component: what is asked at an extreme, times a factor, plus a constant.
struct Term {
    Asked asked{};
    Extreme place{};
    double factor = 1;
    double constant = 0;

    double value() const { return constant + factor * place.value; }
};

/// What the components of a quantity are of, found for one design.
struct Found {
    std::vector<Term> plus{};
    std::vector<Term> minus{};  ///< of a range: those that are taken away
    std::vector<linkage::MarginPlace> margins{};
    bool possible = true;
};

/// The least first; not a number before all.
bool is_less(double a, double b) { return std::isnan(a) ? !std::isnan(b) : a < b; }

bool needs_turns(const Over& over, std::span<const Signal> signals) {
    return std::any_of(signals.begin(), signals.end(), [](const Signal& s) { return s.kind == Signal::Kind::angle; }) ||
           std::any_of(over.model.order.steps.begin(), over.model.order.steps.end(),
                       [](const auto& step) { return step.kind == linkage::Step::Kind::unwound; });
}

/// The motion with its limits, and the turns of links where they are needed.
template <std::size_t K>
Course course_of(const Over& over, std::span<const double> dimensions, linkage::Measured<double, K>& plain,
                 std::span<const Signal> signals) {
    Course course{over.travel()};
    if (needs_turns(over, signals)) {
        course = linkage::course_along(over.driven(dimensions), course.travel,
                                       over.measure.stretch || over.measure.kind == Kind::at);
        if (course.turns.empty()) return course;
    }
    if (!course.travel.whole) {
        course.travel.first = limit_at(plain, course.travel.from, course.turns.near(course.travel.from));
        course.travel.last = limit_at(plain, course.travel.to, course.turns.near(course.travel.to));
    }
    return course;
}

/// Whether it closes here and there over the motion: what does not at all is not looked at closely.
bool closes_at_samples(const Over& over, std::span<const double> dimensions) {
    constexpr int samples = 36;
    const linkage::Travel travel = over.travel();
    if (travel.from > travel.to) return false;
    linkage::Driven<double> driven = over.driven(dimensions);
    for (int i = 0; i < samples; ++i)
        if (!driven.place(travel.from + (travel.to - travel.from) * (i + 0.5) / samples)) return false;
    return true;
}

/// A stretch of the motion as inputs that lie in it, or in its second cycle; absent where it does not.
std::optional<std::array<double, 2>> stretch_in(const Over& over, std::array<double, 2> stretch) {
    constexpr double rounding = 1e-12;
    const linkage::Travel travel = over.travel();
    if (!over.model.driven_by_slide()) {
        if (stretch[1] < stretch[0]) stretch[1] += turn;
        const double shift = turn * std::ceil((travel.from - stretch[0]) / turn - rounding);
        for (double& end : stretch)
            end += shift;
    }
    const double last = travel.whole ? travel.to + over.period() : travel.to;
    if (stretch[1] < stretch[0] || stretch[0] < travel.from - rounding || stretch[1] > last + rounding) return {};
    return std::array{std::max(stretch[0], travel.from), std::min(stretch[1], last)};
}

void add_extremes(Found& found, const std::vector<Extreme>& places, const Asked& asked, double factor,
                  double constant) {
    for (const Extreme& place : places)
        found.plus.push_back({asked, place, factor, constant});
}

bool closes(const std::vector<Extreme>& places) {
    return !places.empty() &&
           std::none_of(places.begin(), places.end(), [](const Extreme& p) { return std::isnan(p.value); });
}

void keep_least(std::vector<Term>& terms, std::size_t count) {
    std::stable_sort(terms.begin(), terms.end(),
                     [](const Term& a, const Term& b) { return is_less(a.value(), b.value()); });
    if (terms.size() > count) terms.resize(count);
}

void keep_greatest(std::vector<Term>& terms, std::size_t count) {
    std::stable_sort(terms.begin(), terms.end(),
                     [](const Term& a, const Term& b) { return is_less(b.value(), a.value()); });
    if (terms.size() > count) terms.resize(count);
}

template <std::size_t K>
Found found_of_all(const Over& over, linkage::Measured<double, K>& plain, const Course& course) {
    Found found;
    const bool folded = over.measure.kind == Kind::transmission_angle_worst;
    for (std::size_t i = 0; i < plain.signals().size(); ++i) {
        const auto places = linkage::extremes(plain, {i, 0}, course, course.travel.from, course.travel.to);
        // A constant has no extremes on a whole motion.
        const std::vector<Extreme> start{
            {course.travel.from, plain.value(i, course.travel.from, course.turns.near(course.travel.from)).c[0],
             false}};
        add_extremes(found, places.empty() ? start : places, {i, 0}, 1, 0);
        if (folded) add_extremes(found, places.empty() ? start : places, {i, 0}, -1, std::numbers::pi);
        found.possible = found.possible && closes(places.empty() ? start : places);
    }
    found.possible = found.possible && !found.plus.empty();
    keep_least(found.plus, most_extremes);
    return found;
}

template <std::size_t K>
Found found_of_signal(const Over& over, linkage::Measured<double, K>& plain, const Course& course, double from,
                      double to) {
    const LinkageMeasure& m = over.measure;
    Found found;
    if (m.kind == Kind::mean || m.kind == Kind::rms) return found;
    if (m.kind == Kind::at) {
        const double value = plain.value(m.asked.signal, from, course.turns.near(from)).derivative(m.asked.derivative);
        found.plus.push_back({m.asked, {from, value, false}});
        found.possible = !std::isnan(value);
        return found;
    }
    std::vector<Extreme> places = linkage::extremes(plain, m.asked, course, from, to);
    if (places.empty())
        places.push_back(
            {from, plain.value(m.asked.signal, from, course.turns.near(from)).derivative(m.asked.derivative), false});
    found.possible = closes(places);
    add_extremes(found, places, m.asked, 1, 0);
    if (m.kind == Kind::least) {
        keep_least(found.plus, most_extremes);
    } else if (m.kind == Kind::greatest) {
        keep_greatest(found.plus, most_extremes);
    } else {
        found.minus = found.plus;
        const std::size_t count = m.kind == Kind::time_ratio ? 1 : most_of_range;
        keep_greatest(found.plus, count);
        keep_least(found.minus, count);
    }
    return found;
}

std::size_t component_count(Kind kind) {
    switch (kind) {
        case Kind::mean:
        case Kind::rms:
        case Kind::at:
        case Kind::total_length: return 1;
        case Kind::time_ratio: return 2;
        case Kind::range:
        case Kind::deviation:
        case Kind::link_ratio: return most_of_range * most_of_range;
        default: return most_extremes;
    }
}

Reduce reduce_of(Kind kind) {
    switch (kind) {
        case Kind::mean:
        case Kind::rms:
        case Kind::at:
        case Kind::total_length: return Reduce::only;
        case Kind::greatest:
        case Kind::range:
        case Kind::deviation:
        case Kind::time_ratio:
        case Kind::link_ratio: return Reduce::greatest;
        default: return Reduce::least;
    }
}

/// Distances of links' origins to their pins, but those that are 0, in the drawing.
template <class T>
std::vector<T> link_lengths(const LinkageModel& model, std::span<const T> dimensions) {
    const linkage::Structure& s = model.structure;
    const std::vector<T> numbers = numbers_of(model, dimensions);
    const T scale = model.scale.at(dimensions);
    std::vector<T> lengths;
    for (std::size_t pin = 0; pin < s.pins.size(); ++pin) {
        if (!linkage::is_joint(s, pin)) continue;
        for (const linkage::Point& point : s.pins[pin].points) {
            const Vector<T> at = linkage::place_of(point.at, std::span<const T>(numbers));
            const T length = hypotenuse(at.x, at.y);
            if (length > T(0)) lengths.push_back(scale * length);
        }
    }
    return lengths;
}

/// The components, the worst first, as many as there are, as functions of the dimensions.
template <class T, std::size_t K>
class Components {
public:
    Components(const Over& over, std::span<const T> seeded, std::span<const Signal> signals,
               linkage::Measured<double, K>& plain, const Course& course, const Found& found,
               std::array<double, 2> stretch)
        : over_(over),
          seeded_(seeded),
          measured_(measured<T, K>(over, seeded, signals)),
          plain_(plain),
          course_(course),
          found_(found),
          stretch_(stretch) {
        if (!course.turns.empty()) measured_.start_at(course);
    }

    std::vector<T> all() {
        const Kind kind = over_.measure.kind;
        std::vector<T> out;
        switch (kind) {
            case Kind::mean: out.push_back(mean(false)); break;
            case Kind::rms: {
                using std::sqrt;
                out.push_back(sqrt(mean(true)));
                break;
            }
            case Kind::range:
            case Kind::deviation: add_differences(kind == Kind::range ? 1 : 0.5, out); break;
            case Kind::time_ratio: add_time_ratios(out); break;
            case Kind::total_length: {
                T sum(0);
                for (const T& length : link_lengths(over_.model, seeded_))
                    sum = sum + length;
                out.push_back(sum);
                break;
            }
            case Kind::link_ratio: add_link_ratios(out); break;
            case Kind::full_turn_margin:
            case Kind::assembly_margin:
                for (const linkage::MarginPlace& place : found_.margins)
                    out.push_back(over_.model.scale.at(seeded_) *
                                  linkage::margin_at(measured_, place, course_.turns.near(place.place.at)));
                break;
            default:
                for (const Term& term : found_.plus)
                    out.push_back(value(term));
        }
        return out;
    }

private:
    T value(const Term& term) {
        return T(term.constant) + T(term.factor) * linkage::value_at(measured_, term.asked, course_, term.place);
    }
    T mean(bool squared) {
        return linkage::mean_of(measured_, plain_, over_.measure.asked, course_, stretch_[0], stretch_[1], squared);
    }
    void add_differences(double factor, std::vector<T>& out) {
        struct Pair {
            std::size_t high, low;
            double value;
        };
        std::vector<Pair> pairs;
        std::vector<T> high, low;
        for (const Term& term : found_.plus)
            high.push_back(value(term));
        for (const Term& term : found_.minus)
            low.push_back(value(term));
        for (std::size_t i = 0; i < high.size(); ++i)
            for (std::size_t j = 0; j < low.size(); ++j)
                pairs.push_back({i, j, found_.plus[i].value() - found_.minus[j].value()});
        std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.value > b.value; });
        for (const Pair& pair : pairs)
            out.push_back(T(factor) * (high[pair.high] - low[pair.low]));
    }
    void add_time_ratios(std::vector<T>& out) {
        const Term &high = found_.plus.front(), &low = found_.minus.front();
        const T apart =
            (T(high.place.at) + T(over_.rate) * shift(high)) - (T(low.place.at) + T(over_.rate) * shift(low));
        const T one = value_of(apart) < 0 ? T(apart + T(over_.period())) : apart, other = T(over_.period()) - one;
        const bool slow = value_of(one) > value_of(other);
        out.push_back(slow ? T(one / other) : T(other / one));
        out.push_back(slow ? T(other / one) : T(one / other));
    }
    T shift(const Term& term) { return linkage::shift_of(measured_, term.asked, course_, term.place); }
    void add_link_ratios(std::vector<T>& out) {
        std::vector<T> lengths = link_lengths(over_.model, seeded_);
        std::stable_sort(lengths.begin(), lengths.end(), [](const T& a, const T& b) { return a > b; });
        const std::size_t n = lengths.size(), few = std::min(most_of_range, n);
        for (std::size_t i = 0; i < few; ++i)
            for (std::size_t j = 0; j < few; ++j)
                if (i != n - 1 - j) out.push_back(lengths[i] / lengths[n - 1 - j]);
        if (n == 1) out.push_back(T(1));
        std::stable_sort(out.begin(), out.end(), [](const T& a, const T& b) { return a > b; });
    }

    const Over& over_;
    std::span<const T> seeded_;
    linkage::Measured<T, K> measured_;
    linkage::Measured<double, K>& plain_;
    const Course& course_;
    const Found& found_;
    std::array<double, 2> stretch_;
};

/// Calls write(k, component) for as many components as a quantity has: where there are fewer, the last is repeated.
template <class T, class Write>
void write_components(const std::vector<T>& all, std::size_t count, const Write& write) {
    for (std::size_t k = 0; k < count; ++k)
        write(k, all[std::min(k, all.size() - 1)]);
}

template <std::size_t K>
bool measure_by_series(const Over& over, std::span<const double> dimensions, const Measurement& out) {
    const Kind kind = over.measure.kind;
    const std::vector<Signal> own = own_signals(over.model, kind);
    const std::span<const Signal> signals =
        over.measure.signals.empty() ? std::span<const Signal>(own) : std::span<const Signal>(over.measure.signals);
    auto plain = measured<double, K>(over, dimensions, signals);
    const bool of_lengths = kind == Kind::total_length || kind == Kind::link_ratio;
    if (kind == Kind::joint_distance_least && own.empty()) return false;
    if (of_lengths && link_lengths(over.model, dimensions).empty()) return false;
    const bool of_margins = kind == Kind::full_turn_margin || kind == Kind::assembly_margin;
    Course course{over.travel()};
    Found found;
    std::array<double, 2> stretch{course.travel.from, course.travel.to};
    if (of_margins) {
        const linkage::Driven<double> driven = over.driven(dimensions);
        const linkage::Travel all = kind == Kind::full_turn_margin && !over.model.driven_by_slide()
                                        ? linkage::Travel{0, over.period(), true}
                                        : course.travel;
        found.margins = linkage::margin_places(plain, driven, all);
        std::stable_sort(found.margins.begin(), found.margins.end(),
                         [](const auto& a, const auto& b) { return is_less(a.place.value, b.place.value); });
        if (found.margins.size() > most_extremes) found.margins.resize(most_extremes);
        if (found.margins.empty()) return false;
        if (needs_turns(over, signals)) course = linkage::course_along(driven, all);
    } else if (!of_lengths) {
        if (!closes_at_samples(over, dimensions)) return false;
        course = course_of(over, dimensions, plain, signals);
        if (needs_turns(over, signals)) {
            if (course.turns.empty() || course.turns.to() < course.travel.to) return false;
            plain.start_at(course);
        }
        if (kind == Kind::transmission_angle_worst || kind == Kind::joint_distance_least) {
            found = found_of_all(over, plain, course);
        } else {
            const auto asked = kind == Kind::at ? std::optional(std::array{over.measure.input, over.measure.input})
                                                : over.measure.stretch;
            if (asked) {
                const auto in = stretch_in(over, *asked);
                if (!in) return false;
                stretch = *in;
            }
            found = found_of_signal(over, plain, course, stretch[0], stretch[1]);
        }
    }
    if (!found.possible) return false;

    const std::size_t n = dimensions.size(), count = component_count(kind);
    const auto components_of = [&]<class T>(std::span<const T> seeded) {
        return Components<T, K>(over, seeded, signals, plain, course, found, stretch).all();
    };
    write_components(components_of(dimensions), count, [&](std::size_t k, double value) { out.value[k] = value; });
    if (out.hessian.empty() && !out.gradient.empty()) {
        constexpr std::size_t chunk = 8;
        using First = Dual<double, chunk>;
        for (std::size_t from = 0; from < n; from += chunk) {
            std::vector<First> seeded(dimensions.begin(), dimensions.end());
            for (std::size_t i = from; i < std::min(n, from + chunk); ++i)
                seeded[i] = First::variable(dimensions[i], i - from);
            write_components(components_of(std::span<const First>(seeded)), count, [&](std::size_t k, const First& c) {
                for (std::size_t i = from; i < std::min(n, from + chunk); ++i)
                    out.gradient[k * n + i] = c.partial[i - from];
            });
        }
    }
    if (out.hessian.empty()) return true;
    // Two blocks of dimensions at a time.
    constexpr std::size_t half = 4;
    using Second = SecondDual<double, 2 * half>;
    const std::size_t blocks = (n + half - 1) / half, pairs = n * (n + 1) / 2;
    for (std::size_t b = 0; b < blocks; ++b)
        for (std::size_t a = 0; a <= b; ++a) {
            if (a == b && blocks > 1) continue;
            std::vector<Second> seeded(dimensions.begin(), dimensions.end());
            std::array<std::size_t, 2 * half> variable{};
            for (std::size_t v = 0; v < 2 * half; ++v) {
                variable[v] = v < half ? a * half + v : b * half + v - half;
                const bool again = a == b && v >= half;
                if (variable[v] >= n || again)
                    variable[v] = n;
                else
                    seeded[variable[v]] = Second::variable(dimensions[variable[v]], v);
            }
            write_components(
                components_of(std::span<const Second>(seeded)), count, [&](std::size_t k, const Second& c) {
                    for (std::size_t v = 0; v < 2 * half; ++v) {
                        if (variable[v] == n) continue;
                        if (!out.gradient.empty()) out.gradient[k * n + variable[v]] = c.first[v];
                        for (std::size_t w = 0; w <= v; ++w)
                            if (variable[w] != n)
                                out.hessian[k * pairs + variable[v] * (variable[v] + 1) / 2 + variable[w]] =
                                    c.mixed(v, w);
                    }
                });
        }
    return true;
}

bool is_defined(const Motion& motion) {
    const LinkageMeasure& m = *static_cast<const LinkageMeasure*>(motion.of);
    const LinkageModel& model = linkage_of(motion.model);
    if (m.kind == Kind::time_ratio) return motion.full_turn;
    if (m.kind == Kind::full_turn_margin) return !model.driven_by_slide();
    return true;
}

std::size_t components(const Motion& motion) {
    return component_count(static_cast<const LinkageMeasure*>(motion.of)->kind);
}

void measure(const Motion& motion, std::span<const double> dimensions, const Measurement& out) {
    const Over over(motion);
    const Kind kind = over.measure.kind;
    std::size_t order = over.measure.signals.empty() ? 2 : linkage::order_for(over.measure.signals, over.measure.asked);
    // A time ratio needs one derivative more for its second ones; what is given where it is, needs none.
    if (kind == Kind::time_ratio) ++order;
    if (motion.full_turn && (kind == Kind::mean || kind == Kind::rms || kind == Kind::at)) order -= 2;
    const bool could = order == 0   ? measure_by_series<0>(over, dimensions, out)
                       : order <= 2 ? measure_by_series<2>(over, dimensions, out)
                       : order <= 4 ? measure_by_series<4>(over, dimensions, out)
                                    : measure_by_series<7>(over, dimensions, out);
    if (could) return;
    for (const std::span<double>& numbers : {out.value, out.gradient, out.hessian})
        std::fill(numbers.begin(), numbers.end(), not_a_number);
}

}  // namespace

Quantity linkage_quantity(std::string name, Unit unit, std::string meaning, LinkageMeasure of, std::size_t dimensions) {
    Quantity quantity;
    quantity.name = std::move(name);
    quantity.unit = unit;
    quantity.meaning = std::move(meaning);
    quantity.reduce = reduce_of(of.kind);
    quantity.reads = Reads(dimensions);
    quantity.defined = is_defined;
    quantity.components = components;
    quantity.measure = measure;
    quantity.worst_first = component_count(of.kind) > 1;
    quantity.of = Model(std::move(of));
    return quantity;
}

}  // namespace mechwright
