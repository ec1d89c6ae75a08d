#include "synthesis/mechanism/linkage/targets/guiding_part.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/four_bar/cognates.h"
#include "synthesis/mechanism/linkage/targets/chosen_dimensions.h"

namespace mechwright {

namespace {

using linkage::Step;
using Place = Vector<double>;

constexpr std::size_t most_joined = 2;

// The parts

std::size_t link_that_carries(const LinkageModel& model, std::size_t pin) {
    for (const Step& step : model.order.steps)
        if (step.kind == Step::Kind::carried && step.pin == pin) return step.link;
    return linkage::none;
}

bool is_on(const LinkageModel& model, std::size_t pin, std::size_t link) {
    return linkage::is_on(model.structure.pins[pin], link);
}

/// A pin of a link, itself or brought onto another, that is on a second link.
struct Reached {
    std::size_t pin;
    std::vector<PinOnPin> joined;
};

/// The ways in which a pin is on a link, or comes to be where it is brought onto another pin of the link that carries
/// it.
std::vector<Reached> ways_onto(const LinkageModel& model, std::size_t pin, std::size_t link) {
    if (is_on(model, pin, link)) return {{pin, {}}};
    std::vector<Reached> all;
    const std::size_t carrier = link_that_carries(model, pin);
    if (carrier == linkage::none) return all;
    for (std::size_t onto = 0; onto < model.structure.pins.size(); ++onto)
        if (onto != pin && is_on(model, onto, carrier) && is_on(model, onto, link))
            all.push_back({onto, {{carrier, pin, onto}}});
    return all;
}

bool is_driven_plainly(const LinkageModel& model) {
    const LinkageDrive& drive = model.drives.front();
    const linkage::Drive& master = model.structure.drives.front();
    return !master.of_slide && master.on == 0 && drive.ratio == 1 && drive.phase == 0 && !drive.motion &&
           model.scale.terms.empty() && model.scale.constant == 1 && !model.guided.empty();
}

/// The pin on which the crank turns about the frame.
std::size_t crank_pivot(const LinkageModel& model, std::size_t crank) {
    for (const Step& step : model.order.steps)
        if (step.kind == Step::Kind::pinned && step.link == crank && is_on(model, step.pin, 0)) return step.pin;
    return linkage::none;
}

void add_parts_of_dyad(const LinkageModel& model, const Step& dyad, const linkage::Locus& coupler,
                       const linkage::Locus& rocker, std::vector<GuidingPart>& parts) {
    const std::size_t crank = model.structure.drives.front().link, pivot = crank_pivot(model, crank);
    if (pivot == linkage::none) return;
    for (const Reached& pin : ways_onto(model, coupler.centre, crank))
        for (const Reached& fixed : ways_onto(model, rocker.centre, 0))
            for (const Reached& point : ways_onto(model, model.guided.front().pin, coupler.link)) {
                if (pin.pin == pivot || fixed.pin == pivot || point.pin == dyad.pin || point.pin == coupler.centre)
                    continue;
                GuidingPart part{{{{0, pivot, fixed.pin},
                                   {crank, pivot, pin.pin},
                                   {coupler.link, coupler.centre, dyad.pin},
                                   {rocker.link, rocker.centre, dyad.pin}}},
                                 point.pin,
                                 dyad.choice,
                                 static_cast<std::int8_t>(&coupler == &dyad.first ? 1 : -1),
                                 pin.joined};
                part.joined.insert(part.joined.end(), fixed.joined.begin(), fixed.joined.end());
                part.joined.insert(part.joined.end(), point.joined.begin(), point.joined.end());
                if (part.joined.size() <= most_joined) parts.push_back(std::move(part));
            }
}

// Their dimensions

struct Between {
    double least, greatest;
};

Between interval_of(const Affine& number, std::span<const double> least, std::span<const double> greatest) {
    Between all{number.constant, number.constant};
    for (const auto& [dimension, factor] : number.terms) {
        const double a = factor * least[dimension], b = factor * greatest[dimension];
        all.least += std::min(a, b);
        all.greatest += std::max(a, b);
    }
    return all;
}

struct BoxOfPlaces {
    Between x, y;
};

BoxOfPlaces box_of_places(const LinkageModel& model, const linkage::Coordinates& at, std::span<const double> least,
                          std::span<const double> greatest) {
    const Between first = interval_of(model.numbers[at.first], least, greatest);
    const Between second = interval_of(model.numbers[at.second], least, greatest);
    if (!at.polar) return {first, second};
    if (second.least == second.greatest) {  // a stretch of a ray
        const double c = std::cos(second.least), s = std::sin(second.least);
        const auto along = [&](double by) -> Between {
            const double a = by * first.least, b = by * first.greatest;
            return {std::min(a, b), std::max(a, b)};
        };
        return {along(c), along(s)};
    }
    const double most = std::max(std::abs(first.least), std::abs(first.greatest));
    return {{-most, most}, {-most, most}};
}

Between less(const Between& a, const Between& b) { return {a.least - b.greatest, a.greatest - b.least}; }

/// From 0 to the nearest and to the farthest of an interval.
Between sizes_of(const Between& all) {
    const double a = std::abs(all.least), b = std::abs(all.greatest);
    const bool has_zero = all.least <= 0 && all.greatest >= 0;
    return {has_zero ? 0 : std::min(a, b), std::max(a, b)};
}

/// Gives an arm its length in the direction that it has, and says that direction.
std::optional<Place> set_arm(const GuidingPart::Arm& arm, double length, ChosenDimensions& chosen) {
    const Place from = chosen.place(arm.link, arm.from), apart = chosen.place(arm.link, arm.to) - from;
    const double now = std::hypot(apart.x, apart.y);
    const Place along = now > 0 ? (1 / now) * apart : Place{1, 0};
    chosen.keep(arm.link, arm.from);
    if (!chosen.move(arm.link, arm.to, from + length * along)) return std::nullopt;
    return along;
}

}  // namespace

std::shared_ptr<const Mechanism> kind_of_part() { return find_mechanism("four-bar"); }

std::vector<GuidingPart> guiding_parts(const LinkageModel& model) {
    std::vector<GuidingPart> parts;
    if (!is_driven_plainly(model)) return parts;
    using linkage::Locus;
    for (const Step& step : model.order.steps) {
        if (step.kind != Step::Kind::dyad || step.is_extended() || step.first.kind != Locus::Kind::circle ||
            step.second.kind != Locus::Kind::circle)
            continue;
        add_parts_of_dyad(model, step, step.first, step.second, parts);
        add_parts_of_dyad(model, step, step.second, step.first, parts);
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const GuidingPart& a, const GuidingPart& b) { return a.joined.size() < b.joined.size(); });
    return parts;
}

