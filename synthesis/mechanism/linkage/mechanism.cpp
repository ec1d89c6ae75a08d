#include "synthesis/mechanism/linkage/mechanism.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/linkage/motion/travel.h"
#include "synthesis/mechanism/linkage/again/again.h"
#include "synthesis/mechanism/linkage/branches.h"
#include "synthesis/mechanism/linkage/clearances.h"
#include "synthesis/mechanism/linkage/drawing/drawing.h"
#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/mechanism/linkage/rooms/room_quantities.h"
#include "synthesis/mechanism/linkage/table.h"
#include "synthesis/mechanism/linkage/targets/followed.h"
#include "synthesis/mechanism/linkage/targets/function.h"
#include "synthesis/mechanism/linkage/targets/guidance.h"

namespace mechwright {

namespace {

// Indices of families; what a slide drives has but one.
constexpr std::size_t full_turn = 0, over_a_range = 1;

/// The travel that holds an input, by whole turns of cyclic inputs.
bool holds(const linkage::Travel& travel, double at, double period) {
    const double shifted = period > 0 ? at + period * std::ceil((travel.from - at) / period) : at;
    return shifted >= travel.from && shifted <= travel.to;
}

/// The one that the file speaks of, else the widest, the first of these.
const linkage::Travel* chosen(const LinkageModel& model, const std::vector<linkage::Travel>& all, double period) {
    if (model.at)
        for (const linkage::Travel& travel : all)
            if (holds(travel, model.input_of(*model.at), period)) return &travel;
    const auto widest = std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
        constexpr double as_wide = 1e-9;
        return (a.to - a.from) * (1 + as_wide) < b.to - b.from;
    });
    return widest == all.end() ? nullptr : &*widest;
}

