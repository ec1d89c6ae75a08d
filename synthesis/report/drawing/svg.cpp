#include "synthesis/report/drawing/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/problem/text.h"
#include "synthesis/report/drawing/figure/labels.h"

namespace mechwright {

namespace {

constexpr double fineness = 1e-4;  // of curves, over the extent: a tenth of a pixel at most
constexpr double paper_margin = 28;

/// Colours that are told apart in print and by most who are colour-blind.
constexpr std::string_view style_sheet =
    "<style>"
    ".paper{fill:#fff}"
    "text{font-family:sans-serif;fill:#222}"
    "path{fill:none;stroke-linejoin:round;stroke-linecap:round}"
    ".link{stroke:#23415f;stroke-width:4;fill:#23415f;fill-opacity:.12}"
    ".block{stroke:#23415f;stroke-width:2;fill:#c9d6e2}"
    ".cam{stroke:#23415f;stroke-width:2.5;fill:#dde6ee}"
    ".pitch,.base{stroke:#7d8a97;stroke-width:1;stroke-dasharray:6 4}"
    ".ground{stroke:#555;stroke-width:1.5}"
    ".path{stroke:#b8442c;stroke-width:1.6}"
    ".follow{stroke:#1c7a4a;stroke-width:1.2;stroke-dasharray:2 3}"
    ".room{stroke:#6b4c9a;stroke-width:1.4;stroke-dasharray:9 4}"
    ".pin{fill:#fff;stroke:#23415f;stroke-width:2}"
    ".point{fill:#b8442c}"
    ".target{fill:none;stroke:#1c7a4a;stroke-width:1.5}"
    ".error{stroke:#1c7a4a;stroke-width:1}"
    ".ghost{opacity:.22}"
    ".link-name{font-size:13px;font-style:italic;text-anchor:middle;fill:#23415f;stroke:#fff;stroke-width:3;"
    "paint-order:stroke}"
    ".cell{stroke:#555;stroke-width:1}"
    ".name{font-size:13px;fill:#111;stroke:#fff;stroke-width:3;paint-order:stroke}"
    "</style>";

std::string px(double value) {
    // Two places: a hundredth of a pixel. "-0" would depend on the sign of zeros.
    std::string text = fmt::format("{:.2f}", value);
    while (text.ends_with('0'))
        text.pop_back();
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string pair(const Vector<double>& p) { return px(p.x) + ' ' + px(p.y); }

/// A path of the drawing; `to_pixels` turns it upside down, so that arcs to the left go against the clock.
template <class ToPixels>
std::string path_data(const Outline& outline, double scale, const ToPixels& to_pixels) {
    const std::vector<ArcVertex>& v = outline.vertices;
    if (v.empty()) return {};
    std::string data = "M" + pair(to_pixels(v.front().at));
    const std::size_t pieces = outline.closed ? v.size() : v.size() - 1;
    for (std::size_t i = 0; i < pieces; ++i) {
        const Vector<double>& end = v[(i + 1) % v.size()].at;
        const double b = v[i].bulge;
        const Vector<double> chord = end - v[i].at;
        const double length = scale * std::hypot(chord.x, chord.y);
        // An arc that does not leave its chord by a hundredth of a pixel is a line.
        if (std::abs(b) * length < 0.02) {
            data += "L" + pair(to_pixels(end));
            continue;
        }
        const double radius = 0.25 * length * (1 + b * b) / std::abs(b);
        data += fmt::format("A{0} {0} 0 {1} {2} {3}", px(radius), std::abs(b) > 1 ? 1 : 0, b > 0 ? 0 : 1,
                            pair(to_pixels(end)));
    }
    return outline.closed ? data + "Z" : data;
}

std::string path_element(const Outline& outline, const std::string& data) {
    return fmt::format("<path class=\"{}\" d=\"{}\"/>", name_of(outline.layer), data);
}

std::string circle(std::string_view kind, const Vector<double>& at, double radius) {
    return fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>", kind, px(at.x), px(at.y), px(radius));
}

std::string line(std::string_view kind, const Vector<double>& a, const Vector<double>& b) {
    return fmt::format("<path class=\"{}\" d=\"M{}L{}\"/>", kind, pair(a), pair(b));
}

/// A bearing on the ground.
std::string pivot(const Vector<double>& at) {
    return fmt::format(
        "<path class=\"ground\" d=\"M{0} {1}l-9 14h18z m-13 14h26m-1 0l-5 5m-1-5l-5 5m-1-5l-5 5m-1-5l-5 5\"/>",
        px(at.x), px(at.y));
}

constexpr double beside_place = 7, name_size = 13;

/// A name beside a place, upright in a group that is turned.
std::string name_element(const Label& label, const Vector<double>& at, const Vector<double>& turn,
                         double beside = beside_place) {
    return fmt::format(
        "<text class=\"name\" data-x=\"{0}\" data-y=\"{1}\" transform=\"matrix({2:.6g} {3:.6g} {4:.6g} {2:.6g} {0} "
        "{1})\" x=\"{5}\" y=\"-7\">{6}</text>",
        px(at.x), px(at.y), turn.x, turn.y, -turn.y, px(beside), escaped(label.text));
}

/// One body in its own frame, in pixels.
std::string body_elements(const Body& body, double scale, const Vector<double>& turn) {
    const auto local = [&](const Vector<double>& p) { return Vector<double>{scale * p.x, -scale * p.y}; };
    std::string text;
    for (const Outline& outline : body.outlines)
        text += path_element(outline, path_data(outline, scale, local));
    for (const Vector<double>& pin : body.pins)
        text += circle("pin", local(pin), 4);
    for (const Vector<double>& point : body.points)
        text += circle("point", local(point), 4);
    for (const Label& label : body.labels)
        text += name_element(label, local(label.at), turn);
    return text;
}

std::string target_elements(const TargetPlace& target, const SvgView& view) {
    const Vector<double> at = view.pixels(target.at);
    std::string text = circle("target", at, 4.5);
    if (target.reached) text += line("error", at, view.pixels(*target.reached));
    if (target.direction) {
        const Vector<double> facing{std::cos(*target.direction), -std::sin(*target.direction)};
        text += line("target", at, at + 20.0 * facing);
    }
    return text;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '"': result += "&quot;"; break;
            case '\'': result += "&#39;"; break;
            default:
                // Most control characters are no text in XML.
                if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') result += c;
        }
    }
    return result;
}

SvgView view_of(const Scene& scene, double width, double most_height) {
    const double wide = std::max(scene.high.x - scene.low.x, 1e-3 * scene.extent());
    const double high = std::max(scene.high.y - scene.low.y, 1e-3 * scene.extent());
    SvgView view;
    view.width = width;
    view.scale = std::min((width - 2 * paper_margin) / wide, (most_height - 2 * paper_margin) / high);
    view.height = view.scale * high + 2 * paper_margin;
    view.origin = {0.5 * width - view.scale * 0.5 * (scene.low.x + scene.high.x),
                   paper_margin + view.scale * scene.high.y};
    return view;
}

std::string svg_matrix(const SvgView& view, const BodyPlace& place) {
    const Vector<double> at = view.pixels(place.at);
    return fmt::format("matrix({0:.6g} {1:.6g} {2:.6g} {0:.6g} {3} {4})", place.turn.x, -place.turn.y, place.turn.y,
                       px(at.x), px(at.y));
}

std::string svg_fixed(const Scene& scene, const SvgView& view) {
    const auto pixels = [&](const Vector<double>& p) { return view.pixels(p); };
    std::string text;
    for (const Outline& outline : scene.fixed)
        text += path_element(outline, path_data(outline, view.scale, pixels));
    for (const Vector<double>& at : scene.pivots)
        text += pivot(view.pixels(at));
    for (const Label& label : scene.ground.labels) {
        const Vector<double> at = view.pixels(label.at);
        // Names at the right border begin further to the left, so that they are whole.
        const double room = view.width - at.x - text_box(label.text, "", name_size).width;
        text += name_element(label, at, {1, 0}, std::min(beside_place, room));
    }
    return text;
}

std::string svg_fixed(const FinishedDesign& design, const Scene& scene, const SvgView& view) {
    std::string text = svg_fixed(scene, view);
    for (const TargetPlace& target : design.targets)
        text += target_elements(target, view);
    return text;
}

std::string svg_body(const Body& body, const SvgView& view) { return body_elements(body, view.scale, {1, 0}); }

std::string svg_bodies(const Scene& scene, const SvgView& view, std::span<const BodyPlace> places) {
    std::string text;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        text += fmt::format("<g class=\"body\" data-body=\"{}\" transform=\"{}\">{}</g>", escaped(scene.bodies[b].name),
                            svg_matrix(view, places[b]), body_elements(scene.bodies[b], view.scale, places[b].turn));
    return text;
}

std::string svg_bodies(const FinishedDesign& design, const Scene& scene, const SvgView& view, double crank_angle,
                       std::size_t assembly) {
    std::vector<BodyPlace> places(scene.bodies.size());
    place_bodies(design, crank_angle, assembly, places);
    return svg_bodies(scene, view, places);
}

std::string svg_ghosts(const FinishedDesign& design, const Scene& scene, const SvgView& view) {
    Scene bare = scene;  // without cams and names
    for (Body& body : bare.bodies) {
        body.labels.clear();
        if (!body.outlines.empty() && body.outlines.front().layer == Layer::cam) body = {};
    }
    std::string text;
    for (const double angle : limit_angles(design))
        text += "<g class=\"ghost\">" + svg_bodies(design, bare, view, angle, design.motion.assembly) + "</g>";
    return text;
}

double pictured_angle(const FinishedDesign& design) {
    // In the middle of the first quarter no mechanism is in line with itself by habit.
    const Motion& motion = design.motion;
    return motion.from + 0.125 * (motion.to - motion.from);
}

namespace {

constexpr double title_height = 34;

}  // namespace

Vector<double> svg_file_size(double width, double height) { return {width, title_height + height}; }

std::string svg_file(std::string_view title, double width, double height, std::string_view content) {
    // A letter is about half as wide as its size.
    const auto letters = static_cast<double>(std::max(1, reading::count_characters(title)));
    const double letter_size = std::min(16.0, 1.8 * width / letters);
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "role=\"img\"><title>{2}</title>{3}<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>",
        px(width), px(title_height + height), escaped(title), style_sheet);
    text += fmt::format("<text x=\"{}\" y=\"23\" font-size=\"{}\" text-anchor=\"middle\">{}</text>\n", px(0.5 * width),
                        px(letter_size), escaped(title));
    return text + fmt::format("<g transform=\"translate(0 {})\">\n", px(title_height)) + std::string(content) +
           "</g>\n</svg>\n";
}

