#include "synthesis/report/drawing/linkage_sheets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "synthesis/mechanism/drawing/outlines.h"
#include "synthesis/mechanism/linkage/drawing/link_bodies.h"
#include "synthesis/problem/linkage/larger_groups.h"
#include "synthesis/problem/linkage/sides.h"
#include "synthesis/problem/text.h"
#include "synthesis/report/drawing/svg.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

/// One picture among others, with lines of text beneath.
struct LinkagePanel {
    Scene scene;
    std::vector<BodyPlace> places;
    std::vector<std::string> lines;
};

constexpr double sheet_symbol = 0.03, line_height = 15, least_panel = 260;
constexpr double shown_arc = 0.35;  ///< to either side of the pin of a circular slot

/// All panels in as many columns as there is room for, in one scale.
std::string sheet(const std::string& title, const std::vector<LinkagePanel>& panels, double width) {
    const auto count = static_cast<double>(panels.size());
    const double columns = std::clamp(std::floor(width / least_panel), 1.0, std::max(1.0, std::ceil(std::sqrt(count))));
    const double panel_width = width / columns;
    Scene all;
    std::size_t most_lines = 0;
    int letters = 1;
    for (const LinkagePanel& panel : panels) {
        const Vector<double> wanted = panel.scene.high - panel.scene.low;
        all.high = {std::max(all.high.x, wanted.x), std::max(all.high.y, wanted.y)};
        most_lines = std::max(most_lines, panel.lines.size());
        for (const std::string& line : panel.lines)
            letters = std::max(letters, reading::count_characters(line));
    }
    if (!(all.extent() > 0)) all.high = {1, 1};
    const SvgView common = view_of(all, panel_width, panel_width);
    const double letter_size = std::min(12.0, 1.6 * (panel_width - 20) / letters);
    const double panel_height = common.height + line_height * (static_cast<double>(most_lines) + 1);
    std::string text;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const LinkagePanel& panel = panels[i];
        const double column = std::fmod(static_cast<double>(i), columns);
        const double row = std::floor(static_cast<double>(i) / columns);
        SvgView view = common;
        const Vector<double> middle = 0.5 * (panel.scene.low + panel.scene.high);
        view.origin = {0.5 * panel_width - view.scale * middle.x, 0.5 * common.height + view.scale * middle.y};
        text += fmt::format("<g class=\"panel\" transform=\"translate({:.2f} {:.2f})\">", column * panel_width,
                            row * panel_height);
        text += svg_fixed(panel.scene, view) + svg_bodies(panel.scene, view, panel.places);
        for (std::size_t k = 0; k < panel.lines.size(); ++k)
            text += fmt::format("<text x=\"10\" y=\"{:.2f}\" font-size=\"{:.2f}\">{}</text>",
                                common.height + line_height * (static_cast<double>(k) + 0.6), letter_size,
                                escaped(panel.lines[k]));
        text += "</g>\n";
    }
    return svg_file(title, width, panel_height * std::ceil(count / columns), text);
}

struct Reach {
    Vector<double> low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Vector<double> high{-low.x, -low.y};

