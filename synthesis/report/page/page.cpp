#include "synthesis/report/page/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "synthesis/document/versions.h"
#include "synthesis/mechanism/linkage/drawing/figure.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/report/drawing/exported.h"
#include "synthesis/report/drawing/figure/figure.h"
#include "synthesis/report/drawing/motion_plots.h"
#include "synthesis/report/drawing/raster.h"
#include "synthesis/report/files/gnuplot.h"
#include "synthesis/report/page/assets.h"
#include "synthesis/report/page/tables.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

constexpr int result_steps = 360, study_steps = 72;
constexpr std::string_view no_network =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:";

/// JSON inside a script element: nothing in it can end that.
std::string in_script(const Json& json) {
    std::string text;
    for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
        text += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return text;
}

Json as_data(ShownParts parts) {
    Json json = std::move(parts.motion);
    json["box"] = std::move(parts.view_box);
    json["drawing"] = std::move(parts.drawing);
    json["tables"] = std::move(parts.tables);
    return json;
}

std::string badge(const Json& document) {
    const std::string status = document.contains("status") ? cell_text(document["status"]) : "evaluated";
    return fmt::format("<span class=\"badge {0}\">{0}</span>", escaped(status));
}

std::string objective_text(const Json& document) {
    if (!document.contains("objective") || !document["objective"].is_object()) return {};
    const Json& objective = document["objective"];
    if (objective.contains("quantity"))
        return fmt::format("{} {}", cell_text(objective["quantity"]),
                           objective.contains("value") ? cell_text(objective["value"]) : "");
    return objective.contains("value") ? "objective " + cell_text(objective["value"]) : "";
}

/// What the page is made of while it is written.
struct Writing {
    Json designs = Json::array();  ///< as the script reads them
    std::string choices;           ///< buttons, one for each design
    ShownParts first;              ///< of the design that shows at first
    bool any = false;

    /// Returns the design's thumbnail, if it is to have one. What is saved of it is called `file`.
    std::string add(const DesignToShow& shown, const std::string& file, int steps, bool with_thumbnail) {
        ShownParts parts = shown_parts(shown, steps, with_thumbnail);
        parts.motion["file"] = file;
        // Those that are shown by the hundred would make the page too large.
        if (with_thumbnail)
            if (Exported drawing = exported(shown.design, "dxf", {}); drawing.fault.empty())
                parts.motion["dxf"] = std::move(drawing.text);
        if (!any) first = parts;
        any = true;
        std::string thumbnail = std::move(parts.thumbnail);
        designs.push_back(as_data(std::move(parts)));
        return thumbnail;
    }
};