namespace {

/// The marks that are not farther from the drawing than it is large, for which it is made larger.
std::vector<Label> shown_marks(const std::vector<Label>& marks, Scene& scene) {
    const double room = scene.extent();
    const Vector<double> low = scene.low - Vector<double>{room, room}, high = scene.high + Vector<double>{room, room};
    std::vector<Label> shown;
    for (const Label& mark : marks) {
        if (mark.at.x < low.x || mark.at.x > high.x || mark.at.y < low.y || mark.at.y > high.y) continue;
        shown.push_back(mark);
        scene.low = {std::min(scene.low.x, mark.at.x), std::min(scene.low.y, mark.at.y)};
        scene.high = {std::max(scene.high.x, mark.at.x), std::max(scene.high.y, mark.at.y)};
    }
    return shown;
}

/// Rings, with one name for all that are at one place.
std::string mark_elements(const std::vector<Label>& marks, const SvgView& view) {
    constexpr double one_place = 3;
    std::vector<Label> joined;
    for (const Label& mark : marks) {
        const Vector<double> at = view.pixels(mark.at);
        const auto other = std::find_if(joined.begin(), joined.end(), [&](const Label& one) {
            return std::hypot(one.at.x - at.x, one.at.y - at.y) < one_place;
        });
        if (other == joined.end())
            joined.push_back({mark.text, at});
        else
            other->text += "; " + mark.text;
    }
    std::string text;
    for (const Label& mark : joined)
        text += circle("target", mark.at, 7) + name_element({mark.text, mark.at}, mark.at, {1, 0});
    return text;
}

}  // namespace

