#include "synthesis/study/charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "synthesis/problem/text.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/csv/csv_text.h"
#include "synthesis/report/files/gnuplot.h"
#include "synthesis/study/store.h"

namespace mechwright {

namespace {

std::string with_unit(std::string name, Unit unit, const Units& units) {
    const std::string label = unit_label(unit, units);
    return label.empty() ? name : name + ", " + label;
}

/// What a column is called in a picture: "require.swing.equal" is "swing, deg".
std::string label_of(const Problem& problem, const std::string& column) {
    const Mechanism& mechanism = whole_of(*problem.mechanism);  // cases may have other targets
    std::string name = column;
    const auto without = [&name](std::string_view front) {
        const bool has = name.starts_with(front);
        if (has) name.erase(0, front.size());
        return has;
    };
    if (without("design.") || without("dimensions.")) {
        const int i = find_dimension(mechanism, name.substr(0, name.find('.')));
        std::replace(name.begin(), name.end(), '.', ' ');
        return i < 0 ? name
                     : with_unit(name, unit_of(mechanism.dimensions[static_cast<std::size_t>(i)].kind), problem.units);
    }
    if (without("require.")) {
        const std::size_t dot = name.rfind('.');
        const std::string limit = dot == name.npos ? "" : name.substr(dot + 1);
        name = name.substr(0, dot);
        const int i = find_quantity(mechanism, name);
        if (limit == "min" || limit == "max") name += limit == "min" ? " at least" : " at most";
        return i < 0 ? name : with_unit(name, mechanism.quantities[static_cast<std::size_t>(i)].unit, problem.units);
    }
    if (const int i = find_quantity(mechanism, name); i >= 0)
        return with_unit(name, mechanism.quantities[static_cast<std::size_t>(i)].unit, problem.units);
    if (name.ends_with(".angle")) return with_unit(name, Unit::angle, problem.units);
    return name;
}

/// The data as a chart needs them.
class ChartData {
public:
    explicit ChartData(const std::filesystem::path& file)
        : database_(file.string(), SQLite::OPEN_READONLY, patience_in_milliseconds) {
        SQLite::Statement columns(database_, "SELECT name FROM pragma_table_info('points')");
        while (columns.executeStep())
            columns_.push_back(columns.getColumn(0).getString());
    }

    void require(const std::string& column) const {
        if (std::find(columns_.begin(), columns_.end(), column) != columns_.end()) return;
        const std::vector<std::string_view> known(columns_.begin(), columns_.end());
        throw ChartFault(fmt::format("the data have no column {}: {}", reading::quoted(std::string_view(column)),
                                     reading::remedy(column, known)));
    }

    std::vector<std::string> texts(const std::string& column, const std::string& where) {
        SQLite::Statement query(database_, fmt::format("SELECT DISTINCT {0} FROM points WHERE {1} AND {0} IS NOT NULL "
                                                       "ORDER BY 1",
                                                       sql_name(column), where));
        std::vector<std::string> values;
        while (query.executeStep())
            values.push_back(query.getColumn(0).isFloat() ? csv_number(query.getColumn(0).getDouble())
                                                          : query.getColumn(0).getString());
        return values;
    }

    std::vector<std::vector<double>> numbers(const std::vector<std::string>& columns, const std::string& where) {
        std::string names, present;
        for (const std::string& column : columns) {
            names += (names.empty() ? "" : ", ") + sql_name(column);
            present += " AND typeof(" + sql_name(column) + ") IN ('real', 'integer')";
        }
        SQLite::Statement query(database_,
                                fmt::format("SELECT {0} FROM points WHERE {1}{2} ORDER BY {0}", names, where, present));
        std::vector<std::vector<double>> rows;
        while (query.executeStep()) {
            rows.emplace_back();
            for (int i = 0; i < query.getColumnCount(); ++i)
                rows.back().push_back(query.getColumn(i).getDouble());
        }
        return rows;
    }

private:
    SQLite::Database database_;
    std::vector<std::string> columns_;
};

std::string equals(const std::string& column, const std::string& value) {
    std::string quoted;
    for (const char c : value)
        quoted += c == '\'' ? "''" : std::string(1, c);
    // A number is one in SQL; a text compares with it as text.
    return fmt::format(" AND ({0} = '{1}' OR {0} = CAST('{1}' AS REAL) AND typeof({0}) <> 'text')", sql_name(column),
                       quoted);
}

/// The ends of an axis: those of the column, with some room beyond.
std::pair<double, double> ends_of(const std::vector<std::vector<double>>& rows, std::size_t column, double room) {
    const auto less = [&](const auto& a, const auto& b) { return a[column] < b[column]; };
    const auto [least, greatest] = std::minmax_element(rows.begin(), rows.end(), less);
    const double from = (*least)[column], to = (*greatest)[column];
    if (from == to) return {from - std::max(1e-6, 0.05 * std::abs(from)), to + std::max(1e-6, 0.05 * std::abs(to))};
    return {from - room * (to - from), to + room * (to - from)};
}

/// Rows begin with x and what goes up; `room` is left beside and above the points.
ChartFrame frame_of(const std::vector<std::vector<double>>& rows, double room_x, double room_y) {
    ChartFrame frame;
    std::tie(frame.x_from, frame.x_to) = ends_of(rows, 0, room_x);
    std::tie(frame.y_from, frame.y_to) = ends_of(rows, 1, room_y);
    return frame;
}

std::string head(const Problem& problem, const StudyChart& chart, const ChartScript& picture) {
    std::string script =
        "set termoption noenhanced\n"
        "set encoding utf8\n"
        "set decimalsign '.'\n"
        "set border 3 lc rgb '#444444'\n"
        "set tics nomirror out\n"
        "set grid lc rgb '#dddddd'\n";
    script += fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n", gnuplot_text(picture.title),
                          gnuplot_text(label_of(problem, chart.x)), gnuplot_text(label_of(problem, picture.upwards)));
    if (chart.logarithmic) script += "set logscale x\n";
    const ChartFrame& frame = picture.frame;
    script += fmt::format(
        "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\n"
        "set tmargin at screen {}\n",
        frame.left, frame.right, frame.bottom, frame.top);
    return script + fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", csv_number(frame.x_from),
                                csv_number(frame.x_to), csv_number(frame.y_from), csv_number(frame.y_to));
}

