#include "synthesis/mechanism/linkage/targets/cognates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <initializer_list>
#include <optional>
#include <utility>

#include "synthesis/mechanism/linkage/targets/chosen_dimensions.h"

namespace mechwright {

namespace {

using linkage::none;
using linkage::Step;
using Complex = std::complex<double>;
using PinPlaces = std::vector<Complex>;

/// Whether these are all the pins of a link.
bool has_only(const LinkageModel& model, std::size_t link, std::initializer_list<std::size_t> pins) {
    const auto& all = model.structure.pins;
    for (std::size_t pin = 0; pin < all.size(); ++pin)
        if (linkage::is_on(all[pin], link) != (std::find(pins.begin(), pins.end(), pin) != pins.end())) return false;
    return true;
}

/// The third pin of a link that has three; none else.
std::size_t third_pin(const LinkageModel& model, std::size_t link, std::size_t one, std::size_t other) {
    const auto& all = model.structure.pins;
    for (std::size_t pin = 0; pin < all.size(); ++pin)
        if (pin != one && pin != other && linkage::is_on(all[pin], link))
            return has_only(model, link, {one, other, pin}) ? pin : none;
    return none;
}

/// The link beside one that a pin joins; none where it joins more or less than two.
std::size_t link_beside(const LinkageModel& model, std::size_t pin, std::size_t link) {
    const auto& points = model.structure.pins[pin].points;
    if (points.size() != 2) return none;
    return points[0].link == link ? points[1].link : points[0].link;
}

/// The pin on which two links turn about each other.
std::size_t pin_between(const LinkageModel& model, std::size_t one, std::size_t other) {
    const auto& all = model.structure.pins;
    for (std::size_t pin = 0; pin < all.size(); ++pin)
        if (linkage::is_on(all[pin], one) && linkage::is_on(all[pin], other)) return pin;
    return none;
}

/// The pins of a cognate in the plane of the frame as it is, and those that it is described by.
std::optional<PinPlaces> moved(const LinkageModel& model, const Step& dyad, const linkage::Locus& first,
                               const linkage::Locus& second, const PinPlaces& at) {
    const std::size_t e = first.centre, g = dyad.pin, f = second.centre;
    const std::size_t x = third_pin(model, first.link, e, g);
    if (x == none || !has_only(model, second.link, {f, g})) return {};
    const std::size_t moving = link_beside(model, e, first.link), base = link_beside(model, f, second.link);
    if (moving == none || base == none) return {};
    const std::size_t z = pin_between(model, moving, base);
    if (z == none) return {};
    const Complex k = (at[x] - at[e]) / (at[g] - at[e]);
    PinPlaces to = at;
    to[z] = at[z] + k * (at[f] - at[z]);
    to[e] = to[z] + (1.0 - k) * (at[e] - at[z]);
    to[g] = at[f] + at[x] - at[g];
    const std::size_t crank = model.structure.drives.front().link;
    if (moving == crank && base == 0) return has_only(model, crank, {z, e}) ? std::optional(to) : std::nullopt;
    const std::size_t b = third_pin(model, moving, z, e), d = third_pin(model, base, z, f);
    if (b == none || d == none || !linkage::is_on(model.structure.pins[d], 0) || link_beside(model, b, moving) != crank)
        return {};
    const std::size_t a = pin_between(model, crank, 0);
    if (a == none || !has_only(model, crank, {a, b})) return {};
    const Complex larger = (to[z] - at[d]) / (at[z] - at[d]);
    to[a] = at[d] + larger * (at[a] - at[d]);
    to[b] = at[d] + larger * (at[b] - at[d]);
    return to;
}

/// How the frame of a link lies: place in the frame of the link = turn times place + origin.
struct Lying {
    Complex turn, origin;
    Complex of(const Complex& place) const { return turn * place + origin; }
};

/// Pins of a link by which its frame is known: one that stays where it is on it, and the direction to another.
struct Described {
    std::size_t from, to;
};

bool is_constant(const LinkageModel& model, const linkage::Coordinates& c) {
    return model.numbers[c.first].terms.empty() && model.numbers[c.second].terms.empty();
}

Described described(const LinkageModel& model, std::size_t link) {
    std::array<std::vector<std::size_t>, 3> pins;  // by how many of their numbers are dimensions
    for (std::size_t pin = 0; pin < model.structure.pins.size(); ++pin) {
        if (!linkage::is_on(model.structure.pins[pin], link)) continue;
        const linkage::Coordinates& c = coordinates_at(model, link, pin);
        const bool second_is = !model.numbers[c.second].terms.empty();
        const std::size_t count = is_constant(model, c) ? 0 : second_is ? 2 : 1;
        pins[count].push_back(pin);
    }
    std::vector<std::size_t> all;
    for (const auto& some : pins)
        all.insert(all.end(), some.begin(), some.end());
    return all.size() < 2 ? Described{none, none} : Described{all[0], all[1]};
}

Complex as_complex(const Vector<double>& v) { return {v.x, v.y}; }

/// Sets the places of a link's pins on it; how its frame lies then.
std::optional<Lying> describe(const LinkageModel& model, std::size_t link, const PinPlaces& to,
                              ChosenDimensions& chosen) {
    const auto [from, towards] = described(model, link);
    if (from == none) return {};
    const Complex pin = as_complex(chosen.place(link, from));
    const Complex now = as_complex(chosen.place(link, towards)) - pin, wanted = to[towards] - to[from];
    if (!(std::abs(now) > 0) || !(std::abs(wanted) > 0)) return {};
    const Complex turn = now / std::abs(now) * std::conj(wanted) / std::abs(wanted);
    const Lying lying{turn, pin - turn * to[from]};
    chosen.keep(link, from);
    const auto move = [&](std::size_t p) {
        const Complex place = lying.of(to[p]);
        return chosen.move(link, p, {place.real(), place.imag()});
    };
    if (!move(towards)) return {};
    for (std::size_t p = 0; p < to.size(); ++p)
        if (p != from && p != towards && linkage::is_on(model.structure.pins[p], link) && !move(p)) return {};
    return lying;
}

std::vector<std::int8_t> sides_of(const LinkageModel& model, const PinPlaces& to, std::vector<std::int8_t> sides) {
    for (const Step& step : model.order.steps) {
        if (step.kind != Step::Kind::dyad || step.choice == none) continue;
        const Complex line = to[step.second.centre] - to[step.first.centre];
        sides[step.choice] = std::imag(std::conj(line) * (to[step.pin] - to[step.first.centre])) > 0 ? 1 : -1;
    }
    return sides;
}

bool is_of_pins_alone(const LinkageModel& model) {
    const linkage::Structure& s = model.structure;
    const auto is_of_circles = [](const Step& step) {
        return step.kind != Step::Kind::dyad ||
               (step.first.kind == linkage::Locus::Kind::circle && !step.is_extended() &&
                step.second.kind == linkage::Locus::Kind::circle);
    };
    return s.slides.empty() && s.slots.empty() && s.gears.empty() && s.racks.empty() && s.drives.size() == 1 &&
           !s.drives.front().of_slide && s.drives.front().on == 0 && model.order.closed() &&
           model.scale.terms.empty() && model.scale.constant == 1 &&
           std::all_of(model.order.steps.begin(), model.order.steps.end(), is_of_circles);
}

/// The linkage whose pins are at these places at an input; nothing where dimensions that are not free would change.
std::optional<LinkageCognate> described_by(const LinkageModel& model, std::span<const double> dimensions,
                                           const std::vector<std::int8_t>& sides, const std::vector<bool>& free,
                                           double input, const PinPlaces& to) {
    LinkageCognate cognate{{dimensions.begin(), dimensions.end()}, sides_of(model, to, sides), 0};
    ChosenDimensions chosen(model, free, cognate.dimensions);
    std::vector<Lying> lying;
    for (std::size_t link = 0; link < model.structure.links; ++link) {
        const auto own = describe(model, link, to, chosen);
        if (!own) return {};
        lying.push_back(*own);
    }
    const Complex frame = lying[0].turn, crank = lying[model.structure.drives.front().link].turn;
    cognate.crank_angle = std::arg(frame * std::conj(crank) * std::polar(1.0, -input));
    const double tilt = chosen.value(model.placement[2]) - std::arg(frame);
    const Complex origin = Complex(chosen.value(model.placement[0]), chosen.value(model.placement[1])) -
                           std::polar(1.0, tilt) * lying[0].origin;
    const bool placed = chosen.choose(model.placement[2], tilt, true) &&
                        chosen.choose(model.placement[0], origin.real()) &&
                        chosen.choose(model.placement[1], origin.imag());
    return placed ? std::optional(std::move(cognate)) : std::nullopt;
}

}  // namespace

std::vector<LinkageCognate> linkage_cognates(const LinkageModel& model, std::span<const double> dimensions,
                                             std::size_t assembly, const std::vector<bool>& free, double input) {
    std::vector<LinkageCognate> all;
    if (!is_of_pins_alone(model)) return all;
    linkage::Driven<double> moving = driven(model, dimensions, assembly);
    if (!moving.place(input)) return all;
    PinPlaces at;
    for (const Vector<double>& pin : moving.pose.pins)
        at.push_back(as_complex(pin));
    for (const Step& step : model.order.steps) {
        if (step.kind != Step::Kind::dyad) continue;
        for (const auto& [first, second] :
             {std::pair(&step.first, &step.second), std::pair(&step.second, &step.first)}) {
            const auto to = moved(model, step, *first, *second, at);
            if (!to) continue;
            auto cognate = described_by(model, dimensions, model.sides[assembly], free, input, *to);
            if (cognate) all.push_back(std::move(*cognate));
        }
    }
    return all;
}

}  // namespace mechwright
