#include "synthesis/report/drawing/sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "synthesis/mechanism/drawing/outlines.h"

namespace mechwright {

namespace {

// Numbers of SolveSpace's file format (version REVa).
constexpr int line_request = 200;
constexpr int circle_request = 400;
constexpr int arc_request = 500;
constexpr int point_request = 101;
constexpr int points_coincide = 20;
constexpr int distance_of_points = 30;
constexpr int point_on_line = 42;
constexpr int diameter = 90;
constexpr int held = 200;
constexpr unsigned workplane = 0x80020000;
constexpr unsigned first_parameter = 16;
constexpr unsigned radius_parameter = 64;

/// A point of the sketch, by its number in the file.
struct SketchPoint {
    unsigned number;
    Vector<double> at;
};

struct SketchLine {
    unsigned number;
    SketchPoint from, to;
};

/// Text of requests (what is drawn) with their parameters (where), and of constraints.
class SketchText {
public:
    /// Joints too many for almost all lengths may fit, as those of a parallelogram with a third crank.
    explicit SketchText(bool allows_redundant) : allows_redundant_(allows_redundant) {}

    SketchPoint point(const Vector<double>& at) {
        const unsigned request = add_request(point_request, false);
        return parameters(request, 0, at);
    }

    SketchLine line(const Vector<double>& from, const Vector<double>& to, bool construction) {
        const unsigned request = add_request(line_request, construction);
        const SketchPoint a = parameters(request, 0, from), b = parameters(request, 1, to);
        return {request << 16, shifted(a), shifted(b)};
    }

    /// Against the clock from one end to the other, as arcs are there.
    SketchLine arc(const Vector<double>& centre, const Vector<double>& from, const Vector<double>& to) {
        const unsigned request = add_request(arc_request, false);
        parameters(request, 0, centre);
        const SketchPoint a = parameters(request, 1, from), b = parameters(request, 2, to);
        return {request << 16, shifted(a), shifted(b)};
    }

    /// Its centre.
    SketchPoint circle(const Vector<double>& centre, double radius) {
        const unsigned request = add_request(circle_request, false);
        const SketchPoint middle = shifted(parameters(request, 0, centre));
        parameters_ += fmt::format("Param.h.v.={:08x}\nParam.val={:.20f}\nAddParam\n\n",
                                   (request << 16) + radius_parameter, radius);
        constraint(diameter, 2 * radius, 0, 0, request << 16);
        return middle;
    }

    void coincide(const SketchPoint& a, const SketchPoint& b) { constraint(points_coincide, 0, a.number, b.number, 0); }
    void keep_distance(const SketchPoint& a, const SketchPoint& b) {
        const Vector<double> d = b.at - a.at;
        constraint(distance_of_points, std::hypot(d.x, d.y), a.number, b.number, 0);
    }
    void keep_on(const SketchPoint& a, const SketchLine& line) {
        constraint(point_on_line, 0, a.number, 0, line.number);
    }
    void hold(const SketchPoint& a) { constraint(held, 0, a.number, 0, 0); }

    std::string text() const { return head() + parameters_ + requests_ + constraints_; }

private:
    unsigned add_request(int type, bool construction) {
        const unsigned request = next_request_++;
        requests_ += fmt::format(
            "Request.h.v={:08x}\nRequest.type={}\nRequest.workplane.v={:08x}\nRequest.group.v=00000002\n"
            "Request.construction={}\nAddRequest\n\n",
            request, type, workplane, construction ? 1 : 0);
        return request;
    }

    /// The point of a request that has this index among its points.
    SketchPoint parameters(unsigned request, unsigned index, const Vector<double>& at) {
        const unsigned first = (request << 16) + first_parameter + 3 * index;
        parameters_ += fmt::format("Param.h.v.={:08x}\nParam.val={:.20f}\nAddParam\n\n", first, at.x);
        parameters_ += fmt::format("Param.h.v.={:08x}\nParam.val={:.20f}\nAddParam\n\n", first + 1, at.y);
        return {(request << 16) + index, at};
    }

    /// Entity 0 of a line or an arc is itself; its points come after it.
    static SketchPoint shifted(SketchPoint point) {
        ++point.number;
        return point;
    }

    void constraint(int type, double value, unsigned a, unsigned b, unsigned line) {
        constraints_ += fmt::format("Constraint.h.v={:08x}\nConstraint.type={}\nConstraint.group.v=00000002\n",
                                    ++last_constraint_, type);
        constraints_ += fmt::format("Constraint.workplane.v={:08x}\n", workplane);
        if (value != 0) constraints_ += fmt::format("Constraint.valA={:.20f}\n", value);
        if (a != 0) constraints_ += fmt::format("Constraint.ptA.v={:08x}\n", a);
        if (b != 0) constraints_ += fmt::format("Constraint.ptB.v={:08x}\n", b);
        if (line != 0) constraints_ += fmt::format("Constraint.entityA.v={:08x}\n", line);
        constraints_ += "Constraint.other=0\nConstraint.other2=0\nConstraint.reference=0\nAddConstraint\n\n";
    }