std::string block(const std::string& name, const std::vector<std::vector<double>>& rows) {
    std::string text = "$" + name + " << END_OF_DATA\n";
    for (const auto& row : rows) {
        for (const double number : row)
            text += csv_number(number) + ' ';
        text += '\n';
    }
    return text + "END_OF_DATA\n";
}

/// Rows of x, y, value on the whole grid of their x and y, x slowest; NaN where there is no value.
std::string grid_block(const std::vector<std::vector<double>>& rows) {
    std::set<double> ys;
    std::map<double, std::map<double, double>> values;
    for (const auto& row : rows) {
        ys.insert(row[1]);
        values[row[0]][row[1]] = row[2];
    }
    std::string text = "$grid << END_OF_DATA\n";
    for (const auto& [x, column] : values) {
        for (const double y : ys) {
            const auto at = column.find(y);
            text += fmt::format("{} {} {}\n", csv_number(x), csv_number(y),
                                at == column.end() ? "NaN" : csv_number(at->second));
        }
        text += '\n';
    }
    return text + "END_OF_DATA\n";
}

void draw_map(ChartData& data, const Problem& problem, const StudyChart& chart, ChartScript& picture) {
    const auto rows = data.numbers({chart.x, chart.y, chart.value}, picture.where);
    if (rows.empty()) throw ChartFault("there is no point to draw");
    picture.frame = frame_of(rows, 0, 0);
    picture.upwards = chart.y;
    std::string script = head(problem, chart, picture) + grid_block(rows);
    script += "set view map\nset contour base\nset key off\n";
    script += fmt::format("set cblabel {} offset 1.5\n", gnuplot_text(label_of(problem, chart.value)));
    if (!chart.levels.empty()) {
        std::string levels;
        for (const double level : chart.levels)
            levels += (levels.empty() ? "" : ", ") + csv_number(level);
        script += "set cntrparam levels discrete " + levels + "\n";
    } else {
        script += "set cntrparam levels auto 12\n";
    }
    script +=
        "set cntrlabel onecolor start 8 interval 60 font ',9'\n"
        "set palette defined (0 '#2c3e70', 1 '#3b7a9e', 2 '#5fb29b', 3 '#b8d98a', 4 '#fbf3c0')\n";
    const bool filled = chart.kind == ChartKind::map;
    script += fmt::format(
        "splot {}$grid using 1:2:3 with lines lc rgb '#222222' nosurface, "
        "$grid using 1:2:3 with labels boxed nosurface\n",
        filled ? "$grid using 1:2:3 with pm3d nocontour, " : "");
    picture.script = script;
}

void draw_curves(ChartData& data, const Problem& problem, const StudyChart& chart, ChartScript& picture) {
    const std::string& where = picture.where;
    const auto all = data.numbers({chart.x, chart.value}, where);
    if (all.empty()) throw ChartFault("there is no point to draw");
    picture.frame = frame_of(all, 0, 0.05);
    if (!chart.family.empty()) picture.frame.right = 0.7;
    picture.upwards = chart.value;
    std::string script = head(problem, chart, picture);
    std::string plots;
    const std::vector<std::string> members =
        chart.family.empty() ? std::vector<std::string>{""} : data.texts(chart.family, where);
    for (std::size_t i = 0; i < members.size(); ++i) {
        const std::string one = chart.family.empty() ? where : where + equals(chart.family, members[i]);
        const auto rows = data.numbers({chart.x, chart.value}, one);
        if (rows.empty()) continue;
        script += block(fmt::format("curve{}", i), rows);
        plots += fmt::format("{}$curve{} using 1:2 with linespoints lw 1.5 pt 7 ps 0.3 title {}",
                             plots.empty() ? "" : ", ", i, gnuplot_text(members[i]));
    }
    if (plots.empty()) throw ChartFault("there is no point to draw");
    script += chart.family.empty()
                  ? "set key off\n"
                  : fmt::format("set key outside right top title {}\n", gnuplot_text(label_of(problem, chart.family)));
    picture.script = script + "plot " + plots + "\n";
}

