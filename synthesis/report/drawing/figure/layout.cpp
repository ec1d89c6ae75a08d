#include "synthesis/report/drawing/figure/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "synthesis/mechanism/drawing/outlines.h"
#include "synthesis/problem/text.h"
#include "synthesis/report/drawing/figure/places.h"

namespace mechwright {

namespace {

constexpr double figure_fineness = 1e-4, panel_border = 10, label_size = 13;
constexpr double beyond_line = 5, beyond_arc = 14, axis_length = 44;

FinishedDesign figure_finished(const FigurePanel& panel) {
    FinishedDesign design;
    static_cast<MovingDesign&>(design) = panel.design;
    if (design.motion.followed != Followed::nothing) design.followed = FollowedTarget{design.motion.followed, false};
    return design;
}

/// Without what guided points describe, unless the panel is to show it.
void place_scene(const FigurePanel& panel, PanelLayout& layout) {
    if (!panel.shows_bodies) return;
    const FinishedDesign design = figure_finished(panel);
    layout.scene = scene_of(design, figure_fineness);
    if (!panel.shows_paths)
        std::erase_if(layout.scene.fixed, [](const Outline& outline) { return outline.layer == Layer::path; });
    // Points have the letters of the panel.
    layout.scene.ground.labels.clear();
    for (Body& body : layout.scene.bodies)
        body.labels.clear();
    const std::size_t assembly = design.motion.assembly;
    layout.places.resize(layout.scene.bodies.size());
    place_bodies(design, panel.input, assembly, layout.places);
    if (!panel.end) return;
    layout.end_places.resize(layout.scene.bodies.size());
    place_bodies(design, *panel.end, assembly, layout.end_places);
}

/// What lies between two corners.
struct PixelReach {
    Vector<double> low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Vector<double> high{-low.x, -low.y};

    void add(const Vector<double>& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    void add(const TextBox& box) {
        const Vector<double> half{0.5 * box.width, 0.5 * box.height};
        add(box.middle - half);
        add(box.middle + half);
    }
    Vector<double> size() const { return high - low; }
};

/// Lays out at one scale.
class Layouter {
public:
    Layouter(const FigurePanel& panel, PanelLayout& layout)
        : panel_(panel), layout_(layout), posed_{panel, layout.scene, layout.places, layout.end_places} {
        layout_.dimensions.clear();
        layout_.texts.clear();
        layout_.lines.clear();
    }

    /// What it needs, in pixels.
    PixelReach lay_out() {
        add_lines();
        add_strokes();
        for (const FigureDimension& dimension : panel_.dimensions)
            layout_.dimensions.push_back(drawn(dimension));
        for (DrawnDimension& dimension : layout_.dimensions)
            add_label(dimension);
        for (const FigurePlace& place : panel_.places)
            if (place.is_shown) add_letter(place);
        for (const FigureLine& line : panel_.lines)
            if (!line.name.empty())
                add_text(line.name, "link-name", round(px(line.outline.vertices.back().at), 4, line.name));
        if (panel_.names_links) add_link_names();
        for (const TextBox& box : labels_.placed)
            reach_.add(box);
        return reach_;
    }

private:
    Vector<double> px(const Vector<double>& p) const { return layout_.view.pixels(p); }
    /// A direction of the drawing in the picture.
    static Vector<double> shown(const Vector<double>& direction) { return {direction.x, -direction.y}; }

    void add_lines() {
        for (const FigureLine& line : panel_.lines)
            layout_.lines.push_back(line.outline);
        const bool has_origin = std::any_of(panel_.places.begin(), panel_.places.end(), [](const FigurePlace& place) {
            return place.name == "O" && place.of == PlaceOf::fixed && place.body.empty() &&
                   dot(place.at, place.at) == 0;
        });
        if (!has_origin || !panel_.shows_bodies) return;
        for (const Vector<double>& axis : {Vector<double>{1, 0}, {0, 1}}) {
            layout_.lines.push_back(outlines::arrow({0, 0}, axis, axis_length / layout_.view.scale, Layer::ground));
            const std::string name = axis.x > 0 ? "x" : "y";
            add_text(name, "link-name", round(px({0, 0}) + (axis_length + 2) * shown(axis), 2, name));
        }
    }

    void add(const Vector<double>& from, const Vector<double>& to, double weight) {
        labels_.strokes.push_back({from, to, weight});
        reach_.add(from);
        reach_.add(to);
    }

    void add_outlines(const std::vector<Outline>& outlines, const BodyPlace& place, double weight) {
        for (const Outline& outline : outlines)
            for (const Stroke& stroke : strokes_of(outline, place, layout_.view))
                add(stroke.from, stroke.to, outline.layer == Layer::path ? 0.4 * weight : weight);
    }