std::string plural(std::size_t n, std::string_view noun) { return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s"); }

/// What there is of links and joints, the frame included.
std::string describe(Form form, std::span<const double>) {
    const linkage::Structure& s = linkage_of(form.model).structure;
    std::size_t pins = 0;
    for (const linkage::Pin& pin : s.pins)
        pins += pin.points.empty() ? 0 : pin.points.size() - 1;
    const auto loose = static_cast<std::size_t>(
        std::count_if(s.slots.begin(), s.slots.end(), [](const linkage::Slot& slot) { return slot.loose; }));
    const auto parallel = static_cast<std::size_t>(
        std::count_if(s.gears.begin(), s.gears.end(), [](const linkage::Gear& gear) { return gear.parallel; }));
    pins += loose;
    std::string text = fmt::format("{} and {}", plural(s.links, "link"), plural(pins, "pin"));
    const auto add = [&](std::size_t n, std::string_view noun) {
        if (n > 0) text += ", " + plural(n, noun);
    };
    add(s.slides.size(), "slide");
    add(s.slots.size() - loose, "slot");
    add(s.gears.size() - parallel, "gear or belt");
    add(s.racks.size(), "rack");
    return text;
}

double size_of_linkage(Form form, std::span<const double> dimensions) {
    const LinkageModel& model = linkage_of(form.model);
    const double size = size_of(driven(model, dimensions, form.assembly)) * model.scale.at(dimensions);
    return size > 0 ? size : 1;
}

/// Adds quantities to a list, each name once.
struct AddQuantity {
    std::vector<Quantity>& all;
    std::size_t dimensions;

    void operator()(std::string name, Unit unit, std::string meaning, LinkageMeasure measure) const {
        if (std::any_of(all.begin(), all.end(), [&](const Quantity& q) { return q.name == name; })) return;
        all.push_back(linkage_quantity(std::move(name), unit, std::move(meaning), std::move(measure), dimensions));
        all.back().measure_again = measure_linkage_again;
    }
};

std::vector<Quantity> quantities_of(const LinkageModel& model, std::size_t dimensions,
                                    std::span<const NamedMeasure> asked) {
    using Kind = LinkageMeasure::Kind;
    std::vector<Quantity> all;
    const AddQuantity add{all, dimensions};
    if (model.order.has_dyad_margins())
        add("transmission-angle-worst", Unit::angle, "least transmission angle of all dyads, folded at a right angle",
            {Kind::transmission_angle_worst});
    add("total-length", Unit::length, "sum of the distances of links' origins to their pins", {Kind::total_length});
    add("link-ratio", Unit::none, "longest of these distances over the shortest", {Kind::link_ratio});
    if (linkage::closes_by_lengths(model.order) && !model.driven_by_slide() && !model.has_stops())
        add("full-turn-margin", Unit::length, "least length by which a dyad closes over a full turn of the drive",
            {Kind::full_turn_margin});
    add("joint-distance-least", Unit::length, "least distance of pins that have no link in common",
        {Kind::joint_distance_least});
    for (Quantity& quantity : quantities_of_rooms(model, dimensions))
        all.push_back(std::move(quantity));
    for (Quantity& quantity : quantities_of_signals(model, dimensions, 0, asked))
        if (std::none_of(all.begin(), all.end(), [&](const Quantity& q) { return q.name == quantity.name; }))
            all.push_back(std::move(quantity));
    return all;
}

/// What keeps the dyads closed over the motion.
Quantity assembly_margin(std::size_t dimensions) {
    return linkage_quantity("assembly margin", Unit::length, "the linkage assembles",
                            {LinkageMeasure::Kind::assembly_margin}, dimensions);
}

/// What keeps them closed between the targets of a path, and the quantities that know that ends of the motion move.
InputRange input_range(const std::vector<Quantity>& quantities, std::size_t dimensions) {
    InputRange input{Reads(dimensions), over_input(assembly_margin(dimensions))};
    for (const Quantity& quantity : quantities)
        input.quantities.push_back(over_input(quantity));
    return input;
}

bool has_own_lengths(const LinkageModel& model) {
    for (std::size_t i = 0; i < model.numbers.size(); ++i)
        if (model.lengths[i] && model.numbers[i].constant != 0) return true;
    for (const linkage::Drive& drive : model.structure.drives)
        if (drive.of_slide) return true;
    if (!model.regions.empty()) return true;
    return model.placement[0].constant != 0 || model.placement[1].constant != 0;
}

std::vector<Family> families_of(const LinkageModel& model, std::size_t dimensions) {
    const Family over_range{"the drive moves over a range", false, {}, assembly_margin(dimensions)};
    if (model.driven_by_slide()) return {over_range};
    return {{"the drive turns fully", true, {}, assembly_margin(dimensions), std::max(model.turns, 1)}, over_range};
}

void add_target(Mechanism& made, const char* section) {
    if (std::find(made.targets.begin(), made.targets.end(), section) == made.targets.end())
        made.targets.emplace_back(section);
}

void add_guidance(const LinkageModel& model, Mechanism& made) {
    const std::size_t count = made.dimensions.size();
    made.point = linkage_point_guidance(model, count);
    for (const GuidedPoint& guided : model.guided) {
        if (guided.follows) continue;
        add_target(made, guided.is_body ? "poses" : "path");
        if (guided.is_body && !made.body) made.body = linkage_body_guidance(model, guided, count);
        if (guided.name.empty()) continue;
        GuidedTarget& named = made.guided.emplace_back();
        named.name = guided.name;
        named.roles = linkage_path_roles(model, guided);
        if (guided.is_body) named.body = linkage_body_guidance(model, guided, count);
    }
}

/// What it has for functions, lines and arcs.
void add_over_input(const LinkageModel& model, Mechanism& made) {
    const std::size_t count = made.dimensions.size();
    for (std::size_t i = 0; i < model.over_input.size(); ++i) {
        const LinkageInputTarget& target = model.over_input[i];
        const bool is_function = target.followed == Followed::nothing, is_line = target.followed == Followed::line;
        add_target(made, is_function ? "function" : is_line ? "line" : "arc");
        std::optional<FunctionGeneration> function;
        std::optional<FollowedShape> shape;
        if (is_function)
            function = linkage_function(model, i, count);
        else
            shape = linkage_shape(model, i, count);
        if (!target.name.empty())
            made.over_input.push_back({target.name, no_dimension, std::move(function), std::move(shape)});
        else if (is_function)
            made.function = std::move(function);
        else
            (is_line ? made.line : made.arc) = std::move(shape);
    }
}

}  // namespace