namespace {

constexpr double bar_room = 26, row_height = 22;

/// Below the drawing, of a round length.
std::string scale_bar(const SvgView& view, std::string_view unit) {
    constexpr double left = 20, tick = 4, most_of_width = 0.25;
    const double most = most_of_width * view.width / view.scale;
    double length = std::pow(10, std::floor(std::log10(most)));
    for (const double more : {5.0, 2.0})
        if (more * length <= most) {
            length *= more;
            break;
        }
    const double top = view.height + 10, end = left + view.scale * length;
    return fmt::format("<g class=\"scale\"><path class=\"ground\" d=\"M{0} {1}v{2}M{0} {3}H{4}M{4} {1}v{2}\"/>",
                       px(left), px(top - tick), px(2 * tick), px(top), px(end)) +
           fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"12\">{:.6g} {}</text></g>\n", px(end + 6), px(top + 4),
                       length, escaped(unit));
}

/// Cells one beneath the other, each with what it says of something.
std::string title_block(const std::vector<std::string>& rows, double width, double top) {
    constexpr double left = 20;
    std::string text;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double y = top + row_height * static_cast<double>(i);
        text += fmt::format(
            "<path class=\"cell\" d=\"M{0} {1}H{2}v{3}H{0}Z\"/><text x=\"{4}\" y=\"{5}\" font-size=\"12\">{6}"
            "</text>\n",
            px(left), px(y), px(width - left), px(row_height), px(left + 8), px(y + 15), escaped(rows[i]));
    }
    return text;
}