    /// The two groups that every file has: the axes with their planes, and a sketch in the xy plane.
    std::string head() const {
        std::string text = "\xB1\xB2\xB3SolveSpaceREVa\n\n\n";
        text +=
            "Group.h.v=00000001\nGroup.type=5000\nGroup.name=#references\nGroup.color=ff000000\nGroup.skipFirst=0\n"
            "Group.predef.swapUV=0\nGroup.predef.negateU=0\nGroup.predef.negateV=0\nGroup.visible=1\nGroup.suppress=0\n"
            "Group.relaxConstraints=0\nGroup.allowRedundant=0\nGroup.allDimsReference=0\nGroup.remap={\n}\n"
            "AddGroup\n\n";
        text +=
            "Group.h.v=00000002\nGroup.type=5001\nGroup.order=1\nGroup.name=mechanism\n"
            "Group.activeWorkplane.v=80020000\nGroup.color=ff000000\nGroup.subtype=6000\nGroup.skipFirst=0\n"
            "Group.predef.q.w=1.00000000000000000000\nGroup.predef.origin.v=00010001\nGroup.predef.swapUV=0\n"
            "Group.predef.negateU=0\nGroup.predef.negateV=0\nGroup.visible=1\nGroup.suppress=0\n"
            "Group.relaxConstraints=0\nGroup.allowRedundant=" +
            std::string(allows_redundant_ ? "1" : "0") +
            "\nGroup.allDimsReference=0\nGroup.remap={\n}\n"
            "AddGroup\n\n";
        // The reference planes: their origins and directions.
        const std::array<std::array<double, 4>, 3> planes{
            {{1, 0, 0, 0}, {0.5, 0.5, 0.5, 0.5}, {0.5, -0.5, -0.5, -0.5}}};
        for (unsigned plane = 0; plane < 3; ++plane) {
            const unsigned base = (plane + 1) << 16;
            for (unsigned k = 0; k < 3; ++k)
                text += fmt::format("Param.h.v.={:08x}\nAddParam\n\n", base + 16 + k);
            for (unsigned k = 0; k < 4; ++k)
                text +=
                    fmt::format("Param.h.v.={:08x}\nParam.val={:.20f}\nAddParam\n\n", base + 32 + k, planes[plane][k]);
        }
        for (unsigned plane = 1; plane <= 3; ++plane)
            text += fmt::format(
                "Request.h.v={:08x}\nRequest.type=100\nRequest.group.v=00000001\nRequest.construction="
                "0\nAddRequest\n\n",
                plane);
        return text;
    }

    bool allows_redundant_;
    std::string parameters_, requests_, constraints_;
    unsigned next_request_ = 4;
    unsigned last_constraint_ = 0;
};

bool same(const Vector<double>& a, const Vector<double>& b, double tolerance) {
    return std::hypot(a.x - b.x, a.y - b.y) <= tolerance;
}

/// What of the bodies is in the sketch already.
struct Joined {
    std::vector<SketchPoint> points;
    std::vector<std::pair<std::string, SketchLine>> arms;  ///< the first line of each body
};

/// Joins a point to those that are at its place; pins of two bodies at one place are one joint.
void join(SketchText& sketch, Joined& joined, const SketchPoint& point, double tolerance) {
    for (const SketchPoint& other : joined.points)
        if (same(other.at, point.at, tolerance)) {
            sketch.coincide(other, point);
            return;
        }
    joined.points.push_back(point);
}

SketchLine add_side(SketchText& sketch, Joined& joined, const Vector<double>& from, const Vector<double>& to,
                    double tolerance) {
    const SketchLine line = sketch.line(from, to, false);
    join(sketch, joined, line.from, tolerance);
    join(sketch, joined, line.to, tolerance);
    sketch.keep_distance(line.from, line.to);
    return line;
}

/// Three corners in line, to within a millionth: the lengths of a flat triangle do not say how it turns, so that it is
/// one line with a point on it.
bool in_line(const std::vector<Vector<double>>& corners) {
    if (corners.size() != 3) return false;
    const Vector<double> a = corners[1] - corners[0], b = corners[2] - corners[0], c = corners[2] - corners[1];
    return std::abs(cross(a, b)) <= 1e-6 * std::max({dot(a, a), dot(b, b), dot(c, c)});
}

void add_flat_link(SketchText& sketch, Joined& joined, const std::string& name, std::vector<Vector<double>> corners,
                   double tolerance) {
    const auto apart = [](const Vector<double>& a, const Vector<double>& b) {
        return std::hypot(b.x - a.x, b.y - a.y);
    };
    // The corner between the other two comes last.
    while (apart(corners[0], corners[1]) < std::max(apart(corners[1], corners[2]), apart(corners[2], corners[0])))
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    const SketchLine line = add_side(sketch, joined, corners[0], corners[1], tolerance);
    joined.arms.emplace_back(name, line);
    if (same(corners[2], corners[0], tolerance) || same(corners[2], corners[1], tolerance)) return;
    const SketchPoint between = sketch.point(corners[2]);
    sketch.keep_on(between, line);
    sketch.keep_distance(between, line.from);
    join(sketch, joined, between, tolerance);
}

/// A body of many points: each is held by its distances from the two that are farthest apart.
void add_plate(SketchText& sketch, Joined& joined, const std::string& name, const std::vector<Vector<double>>& corners,
               double tolerance) {
    const auto square = [](const Vector<double>& a, const Vector<double>& b) { return dot(b - a, b - a); };
    std::size_t first = 0, second = 1;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t k = i + 1; k < corners.size(); ++k)
            if (square(corners[i], corners[k]) > square(corners[first], corners[second])) first = i, second = k;
    const SketchLine line = add_side(sketch, joined, corners[first], corners[second], tolerance);
    joined.arms.emplace_back(name, line);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i == first || i == second) continue;
        if (in_line({corners[first], corners[second], corners[i]})) {
            const SketchPoint between = sketch.point(corners[i]);
            sketch.keep_on(between, line);
            sketch.keep_distance(between, line.from);
            join(sketch, joined, between, tolerance);
        } else {
            add_side(sketch, joined, corners[first], corners[i], tolerance);
            add_side(sketch, joined, corners[second], corners[i], tolerance);
        }
    }
}

