#include "synthesis/exact/output_dyads/output_dyad.h"

#include <algorithm>

#include "analysis/linkage/motion/driven.h"
#include "analysis/numbers/unit_vector.h"

namespace mechwright {

namespace {

using linkage::Locus;
using linkage::Step;

/// The link of a pin, other than the lever, that is there before the dyad is placed: the frame, or one of a step
/// before.
std::optional<std::size_t> carrier_of(const LinkageModel& model, std::size_t pin, std::size_t lever, std::size_t step) {
    for (const linkage::Point& point : model.structure.pins[pin].points) {
        if (point.link == lever) continue;
        const auto places = [&](const Step& one) {
            return one.link == point.link ||
                   (one.kind == Step::Kind::dyad && (one.first.link == point.link || one.second.link == point.link));
        };
        const auto end = model.order.steps.begin() + static_cast<std::ptrdiff_t>(step);
        if (point.link == 0 || std::any_of(model.order.steps.begin(), end, places)) return point.link;
    }
    return {};
}

std::optional<OutputDyad> dyad_at(const LinkageModel& model, std::size_t step, std::size_t lever) {
    const Step& s = model.order.steps[step];
    const bool circles = s.first.kind == Locus::Kind::circle && s.second.kind == Locus::Kind::circle;
    if (s.kind != Step::Kind::dyad || !circles || s.is_extended()) return {};
    if (s.first.link != lever && s.second.link != lever) return {};
    OutputDyad dyad;
    dyad.step = step;
    dyad.choice = s.choice;
    dyad.counts_from_rod = s.second.link == lever;
    const Locus &of_lever = dyad.counts_from_rod ? s.second : s.first,
                &of_rod = dyad.counts_from_rod ? s.first : s.second;
    dyad.lever = lever;
    dyad.rod = of_rod.link;
    dyad.outer = of_rod.centre;
    dyad.inner = s.pin;
    dyad.pivot = of_lever.centre;
    const auto carrier = carrier_of(model, dyad.pivot, lever, step);
    if (!carrier) return {};
    dyad.carrier = *carrier;
    return dyad;
}

/// Of a rod that leads a slide on a link that is there before.
std::optional<OutputDyad> slide_at(const LinkageModel& model, std::size_t step, std::size_t slide) {
    const Step& s = model.order.steps[step];
    if (s.kind != Step::Kind::dyad || s.is_extended() || s.first.kind != Locus::Kind::circle) return {};
    const linkage::Slide& of = model.structure.slides[slide];
    if (s.second.kind != Locus::Kind::line || s.second.link != of.link || s.second.tie.joint != slide ||
        s.second.tie.kind != linkage::Tie::Kind::slides)
        return {};
    OutputDyad dyad;
    dyad.step = step;
    dyad.choice = s.choice;
    dyad.rod = s.first.link;
    dyad.lever = of.link;
    dyad.outer = s.first.centre;
    dyad.inner = s.pin;
    dyad.carrier = of.line.on;
    dyad.slide = slide;
    return dyad;
}

template <class T>
std::optional<KnownPlaces<T>> placed(const LinkageModel& model, const OutputDyad& dyad, std::span<const T> dimensions,
                                     std::size_t scales, std::size_t assembly, std::span<const Vector<double>> points,
                                     std::span<const linkage::DriveLawIn<T>> laws) {
    linkage::Order before = model.order;
    before.steps.resize(dyad.step);
    const std::vector<T> numbers = numbers_of(model, dimensions);
    linkage::Driven<T> moving(model.structure, before, std::span<const T>(numbers), model.sides[assembly], laws);
    KnownPlaces<T> known;
    for (const Vector<double>& point : points) {
        const T input = dimensions[scales] + dimensions[scales + 1] * T(point.x);
        if (!moving.place(input / T(model.input_length))) return {};
        const linkage::LinkPlace<T>& carrier = moving.pose.links[dyad.carrier];
        const Vector<T> back = linkage::detail::conjugate(carrier.along);
        const T output = T(dyad.sense) * dimensions[scales + 3] * T(point.y);
        known.outer.push_back(turned(moving.pose.pins[dyad.outer] - carrier.origin, back));
        if (dyad.slides())
            known.ways.push_back(output);
        else
            known.turns.push_back(turned(unit_at(output), back));
    }
    return known;
}

}  // namespace

std::optional<OutputDyad> output_dyad(const LinkageModel& model) {
    if (model.over_input.size() != 1 || model.over_input.front().followed != Followed::nothing) return {};
    const linkage::Signal& output = model.signals[model.over_input.front().of];
    const bool slides = output.kind == linkage::Signal::Kind::slide;
    if (!slides && (output.kind != linkage::Signal::Kind::angle || (output.to != 0 && output.of != 0))) return {};
    const std::size_t lever = output.of != 0 ? output.of : output.to;
    const auto& steps = model.order.steps;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (steps[i].kind == Step::Kind::together) return {};
        auto dyad = slides ? slide_at(model, i, output.of) : dyad_at(model, i, lever);
        if (!dyad) continue;
        dyad->sense = slides || output.of != 0 ? 1 : -1;
        return dyad;
    }
    return {};
}

std::optional<KnownPlaces<double>> known_places(const LinkageModel& model, const OutputDyad& dyad,
                                                std::span<const double> dimensions, std::size_t scales,
                                                std::size_t assembly, std::span<const Vector<double>> points) {
    const auto laws = laws_of(model);
    return placed<double>(model, dyad, dimensions, scales, assembly, points, laws);
}

std::optional<KnownPlaces<Digits50>> known_places_again(const LinkageModel& model, const OutputDyad& dyad,
                                                        std::span<const Digits50> dimensions, std::size_t scales,
                                                        std::size_t assembly, std::span<const Vector<double>> points) {
    const auto laws = laws_again_of(model);
    return placed<Digits50>(model, dyad, dimensions, scales, assembly, points, laws);
}

}  // namespace mechwright