    void add(const Vector<double>& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    void add(const std::vector<Outline>& outlines, const BodyPlace& place) {
        for (const Outline& outline : outlines)
            for (const ArcVertex& v : outline.vertices)
                add(in_drawing(place, v.at));
    }
};

double size_of(const LinkageShape& shape) {
    const double size = shape.scale * linkage::farthest_point(shape.structure, shape.numbers);
    return size > 0 ? size : 1;
}

/// A linkage as it is drawn standing still: a slot reaches a little to either side of its pin.
LinkageShape shape_at(const Linkage& l, std::span<const double> numbers, const linkage::Pose<double>& pose) {
    LinkageShape shape{.structure = l.structure, .numbers = numbers, .links = l.links, .pins = l.pins};
    const double reach = 0.15 * size_of(shape);
    for (std::size_t i = 0; i < l.structure.slides.size(); ++i) {
        const double at = slide_displacement(shape, i, pose);
        shape.slides.push_back({at - reach, at + reach});
    }
    for (std::size_t i = 0; i < l.structure.slots.size(); ++i) {
        const double at = slot_displacement(shape, i, pose);
        const double room = is_redundant(l, l.structure.slots[i].line.on) ? 0 : reach;
        shape.slots.push_back({at - room, at + room});
    }
    for (std::size_t i = 0; i < l.structure.circular.size(); ++i) {
        const double at = arc_direction(shape, i, pose);
        shape.arcs.push_back({at - shown_arc, at + shown_arc});
    }
    return shape;
}

/// The bodies of a pose, the frame fixed.
LinkagePanel posed(const Linkage& l, const LinkageShape& shape, const linkage::Pose<double>& pose) {
    LinkagePanel panel;
    panel.scene.symbol = sheet_symbol * 2 * size_of(shape);
    panel.scene.ground = link_body(shape, 0, panel.scene.symbol);
    panel.scene.fixed = std::move(panel.scene.ground.outlines);
    panel.scene.pivots = panel.scene.ground.pins;
    Reach box;
    box.add(panel.scene.fixed, {});
    for (const Vector<double>& pivot : panel.scene.pivots)
        box.add(pivot);
    for (std::size_t link = 1; link < l.links.size(); ++link) {
        panel.scene.bodies.push_back(link_body(shape, link, panel.scene.symbol));
        panel.places.push_back({pose.links[link].origin, pose.links[link].along});
        box.add(panel.scene.bodies.back().outlines, panel.places.back());
    }
    panel.scene.low = box.low;
    panel.scene.high = box.high;
    return panel;
}

std::string input_text(const Linkage& l, double master) {
    const bool slide = l.structure.drives.front().of_slide;
    return fmt::format("{} {}", slide ? "displacement" : "crank angle",
                       number_text(slide || !l.units.degrees ? master : master * 180 / std::numbers::pi));
}

/// What a line of the file goes through where nothing says how far.
Extent nominal(const LinkageShape& shape, const linkage::Line& line) {
    if (line.by_angle) return {-0.2 * size_of(shape), 0.2 * size_of(shape)};
    const Vector<double> along = shape.at(line.towards) - shape.at(line.through);
    return {0, std::hypot(along.x, along.y)};
}

LinkageShape shape_apart(const Linkage& l, std::span<const double> numbers) {
    LinkageShape shape{.structure = l.structure, .numbers = numbers, .links = l.links, .pins = l.pins};
    for (const linkage::Slide& slide : l.structure.slides)
        shape.slides.push_back(nominal(shape, slide.line));
    for (const linkage::Slot& slot : l.structure.slots) {
        shape.slots.push_back(nominal(shape, slot.line));
        if (is_redundant(l, slot.line.on)) shape.slots.back().from = shape.slots.back().to;
    }
    shape.arcs.assign(l.structure.circular.size(), {-shown_arc, shown_arc});
    return shape;
}

/// A link in its own frame; all its points have their names, and stand below with their places.
LinkagePanel apart(const Linkage& l, const LinkageShape& shape, std::size_t link, double symbol) {
    LinkagePanel panel;
    Body body = link_body(shape, link, symbol);
    body.labels.clear();
    panel.lines = {l.links[link]};
    const auto add = [&](std::size_t pin, const Vector<double>& at) {
        constexpr std::size_t longest = 40;
        body.labels.push_back({l.pins[pin], at});
        const std::string place = fmt::format("{} ({}, {})", l.pins[pin], number_text(at.x, 6), number_text(at.y, 6));
        if (panel.lines.size() > 1 && panel.lines.back().size() + place.size() < longest)
            panel.lines.back() += ", " + place;
        else
            panel.lines.push_back(place);
    };
    for (std::size_t i = 0; i < l.pins.size(); ++i)
        if (is_on(l.structure.pins[i], link)) add(i, shape.at(coordinates_on(l.structure.pins[i], link)));
    for (std::size_t i = 0; i < l.structure.slots.size(); ++i)
        if (const linkage::Slot& slot = l.structure.slots[i]; slot.line.on == link && is_redundant(l, link))
            add(slot.pin, slot_line(shape, i).at(shape.slots[i].to));
    panel.scene.symbol = symbol;
    panel.scene.fixed = {outlines::arrow({}, {1, 0}, 4 * symbol, Layer::ground),
                         outlines::arrow({}, {0, 1}, 4 * symbol, Layer::ground)};
    Reach box;
    box.add(panel.scene.fixed, {});
    box.add(body.outlines, {});
    for (const Label& label : body.labels)
        box.add(label.at);
    panel.scene.low = box.low;
    panel.scene.high = box.high;
    if (link == 0) {
        panel.scene.fixed.insert(panel.scene.fixed.end(), body.outlines.begin(), body.outlines.end());
        panel.scene.pivots = body.pins;
        panel.scene.ground.labels = body.labels;
    } else {
        panel.scene.bodies = {std::move(body)};
        panel.places = {{}};
    }
    return panel;
}

}  // namespace