/// "crank-rocker", "crank-rocker-alternative-2"
std::string name_for_files(const ResultToShow& result, const DesignToShow& shown) {
    std::string name = std::filesystem::path(result.file).stem().string();
    if (name.empty()) name = "design";
    if (&shown != &result.designs.front()) name += "-" + shown.name;
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

void add_result(const ResultToShow& result, bool heading, Writing& writing) {
    if (heading)
        writing.choices += fmt::format("<h3>{} {}</h3><p class=\"file\">{}</p>", escaped(result.title),
                                       badge(result.document), escaped(result.file));
    if (result.designs.empty()) {
        writing.choices += "<p>" + escaped(standing_sentence(result.document)) + " There is no design to show.</p>";
        return;
    }
    writing.choices += "<div class=\"choices\">";
    for (const DesignToShow& shown : result.designs) {
        const std::size_t number = writing.designs.size();
        const std::string thumbnail = writing.add(shown, name_for_files(result, shown), result_steps, true);
        const std::string defect = shown.document.contains("defect") ? ": " + cell_text(shown.document["defect"]) : "";
        writing.choices += fmt::format(
            "<button type=\"button\" class=\"choice\" data-design=\"{}\" aria-pressed=\"{}\">{}<span>{}{}<br>{}</span>"
            "</button>",
            number, number == 0 ? "true" : "false", thumbnail, escaped(shown.name), escaped(defect),
            escaped(objective_text(shown.document)));
    }
    writing.choices += "</div>";
    if (result.not_shown > 0)
        writing.choices += fmt::format("<p>{} further alternatives are in the file.</p>", result.not_shown);
}

std::string lines_table(const std::vector<ResultLine>& lines) {
    std::string rows;
    for (const ResultLine& line : lines)
        rows += table_row({line.file, line.title, line.standing});
    return table_of("Other files", {"file", "title", ""}, rows);
}

Json study_data(const StudyToShow& study) {
    Json charts = Json::array(), points = Json::array();
    for (const PageChart& chart : study.charts)
        charts.push_back({{"box", {chart.left, chart.right, chart.bottom, chart.top}},
                          {"x", {chart.x_from, chart.x_to}},
                          {"y", {chart.y_from, chart.y_to}},
                          {"log", chart.logarithmic}});
    for (const ChartPoint& point : study.points)
        points.push_back({{"at", point.at}, {"values", point.values}, {"design", point.design}});
    return {{"charts", charts}, {"columns", study.columns}, {"points", points}};
}

std::string study_section(const StudyToShow& study) {
    if (study.standing.empty()) return {};
    std::string text = "<section id=\"study\"><h2>Study</h2><p>" + escaped(study.standing) + "</p>";
    for (std::size_t i = 0; i < study.charts.size(); ++i)
        text += fmt::format(
            "<figure class=\"chart\" data-chart=\"{}\" tabindex=\"0\" role=\"application\" aria-label=\"{}: arrow keys "
            "go from point to point\">{}<i class=\"mark\" hidden></i></figure>",
            i, escaped(study.charts[i].title), svg_element(study.charts[i].svg));
    if (!study.text.empty()) text += "<pre>" + escaped(study.text) + "</pre>";
    if (study.charts.empty()) return text + "</section>";
    return text +
           "<p class=\"script\">Click a point of a chart, or go through them with the arrow keys, to open its "
           "design.</p><div id=\"point\" aria-live=\"polite\"></div></section>";
}

std::string controls() {
    return "<div class=\"controls script\">"
           "<button type=\"button\" id=\"play\" aria-pressed=\"false\">Play</button>"
           "<label class=\"grow\"><span id=\"angle-name\">angle</span> <input type=\"range\" id=\"angle\" min=\"0\" "
           "max=\"1\" value=\"0\"></label><output id=\"angle-text\" for=\"angle\"></output>"
           "<label><input type=\"number\" id=\"speed\" min=\"0.1\" max=\"600\" step=\"any\" value=\"15\"> "
           "<span id=\"speed-name\">turns per minute</span></label>"
           "<label><input type=\"checkbox\" id=\"ghosts\" checked> limit positions</label>"
           "<label id=\"other-label\"><input type=\"checkbox\" id=\"other\"> other assembly</label></div>"
           "<div class=\"controls script\">"
           "<button type=\"button\" id=\"farther\" aria-label=\"Zoom out\">\u2212</button>"
           "<button type=\"button\" id=\"nearer\" aria-label=\"Zoom in\">+</button>"
           "<button type=\"button\" id=\"whole\">Whole</button>"
           "<button type=\"button\" id=\"full\">Full screen</button>"
           "<span>Save as</span>"
           "<button type=\"button\" id=\"save-svg\" aria-label=\"Save the drawing as SVG\">SVG</button>"
           "<button type=\"button\" id=\"save-dxf\" aria-label=\"Save the drawing as DXF, for CAD\">DXF</button>"
           "<button type=\"button\" id=\"save-csv\" aria-label=\"Save the motion as a table, CSV\">CSV</button>"
           "<button type=\"button\" id=\"save-gif\" aria-label=\"Save the motion as a moving picture, GIF\">GIF"
           "</button></div>";
}

std::string mechanism_section(const Writing& writing) {
    if (!writing.any) return {};
    return fmt::format(
               "<section id=\"mechanism\"><h2>Mechanism</h2><svg id=\"drawing\" viewBox=\"{}\" role=\"img\" "
               "aria-label=\"The mechanism\">{}</svg>",
               writing.first.view_box, writing.first.drawing) +
           controls() + "</section>";
}

/// That which the page shows at first. Precondition: there is one.
const DesignToShow& first_design(const Page& page) {
    for (const ResultToShow& result : page.results)
        if (!result.designs.empty()) return result.designs.front();
    return page.study.designs.front();
}

std::string plots_section(const Page& page, const Writing& writing) {
    if (!writing.any) return {};
    std::string still;
    if (page.static_plots) {
        const DesignToShow& first = first_design(page);
        const MotionPlots plots = motion_plots(first.design, first.document, result_steps);
        constexpr int width = 720;
        still =
            svg_element(gnuplot_picture(plots_script(plots), {.width = width, .height = plots_height(plots, width)}));
    }
    return "<section id=\"motion\"><h2>Motion</h2><div id=\"plots\"></div><div id=\"still-plots\">" + still +
           "</div></section>";
}

/// A picture without its styles: the page has its own, for light and dark.
std::string unstyled(std::string svg) {
    constexpr std::string_view open = "<style>", close = "</style>";
    for (std::size_t from; (from = svg.find(open)) != std::string::npos;)
        svg.erase(from, svg.find(close, from) + close.size() - from);
    return svg_element(svg);
}

/// The first design of each mechanism that the page shows.
std::vector<const FinishedDesign*> one_of_each(const Page& page) {
    std::vector<const FinishedDesign*> first;
    const auto add = [&](const std::vector<DesignToShow>& designs) {
        for (const DesignToShow& shown : designs)
            if (std::none_of(first.begin(), first.end(), [&](const FinishedDesign* other) {
                    return other->mechanism->name == shown.design.mechanism->name;
                }))
                first.push_back(&shown.design);
    };
    for (const ResultToShow& result : page.results)
        add(result.designs);
    add(page.study.designs);
    return first;
}

/// What the dimensions of the tables are, to be opened.
std::string figures(const Page& page) {
    std::string text;
    for (const FinishedDesign* design : one_of_each(page)) {
        const std::string& name = design->mechanism->name;
        std::string picture = figure_picture(*design->mechanism);
        if (picture.empty() && design->mechanism->model.as<LinkageModel>() != nullptr)
            picture = figure_picture(name, std::array{linkage_panel(*design)});
        if (!picture.empty())
            text += "<details class=\"figure\"><summary>Where the dimensions of a " + escaped(name) + " are</summary>" +
                    unstyled(picture) + "</details>";
    }
    return text;
}

std::string licences() {
    return fmt::format(
        "<footer><p>Made by mechwright {}.</p><details><summary>Licence of the plotting library</summary><pre>{}</pre>"
        "</details></footer>",
        program_version(), escaped(assets::dygraphs_licence()));
}

}  // namespace