PartRanges ranges_of_part(const LinkageModel& model, const GuidingPart& part, std::span<const double> least,
                          std::span<const double> greatest) {
    PartRanges ranges{};
    const auto box = [&](std::size_t link, std::size_t pin) {
        return box_of_places(model, coordinates_at(model, link, pin), least, greatest);
    };
    const auto set = [&](std::size_t i, const Between& to) {
        ranges.least[i] = to.least;
        ranges.greatest[i] = to.greatest;
    };
    for (std::size_t i = 0; i < part.arms.size(); ++i) {
        const GuidingPart::Arm& arm = part.arms[i];
        const BoxOfPlaces from = box(arm.link, arm.from), to = box(arm.link, arm.to);
        const Between x = sizes_of(less(to.x, from.x)), y = sizes_of(less(to.y, from.y));
        set(i, {std::hypot(x.least, y.least), std::hypot(x.greatest, y.greatest)});
    }
    const BoxOfPlaces from = box(part.coupler().link, part.coupler().from), to = box(part.coupler().link, part.point);
    const BoxOfPlaces pin = box(part.coupler().link, part.coupler().to);
    const Between x = less(to.x, from.x), y = less(to.y, from.y), axis = less(pin.y, from.y);
    const double far = std::hypot(sizes_of(x).greatest, sizes_of(y).greatest);
    const bool is_axis = axis.least == 0 && axis.greatest == 0 && less(pin.x, from.x).least >= 0;
    set(4, is_axis ? x : Between{-far, far});
    set(5, is_axis ? y : Between{-far, far});
    const BoxOfPlaces pivot = box(0, part.arms[0].from), other = box(0, part.arms[0].to);
    const double off = std::hypot(sizes_of(pivot.x).greatest, sizes_of(pivot.y).greatest);
    for (std::size_t i = 0; i < 2; ++i) {
        const Between origin = interval_of(model.placement[i], least, greatest);
        set(6 + i, {origin.least - off, origin.greatest + off});
    }
    const Between across = less(other.y, pivot.y);
    const bool along_x = across.least == 0 && across.greatest == 0 && less(other.x, pivot.x).least >= 0;
    set(8, along_x ? interval_of(model.placement[2], least, greatest) : Between{0, 2 * std::acos(-1.0)});
    return ranges;
}

std::optional<PlacedPart> with_part(const LinkageModel& model, const GuidingPart& part, const PartDimensions& four,
                                    const std::vector<bool>& free, std::vector<double> dimensions) {
    PlacedPart placed{std::move(dimensions), {}, 0};
    ChosenDimensions chosen(model, free, placed.dimensions);
    std::array<Place, 4> along;
    for (std::size_t i = 0; i < part.arms.size(); ++i) {
        const auto direction = set_arm(part.arms[i], four[i], chosen);
        if (!direction) return std::nullopt;
        along[i] = *direction;
    }
    const GuidingPart::Arm& coupler = part.coupler();
    const Place point = chosen.place(coupler.link, coupler.from) + turned(Place{four[4], four[5]}, along[2]);
    if (!chosen.move(coupler.link, part.point, point)) return std::nullopt;
    for (const PinOnPin& one : part.joined)
        if (!chosen.move(one.link, one.pin, chosen.place(one.link, one.onto))) return std::nullopt;
    const double frame = std::atan2(along[0].y, along[0].x), tilt = four[8] - frame;
    const Place pivot = turned(chosen.place(0, part.arms[0].from), Place{std::cos(tilt), std::sin(tilt)});
    if (!chosen.choose(model.placement[2], tilt, true) || !chosen.choose(model.placement[0], four[6] - pivot.x) ||
        !chosen.choose(model.placement[1], four[7] - pivot.y))
        return std::nullopt;
    placed.chosen = chosen.chosen();
    placed.crank_angle = frame - std::atan2(along[1].y, along[1].x);
    return placed;
}

PartDimensions cognate_of_part(const PartDimensions& four) {
    const PathLinkage<double> own{
        {four[0], four[1], four[2], four[3]}, {four[4], four[5]}, {{four[6], four[7]}, four[8]}, Assembly::open};
    const PathLinkage<double> other = cognates(own)[1];
    return {other.links.ground,       other.links.crank,        other.links.coupler,
            other.links.rocker,       other.point.along,        other.point.across,
            other.placement.origin.x, other.placement.origin.y, other.placement.tilt};
}

}  // namespace mechwright