    void add_strokes() {
        constexpr double faint = 0.4, pin = 6;
        const Scene& scene = layout_.scene;
        add_outlines(scene.fixed, {}, 1);
        add_outlines(layout_.lines, {}, 1);
        for (const Vector<double>& pivot : scene.pivots) {
            const Vector<double> at = px(pivot);
            for (const double height : {4.0, 9.0, 14.0, 18.0})
                add(at + Vector<double>{-0.7 * height, height}, at + Vector<double>{0.7 * height, height}, 1);
        }
        const auto add_bodies = [&](std::span<const BodyPlace> places, double weight) {
            for (std::size_t b = 0; b < places.size(); ++b) {
                add_outlines(scene.bodies[b].outlines, places[b], weight);
                for (const auto& list : {scene.bodies[b].pins, scene.bodies[b].points})
                    for (const Vector<double>& own : list) {
                        const Vector<double> at = px(in_drawing(places[b], own));
                        for (const double side : {-0.6, 0.0, 0.6})
                            add(at + pin * Vector<double>{-0.8, side}, at + pin * Vector<double>{0.8, side},
                                2 * weight);
                    }
            }
        };
        add_bodies(layout_.end_places, faint);
        add_bodies(layout_.places, 1);
    }

    DrawnDimension drawn(const FigureDimension& dimension) {
        DrawnDimension d{.of = dimension};
        const Vector<double> from = px(posed_.at(dimension.from));
        if (dimension.as == ShownAs::word) return d;
        const Vector<double> direction = posed_.direction(dimension.along);
        if (dimension.as == ShownAs::angle) {
            set_arc(d, from, direction);
            return d;
        }
        const Vector<double> to = px(posed_.at(dimension.to));
        d.along = shown(direction);
        const Vector<double> left = shown(left_of(direction));
        const Vector<double> by = dimension.by.empty() ? from : px(posed_.at(dimension.by));
        d.from = from + (dot(by - from, left) + dimension.away) * left;
        d.to = d.from + dot(to - from, d.along) * d.along;
        const auto witness = [&](const Vector<double>& at, const Vector<double>& end) {
            const Vector<double> way = end - at;
            const double length = std::hypot(way.x, way.y);
            if (length > beyond_line) d.thin.push_back({at, end + (beyond_line / length) * way});
        };
        witness(from, d.from);
        witness(to, d.to);
        add(d.from, d.to, 1);
        for (const Stroke& stroke : d.thin)
            add(stroke.from, stroke.to, 0.6);
        return d;
    }

    void set_arc(DrawnDimension& d, const Vector<double>& vertex, const Vector<double>& zero) {
        const Vector<double> side = posed_.direction(d.of.side);
        const double value = panel_.design[d.of.name], turn = 2 * std::numbers::pi;
        const double measured = std::atan2(cross(zero, side), dot(zero, side));
        d.arc = {vertex, d.of.away, std::atan2(zero.y, zero.x),
                 measured + turn * std::round((value - measured) / turn)};
        d.from = d.arc.at(d.arc.zero);
        d.to = d.arc.at(d.arc.zero + d.arc.turn);
        d.zero.push_back({vertex, vertex + (d.of.away + beyond_arc) * shown(zero)});
        d.thin.push_back({vertex, vertex + (d.of.away + beyond_line) * shown(side)});
        add(d.zero[0].from, d.zero[0].to, 0.8);
        add(d.thin[0].from, d.thin[0].to, 0.4);
        constexpr int parts = 24;
        for (int i = 0; i < parts; ++i)
            add(d.arc.at(d.arc.zero + d.arc.turn * i / parts), d.arc.at(d.arc.zero + d.arc.turn * (i + 1) / parts), 1);
    }

    void add_label(DrawnDimension& d) {
        const TextBox box = text_box(d.of.name, "dimension-name", label_size);
        std::vector<Vector<double>> places;
        if (d.of.as == ShownAs::word)
            places = round(px(posed_.at(d.of.from)), 8, d.of.name);
        else if (d.of.as == ShownAs::angle)
            places = beside_arc(d.arc, box);
        else
            places = Labels::beside_line(d.from, d.to, box);
        d.label = labels_.place(box, places);
    }

    static std::vector<Vector<double>> beside_arc(const FigureArc& arc, const TextBox& box) {
        std::vector<Vector<double>> places;
        for (const double far : {0.0, 8.0, 18.0})
            for (const double part : {0.5, 0.35, 0.65, 0.2, 0.8, 0.05, 0.95, -0.15, 1.15})
                for (const double outwards : {1.0, -1.0}) {
                    const Vector<double> on = arc.at(arc.zero + part * arc.turn);
                    const Vector<double> radial = (1 / arc.radius) * (on - arc.vertex);
                    places.push_back(on + outwards * (Labels::clearance(radial, box) + far) * radial);
                }
        return places;
    }