std::vector<std::string> assembly_block(const Linkage& linkage, const LinkageAssembly& assembly, std::size_t number) {
    std::vector<std::string> lines{fmt::format("# {}{}", number, assembly.as_in_file ? ", as in the file" : "")};
    for (const linkage::Group* group : chosen_dyads(linkage))
        lines.push_back(assembly_line(linkage, *group, assembly.sides[group->choice]));
    for (std::size_t i = 0; i < assembly.larger.size(); ++i)
        lines.push_back(larger_line(linkage, i, assembly.larger[i]));
    return lines;
}

std::string assemblies_picture(const Linkage& linkage, std::span<const LinkageAssembly> assemblies, double master,
                               double width) {
    constexpr std::size_t most = 64;
    const std::vector<double> numbers = numbers_of(linkage, usual_dimensions(linkage));
    std::vector<LinkagePanel> panels;
    for (std::size_t i = 0; i < std::min(most, assemblies.size()); ++i) {
        const linkage::Pose<double>& pose = assemblies[i].pose;
        panels.push_back(posed(linkage, shape_at(linkage, numbers, pose), pose));
        panels.back().lines = assembly_block(linkage, assemblies[i], i + 1);
    }
    std::string title = fmt::format("{}{}assemblies at the {}: {}", linkage.title, linkage.title.empty() ? "" : ", ",
                                    input_text(linkage, master), assemblies.size());
    if (assemblies.size() > most) title += fmt::format(", of which the first {}", most);
    return sheet(title, panels, width);
}

bool has_skeleton(const Linkage& linkage) {
    const linkage::Structure& s = linkage.structure;
    const auto known = [&](const linkage::Coordinates& at) {
        return at.first < linkage.numbers.size() && at.second < linkage.numbers.size();
    };
    const auto known_line = [&](const linkage::Line& line) {
        return line.on < s.links && known(line.through) &&
               (line.by_angle ? line.angle < linkage.numbers.size() : known(line.towards));
    };
    const auto all = [](const auto& list, const auto& holds) { return std::all_of(list.begin(), list.end(), holds); };
    const std::vector<double> numbers = numbers_of(linkage, usual_dimensions(linkage));
    return s.links > 1 && linkage.links.size() == s.links && linkage.pins.size() == s.pins.size() &&
           all(numbers, [](double number) { return std::abs(number) < 1e100; }) &&
           all(s.pins,
               [&](const linkage::Pin& pin) {
                   return all(pin.points, [&](const auto& p) { return p.link < s.links && known(p.at); });
               }) &&
           all(s.slides,
               [&](const linkage::Slide& slide) {
                   return slide.link < s.links && known_line(slide.line) && known({slide.angle, slide.offset});
               }) &&
           all(s.slots, [&](const linkage::Slot& slot) { return slot.pin < s.pins.size() && known_line(slot.line); }) &&
           all(s.gears,
               [&](const linkage::Gear& gear) {
                   return known({gear.ratio, gear.phase});
               }) &&
           all(s.racks, [&](const linkage::Rack& rack) {
               return rack.slide < s.slides.size() && known({rack.radius, rack.phase});
           });
}

std::string skeleton_picture(const Linkage& linkage, double width) {
    const std::vector<double> numbers = numbers_of(linkage, usual_dimensions(linkage));
    const LinkageShape shape = shape_apart(linkage, numbers);
    const double symbol = sheet_symbol * size_of(shape);
    std::vector<LinkagePanel> panels;
    const auto& circular = linkage.structure.circular;
    for (std::size_t link = 0; link < linkage.links.size(); ++link)
        if (std::none_of(circular.begin(), circular.end(), [&](const auto& slot) { return slot.link == link; }))
            panels.push_back(apart(linkage, shape, link, symbol));
    return sheet(linkage.title.empty() ? std::string("links") : linkage.title + ", links", panels, width);
}

}  // namespace mechwright
