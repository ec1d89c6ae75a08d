#include "synthesis/mechanism/linkage/quantities.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "synthesis/mechanism/linkage/limit_text.h"
#include "synthesis/mechanism/linkage/measured_by_series.h"

namespace mechwright {

namespace measuring {

ComponentsOfKind components_of(Kind kind) {
    switch (kind) {
        case Kind::mean:
        case Kind::rms:
        case Kind::at:
        case Kind::extent:
        case Kind::function_rms:
        case Kind::turned_width:
        case Kind::turned_area:
        case Kind::swept_area:
        case Kind::uncovered:
        case Kind::total_length: return {1, Reduce::only};
        case Kind::function_greatest: return {most_errors, Reduce::greatest};
        case Kind::time_ratio: return {2, Reduce::greatest};
        case Kind::sampled: return {most_samples, Reduce::greatest};
        case Kind::deviation: return {most_of_deviation * most_of_deviation, Reduce::greatest};
        case Kind::range:
        case Kind::room_width:
        case Kind::room_height:
        case Kind::link_ratio: return {most_of_range * most_of_range, Reduce::greatest};
        case Kind::room_area: return {most_of_area * most_of_area * most_of_area * most_of_area, Reduce::greatest};
        case Kind::greatest:
        case Kind::distance_greatest: return {most_extremes, Reduce::greatest};
        default: return {most_extremes, Reduce::least};
    }
}

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool is_defined(const Motion& motion) {
    const LinkageMeasure& m = *static_cast<const LinkageMeasure*>(motion.of);
    const LinkageModel& model = linkage_of(motion.model);
    if (m.kind == Kind::time_ratio) return motion.full_turn;
    // Nor where nothing comes back to where it was, as on a rack.
    if (m.kind == Kind::full_turn_margin) return !model.driven_by_slide() && !model.has_stops() && model.turns > 0;
    // Not known before the design is.
    if (m.kind == Kind::assembly_margin) return motion.full_turn || motion.from <= motion.to;
    return true;
}

std::size_t components(const Motion& motion) {
    return components_of(static_cast<const LinkageMeasure*>(motion.of)->kind).count;
}

void measure(const Over& over, std::span<const double> arguments, const Measurement& out) {
    const Kind kind = over.measure.kind;
    const bool full_turn = over.motion.full_turn;
    std::size_t order = over.measure.signals.empty() ? 2 : linkage::order_for(over.measure.signals, over.measure.asked);
    if (is_of_parts(kind)) order = is_of_turned_box(kind) || is_of_swept_area(kind) ? order_of_slopes : order_of_places;
    // A time ratio needs one derivative more for its second ones; what is given where it is, needs none.
    if (kind == Kind::time_ratio) ++order;
    // What divides is looked at for zeros, at its extremes.
    const bool of_values =
        full_turn && (kind == Kind::mean || kind == Kind::rms || kind == Kind::at || kind == Kind::sampled);
    const auto divides = [](std::size_t) { return true; };
    const auto is_divided = [&] {
        return linkage::any_divisor(over.measure.signals, over.measure.asked.signal, divides) ||
               linkage::any_curvature(over.measure.signals, over.measure.asked.signal, divides);
    };
    if (of_values && !is_divided()) order -= 2;
    const bool could = order == 0   ? measure_by_series<0>(over, arguments, out)
                       : order <= 2 ? measure_by_series<2>(over, arguments, out)
                       : order <= 4 ? measure_by_series<4>(over, arguments, out)
                                    : measure_by_series<7>(over, arguments, out);
    if (could) return;
    for (const std::span<double>& numbers : {out.value, out.gradient, out.hessian})
        std::fill(numbers.begin(), numbers.end(), not_a_number);
}

void measure_over_motion(const Motion& motion, std::span<const double> dimensions, const Measurement& out) {
    measure(Over(motion), dimensions, out);
}

void measure_over_input(const Motion& motion, std::span<const double> arguments, const Measurement& out) {
    const std::size_t own = Over(motion, true).dimensions_of(arguments).size();
    const double start = arguments[own], end = start + arguments[own + 1];
    const double unit = linkage_of(motion.model).unit_of_input();
    Motion over = motion;
    over.full_turn = false;
    over.from = unit * std::min(start, end);
    over.to = unit * std::max(start, end);
    measure(Over(over, true), arguments, out);
}

}  // namespace

}  // namespace measuring

Unit unit_of(const LinkageModel& model, const LinkageMeasure& measure) {
    const Unit unit = model.signal_names[measure.asked.signal].unit;
    if (measure.kind == LinkageMeasure::Kind::time_ratio) return Unit::none;
    const bool by_nothing = unit != Unit::angle && !model.driven_by_slide();
    return measure.asked.derivative == 0 || by_nothing ? unit : Unit::none;
}

Quantity linkage_quantity(std::string name, Unit unit, std::string meaning, LinkageMeasure of, std::size_t dimensions) {
    Quantity quantity;
    quantity.name = std::move(name);
    quantity.unit = unit;
    quantity.meaning = std::move(meaning);
    quantity.reduce = measuring::components_of(of.kind).reduce;
    quantity.reads = Reads(dimensions);
    quantity.defined = measuring::is_defined;
    quantity.components = measuring::components;
    quantity.measure = measuring::measure_over_motion;
    quantity.worst_first = measuring::components_of(of.kind).count > 1;
    using Kind = LinkageMeasure::Kind;
    quantity.of_motion =
        of.kind != Kind::total_length && of.kind != Kind::link_ratio && of.kind != Kind::full_turn_margin;
    quantity.of = Model(std::move(of));
    return quantity;
}

std::string nearest_limit_of_linkage(const Motion& motion, std::span<const double> dimensions) {
    const LinkageMeasure measure{LinkageMeasure::Kind::assembly_margin};
    Motion over_motion = motion;
    over_motion.of = &measure;
    const measuring::Over over(over_motion);
    auto plain = measuring::measured<double, 2>(over, dimensions, {});
    const auto places = linkage::margin_places(plain, over.driven(dimensions), over.travel());
    const auto least = std::min_element(places.begin(), places.end(), [](const auto& a, const auto& b) {
        return measuring::is_less(a.place.value, b.place.value);
    });
    const LinkageModel& model = over.model;
    return least == places.end() ? "the linkage assembles"
                                 : "the linkage comes near to " +
                                       limit_text(model.order, least->margin, model.links, model.pins, model.slides);
}

Quantity over_input(Quantity quantity) {
    quantity.measure = measuring::measure_over_input;
    quantity.defined = [](const Motion& motion) {
        return static_cast<const LinkageMeasure*>(motion.of)->kind != LinkageMeasure::Kind::time_ratio;
    };
    return quantity;
}

}  // namespace mechwright