/// The corners of a rigid body joined by lines of fixed length.
void add_link(SketchText& sketch, Joined& joined, const std::string& name, const std::vector<Vector<double>>& corners,
              double tolerance) {
    if (corners.size() == 1) return;
    if (corners.size() > 3) return add_plate(sketch, joined, name, corners, tolerance);
    if (in_line(corners)) return add_flat_link(sketch, joined, name, corners, tolerance);
    const std::size_t sides = corners.size() == 2 ? 1 : corners.size();
    for (std::size_t i = 0; i < sides; ++i) {
        const SketchLine line = add_side(sketch, joined, corners[i], corners[(i + 1) % corners.size()], tolerance);
        if (i == 0) joined.arms.emplace_back(name, line);
    }
}

/// Lines and arcs one after the other, their ends joined.
void add_curve(SketchText& sketch, const Outline& outline, const BodyPlace& place) {
    const std::vector<ArcVertex>& v = outline.vertices;
    std::optional<SketchPoint> first, last;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Vector<double> from = in_drawing(place, v[i].at), to = in_drawing(place, v[(i + 1) % v.size()].at);
        const double b = v[i].bulge;
        const Vector<double> chord = to - from;
        SketchPoint start{}, end{};
        if (std::abs(b) < 1e-9) {
            const SketchLine line = sketch.line(from, to, false);
            start = line.from;
            end = line.to;
        } else {
            // The centre lies (1 - b^2) / (4 b) chords to the left of the chord's middle.
            const Vector<double> centre = from + 0.5 * chord + ((1 - b * b) / (4 * b)) * left_of(chord);
            const SketchLine arc = b > 0 ? sketch.arc(centre, from, to) : sketch.arc(centre, to, from);
            start = b > 0 ? arc.from : arc.to;
            end = b > 0 ? arc.to : arc.from;
        }
        if (last) sketch.coincide(*last, start);
        if (!first) first = start;
        last = end;
    }
    if (first && last) sketch.coincide(*last, *first);
}

/// The point of the sketch at a place, made where there is none.
SketchPoint point_at(SketchText& sketch, Joined& joined, const Vector<double>& at, double tolerance) {
    for (const SketchPoint& point : joined.points)
        if (same(point.at, at, tolerance)) return point;
    joined.points.push_back(sketch.point(at));
    return joined.points.back();
}

/// A scene with its bodies where they are.
struct PlacedScene {
    const Scene& scene;
    std::vector<BodyPlace> places;

