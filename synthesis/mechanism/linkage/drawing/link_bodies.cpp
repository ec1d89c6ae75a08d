#include "synthesis/mechanism/linkage/drawing/link_bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "synthesis/mechanism/drawing/outlines.h"

namespace mechwright {

namespace {

using linkage::LinkPlace;

Vector<double> unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

Vector<double> conjugate(const Vector<double>& a) { return {a.x, -a.y}; }

double distance(const Vector<double>& a, const Vector<double>& b) { return std::hypot(b.x - a.x, b.y - a.y); }

bool before(const Vector<double>& a, const Vector<double>& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// The convex hull against the clock (Andrew's monotone chain), without corners in line: two points where all are in
/// one line, one where all are one.
std::vector<Vector<double>> hull_of(std::vector<Vector<double>> points) {
    std::sort(points.begin(), points.end(), before);
    if (points.size() < 2) return points;
    const double size = distance(points.front(), points.back());
    std::vector<Vector<double>> hull;
    const auto add_chain = [&](auto from, auto to) {
        const std::size_t start = hull.size();
        for (auto p = from; p != to; ++p) {
            while (hull.size() >= start + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 1e-9 * size * size)
                hull.pop_back();
            if (hull.size() == start || distance(hull.back(), *p) > 1e-9 * size) hull.push_back(*p);
        }
        hull.pop_back();
    };
    add_chain(points.begin(), points.end());
    add_chain(points.rbegin(), points.rend());
    return hull.empty() ? std::vector{points.front()} : hull;
}

/// The place of a pin that two links share, on the first and on the second of them.
struct SharedPin {
    Vector<double> on_first, on_second;
};

std::optional<SharedPin> shared_pin(const LinkageShape& shape, std::size_t first, std::size_t second) {
    for (const linkage::Pin& pin : shape.structure.pins)
        if (is_on(pin, first) && is_on(pin, second))
            return SharedPin{shape.at(coordinates_on(pin, first)), shape.at(coordinates_on(pin, second))};
    return std::nullopt;
}

bool in_a_slot(const LinkageShape& shape, std::size_t pin) {
    const auto& slots = shape.structure.slots;
    return std::any_of(slots.begin(), slots.end(), [pin](const linkage::Slot& slot) { return slot.pin == pin; });
}

/// A vector of the link that has a slide's line, in the frame of the link that slides.
Vector<double> seen_from_slider(const LinkageShape& shape, const linkage::Slide& slide, const Vector<double>& vector) {
    return turned(vector, conjugate(unit(shape.numbers[slide.angle])));
}

bool is_circular(const LinkageShape& shape, std::size_t link) {
    const auto& all = shape.structure.circular;
    return std::any_of(all.begin(), all.end(), [link](const linkage::CircularSlot& slot) { return slot.link == link; });
}

/// A link that moves of those that have a pin and are seen, else the frame.
std::size_t bearer_of(const LinkageShape& shape, const linkage::Pin& pin) {
    for (const linkage::Point& point : pin.points)
        if (point.link != 0 && !is_circular(shape, point.link)) return point.link;
    return 0;
}

double arc_radius(const LinkageShape& shape, std::size_t slot) {
    const linkage::CircularSlot& s = shape.structure.circular[slot];
    return distance({}, shape.at(coordinates_on(shape.structure.pins[s.pin], s.link)));
}

/// What is drawn of a link, one after the other.
struct LinkDrawing {
    const LinkageShape& shape;
    std::size_t link;
    double symbol;
    Body body{};
    std::vector<Vector<double>> corners{};  ///< what the plate reaches

    Layer layer(Layer moving) const { return link == 0 ? Layer::ground : moving; }

    void add_points() {
        for (std::size_t i = 0; i < shape.structure.pins.size(); ++i) {
            const linkage::Pin& pin = shape.structure.pins[i];
            if (!is_on(pin, link)) continue;
            const Vector<double> at = shape.at(coordinates_on(pin, link));
            const auto seen = std::count_if(pin.points.begin(), pin.points.end(), [&](const linkage::Point& point) {
                return !is_circular(shape, point.link);
            });
            // The middle of a circular slot is nothing to be seen.
            if (is_middle(i) && seen == 1) continue;
            const bool joint = pin.points.size() > 1 || in_a_slot(shape, i);
            if (joint || link != 0) (joint ? body.pins : body.points).push_back(at);
            corners.push_back(at);
            if (link == bearer_of(shape, pin)) body.labels.push_back({shape.pins[i], at});
        }
    }

    /// Of a slot whose pin stays where it is there is only the pin: that of a link too many, which fits.
    void add_slots() {
        constexpr double still = 1e-9;
        for (std::size_t i = 0; i < shape.structure.slots.size(); ++i) {
            const linkage::Slot& slot = shape.structure.slots[i];
            if (slot.line.on != link) continue;
            const Extent& passed = shape.slots[i];
            const GuidingLine line = slot_line(shape, i);
            const Vector<double> from = line.at(passed.from), to = line.at(passed.to);
            if (passed.to - passed.from <= still * std::max(std::abs(passed.from), distance({}, from))) {
                body.pins.push_back(from);
                corners.push_back(from);
                continue;
            }
            add_slot(from, to, line.direction);
            const linkage::Pin& pin = shape.structure.pins[slot.pin];
            const std::size_t bearer = bearer_of(shape, pin);
            body.guides.push_back({line.at(passed.from - 3 * symbol),
                                   line.at(passed.to + 3 * symbol),
                                   body_of(shape.first_body, bearer),
                                   {shape.at(coordinates_on(pin, bearer))}});
        }
    }

    bool is_middle(std::size_t pin) const {
        const auto& all = shape.structure.circular;
        return std::any_of(all.begin(), all.end(),
                           [pin](const linkage::CircularSlot& slot) { return slot.centre == pin; });
    }

    /// As far as their pins go, with what the plate needs about them.
    void add_circular_slots() {
        for (std::size_t i = 0; i < shape.structure.circular.size(); ++i) {
            const linkage::CircularSlot& slot = shape.structure.circular[i];
            if (slot.on != link) continue;
            const Vector<double> centre = shape.at(coordinates_on(shape.structure.pins[slot.centre], link));
            const double half_width = 0.55 * symbol, wall = 0.6 * symbol, radius = arc_radius(shape, i);
            for (Outline& outline : outlines::arc_slot(centre, radius, shape.arcs[i].from, shape.arcs[i].to, half_width,
                                                       layer(Layer::link)))
                body.outlines.push_back(std::move(outline));
            constexpr int places = 24;
            for (int k = 0; k <= places; ++k) {
                const double angle = shape.arcs[i].from + (shape.arcs[i].to - shape.arcs[i].from) * k / places;
                for (const double length : {radius - half_width - wall, radius + half_width + wall})
                    corners.push_back(centre + length * unit(angle));
            }
        }
    }

    /// What stands for a circular slot is seen nowhere, but says the distance of the pin from the centre.
    void add_radius() {
        for (std::size_t i = 0; i < shape.structure.circular.size(); ++i) {
            const linkage::CircularSlot& slot = shape.structure.circular[i];
            if (slot.link != link) continue;
            body.guides.push_back({{},
                                   {arc_radius(shape, i), 0},
                                   body_of(shape.first_body, slot.on),
                                   {shape.at(coordinates_on(shape.structure.pins[slot.centre], slot.on))}});
        }
    }

    void add_slot(const Vector<double>& from, const Vector<double>& to, const Vector<double>& direction) {
        const double half_width = 0.55 * symbol, wall = 0.6 * symbol;
        body.outlines.push_back(outlines::slot(from, to, half_width, layer(Layer::link)));
        const Vector<double> ahead = (half_width + wall) * direction, side = left_of(ahead);
        for (const Vector<double>& corner :
             {from - ahead - side, to + ahead - side, to + ahead + side, from - ahead + side})
            corners.push_back(corner);
    }

    /// Where other links slide on this one: on the ground a line beside the block, else a bar.
    void add_slides() {
        for (std::size_t i = 0; i < shape.structure.slides.size(); ++i) {
            const linkage::Slide& slide = shape.structure.slides[i];
            if (slide.link == link) add_block(slide);
            if (slide.line.on != link) continue;
            const GuidingLine line = slide_line(shape, i);
            const Vector<double> beyond = 3 * symbol * line.direction;
            const double offset = shape.scale * shape.numbers[slide.offset];
            const Vector<double> down = (offset + (link == 0 ? symbol : 0)) * left_of(line.direction);
            const Vector<double> from = line.at(shape.slides[i].from) - beyond - down;
            const Vector<double> to = line.at(shape.slides[i].to) + beyond - down;
            body.outlines.push_back(outlines::segment(from, to, layer(Layer::link)));
            if (link != 0) corners.insert(corners.end(), {from, to});
            add_guide(i, line);
        }
    }

    /// A point of what slides, and one ahead of it on the same line, so that it does not turn.
    void add_guide(std::size_t index, const GuidingLine& line) {
        const linkage::Slide& slide = shape.structure.slides[index];
        const auto& pins = shape.structure.pins;
        const auto pin =
            std::find_if(pins.begin(), pins.end(), [&](const linkage::Pin& one) { return is_on(one, slide.link); });
        const Vector<double> point = pin == pins.end() ? Vector<double>{} : shape.at(coordinates_on(*pin, slide.link));
        const Vector<double> away = turned(point, unit(shape.numbers[slide.angle]));
        const double ahead = 4 * symbol, beyond = 3 * symbol;
        body.guides.push_back({line.at(shape.slides[index].from - beyond) + away,
                               line.at(shape.slides[index].to + ahead + beyond) + away,
                               body_of(shape.first_body, slide.link),
                               {point, point + ahead * seen_from_slider(shape, slide, line.direction)}});
    }

    /// A block at the foot of this link's origin.
    void add_block(const linkage::Slide& slide) {
        const Vector<double> along = seen_from_slider(shape, slide, direction_of(slide.line, shape.numbers));
        const Vector<double> foot = -(shape.scale * shape.numbers[slide.offset]) * left_of(along);
        Outline block = outlines::rectangle(1.6 * symbol, symbol, layer(Layer::block));
        for (ArcVertex& v : block.vertices)
            v.at = foot + turned(v.at, along);
        body.outlines.push_back(std::move(block));
        corners.push_back(foot);
    }

    /// A pitch circle with a mark that turns with it.
    void add_wheel(const Wheel& wheel) {
        body.outlines.push_back(outlines::circle(wheel.centre, wheel.radius, Layer::pitch));
        body.outlines.push_back(
            outlines::segment(wheel.centre, wheel.centre + Vector<double>{wheel.radius, 0}, Layer::pitch));
    }

    void add_wheels() {
        for (const linkage::Gear& gear : shape.structure.gears)
            if (const auto wheels = gear.parallel ? std::nullopt : wheels_of(shape, gear)) {
                if (gear.first == link) add_wheel((*wheels)[0]);
                if (gear.second == link) add_wheel((*wheels)[1]);
                if (gear.belt && gear.carrier == link) add_belt(gear, *wheels);
            }
        for (const linkage::Rack& rack : shape.structure.racks)
            if (const auto drawn = rack_of(shape, rack)) {
                if (rack.wheel == link) add_wheel(drawn->wheel);
                if (shape.structure.slides[rack.slide].link == link)
                    body.outlines.push_back(outlines::segment(drawn->from, drawn->to, Layer::pitch));
            }
    }

    /// The two tangents of the wheels: the outer ones, or of a crossed belt the inner ones.
    void add_belt(const linkage::Gear& gear, const std::array<Wheel, 2>& wheels) {
        const Vector<double> a = shared_pin(shape, gear.first, link)->on_second;
        const Vector<double> b = shared_pin(shape, gear.second, link)->on_second;
        const double d = distance(a, b), crossed = shape.numbers[gear.ratio] < 0 ? -1 : 1;
        const double cosine = (wheels[0].radius - crossed * wheels[1].radius) / d;
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        for (const double side : {sine, -sine}) {
            const Vector<double> normal = turned(Vector<double>{cosine, side}, (1 / d) * (b - a));
            body.outlines.push_back(outlines::segment(a + wheels[0].radius * normal,
                                                      b + crossed * wheels[1].radius * normal, Layer::pitch));
        }
    }

    /// What holds it all together: a bar, or a plate.
    void add_plate() {
        const std::vector<Vector<double>> hull = hull_of(corners);
        if (hull.size() < 2) return;
        Outline plate{Layer::link, {}, hull.size() > 2};
        for (const Vector<double>& corner : hull)
            plate.vertices.push_back({corner, 0});
        body.outlines.insert(body.outlines.begin(), std::move(plate));
    }
};

}  // namespace

GuidingLine slide_line(const LinkageShape& shape, std::size_t slide) {
    const linkage::Slide& s = shape.structure.slides[slide];
    const Vector<double> direction = direction_of(s.line, shape.numbers);
    return {shape.at(s.line.through) + shape.scale * shape.numbers[s.offset] * left_of(direction), direction};
}

GuidingLine slot_line(const LinkageShape& shape, std::size_t slot) {
    const linkage::Line& line = shape.structure.slots[slot].line;
    return {shape.at(line.through), direction_of(line, shape.numbers)};
}

namespace {

/// How far a place is along a line on a link.
double along_line(const LinkageShape& shape, const GuidingLine& line, const LinkPlace<double>& on,
                  const Vector<double>& at) {
    return dot(line.direction, shape.scale * turned(at - on.origin, conjugate(on.along)) - line.through);
}

}  // namespace

double slide_displacement(const LinkageShape& shape, std::size_t slide, const linkage::Pose<double>& pose) {
    const linkage::Slide& s = shape.structure.slides[slide];
    return along_line(shape, slide_line(shape, slide), pose.links[s.line.on], pose.links[s.link].origin);
}

double slot_displacement(const LinkageShape& shape, std::size_t slot, const linkage::Pose<double>& pose) {
    const linkage::Slot& s = shape.structure.slots[slot];
    return along_line(shape, slot_line(shape, slot), pose.links[s.line.on], pose.pins[s.pin]);
}

double arc_direction(const LinkageShape& shape, std::size_t slot, const linkage::Pose<double>& pose, double near) {
    const linkage::CircularSlot& s = shape.structure.circular[slot];
    const Vector<double> own = linkage::place_of(coordinates_on(shape.structure.pins[s.pin], s.link), shape.numbers);
    const Vector<double> seen = turned(turned(own, pose.links[s.link].along), conjugate(pose.links[s.on].along));
    return near + std::remainder(std::atan2(seen.y, seen.x) - near, 2 * std::numbers::pi);
}

std::optional<std::array<Wheel, 2>> wheels_of(const LinkageShape& shape, const linkage::Gear& gear) {
    const auto first = shared_pin(shape, gear.first, gear.carrier);
    const auto second = shared_pin(shape, gear.second, gear.carrier);
    if (!first || !second) return std::nullopt;
    const double d = distance(first->on_second, second->on_second), ratio = shape.numbers[gear.ratio];
    const double by = std::abs(ratio);
    // R1 = abs(ratio) R2, and what is left of these is d.
    const double whole = gear.belt ? (1 + by) / 0.6 : ratio < 0 ? 1 + by : std::abs(by - 1);
    if (!(d > 0) || !(whole > 0)) return std::nullopt;
    return std::array<Wheel, 2>{{{first->on_first, by * d / whole}, {second->on_first, d / whole}}};
}

std::optional<RackWheel> rack_of(const LinkageShape& shape, const linkage::Rack& rack) {
    const linkage::Slide& slide = shape.structure.slides[rack.slide];
    const auto pin = shared_pin(shape, rack.wheel, rack.carrier);
    if (!pin || slide.line.on != rack.carrier) return std::nullopt;
    const double radius = shape.scale * shape.numbers[rack.radius];
    const GuidingLine line = slide_line(shape, rack.slide);
    // A wheel that turns against the clock moves its lowest point along the line's direction.
    const Vector<double> contact = pin->on_second - radius * left_of(line.direction);
    const auto on_rack = [&](double displacement) {
        return seen_from_slider(shape, slide, contact - line.at(displacement));
    };
    const Vector<double> beyond = 0.1 * std::abs(radius) * seen_from_slider(shape, slide, line.direction);
    const Extent& passed = shape.slides[rack.slide];
    return RackWheel{{pin->on_first, std::abs(radius)}, on_rack(passed.to) - beyond, on_rack(passed.from) + beyond};
}

std::size_t body_of(std::size_t first, std::size_t link) {
    if (link == 0) return the_ground;
    return link == first ? 0 : link < first ? link : link - 1;
}

Body link_body(const LinkageShape& shape, std::size_t link, double symbol) {
    LinkDrawing drawing{shape, link, symbol};
    drawing.body.name = shape.links[link];
    if (is_circular(shape, link)) {
        drawing.add_radius();
        return std::move(drawing.body);
    }
    drawing.add_points();
    drawing.add_slots();
    drawing.add_circular_slots();
    drawing.add_slides();
    drawing.add_wheels();
    if (link != 0) drawing.add_plate();
    return std::move(drawing.body);
}

}  // namespace mechwright
