#include "synthesis/mechanism/linkage/drawing/drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "synthesis/mechanism/drawing/moving_design.h"
#include "synthesis/mechanism/linkage/drawing/drawn_rooms.h"

namespace mechwright {

namespace {

const LinkageModel& model_of(const MovingDesign& design) { return linkage_of(design.motion.model); }

/// Calls `take` with poses of the linkage spread over its motion.
template <class Take>
void over_motion(const MovingDesign& design, const Take& take) {
    const LinkageModel& model = model_of(design);
    linkage::Driven<double> linkage = driven(model, design.dimensions, design.motion.assembly);
    const Motion& motion = design.motion;
    const int samples = 360 * (motion.full_turn ? std::max(1, model.turns) : 1);
    for (int i = 0; i <= samples; ++i)
        if (place_within(linkage, motion, motion.from + (motion.to - motion.from) * i / samples)) take(linkage.pose);
}

std::vector<double> numbers_of(const MovingDesign& design) {
    return numbers_of(model_of(design), std::span<const double>(design.dimensions));
}

/// The shape of a design of these numbers, with all that its slides and pins in slots pass.
LinkageShape shape_of(const MovingDesign& design, std::span<const double> numbers) {
    const LinkageModel& model = model_of(design);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    LinkageShape shape{.structure = model.structure,
                       .numbers = numbers,
                       .links = model.links,
                       .pins = model.pins,
                       .scale = placement_of(model, design.dimensions).scale,
                       .first_body = driven_link(model),
                       .slides = {model.structure.slides.size(), Extent{infinity, -infinity}},
                       .slots = {model.structure.slots.size(), Extent{infinity, -infinity}},
                       .arcs = {model.structure.circular.size(), Extent{infinity, -infinity}}};
    if (shape.slides.empty() && shape.slots.empty() && shape.arcs.empty()) return shape;
    std::vector<double> directions(shape.arcs.size(), 0);
    const auto widen = [](Extent& stretch, double at) {
        stretch = {std::min(stretch.from, at), std::max(stretch.to, at)};
    };
    over_motion(design, [&](const linkage::Pose<double>& pose) {
        for (std::size_t i = 0; i < shape.slides.size(); ++i)
            widen(shape.slides[i], slide_displacement(shape, i, pose));
        for (std::size_t i = 0; i < shape.slots.size(); ++i)
            widen(shape.slots[i], slot_displacement(shape, i, pose));
        for (std::size_t i = 0; i < shape.arcs.size(); ++i) {
            directions[i] = arc_direction(shape, i, pose, directions[i]);
            widen(shape.arcs[i], directions[i]);
        }
    });
    for (std::vector<Extent>* stretches : {&shape.slides, &shape.slots, &shape.arcs})
        for (Extent& stretch : *stretches)
            if (!(stretch.from <= stretch.to)) stretch = {};
    return shape;
}

std::vector<Body> bodies(const MovingDesign& design, double symbol, double) {
    const std::vector<double> numbers = numbers_of(design);
    const LinkageShape shape = shape_of(design, numbers);
    std::vector<Body> made(shape.links.size() - 1);
    for (std::size_t link = 1; link < shape.links.size(); ++link)
        made[body_of(shape.first_body, link)] = link_body(shape, link, symbol);
    // A guided point that is a joint is among the pins only.
    for (const GuidedPoint& guided : model_of(design).guided) {
        std::vector<Vector<double>>& points = made[body_of(shape.first_body, guided.link)].points;
        const Vector<double> at = shape.at(coordinates_on(shape.structure.pins[guided.pin], guided.link));
        const auto is_it = [&](const Vector<double>& p) { return p.x == at.x && p.y == at.y; };
        if (std::none_of(points.begin(), points.end(), is_it)) points.push_back(at);
    }
    // Points of the ground that bodies guide are in the drawing.
    const LinkagePlacement placement = placement_of(model_of(design), design.dimensions);
    for (Body& body : made)
        for (Guide& guide : body.guides)
            if (guide.body == the_ground)
                for (Vector<double>& point : guide.points)
                    point = in_drawing(placement.frame, point);
    return made;
}

/// The frame, in the drawing.
Body ground(const MovingDesign& design, double symbol) {
    const std::vector<double> numbers = numbers_of(design);
    Body body = link_body(shape_of(design, numbers), 0, symbol);
    const BodyPlace frame = placement_of(model_of(design), design.dimensions).frame;
    const auto put = [&frame](Vector<double>& at) { at = in_drawing(frame, at); };
    for (Outline& outline : body.outlines)
        for (ArcVertex& vertex : outline.vertices)
            put(vertex.at);
    for (Vector<double>& pin : body.pins)
        put(pin);
    for (Label& label : body.labels)
        put(label.at);
    for (Guide& guide : body.guides)
        put(guide.from), put(guide.to);
    return body;
}

bool place(const MovingDesign& design, double crank_angle, std::size_t assembly, std::span<BodyPlace> places) {
    const LinkageModel& model = model_of(design);
    linkage::Driven<double> linkage = driven(model, design.dimensions, assembly);
    const bool closes = place_within(linkage, design.motion, crank_angle);
    const LinkagePlacement placement = placement_of(model, design.dimensions);
    const std::size_t first = driven_link(model);
    for (std::size_t link = 1; link < model.links.size(); ++link) {
        const linkage::LinkPlace<double>& at = linkage.pose.links[link];
        places[body_of(first, link)] = {placement.in_drawing(at.origin), turned(at.along, placement.frame.turn)};
    }
    return closes;
}

/// Where the pins of the frame are.
std::vector<Vector<double>> pivots(const MovingDesign& design) { return ground(design, 0).pins; }

std::vector<double> limits(const MovingDesign& design) {
    return design.motion.full_turn ? std::vector<double>{} : ends_of(design.motion);
}

}  // namespace

std::size_t driven_link(const LinkageModel& model) {
    const linkage::Drive& drive = model.structure.drives.front();
    if (!drive.of_slide) return drive.link != 0 ? drive.link : drive.on;
    const linkage::Slide& slide = model.structure.slides[drive.slide];
    return slide.link != 0 ? slide.link : slide.line.on;
}

bool place_within(linkage::Driven<double>& linkage, const Motion& motion, double master) {
    const LinkageModel& model = linkage_of(motion.model);
    if (linkage.place(model.input_of(master))) return true;
    if (motion.full_turn) return false;
    const double span = motion.to - motion.from, inwards = master < 0.5 * (motion.from + motion.to) ? 1 : -1;
    for (double share = 1e-15; share <= 1e-6; share *= 10)
        if (linkage.place(model.input_of(master + inwards * share * span))) return true;
    return false;
}

Drawing linkage_drawing() { return {bodies, place, pivots, limits, ground, nullptr, draw_rooms}; }

}  // namespace mechwright
