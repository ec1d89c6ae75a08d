#include "synthesis/mechanism/linkage/dwell.h"

#include <algorithm>
#include <cmath>

#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/mechanism/linkage/targets/found_places.h"

namespace mechwright {

namespace {

using measuring::Over;

const LinkageMeasure& measure_of_dwell(const Quantity& quantity) { return *quantity.of.as<LinkageMeasure>(); }

template <std::size_t K>
std::vector<DwellExtreme> extremes_by_series(const Over& over, std::span<const double> dimensions,
                                             const Vector<double>& stretch) {
    const LinkageMeasure& m = over.measure;
    auto plain = measuring::measured<double, K>(over, dimensions, m.signals);
    const measuring::Course course = measuring::course_of(over, dimensions, plain, m.signals);
    if (measuring::needs_turns(over, m.signals)) {
        if (course.turns.empty() || course.turns.to() < course.travel.to) return {};
        plain.start_at(course);
    }
    std::vector<DwellExtreme> all;
    for (const linkage::Extreme& place : linkage::extremes(plain, m.asked, course, stretch.x, stretch.y)) {
        if (std::isnan(place.value) || place.limit.exists()) return {};
        all.push_back({over.model.of_motion(place.at), place.value});
    }
    return all;
}

/// Another measure of the same signal.
Quantity with_measure(const Quantity& quantity, LinkageMeasure measure) {
    Quantity made = quantity;
    made.of = Model(std::move(measure));
    made.reduce = Reduce::only;
    made.worst_first = false;
    return made;
}

}  // namespace

bool is_of_dwell(const Quantity& quantity) {
    const LinkageMeasure* measure = quantity.of.as<LinkageMeasure>();
    return measure != nullptr && measure->kind == LinkageMeasure::Kind::deviation;
}

Vector<double> dwell_stretch(const Quantity& quantity, const Motion& motion) {
    const Motion own = motion_for(quantity, motion);
    const Over over(own);
    const linkage::Travel travel = over.travel();
    const LinkageModel& model = over.model;
    if (!over.measure.stretch) return {model.of_motion(travel.from), model.of_motion(travel.to)};
    const auto stretch = measuring::stretch_in(over, *over.measure.stretch);
    if (!stretch) return {0, 0};
    return {model.of_motion((*stretch)[0]), model.of_motion((*stretch)[1])};
}

std::vector<DwellExtreme> dwell_extremes(const Quantity& quantity, const Motion& motion,
                                         std::span<const double> dimensions) {
    if (!(motion.from <= motion.to)) return {};
    const Motion own = motion_for(quantity, motion);
    const Over over(own);
    if (!over.measure.stretch && !motion.full_turn) return {};
    const Vector<double> stretch = dwell_stretch(quantity, motion);
    if (!(stretch.x < stretch.y) || !measuring::closes_at_samples(over, dimensions)) return {};
    const Vector<double> inputs{over.model.input_of(stretch.x), over.model.input_of(stretch.y)};
    const std::size_t order = linkage::order_for(over.measure.signals, over.measure.asked);
    return order <= 2   ? extremes_by_series<2>(over, dimensions, inputs)
           : order <= 4 ? extremes_by_series<4>(over, dimensions, inputs)
                        : extremes_by_series<7>(over, dimensions, inputs);
}

Quantity dwell_samples(const Quantity& quantity) {
    LinkageMeasure samples = measure_of_dwell(quantity);
    samples.kind = LinkageMeasure::Kind::sampled;
    return with_measure(quantity, std::move(samples));
}

Quantity dwell_at(const Quantity& quantity, double input) {
    LinkageMeasure at = measure_of_dwell(quantity);
    at.kind = LinkageMeasure::Kind::at;
    at.input = input;
    at.stretch.reset();
    return with_measure(quantity, std::move(at));
}

}  // namespace mechwright