/// The names of links beside them, those of two pins with their lengths.
std::string link_names(const Scene& scene, const SvgView& view, std::span<const BodyPlace> places,
                       const std::vector<Label>& marks) {
    Labels labels;
    const auto add = [&](const std::vector<Outline>& outlines, const BodyPlace& place, double weight) {
        for (const Outline& outline : outlines)
            for (Stroke stroke : strokes_of(outline, place, view)) {
                stroke.weight = weight;
                labels.strokes.push_back(stroke);
            }
    };
    add(scene.fixed, {}, 0.5);
    for (std::size_t b = 0; b < places.size(); ++b)
        add(scene.bodies[b].outlines, places[b], 1);
    const auto keep_clear = [&](const Label& label, const BodyPlace& place) {
        TextBox box = text_box(label.text, "", name_size);
        box.middle =
            view.pixels(in_drawing(place, label.at)) + Vector<double>{7 + 0.5 * box.width, -4 - 0.5 * box.height};
        labels.placed.push_back(std::move(box));
    };
    for (const std::vector<Label>& more : {scene.ground.labels, marks})
        for (const Label& label : more)
            keep_clear(label, {});
    for (std::size_t b = 0; b < places.size(); ++b)
        for (const Label& label : scene.bodies[b].labels)
            keep_clear(label, places[b]);
    std::string text;
    for (std::size_t b = 0; b < places.size(); ++b) {
        const Body& body = scene.bodies[b];
        if (body.name.empty() || body.pins.empty()) continue;
        const auto at = [&](std::size_t pin) { return view.pixels(in_drawing(places[b], body.pins[pin])); };
        std::string name = body.name;
        if (body.pins.size() == 2)
            name +=
                fmt::format(" {:.4g}", std::hypot(body.pins[1].x - body.pins[0].x, body.pins[1].y - body.pins[0].y));
        const Vector<double> from = at(0), to = body.pins.size() > 1 ? at(1) : from + Vector<double>{1, 0};
        const TextBox box = text_box(name, "link-name", 13);
        std::vector<Vector<double>> middles = Labels::beside_line(from, to, box);
        std::erase_if(middles, [&](const Vector<double>& middle) {
            return std::abs(middle.x - 0.5 * view.width) + 0.5 * box.width > 0.5 * view.width - 2;
        });
        if (middles.empty()) continue;
        const TextBox& placed = labels.place(box, middles);
        text += fmt::format("<text class=\"link-name\" x=\"{}\" y=\"{}\">{}</text>", px(placed.middle.x),
                            px(placed.middle.y + 4), escaped(placed.text));
    }
    return text + "\n";
}

}  // namespace

std::string svg_picture(const FinishedDesign& design, const SvgPicture& picture) {
    Scene scene = scene_of(design, fineness);
    const std::vector<Label> marks = shown_marks(picture.marks, scene);
    const SvgView view = view_of(scene, picture.width, picture.width);
    std::string text =
        svg_fixed(design, scene, view) + "\n" + svg_ghosts(design, scene, view) + "\n" +
        svg_bodies(design, scene, view, picture.at.value_or(pictured_angle(design)), design.motion.assembly) +
        mark_elements(marks, view);
    constexpr double least_with_names = 480;
    if (picture.width >= least_with_names) {
        std::vector<BodyPlace> places(scene.bodies.size());
        place_bodies(design, picture.at.value_or(pictured_angle(design)), design.motion.assembly, places);
        text += link_names(scene, view, places, marks);
    }
    text += scale_bar(view, design.units.length);
    double height = view.height + bar_room;
    if (!picture.below.empty())
        text += fmt::format("<g transform=\"translate(0 {})\">{}</g>\n", px(height), picture.below);
    height += picture.below_height;
    if (!picture.title_block.empty()) {
        text += title_block(picture.title_block, picture.width, height);
        height += row_height * (static_cast<double>(picture.title_block.size()) + 0.5);
    }
    return svg_file(picture.title, picture.width, height, text);
}

}  // namespace mechwright
