#include "synthesis/report/drawing/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "analysis/numbers/scalar.h"
#include "synthesis/mechanism/drawing/outlines.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/target/followed/draw.h"

namespace mechwright {

namespace {

constexpr int samples_of_motion = 360;

const Drawing& drawing_of(const FinishedDesign& design) {
    const std::optional<Drawing>& drawing = design.mechanism->drawing;
    if (!drawing) throw std::logic_error("nothing says how a " + design.mechanism->name + " is drawn");
    return *drawing;
}

struct Box {
    Vector<double> low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Vector<double> high{-low.x, -low.y};

    void add(const Vector<double>& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    double extent() const { return std::max(high.x - low.x, high.y - low.y); }
};

double angle_at(const Motion& motion, int i) { return motion.from + (motion.to - motion.from) * i / samples_of_motion; }

/// Hands out the places of the bodies at crank angles spread over the motion.
template <class Take>
void over_motion(const FinishedDesign& design, std::size_t bodies, const Take& take) {
    std::vector<BodyPlace> places(bodies);
    for (int i = 0; i <= samples_of_motion; ++i)
        if (place_bodies(design, angle_at(design.motion, i), design.motion.assembly, places))
            take(std::span<const BodyPlace>(places));
}

/// What the bodies pass, with pivots, what else is fixed, and targets.
Box passed(const FinishedDesign& design, const std::vector<Body>& bodies, const std::vector<Vector<double>>& pivots,
           const Body& ground) {
    Box box;
    for (const Vector<double>& pivot : pivots)
        box.add(pivot);
    for (const Outline& outline : ground.outlines)
        for (const ArcVertex& v : outline.vertices)
            box.add(v.at);
    for (const TargetPlace& target : design.targets)
        box.add(target.at);
    over_motion(design, bodies.size(), [&](std::span<const BodyPlace> places) {
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            for (const Vector<double>& pin : bodies[b].pins)
                box.add(in_drawing(places[b], pin));
            for (const Outline& outline : bodies[b].outlines)
                for (const ArcVertex& v : outline.vertices)
                    box.add(in_drawing(places[b], v.at));
        }
    });
    return box;
}

/// The line on which a ram slides, as far as it goes.
void add_slide(const FinishedDesign& design, Scene& scene) {
    if (drawing_of(design).ground != nullptr || scene.bodies.back().name != "ram") return;
    double from = std::numeric_limits<double>::infinity(), to = -from;
    BodyPlace line;
    over_motion(design, scene.bodies.size(), [&](std::span<const BodyPlace> places) {
        line = places.back();
        const double along = dot(line.at, line.turn);
        from = std::min(from, along);
        to = std::max(to, along);
    });
    if (!(from <= to)) return;
    const double here = dot(line.at, line.turn), beyond = 3 * scene.symbol;
    const auto at = [&](double along) {
        return line.at + (along - here) * line.turn - scene.symbol * left_of(line.turn);
    };
    scene.fixed.push_back(outlines::segment(at(from - beyond), at(to + beyond), Layer::ground));
}

/// What guided points describe over the motion.
void add_paths(const FinishedDesign& design, double tolerance, Scene& scene) {
    const Motion& motion = design.motion;
    // In quarters of a turn at least, so that no arc closes on itself.
    const int pieces =
        4 * std::max(1, static_cast<int>(std::lround((motion.to - motion.from) / (2 * std::numbers::pi))));
    const auto piece_end = [&](int i) { return motion.from + (motion.to - motion.from) * i / pieces; };
    std::vector<BodyPlace> places(scene.bodies.size());
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        for (const Vector<double>& point : scene.bodies[b].points) {
            const auto curve = [&](double crank_angle) {
                place_bodies(design, crank_angle, motion.assembly, places);
                return in_drawing(places[b], point);
            };
            Outline path{Layer::path, {}, motion.full_turn};
            for (int i = 0; i < pieces; ++i)
                fit_arcs(curve, piece_end(i), piece_end(i + 1), tolerance, path.vertices);
            if (!path.closed) path.vertices.push_back({curve(motion.to), 0});
            scene.fixed.push_back(std::move(path));
        }
}

}  // namespace

std::string_view name_of(Layer layer) {
    switch (layer) {
        case Layer::ground: return "ground";
        case Layer::link: return "link";
        case Layer::block: return "block";
        case Layer::cam: return "cam";
        case Layer::pitch: return "pitch";
        case Layer::base: return "base";
        case Layer::path: return "path";
        case Layer::follow: return "follow";
        case Layer::room: return "room";
    }
    return "";
}

bool place_bodies(const FinishedDesign& design, double crank_angle, std::size_t assembly, std::span<BodyPlace> places) {
    return drawing_of(design).place(design, crank_angle, assembly, places);
}

std::vector<double> limit_angles(const FinishedDesign& design) { return drawing_of(design).limits(design); }

std::optional<Vector<double>> guided_point(const FinishedDesign& design, const Scene& scene, double crank_angle) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        if (scene.bodies[b].points.empty()) continue;
        std::vector<BodyPlace> places(scene.bodies.size());
        place_bodies(design, crank_angle, design.motion.assembly, places);
        return in_drawing(places[b], scene.bodies[b].points.front());
    }
    return std::nullopt;
}

Scene scene_of(const FinishedDesign& design, double fineness) {
    const Drawing& drawing = drawing_of(design);
    constexpr double symbol_share = 0.018, coarse = 1e-3;
    Scene scene;
    scene.pivots = drawing.pivots(design);
    const auto ground = [&](double symbol) {
        Body body = drawing.ground == nullptr ? Body{} : drawing.ground(design, symbol);
        if (drawing.rooms != nullptr) drawing.rooms(design, body);
        return body;
    };
    // Symbols are sized by the drawing without them.
    const Box bare =
        passed(design, drawing.bodies(design, 0, coarse * longest_length(*design.mechanism, design.dimensions)),
               scene.pivots, ground(0));
    const double extent = bare.extent() > 0 ? bare.extent() : 1;
    scene.symbol = symbol_share * extent;
    scene.bodies = drawing.bodies(design, scene.symbol, fineness * extent);
    scene.ground = ground(scene.symbol);
    const Box box = passed(design, scene.bodies, scene.pivots, scene.ground);
    scene.low = box.low;
    scene.high = box.high;
    scene.fixed = std::exchange(scene.ground.outlines, {});
    add_paths(design, fineness * extent, scene);
    add_slide(design, scene);
    add_followed(design, scene);
    return scene;
}

}  // namespace mechwright
