#include "synthesis/verify/proofs/limits_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "analysis/numbers/golden_section.h"
#include "synthesis/mechanism/possible_values.h"

namespace mechwright {

namespace {

using claims::member;

const Digits50& pi() { return boost::math::constants::pi<Digits50>(); }

Digits50 angle_of_cosine(const Digits50& cosine) {
    return acos(std::clamp<Digits50>(cosine, Digits50(-1), Digits50(1)));
}

/// The greatest value of a function between two places: samples that are dense towards both find where it is, a golden
/// section between the neighbours of every sample that is as great as they are closes in on it to the last digits of a
/// double, and there it is measured in fifty.
template <class Function>
Digits50 greatest_of(const Function& f, double from, double to) {
    constexpr int steps = 1000;
    std::vector<double> at, value;
    for (int i = 0; i <= steps; ++i) {
        at.push_back(from + (to - from) * (0.5 - 0.5 * std::cos(std::numbers::pi * i / steps)));
        value.push_back(f(at.back()));
    }
    Digits50 greatest = -std::numeric_limits<Digits50>::infinity();
    const double highest = *std::max_element(value.begin(), value.end());
    constexpr double near = 1e-2;  // what falls short of the highest sample by more does not become the greatest
    for (std::size_t i = 1; i + 1 < at.size(); ++i) {
        if (value[i] < value[i - 1] || value[i] < value[i + 1] || value[i] < highest - near) continue;
        const Digits50 place = greatest_between(f, at[i - 1], at[i + 1]);
        greatest = std::max({greatest, Digits50(f(place)), Digits50(f(Digits50(at[i])))});
    }
    return greatest;
}

/// The worst transmission angle of a crank-rocker with crank 1 and a coupler of (1 + part) / (1 - part) in the family
/// of a swing and a stroke; negative where there is none. Both limits of the rocker pin are known from the coupler and
/// the stroke, and the rocker's pivot sees them under the swing.
template <class T>
T member_of_family(const T& swing, const T& stroke, const T& part) {
    using std::acos, std::cos, std::sin, std::sqrt, std::tan;
    const T coupler = (1 + part) / (1 - part);
    const Vector<T> outer{coupler + 1, T(0)};
    const Vector<T> inner{T(-(coupler - 1) * cos(stroke)), T((coupler - 1) * sin(stroke))};
    const Vector<T> chord = inner - outer;
    const T half = sqrt(dot(chord, chord)) / 2, rocker = half / sin(swing / 2);
    T best = -1;
    for (const int side : {1, -1}) {
        const Vector<T> pivot = T(0.5) * (outer + inner) + T(side / (2 * tan(swing / 2))) * left_of(chord);
        const T ground = sqrt(dot(pivot, pivot)), longest = std::max({ground, coupler, rocker});
        if (!(coupler > 1 && ground > 1 && rocker > 1 && 1 + 2 * longest <= ground + coupler + rocker)) continue;
        // Both limits have the pivot on the same side of the coupler, or they are those of two assemblies.
        if ((cross(outer, pivot) > 0) != (cross(inner, pivot) > 0)) continue;
        const auto angle = [&](const T& diagonal) {
            const T cosine = (coupler * coupler + rocker * rocker - diagonal * diagonal) / (2 * coupler * rocker);
            return T(acos(std::clamp<T>(cosine, T(-1), T(1))));
        };
        // The greater one's supplement: half a turn less an arc cosine is that of the negative.
        const T folded = angle(ground - 1), stretched = angle(ground + 1);
        best = std::max<T>(best, std::min<T>(folded, boost::math::constants::pi<T>() - stretched));
    }
    return best;
}

Digits50 best_of_family(const Digits50& swing, const Digits50& time_ratio) {
    const Digits50 slow = 2 * pi() * time_ratio / (1 + time_ratio);
    Digits50 best = 0;
    for (const Digits50& stroke : {slow, Digits50(2 * pi() - slow)})
        best = std::max(best, greatest_of(
                                  [&]<class T>(const T& part) {
                                      return member_of_family(static_cast<T>(swing), static_cast<T>(stroke), part);
                                  },
                                  0, 1));
    return best;
}

/// The ram's limits subtend the angle 2 h of the time ratio at the crank pivot, which lies on a circle through them. At
/// an angle m along it the rod's greatest slope has the sine (cos m s + sin^2 m - s^2) / (sin m cos h), s = sin h. Its
/// derivative is that of a cubic in cos m, one of whose roots is the end s; of the others x = (sqrt(s^2 + 4) - s) / 2
/// lies between the ends, at both of which the slope is a right angle: there it is least.
Digits50 best_slider_crank(const Digits50& time_ratio) {
    const Digits50 h = pi() / 2 * (time_ratio - 1) / (time_ratio + 1), s = sin(h);
    if (!(4 * h < pi())) return 0;
    const Digits50 x = (sqrt(s * s + 4) - s) / 2;
    return angle_of_cosine((2 * s * x - s * s) / sqrt(s * x * (1 - s * s)));
}

/// The rod of a crank shaper rises to lever - line with the lever upright and to line - lever cos(swing / 2) at its
/// ends. The greater of the two is least over lever and line where the two are as great, on the edge of their ranges,
/// or at a corner.
Digits50 best_shaper(const ProofContext& c, const Digits50& time_ratio, const Digits50& stroke, Strictness limits) {
    constexpr std::size_t lever = 2, rod = 3, line = 4;
    const Digits50 sine = cos(pi() / (1 + time_ratio)), cosine = sin(pi() / (1 + time_ratio));
    DigitsRange levers = range_again(c, lever, limits);
    const DigitsRange lines = range_again(c, line, limits);
    if (stroke > 0) levers.least = levers.greatest = stroke / (2 * sine);
    std::vector<Vector<Digits50>> places;
    for (const Digits50& l : {levers.least, levers.greatest}) {
        const Digits50 level = l * (1 + cosine) / 2;
        for (const Digits50& h : {lines.least, lines.greatest, std::clamp(level, lines.least, lines.greatest)})
            places.push_back({l, h});
    }
    for (const Digits50& h : {lines.least, lines.greatest})
        places.push_back({std::clamp<Digits50>(2 * h / (1 + cosine), levers.least, levers.greatest), h});
    Digits50 least = std::numeric_limits<Digits50>::infinity();
    for (const auto& [l, h] : places)
        least = std::min<Digits50>(least, std::max<Digits50>(l - h, h - l * cosine));
    return angle_of_cosine(least / range_again(c, rod, limits).greatest);
}

/// What a document asks of a quantity: one of its ends, or where it asks nothing of it 0.
Digits50 asked_end(const ProofContext& c, std::string_view quantity, Strictness limits, bool least) {
    const DigitsRange asked = asked_again(c, quantity, limits);
    const Digits50 end = least ? asked.least : asked.greatest;
    return isfinite(end) ? end : Digits50(0);
}

/// The rod's greatest slope has at least the sine of half a stroke over the rod.
Digits50 sloped_by_stroke(const ProofContext& c, std::size_t rod, const Digits50& stroke, Strictness limits) {
    return angle_of_cosine(stroke / 2 / range_again(c, rod, limits).greatest);
}

/// The greatest value of `of` at the ends of what is asked of two quantities. What it is of falls with both, but which
/// end that is need not be known.
template <class Function>
Digits50 greatest_at_ends(const Function& of, const DigitsRange& a, const DigitsRange& b) {
    Digits50 greatest = of(a.least, b.least);
    if (a.least == a.greatest && b.least == b.greatest) return greatest;
    for (const auto& [x, y] : {std::pair{a.least, b.greatest}, {a.greatest, b.least}, {a.greatest, b.greatest}})
        greatest = std::max<Digits50>(greatest, of(x, y));
    return greatest;
}

/// A limit that this place knows: no design that meets the other requirements has a greater value of the quantity.
std::optional<Digits50> greatest_again(const ProofContext& c, std::string_view limit, std::string_view quantity,
                                       Strictness limits) {
    const auto least = [&](std::string_view name) { return asked_end(c, name, limits, true); };
    const bool worst = quantity == "transmission-angle-worst";
    const bool transmission = worst || quantity == "transmission-angle-min";
    const Digits50 swing = least("swing"), ratio = least("time-ratio"), stroke = least("stroke");
    const std::string_view mechanism = c.problem.mechanism->name;
    if (mechanism == "four-bar") {
        // Both of VDI 2130.
        if (limit == "swing" && worst) return (pi() - swing) / 2;
        const Digits50 most = asked_end(c, "swing", limits, false);
        if (limit == "swing-time-ratio" && quantity == "time-ratio" && most > 0 && most < pi())
            return (3 * pi() + most) / (pi() - most);
        const DigitsRange swings = asked_again(c, "swing", limits), ratios = asked_again(c, "time-ratio", limits);
        if (limit == "family" && worst && swing > 0 && ratio >= 1 && isfinite(swings.greatest + ratios.greatest))
            return greatest_at_ends(best_of_family, swings, ratios);
    }
    if (mechanism == "slider-crank") {
        if (limit == "time-ratio" && quantity == "time-ratio") return Digits50(3);
        if (limit == "ratio-family" && transmission && ratio >= 1) return best_slider_crank(ratio);
        if (limit == "stroke" && transmission) return sloped_by_stroke(c, 1, stroke, limits);
    }
    const DigitsRange strokes{stroke, asked_end(c, "stroke", limits, false)};
    if (mechanism == "crank-shaper" && limit == "lever" && transmission && ratio > 1) {
        const DigitsRange ratios = asked_again(c, "time-ratio", limits);
        if (!isfinite(ratios.greatest)) return std::nullopt;
        return greatest_at_ends([&](const Digits50& r, const Digits50& s) { return best_shaper(c, r, s, limits); },
                                ratios, strokes);
    }
    if (mechanism == "whitworth" && transmission) {
        constexpr std::size_t arm = 2, rod = 3;
        const Digits50 arms = range_again(c, arm, limits).least;
        if (limit == "arm") return sloped_by_stroke(c, rod, std::max<Digits50>(stroke, 2 * arms), limits);
        if (limit == "stroke") return sloped_by_stroke(c, rod, stroke, limits);
    }
    return std::nullopt;
}

/// Where a quantity cannot go by its meaning, and where a limit of this name keeps it: NaN at an end that is not known.
DigitsRange limit_again(const ProofContext& c, std::string_view limit, const Quantity& quantity, Strictness limits) {
    const Digits50 unknown = std::numeric_limits<Digits50>::quiet_NaN();
    if (limit == "possible-values") {
        // Angles in radians are halves and wholes of a turn's half: in fifty digits.
        const auto exact = [](double value) {
            for (const int halves : {1, 2})
                if (value == halves * std::numbers::pi / 2) return Digits50(halves * pi() / 2);
            return Digits50(value);
        };
        const PossibleValues possible = possible_values(quantity.name);
        return {exact(possible.least), exact(possible.greatest)};
    }
    return {unknown, greatest_again(c, limit, quantity.name, limits).value_or(unknown)};
}

}  // namespace

Finding check_limit_again(const ProofContext& c) {
    constexpr double same_within = 1e-9;
    claims::Reader in;
    const std::string name = in.text(member(c.certificate, "limit"), "search.certificate.limit");
    const std::string quantity_name = in.text(member(c.certificate, "quantity"), "search.certificate.quantity");
    const double stated = in.number(member(c.certificate, "value"), "search.certificate.value");
    if (!in.understood()) return fails(in.defect);
    const int index = find_quantity(*c.problem.mechanism, quantity_name);
    if (index < 0) return fails("there is no such quantity");
    const Quantity& quantity = c.problem.mechanism->quantities[static_cast<std::size_t>(index)];
    const Digits50 value = from_document(stated, quantity.unit, c.problem.units);
    const Digits50 room = same_within * std::max<Digits50>(1, abs(value));
    const DigitsRange exact = limit_again(c, name, quantity, Strictness::exact);
    const bool above = !c.infeasible || asked_again(c, quantity.name, Strictness::exact).least > value;
    const auto in_words = [&](const Digits50& number) { return value_text(number, quantity.unit, c.problem.units); };
    if (!(above ? exact.greatest <= value + room : exact.least >= value - room))
        return fails(fmt::format("the limit '{}' is {}, and {} is stated", name,
                                 in_words(above ? exact.greatest : exact.least), in_words(value)));
    if (c.infeasible) {
        const DigitsRange asked = asked_again(c, quantity.name, Strictness::loosened);
        const DigitsRange limit = limit_again(c, name, quantity, Strictness::loosened);
        if (!(above ? asked.least > limit.greatest : asked.greatest < limit.least))
            return fails("what is asked for is within the limit");
        return holds(fmt::format("'{}' never is {} than {}", quantity.name, above ? "greater" : "less",
                                 in_words(above ? limit.greatest : limit.least)));
    }
    if (single_objective(c, true) != &quantity) return fails("the limit is not one of what is to be greatest");
    Measurements measurements(c.design);
    const auto& reached = measurements.of(static_cast<std::size_t>(index));
    if (!reached || !(reached->value >= exact.greatest - room))
        return fails("the design does not come up to the limit");
    return holds(fmt::format("the design comes up to the limit {}", in_words(exact.greatest)));
}

}  // namespace mechwright
