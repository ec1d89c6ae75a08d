#include "synthesis/report/drawing/motion_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/problem/input_tasks.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/csv/csv_text.h"
#include "synthesis/report/files/gnuplot.h"
#include "synthesis/report/text/table.h"
#include "synthesis/target/followed/draw.h"
#include "synthesis/target/function/draw.h"
#include "synthesis/target/function/function_target.h"

namespace mechwright {

namespace {

/// In which plot a column of the motion table stands; empty for columns that are places in the plane.
std::string_view plot_of(std::string_view column) {
    const auto ends = [&](std::string_view end) { return column.ends_with(end); };
    if (ends("-x") || ends("-y") || column == "face-contact") return {};
    if (ends("transmission-angle")) return "transmission angle";
    if (ends("pressure-angle")) return "pressure angle";
    if (ends("velocity")) return "velocity";
    if (ends("acceleration")) return "acceleration";
    if (ends("jerk")) return "jerk";
    if (ends("profile-radius")) return "curvature of the profile";
    return "position";
}

/// The unit of a derivative by the crank angle.
std::string unit_of_plot(std::string_view plot, Unit unit, const Units& units) {
    const std::string label = unit_label(unit, units);
    const auto per = [&](const char* what) { return label.empty() ? std::string() : label + what; };
    if (plot == "velocity") return per("/rad");
    if (plot == "acceleration") return per("/rad\u00b2");
    if (plot == "jerk") return per("/rad\u00b3");
    if (plot == "curvature of the profile") return "1/" + label;
    return label;
}

/// Angles without jumps of a full turn.
void unwrap(std::vector<double>& radians) {
    constexpr double turn = 2 * std::numbers::pi;
    double before = std::numeric_limits<double>::quiet_NaN();
    for (double& angle : radians) {
        if (std::isnan(angle)) continue;
        if (!std::isnan(before)) angle -= turn * std::round((angle - before) / turn);
        before = angle;
    }
}

/// Which plot shows what a quantity limits, and whether the limit holds below zero, or on both sides of zero or of a
/// right angle.
struct LimitedPlot {
    std::string_view quantity;
    std::string_view plot;
    enum class Mirror { none, below_zero, at_zero, at_right_angle } mirror = Mirror::none;
};

using enum LimitedPlot::Mirror;
constexpr std::array<LimitedPlot, 17> limited_plots{{
    {"function-max", "error of the function", at_zero},
    {"line-deviation", "distance from the line", at_zero},
    {"arc-deviation", "distance from the arc", at_zero},
    {"transmission-angle-min", "transmission angle"},
    {"transmission-angle-max", "transmission angle"},
    {"transmission-angle-worst", "transmission angle", at_right_angle},
    {"pressure-angle-rise", "pressure angle"},
    {"pressure-angle-return", "pressure angle", below_zero},
    {"pressure-angle-max", "pressure angle", at_zero},
    {"velocity-max", "velocity", at_zero},
    {"velocity-ratio-min", "velocity"},
    {"velocity-ratio-max", "velocity"},
    {"ram-speed-max", "velocity", at_zero},
    {"ram-speed-min-working", "velocity", at_zero},
    {"ram-acceleration-max", "acceleration", at_zero},
    {"acceleration-max", "acceleration", at_zero},
    {"jerk-max", "jerk", at_zero},
}};

void add_level(MotionPlots& plots, std::string_view quantity, std::string_view what, double value, bool degrees) {
    for (const LimitedPlot& limited : limited_plots) {
        if (limited.quantity != quantity) continue;
        for (MotionPlot& plot : plots.plots) {
            if (plot.title != limited.plot) continue;
            const std::string name = fmt::format("{} {}", quantity, what);
            plot.levels.push_back({name, limited.mirror == below_zero ? -value : value});
            const double right_angle = degrees ? 90 : 0.5 * std::numbers::pi;
            if (limited.mirror == at_zero) plot.levels.push_back({name, -value});
            if (limited.mirror == at_right_angle) plot.levels.push_back({name, 2 * right_angle - value});
            break;
        }
    }
}

void add_levels(MotionPlots& plots, const nlohmann::ordered_json& document, bool degrees) {
    const auto add = [&](const nlohmann::ordered_json& about, const char* member, const char* what) {
        if (!about.contains("quantity") || !about["quantity"].is_string()) return;
        if (about.contains(member) && about[member].is_number())
            add_level(plots, about["quantity"].get<std::string>(), what, about[member].get<double>(), degrees);
    };
    if (document.contains("requirements") && document["requirements"].is_array())
        for (const auto& requirement : document["requirements"]) {
            if (!requirement.is_object()) continue;
            add(requirement, "min", "at least");
            add(requirement, "max", "at most");
            add(requirement, "equal", "required");
        }
    if (document.contains("objective") && document["objective"].is_object())
        add(document["objective"], "value", "reached");
}

/// Where a crank angle is in an input range, as a share of that; it may be whole turns further on, which a displacement
/// never is.
double share_of(double input, double start, double range, bool turns) {
    constexpr double end_within = 1e-12, turn = 2 * std::numbers::pi;
    const auto inside = [](double share) { return share >= -end_within && share <= 1 + end_within; };
    const double away = input - start;
    if (!turns) return inside(away / range) ? away / range : std::nan("");
    const double turned = away - turn * (range > 0 ? std::floor(away / turn) : std::ceil(away / turn));
    return inside(away / range) ? away / range : inside(turned / range) ? turned / range : std::nan("");
}

/// What is left between what a design does and what it is to follow, at a crank angle of its input range: the error of
/// a function, or the distance from a line or an arc. NaN where there is none.
double error_at(const FinishedDesign& design, const InputTask& task, const MotionRow& row) {
    const double angle = row.values().front();
    const double share = share_of(angle, design.dimensions[task.start], design.dimensions[task.start + 1],
                                  input_unit(design) == Unit::angle);
    if (std::isnan(share)) return share;
    return task.is_function() ? function_error(design, task, share) : distance_from_followed(design, task, angle);
}

/// Samples of a function are not joined.
MotionPlot error_plot(const FinishedDesign& design, const InputTask& task, int steps) {
    MotionCurve curve{task.is_function() ? "error" : "distance", {}};
    for (const double angle : even_angles(design, steps)) {
        const MotionRow row(design, angle);
        curve.values.push_back(row.assembled()
                                   ? error_at(design, task, row) * file_units_per_inner(task.unit(), design.units)
                                   : std::numeric_limits<double>::quiet_NaN());
    }
    std::string title = std::string(task.is_function() ? "error of the " : "distance from the ") + task.section();
    if (!task.asked.name.empty()) title += " '" + task.asked.name + "'";
    return {title, unit_label(task.unit(), design.units), {std::move(curve)}, {}};
}

/// The plots of that, first of all: it is what such a design is made for.
void add_errors(const FinishedDesign& design, int steps, MotionPlots& plots) {
    std::vector<MotionPlot> errors;
    for (const InputTask& task : input_tasks(design))
        if (!task.is_function() || !task.asked.function->expression.empty())
            errors.push_back(error_plot(design, task, steps));
    plots.plots.insert(plots.plots.begin(), errors.begin(), errors.end());
}

MotionPlot& plot_with(std::vector<MotionPlot>& plots, std::string_view title, const std::string& unit) {
    for (MotionPlot& plot : plots)
        if (plot.title == title && plot.unit == unit) return plot;
    plots.push_back({std::string(title), unit, {}, {}});
    return plots.back();
}

std::vector<double> in_units(std::vector<double> values, std::string_view plot, Unit unit, const Units& units) {
    if (plot == "position" && unit == Unit::angle) unwrap(values);
    const double factor = plot == "curvature of the profile" ? 1 : file_units_per_inner(unit, units);
    for (double& value : values) {
        if (plot == "curvature of the profile") value = 1 / value;
        value = std::isfinite(value) ? value * factor : std::numeric_limits<double>::quiet_NaN();
    }
    return values;
}

}  // namespace

std::vector<std::string_view> quantities_with_levels() {
    std::vector<std::string_view> names;
    for (const LimitedPlot& limited : limited_plots)
        names.push_back(limited.quantity);
    return names;
}

MotionPlots motion_plots(const FinishedDesign& design, const nlohmann::ordered_json& document, int steps) {
    const Mechanism& mechanism = *design.mechanism;
    const std::size_t columns = mechanism.table.columns.size(), rows = static_cast<std::size_t>(steps) + 1;
    std::vector<std::vector<double>> table(columns,
                                           std::vector<double>(rows, std::numeric_limits<double>::quiet_NaN()));
    MotionPlots plots;
    plots.angle_name = mechanism.table.columns.front();
    plots.angle_unit = unit_label(input_unit(design), design.units);
    for (const double angle : even_angles(design, steps)) {
        const std::size_t i = plots.angles.size();
        plots.angles.push_back(in_file_unit(angle, input_unit(design), design.units));
        const MotionRow row(design, angle);
        if (!row.assembled()) continue;
        for (std::size_t c = 0; c < columns; ++c)
            table[c][i] = row.values()[c];
    }
    for (std::size_t c = 1; c < columns; ++c) {
        const std::string_view title = plot_of(mechanism.table.columns[c]);
        if (title.empty()) continue;
        const Unit unit = mechanism.table.units[c];
        MotionPlot& plot = plot_with(plots.plots, title, unit_of_plot(title, unit, design.units));
        const bool inverse = title == "curvature of the profile";
        plot.curves.push_back({(inverse ? "1/" : "") + std::string(mechanism.table.columns[c]),
                               in_units(std::move(table[c]), title, unit, design.units)});
    }
    add_errors(design, steps, plots);
    add_levels(plots, document, design.units.degrees);
    return plots;
}

namespace {

/// The ends of the upright axis: all values and levels, and some room.
std::pair<double, double> upright_axis(const MotionPlot& plot) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto add = [&](double value) {
        if (std::isnan(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    };
    for (const MotionCurve& curve : plot.curves)
        std::for_each(curve.values.begin(), curve.values.end(), add);
    for (const PlotLevel& level : plot.levels)
        add(level.value);
    if (!(low <= high)) return {0, 1};
    const double room = low < high ? 0.08 * (high - low) : std::max(0.01, 0.01 * std::abs(low));
    return {low - room, high + room};
}

}  // namespace

int plots_height(const MotionPlots& plots, int width) {
    return static_cast<int>((plots.plots.size() + 1) / 2) * width * 2 / 5;
}

std::string plots_script(const MotionPlots& plots) {
    std::string script = "set encoding utf8\nset termoption noenhanced\nset decimalsign '.'\n";
    script += fmt::format("set multiplot layout {},2\n", (plots.plots.size() + 1) / 2);
    script += "set border 3 lc rgb '#444444'\nset tics nomirror out font ',10'\nset grid lc rgb '#dddddd'\n";
    script += "set key bmargin center horizontal samplen 2 font ',10'\n";
    script += fmt::format("set xrange [{}:{}]\n", csv_number(plots.angles.front()), csv_number(plots.angles.back()));
    if (plots.angle_unit == "deg") script += "set xtics 60\n";
    for (std::size_t k = 0; k < plots.plots.size(); ++k) {
        const MotionPlot& plot = plots.plots[k];
        const std::string unit = plot.unit.empty() ? "" : ", " + plot.unit;
        script += fmt::format("set title {}\nset xlabel {}\n", gnuplot_text(plot.title + unit),
                              gnuplot_text(plots.angle_name + ", " + plots.angle_unit));
        const auto [low, high] = upright_axis(plot);
        script += fmt::format("set yrange [{}:{}]\n$plot{} << END_OF_DATA\n", csv_number(low), csv_number(high), k);
        for (std::size_t i = 0; i < plots.angles.size(); ++i) {
            script += csv_number(plots.angles[i]);
            for (const MotionCurve& curve : plot.curves)
                script += std::isnan(curve.values[i]) ? " NaN" : " " + number_text(curve.values[i]);
            script += '\n';
        }
        script += "END_OF_DATA\nplot ";
        for (std::size_t c = 0; c < plot.curves.size(); ++c)
            script += fmt::format("{}$plot{} using 1:{} with lines lw 1.5 title {}", c == 0 ? "" : ", ", k, c + 2,
                                  gnuplot_text(plot.curves[c].name));
        for (const PlotLevel& level : plot.levels)
            script += fmt::format(", {} with lines dt 2 lc rgb '#b8442c' notitle", csv_number(level.value));
        script += '\n';
    }
    return script + "unset multiplot\n";
}

}  // namespace mechwright