    BodyPlace place(std::size_t body) const { return body == the_ground ? BodyPlace{} : places[body]; }
    /// Pins and points of a body, and those that guides need: their ends, and what they guide.
    std::vector<Vector<double>> corners(std::size_t b, double tolerance) const {
        const Body& body = scene.bodies[b];
        std::vector<Vector<double>> all;
        const auto add = [&](const Vector<double>& own) {
            const Vector<double> at = in_drawing(places[b], own);
            for (const Vector<double>& other : all)
                if (same(other, at, tolerance)) return;
            all.push_back(at);
        };
        for (const std::vector<Vector<double>>& list : {body.pins, body.points})
            std::for_each(list.begin(), list.end(), add);
        for (const Guide& guide : body.guides)
            add(guide.from), add(guide.to);
        for (const Body& other : scene.bodies)
            for (const Guide& guide : other.guides)
                if (guide.body == b) std::for_each(guide.points.begin(), guide.points.end(), add);
        for (const Guide& guide : scene.ground.guides)
            if (guide.body == b) std::for_each(guide.points.begin(), guide.points.end(), add);
        return all;
    }
};

/// The points that stay on lines of a body, or of the ground.
void add_guides(SketchText& sketch, Joined& joined, const PlacedScene& placed, std::size_t on, double tolerance) {
    const Body& body = on == the_ground ? placed.scene.ground : placed.scene.bodies[on];
    for (const Guide& guide : body.guides) {
        const SketchLine line =
            sketch.line(in_drawing(placed.place(on), guide.from), in_drawing(placed.place(on), guide.to), true);
        for (const SketchPoint& end : {line.from, line.to})
            on == the_ground ? sketch.hold(end) : join(sketch, joined, end, tolerance);
        for (const Vector<double>& own : guide.points) {
            const SketchPoint point = point_at(sketch, joined, in_drawing(placed.place(guide.body), own), tolerance);
            if (guide.body == the_ground) sketch.hold(point);
            sketch.keep_on(point, line);
        }
    }
}

/// Wheels, which turn about the joint at their middle.
void add_wheels(SketchText& sketch, Joined& joined, const std::vector<Outline>& drawn, const BodyPlace& place,
                double tolerance) {
    for (const Outline& outline : drawn)
        if (const auto radius = outline.layer == Layer::pitch ? outlines::radius_of(outline) : std::nullopt) {
            const Vector<double> middle = 0.5 * (outline.vertices[0].at + outline.vertices[2].at);
            join(sketch, joined, sketch.circle(in_drawing(place, middle), *radius), tolerance);
        }
}

/// The line of a ram, and the arm on which a block stays.
void add_ram_and_block(SketchText& sketch, const Joined& joined, const PlacedScene& placed, double tolerance) {
    const auto pin_of = [&](const std::string& name) -> std::optional<SketchPoint> {
        for (std::size_t b = 0; b < placed.places.size(); ++b)
            if (placed.scene.bodies[b].name == name)
                for (const SketchPoint& point : joined.points)
                    if (same(point.at, placed.places[b].at, tolerance)) return point;
        return std::nullopt;
    };
    if (const auto ram = pin_of("ram")) {
        const BodyPlace& slide = placed.places.back();
        const double reach = 0.2 * placed.scene.extent();
        const SketchLine line = sketch.line(slide.at - reach * slide.turn, slide.at + reach * slide.turn, true);
        sketch.hold(line.from);
        sketch.hold(line.to);
        sketch.keep_on(*ram, line);
    }
    if (const auto block = pin_of("block"))
        for (const auto& [name, arm] : joined.arms)
            if (name == "lever" || name == "arm") sketch.keep_on(*block, arm);
}

}  // namespace

std::string sketch_of(const FinishedDesign& design, const Scene& scene, double crank_angle) {
    PlacedScene placed{scene, std::vector<BodyPlace>(scene.bodies.size())};
    place_bodies(design, crank_angle, design.motion.assembly, placed.places);
    const double tolerance = 1e-9 * scene.extent();
    const bool says_its_guides = design.mechanism->drawing->ground != nullptr;
    SketchText sketch(says_its_guides);
    Joined joined;
    for (const Vector<double>& pivot : scene.pivots) {
        const SketchPoint point = sketch.point(pivot);
        sketch.hold(point);
        joined.points.push_back(point);
    }
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const Body& body = scene.bodies[b];
        for (const Outline& outline : body.outlines)
            if (outline.layer == Layer::cam) add_curve(sketch, outline, placed.places[b]);
        const std::vector<Vector<double>> corners = placed.corners(b, tolerance);
        if (!corners.empty()) add_link(sketch, joined, body.name, corners, tolerance);
    }
    if (!says_its_guides) {
        add_ram_and_block(sketch, joined, placed, tolerance);
        return sketch.text();
    }
    add_guides(sketch, joined, placed, the_ground, tolerance);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        add_guides(sketch, joined, placed, b, tolerance);
        add_wheels(sketch, joined, scene.bodies[b].outlines, placed.places[b], tolerance);
    }
    add_wheels(sketch, joined, scene.fixed, {}, tolerance);
    return sketch.text();
}

}  // namespace mechwright