    /// Round a place, near ones first.
    static std::vector<Vector<double>> round(const Vector<double>& at, double radius, const std::string& text) {
        const TextBox box = text_box(text, "", label_size);
        std::vector<Vector<double>> places;
        constexpr int directions = 16;
        for (const double far : {0.0, 6.0, 12.0, 20.0, 30.0})
            for (int i = 0; i < directions; ++i) {
                const double angle = std::numbers::pi * (0.75 + 2.0 * i / directions);
                const Vector<double> out{std::cos(angle), -std::sin(angle)};
                places.push_back(at + (radius + far + Labels::clearance(out, box)) * out);
            }
        return places;
    }

    void add_text(const std::string& text, std::string_view kind, const std::vector<Vector<double>>& places) {
        layout_.texts.push_back(labels_.place(text_box(text, kind, label_size), places));
    }

    void add_letter(const FigurePlace& place) {
        add_text(place.name, "letter", round(px(posed_.at(place)), 4, place.name));
    }

    void add_link_names() {
        const Scene& scene = layout_.scene;
        for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
            const Body& body = scene.bodies[b];
            const bool is_dimension = std::any_of(panel_.dimensions.begin(), panel_.dimensions.end(),
                                                  [&](const auto& d) { return d.name == body.name; });
            if (body.name.empty() || is_dimension) continue;
            const auto at = [&](const Vector<double>& own) { return px(in_drawing(layout_.places[b], own)); };
            if (body.pins.size() > 1)
                add_text(body.name, "link-name",
                         Labels::beside_line(at(body.pins[0]), at(body.pins[1]), text_box(body.name, "", label_size)));
            else
                add_text(body.name, "link-name",
                         round(at(body.pins.empty() ? Vector<double>{} : body.pins[0]), 10, body.name));
        }
    }

    const FigurePanel& panel_;
    PanelLayout& layout_;
    PosedPanel posed_;
    Labels labels_;
    PixelReach reach_;
};

/// All that is drawn, without dimensions.
PixelReach drawn_reach(const FigurePanel& panel, const PanelLayout& layout) {
    PixelReach reach;
    const auto add = [&](const std::vector<Outline>& outlines, const BodyPlace& place) {
        for (const Outline& outline : outlines)
            for (const ArcVertex& v : outline.vertices)
                reach.add(in_drawing(place, v.at));
    };
    add(layout.scene.fixed, {});
    for (const FigureLine& line : panel.lines)
        add({line.outline}, {});
    for (const auto& places : {layout.places, layout.end_places})
        for (std::size_t b = 0; b < places.size(); ++b)
            add(layout.scene.bodies[b].outlines, places[b]);
    const PosedPanel posed{panel, layout.scene, layout.places, layout.end_places};
    for (const FigurePlace& place : panel.places)
        reach.add(posed.at(place));
    return reach;
}

constexpr double most_share = 0.9;  ///< of a panel's height, over its width

bool is_too_large(const Vector<double>& size, double width) {
    return size.x > width - 2 * panel_border || size.y > most_share * width;
}

}  // namespace

PanelLayout lay_out(const FigurePanel& panel, double width) {
    constexpr double shrinks = 0.94;
    constexpr int most_steps = 40;
    PanelLayout layout;
    layout.title = folded_text(panel.title, width - 2 * panel_border);
    layout.remark = folded_text(panel.remark, width - 2 * panel_border);
    place_scene(panel, layout);
    const Vector<double> wanted = drawn_reach(panel, layout).size();
    layout.view = {
        std::min(width / std::max(wanted.x, 1e-9), most_share * width / std::max(wanted.y, 1e-9)), {}, width, 0};
    PixelReach reach = Layouter(panel, layout).lay_out();
    // Texts do not shrink: where they alone are wider than the picture there is an end to it.
    for (int i = 0; i < most_steps && is_too_large(reach.size(), width); ++i) {
        layout.view.scale *= shrinks;
        reach = Layouter(panel, layout).lay_out();
    }
    const double top = panel_border + figure_line_height * static_cast<double>(layout.title.size());
    layout.view.origin = {0.5 * width - 0.5 * (reach.low.x + reach.high.x), top - reach.low.y};
    Layouter(panel, layout).lay_out();
    layout.view.height = top + reach.size().y + panel_border;
    layout.height = layout.view.height + figure_line_height * static_cast<double>(layout.remark.size());
    return layout;
}

}  // namespace mechwright
