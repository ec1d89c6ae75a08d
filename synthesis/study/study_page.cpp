#include "synthesis/study/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/problem/study/varied_problem.h"
#include "synthesis/program/assess.h"
#include "synthesis/report/files/gnuplot.h"
#include "synthesis/report/files/temporary_folder.h"
#include "synthesis/study/charts.h"
#include "synthesis/study/data.h"
#include "synthesis/study/points.h"
#include "synthesis/study/prepare.h"
#include "synthesis/study/store.h"
#include "synthesis/study/tolerance.h"
#include "synthesis/study/tolerance_text.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

/// A chart with the columns of its axes and the points in it.
struct ChartOfPoints {
    std::string x;
    std::string upwards;
    std::vector<std::uint64_t> points;  ///< increasing
};

PageChart page_chart(const StudyChart& chart, const ChartScript& script) {
    const ChartFrame& frame = script.frame;
    return {.title = script.title,
            .svg = gnuplot_picture(script.script, {}),
            .left = ChartFrame::left,
            .right = frame.right,
            .bottom = 1 - ChartFrame::bottom,
            .top = 1 - ChartFrame::top,
            .x_from = frame.x_from,
            .x_to = frame.x_to,
            .y_from = frame.y_from,
            .y_to = frame.y_to,
            .logarithmic = chart.logarithmic};
}

/// The points for which an SQL condition holds.
std::vector<std::uint64_t> points_where(const std::filesystem::path& data, const std::string& where) {
    std::string text;
    export_data(data, {"SELECT point FROM points WHERE " + where + " ORDER BY point"}, DataFormat::json,
                [&](std::string_view part) {
                    text += part;
                    return true;
                });
    std::vector<std::uint64_t> points;
    for (const Json& row : Json::parse(text))
        points.push_back(row.front().get<std::uint64_t>());
    return points;
}

double number_in(const Json& row, const std::string& column) {
    return row.contains(column) && row[column].is_number() ? row[column].get<double>()
                                                           : std::numeric_limits<double>::quiet_NaN();
}

/// What the page says of every point.
std::vector<std::string> columns_of(const Study& study) {
    std::vector<std::string> columns{"point"};
    for (const StudyAxis& axis : study.axes)
        columns.push_back(axis.name);
    for (const FollowingValue& following : study.following)
        columns.push_back(following.path);
    columns.insert(columns.end(), {"status", "objective", "note"});
    return columns;
}

ChartPoint chart_point(const StudyPoint& point, const std::vector<std::string>& columns,
                       const std::vector<ChartOfPoints>& charts) {
    ChartPoint shown;
    for (const ChartOfPoints& chart : charts) {
        const bool in = std::binary_search(chart.points.begin(), chart.points.end(), point.number);
        const double x = in ? number_in(point.row, chart.x) : std::numeric_limits<double>::quiet_NaN();
        shown.at.insert(shown.at.end(), {x, std::isnan(x) ? x : number_in(point.row, chart.upwards)});
    }
    for (const std::string& column : columns)
        shown.values.push_back(point.row.contains(column) ? point.row[column] : Json());
    return shown;
}

/// The problem of a point, or nothing where it cannot be read (a file that it names may be elsewhere).
std::optional<Problem> problem_at(VariedProblem& varied, const Study& study, std::uint64_t point) {
    if (!study.tolerances() && !varied.put(study, point_values(study, point)).empty()) return std::nullopt;
    ReadProblem read = varied.read();
    if (!read.ok()) return std::nullopt;
    return std::move(read.problem);
}

bool fits(const Design& design, const Problem& problem) {
    return design.dimensions.size() == problem.mechanism->dimensions.size() &&
           std::all_of(design.dimensions.begin(), design.dimensions.end(), [](double d) { return std::isfinite(d); }) &&
           std::find(problem.assemblies.begin(), problem.assemblies.end(), design.assembly) != problem.assemblies.end();
}

/// The design of a point for the page; nothing where it cannot be shown.
std::optional<DesignToShow> design_to_show(const StudyPoint& point, VariedProblem& varied, const Study& study) {
    const std::optional<Problem> problem = problem_at(varied, study, point.number);
    if (!problem || !fits(*point.design, *problem)) return std::nullopt;
    FinishedDesign finished = finished_design(*problem, *point.design);
    if (!finished.assembles()) return std::nullopt;
    return DesignToShow{fmt::format("point {}", point.number), std::move(finished),
                        analysis_document(*problem, assess(*problem, *point.design))};
}

/// Every point, and of every so many designs the first one, so that they lie evenly.
void add_points(const std::filesystem::path& data, const std::string& text, const std::string& file, const Study& study,
                const std::vector<ChartOfPoints>& charts, std::uint64_t most_designs, StudyToShow& shown) {
    std::uint64_t designs = 0, seen = 0;
    for_each_point(data, [&](const StudyPoint& point) { designs += point.design ? 1 : 0; });
    const std::uint64_t every = std::max<std::uint64_t>(1, (designs + most_designs - 1) / most_designs);
    VariedProblem varied(text, file);
    for_each_point(data, [&](const StudyPoint& point) {
        shown.points.push_back(chart_point(point, shown.columns, charts));
        if (!point.design || seen++ % every != 0) return;
        if (auto design = design_to_show(point, varied, study)) {
            shown.points.back().design = static_cast<long>(shown.designs.size());
            shown.designs.push_back(std::move(*design));
        }
    });
}

/// Of a tolerance study its tables, and the design that it is about.
void add_tolerances(const std::filesystem::path& data, const std::string& file, StudyToShow& shown) {
    const PreparedOrNot read = prepare_study(file);
    if (!read.ok) return;
    std::string why;
    const auto design = toleranced_design(read.prepared, {}, why);
    if (!design) {
        shown.text = why;
        return;
    }
    shown.text = tolerance_text(tolerance_report(read.prepared, *design, data));
    FinishedDesign nominal = finished_design(design->problem, design->nominal.design);
    if (nominal.assembles())
        shown.designs.push_back({"nominal", std::move(nominal), analysis_document(design->problem, design->nominal)});
}

}  // namespace

Page study_page(const std::filesystem::path& data, std::uint64_t most_designs) {
    const StudyStanding standing = standing_of_study(data);
    const TemporaryFolder folder;
    const std::string file = write_study_files(data, folder.path).string(), text = problem_text(data);
    const Problem problem = parse_problem(text, file).problem;
    if (problem.mechanism == nullptr || !problem.study) throw StoreFault(data.string() + ": holds no study");
    Page page;
    page.title = standing.title.empty() ? "Study" : standing.title;
    page.study.standing = tally(standing) + ".";
    page.study.columns = columns_of(*problem.study);
    std::vector<ChartOfPoints> charts;
    for (const StudyChart& chart : charts_of(problem))
        for (const ChartScript& script : chart_scripts(data, problem, chart)) {
            page.study.charts.push_back(page_chart(chart, script));
            charts.push_back({chart.x, script.upwards, points_where(data, script.where)});
        }
    if (problem.study->tolerances()) add_tolerances(data, file, page.study);
    // Points without a chart cannot be chosen: they stay in the data.
    if (!charts.empty()) add_points(data, text, file, *problem.study, charts, most_designs, page.study);
    return page;
}

}  // namespace mechwright
