#include "synthesis/report/drawing/figure/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/report/drawing/figure/layout.h"

namespace mechwright {

namespace {

constexpr double least_panel_width = 380, greatest_panel_width = 620, head_length = 9;

/// Beside that of all pictures.
constexpr std::string_view figure_style =
    "<style>"
    ".measure{stroke:#8a1f6b;stroke-width:1.4}"
    ".thin{stroke:#8a1f6b;stroke-width:.7;opacity:.8}"
    ".zero{stroke:#555;stroke-width:1;stroke-dasharray:10 3 2 3}"
    ".head{fill:#8a1f6b;stroke:none}"
    ".dimension-name{font-size:13px;font-weight:bold;fill:#8a1f6b}"
    ".letter{font-size:13px;font-weight:bold;fill:#111}"
    ".link-name{font-size:13px;font-style:italic;fill:#23415f}"
    ".dimension-name,.letter,.link-name{text-anchor:middle;stroke:#fff;stroke-width:3;paint-order:stroke}"
    ".panel-title{font-size:13px;font-weight:bold;text-anchor:middle}"
    ".remark{font-size:12px}"
    ".follow{stroke-width:2.6}"
    ".frame{stroke:#d5dce3;stroke-width:1}"
    "</style>";

std::string pixels_text(double value) {
    const std::string text = fmt::format("{:.2f}", value);
    return text == "-0.00" ? "0.00" : text;
}

std::string place_text(const Vector<double>& p) { return pixels_text(p.x) + " " + pixels_text(p.y); }

std::string stroke_element(std::string_view kind, const Vector<double>& from, const Vector<double>& to) {
    return fmt::format("<path class=\"{}\" d=\"M{}L{}\"/>", kind, place_text(from), place_text(to));
}

/// The head of an arrow that points in a direction (unit vector).
std::string arrow_head(const Vector<double>& tip, const Vector<double>& towards, double length = head_length) {
    const Vector<double> neck = tip - length * towards, side = 0.3 * length * left_of(towards);
    return fmt::format("<path class=\"head\" d=\"M{}L{}L{}Z\"/>", place_text(tip), place_text(neck + side),
                       place_text(neck - side));
}

/// With heads from outside where there is no room between.
std::string measure_elements(const DrawnDimension& d) {
    const Vector<double> way = d.to - d.from;
    const double length = std::hypot(way.x, way.y);
    if (!(length > 0)) return {};
    const Vector<double> along = (1 / length) * way;
    const bool one = d.of.as == ShownAs::coordinate;
    if (length > (one ? 1.5 : 2.5) * head_length)
        return stroke_element("measure", d.from, d.to) + arrow_head(d.to, along) +
               (one ? fmt::format("<circle class=\"head\" cx=\"{}\" cy=\"{}\" r=\"2.5\"/>", pixels_text(d.from.x),
                                  pixels_text(d.from.y))
                    : arrow_head(d.from, -along));
    const Vector<double> out = 2 * head_length * along;
    return stroke_element("measure", d.from - out, d.to + out) + arrow_head(d.from, along) + arrow_head(d.to, -along);
}

std::string arc_elements(const DrawnDimension& d) {
    const FigureArc& arc = d.arc;
    std::string data = "M" + place_text(arc.at(arc.zero));
    // In parts, of which none is half a turn.
    constexpr int parts = 3;
    for (int i = 1; i <= parts; ++i)
        data += fmt::format("A{0} {0} 0 0 {1} {2}", pixels_text(arc.radius), arc.turn > 0 ? 0 : 1,
                            place_text(arc.at(arc.zero + arc.turn * i / parts)));
    const double sense = arc.turn > 0 ? 1 : -1;
    const double length = std::min(head_length, 0.7 * std::abs(arc.turn) * arc.radius);
    // The head is as wide as the arc bends under it: it points along the chord.
    const double end = arc.zero + arc.turn, back = end - sense * 0.5 * length / arc.radius;
    const Vector<double> towards{-sense * std::sin(back), -sense * std::cos(back)};
    return fmt::format("<path class=\"measure\" d=\"{}\"/>", data) + arrow_head(arc.at(end), towards, length);
}

std::string label_element(const TextBox& box) {
    constexpr double above_line = 0.32;  // of the height: the middle of a letter is above the line that it stands on
    return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>", box.kind, pixels_text(box.middle.x),
                       pixels_text(box.middle.y + above_line * box.height), escaped(box.text));
}

std::string dimension_element(const DrawnDimension& d) {
    std::string text = fmt::format("<g class=\"dimension\" data-name=\"{}\">", escaped(d.of.name));
    for (const Stroke& stroke : d.zero)
        text += stroke_element("zero", stroke.from, stroke.to);
    for (const Stroke& stroke : d.thin)
        text += stroke_element("thin", stroke.from, stroke.to);
    if (d.of.as == ShownAs::angle)
        text += arc_elements(d);
    else if (d.of.as != ShownAs::word)
        text += measure_elements(d);
    return text + "</g>\n";
}

std::string panel_element(const PanelLayout& layout) {
    Scene lines;
    lines.fixed = layout.lines;
    std::string text;
    for (std::size_t i = 0; i < layout.title.size(); ++i)
        text +=
            fmt::format("<text class=\"panel-title\" x=\"{}\" y=\"{}\">{}</text>", pixels_text(0.5 * layout.view.width),
                        pixels_text(figure_line_height * (static_cast<double>(i) + 1)), escaped(layout.title[i]));
    if (!layout.end_places.empty())
        text += "<g class=\"ghost\">" + svg_bodies(layout.scene, layout.view, layout.end_places) + "</g>\n";
    text += svg_fixed(layout.scene, layout.view) + svg_fixed(lines, layout.view) + "\n" +
            svg_bodies(layout.scene, layout.view, layout.places) + "\n";
    for (const DrawnDimension& dimension : layout.dimensions)
        text += dimension_element(dimension);
    for (const DrawnDimension& dimension : layout.dimensions)
        text += label_element(dimension.label);
    for (const TextBox& box : layout.texts)
        text += label_element(box);
    for (std::size_t i = 0; i < layout.remark.size(); ++i)
        text += fmt::format("<text class=\"remark\" x=\"10\" y=\"{}\">{}</text>",
                            pixels_text(layout.view.height + figure_line_height * (static_cast<double>(i) + 0.5)),
                            escaped(layout.remark[i]));
    return text;
}

/// What the heads of arrows say, below all panels.
constexpr std::string_view figure_legend =
    "An arrow with one head goes from zero to where the number is positive; arcs begin at their zero line, and are "
    "positive against the clock.";

}  // namespace