std::vector<Quantity> quantities_of_signals(const LinkageModel& model, std::size_t dimensions, std::size_t first,
                                            std::span<const NamedMeasure> asked) {
    using Kind = LinkageMeasure::Kind;
    std::vector<Quantity> all;
    const AddQuantity add{all, dimensions};
    for (std::size_t i = first; i < model.signals.size(); ++i)
        for (const auto& [word, kind] :
             {std::pair("least", Kind::least), {"greatest", Kind::greatest}, {"range", Kind::range}}) {
            const LinkageMeasure measure{kind, model.signals, {i, 0}};
            add(model.signal_names[i].name + "." + word, unit_of(model, measure),
                fmt::format("{} of the signal over the motion",
                            kind == Kind::range ? "greatest less least value" : std::string(word) + " value"),
                measure);
        }
    for (const auto& [name, value] : asked) {
        LinkageMeasure measure = value;
        measure.signals = model.signals;
        if (!measure.signals.empty()) add(name, unit_of(model, measure), "of the signal, as its name says", measure);
    }
    return all;
}

Motion motion_of_linkage(Form form, std::span<const double> dimensions, const double* crank_range) {
    const LinkageModel& model = linkage_of(form.model);
    Motion motion;
    motion.assembly = form.assembly;
    motion.family = model.driven_by_slide() ? 0 : over_a_range;
    motion.full_turn = false;
    if (crank_range != nullptr) {
        motion.from = crank_range[0];
        motion.to = crank_range[1];
        return motion;
    }
    if (model.turns == 0 && !model.has_stops()) {
        motion.from = 1;
        return motion;
    }
    const linkage::Driven<double> moving = driven(model, dimensions, form.assembly);
    const linkage::Inputs inputs = inputs_of(model, dimensions, moving);
    const double period = inputs.cyclic ? inputs.to - inputs.from : 0;
    const auto travels = linkage::travels(moving, inputs);
    const linkage::Travel* travel = chosen(model, travels, period);
    if (travel == nullptr) {
        motion.from = 1;
        return motion;
    }
    motion.full_turn = travel->whole;
    if (travel->whole) motion.family = full_turn;
    motion.from = model.of_motion(travel->from);
    motion.to = model.of_motion(travel->to);
    return motion;
}

bool is_endless(Form form, std::span<const double> dimensions) {
    const LinkageModel& model = linkage_of(form.model);
    const linkage::Inputs inputs = inputs_of(model, dimensions, driven(model, dimensions, form.assembly));
    const Motion motion = motion_of_linkage(form, dimensions, nullptr);
    return model.driven_by_slide() && motion.from <= motion.to &&
           (motion.from == model.of_motion(inputs.from) || motion.to == model.of_motion(inputs.to));
}

Mechanism linkage_mechanism(LinkageModel model, std::vector<Dimension> dimensions,
                            std::span<const NamedMeasure> quantities) {
    Mechanism made;
    made.name = "linkage";
    made.meaning = "links and joints as a file describes them";
    made.dimensions = std::move(dimensions);
    made.quantities = quantities_of(model, made.dimensions.size(), quantities);
    made.families = families_of(model, made.dimensions.size());
    made.table = linkage_table(model);
    if (has_own_lengths(model)) made.model_over = linkage_over_unit;
    for (GuidedPoint& guided : model.guided)
        guided.needed = needed_for_guidance(model, guided);
    if (!model.guided.empty() || !model.over_input.empty())
        made.input = input_range(made.quantities, made.dimensions.size());
    if (!model.guided.empty()) add_guidance(model, made);
    add_over_input(model, made);
    if (auto joints = names_of_joints(model); !joints.empty())
        made.pin_joints = PinJoints{std::move(joints), with_moved_holes};
    made.model = Model(std::move(model));
    made.size = size_of_linkage;
    made.motion = motion_of_linkage;
    made.motion_again = linkage_motion_again;
    made.describe = describe;
    made.circuit = circuit_of_linkage;
    made.nearest_limit = nearest_limit_of_linkage;
    made.check_motion = check_linkage_motion;
    made.drawing = linkage_drawing();
    return made;
}

}  // namespace mechwright