std::string page_text(const Page& page) {
    Writing writing;
    const bool several = page.results.size() > 1;
    for (const ResultToShow& result : page.results)
        add_result(result, several, writing);
    for (const DesignToShow& shown : page.study.designs)
        writing.add(shown, "design", study_steps, false);

    const std::string head =
        several || page.results.empty()
            ? ""
            : fmt::format("<p>{} {}</p><p class=\"file\">{}</p>", badge(page.results[0].document),
                          escaped(standing_sentence(page.results[0].document)), escaped(page.results[0].file));
    const bool choose = several || (page.results.size() == 1 && page.results[0].designs.size() > 1) ||
                        (page.results.size() == 1 && page.results[0].designs.empty());
    std::string text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\"><meta http-equiv=\"Content-Security-Policy\" content=\"{}\">"
        "<title>{}</title>\n<style>{}\n{}</style></head>\n<body "
        "class=\"still\"><header><h1>{}</h1>{}</header>\n<main>\n",
        no_network, escaped(page.title), assets::dygraphs_style(), assets::page_style(), escaped(page.title), head);
    text += study_section(page.study) + "\n";
    if (choose) text += "<section id=\"designs\"><h2>Designs</h2>" + writing.choices + "</section>\n";
    text += mechanism_section(writing) + "\n";
    if (writing.any)
        text += "<section id=\"tables\"><h2>Numbers</h2><div id=\"numbers\">" + writing.first.tables + "</div>" +
                figures(page) + "</section>\n";
    text += plots_section(page, writing) + "\n";
    if (!page.lines.empty())
        text += "<section id=\"others\"><h2>Other results</h2>" + lines_table(page.lines) + "</section>\n";
    text += "</main>\n" + licences();
    text += "<script type=\"application/json\" id=\"data\">" +
            in_script({{"designs", std::move(writing.designs)}, {"study", study_data(page.study)}}) + "</script>\n";
    text += fmt::format("<script>{}</script>\n<script>{}</script>\n<script>{}</script></body></html>\n",
                        assets::dygraphs_script(), assets::gif_script(), assets::page_script());
    return text;
}

}  // namespace mechwright