std::string figure_picture(const std::string& title, std::span<const FigurePanel> panels, double most_width) {
    const double most = std::max(1.0, std::floor(most_width / least_panel_width));
    const auto columns = static_cast<std::size_t>(std::min(most, static_cast<double>(panels.size())));
    const double count = static_cast<double>(columns);
    const double panel_width = std::clamp(most_width / count, least_panel_width, greatest_panel_width);
    const double width = panel_width * count;
    std::string text(figure_style);
    double top = 0;
    for (std::size_t i = 0; i < panels.size(); i += columns) {
        std::vector<PanelLayout> row;
        for (std::size_t k = i; k < std::min(i + columns, panels.size()); ++k)
            row.push_back(lay_out(panels[k], panel_width));
        double height = 0;
        for (const PanelLayout& layout : row)
            height = std::max(height, layout.height);
        for (std::size_t k = 0; k < row.size(); ++k)
            text += fmt::format(
                "<g class=\"panel\" transform=\"translate({} {})\"><path class=\"frame\" "
                "d=\"M4 0H{}V{}H4Z\"/>\n{}</g>\n",
                pixels_text(static_cast<double>(k) * panel_width), pixels_text(top), pixels_text(panel_width - 4),
                pixels_text(height), panel_element(row[k]));
        top += height + 8;
    }
    for (const std::string& line : folded_text(figure_legend, width - 20)) {
        top += figure_line_height;
        text += fmt::format("<text class=\"remark\" x=\"10\" y=\"{}\">{}</text>\n", pixels_text(top - 4), line);
    }
    return svg_file(title, width, top + 8, text);
}

namespace {

std::string figure_named(const std::string& mechanism, std::span<const FigurePanel> panels, double most_width) {
    return panels.empty() ? ""
                          : figure_picture("Dimensions of the mechanism \"" + mechanism + "\"", panels, most_width);
}

}  // namespace

std::string figure_picture(std::string_view mechanism_name, double most_width) {
    return figure_named(std::string(mechanism_name), figure_of(mechanism_name), most_width);
}

std::string figure_picture(const Mechanism& mechanism, double most_width) {
    return figure_named(mechanism.name, figure_of(mechanism), most_width);
}

}  // namespace mechwright