/// The points of which none is better in both columns, in the order of x.
std::vector<std::vector<double>> front_of(std::vector<std::vector<double>> rows, bool more_x, bool more_y) {
    const auto x = [&](const std::vector<double>& row) { return more_x ? -row[0] : row[0]; };
    const auto y = [&](const std::vector<double>& row) { return more_y ? -row[1] : row[1]; };
    std::sort(rows.begin(), rows.end(),
              [&](const auto& a, const auto& b) { return std::pair(x(a), y(a)) < std::pair(x(b), y(b)); });
    std::vector<std::vector<double>> front;
    for (auto& row : rows)
        if (front.empty() || y(row) < y(front.back())) front.push_back(std::move(row));
    return front;
}

void draw_front(ChartData& data, const Problem& problem, const StudyChart& chart, ChartScript& picture) {
    const auto rows = data.numbers({chart.x, chart.y}, picture.where);
    if (rows.empty()) throw ChartFault("there is no point to draw");
    const auto more = [&](const std::string& column) {
        return std::find(chart.maximized.begin(), chart.maximized.end(), column) != chart.maximized.end();
    };
    const auto front = front_of(rows, more(chart.x), more(chart.y));
    picture.frame = frame_of(rows, 0.03, 0.05);
    picture.upwards = chart.y;
    picture.script = head(problem, chart, picture) + block("all", rows) + block("front", front) +
                     "plot $all using 1:2 with points pt 7 ps 0.4 lc rgb '#9aa7b8' title 'designs', "
                     "$front using 1:2 with linespoints lw 2 pt 7 ps 0.6 lc rgb '#b8442c' title 'front'\n";
}

ChartScript chart_script(ChartData& data, const Problem& problem, const StudyChart& chart, ChartScript picture) {
    switch (chart.kind) {
        case ChartKind::map:
        case ChartKind::contours: draw_map(data, problem, chart, picture); break;
        case ChartKind::curves: draw_curves(data, problem, chart, picture); break;
        case ChartKind::front: draw_front(data, problem, chart, picture); break;
    }
    return picture;
}

std::string file_name(std::string text) {
    for (char& c : text)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '.') c = '-';
    return text;
}

std::string title_of(const Problem& problem, const StudyChart& chart) {
    return chart.title.empty() ? problem.title : chart.title;
}

}  // namespace

std::vector<StudyChart> charts_of(const Problem& problem) {
    const Study& study = *problem.study;
    if (!study.charts.empty() || study.tolerances() || !problem.objective) return study.charts;
    std::vector<std::string> numeric, others;
    for (const StudyAxis& axis : study.axes)
        (axis.numeric() ? numeric : others).push_back(axis.name);
    StudyChart chart;
    chart.name = "objective";
    chart.value = "objective";
    if (numeric.empty()) return {};
    chart.x = numeric.back();
    if (numeric.size() > 1) {
        chart.y = numeric[numeric.size() - 2];
        chart.each = others.empty() ? "" : others.front();
    } else {
        chart.kind = ChartKind::curves;
        chart.family = others.empty() ? "" : others.front();
    }
    return {chart};
}

std::vector<ChartScript> chart_scripts(const std::filesystem::path& file, const Problem& problem,
                                       const StudyChart& chart) {
    try {
        ChartData data(file);
        for (const std::string* column : {&chart.x, &chart.y, &chart.value, &chart.family, &chart.each})
            if (!column->empty()) data.require(*column);
        const std::string where = chart.where.empty() ? "status = 'solved'" : "(" + chart.where + ")";
        const auto picture = [&](const std::string& name, const std::string& title, const std::string& points) {
            return chart_script(
                data, problem, chart,
                {.name = name, .title = title, .script = {}, .frame = {}, .upwards = {}, .where = points});
        };
        if (chart.each.empty()) return {picture(chart.name, title_of(problem, chart), where)};
        std::vector<ChartScript> scripts;
        for (const std::string& value : data.texts(chart.each, where))
            scripts.push_back(picture(chart.name + "-" + file_name(value), title_of(problem, chart) + ": " + value,
                                      where + equals(chart.each, value)));
        if (scripts.empty()) throw ChartFault("there is no point to draw");
        return scripts;
    } catch (const SQLite::Exception& fault) {
        throw ChartFault(fault.what());
    } catch (const ChartFault& fault) {
        throw ChartFault(fmt::format("chart '{}': {}", chart.name, fault.what()));
    }
}

}  // namespace mechwright
