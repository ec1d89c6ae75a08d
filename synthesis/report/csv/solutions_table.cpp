#include "synthesis/report/csv/solutions_table.h"

#include <cmath>

#include "synthesis/mechanism/input.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/csv/csv_text.h"

namespace mechwright {

namespace {

/// Whether a dimension has a column: what is not named in the file and stays 0 has none.
bool has_column(const Problem& problem, std::size_t i) {
    return problem.mechanism->dimensions[i].required || problem.dimensions[i].named;
}

std::string csv_column(std::string name, Unit unit, const Units& units) {
    const std::string label = unit_label(unit, units);
    return csv_field(label.empty() ? name : name + " [" + label + "]");
}

std::size_t targets_of(const Problem& problem) { return problem.path ? problem.path->points.size() : 0; }

std::string header(const Problem& problem) {
    std::string line = "number,defect,objective";
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i) {
        const Dimension& dimension = problem.mechanism->dimensions[i];
        if (has_column(problem, i))
            line += "," + csv_column(std::string(dimension.name), unit_of(dimension.kind), problem.units);
    }
    if (!problem.mechanism->assemblies.empty()) line += ",assembly";
    const Unit unit = input_unit(*problem.mechanism);
    for (std::size_t i = 1; i <= targets_of(problem); ++i)
        line += "," + csv_column((unit == Unit::angle ? "crank-angle-" : "displacement-") + std::to_string(i), unit,
                                 problem.units);
    return line + '\n';
}

/// Nothing where a number is not finite.
std::string number_field(double value) { return std::isfinite(value) ? csv_number(value) : ""; }

std::string row(const Problem& problem, std::size_t number, const Solution& solution, const std::string& defect) {
    const Design& design = solution.design;
    std::string line = std::to_string(number) + "," + csv_field(defect) + "," +
                       (problem.objective ? number_field(solution.objective) : "");
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i)
        if (has_column(problem, i))
            line += "," + number_field(in_file_unit(design.dimensions[i],
                                                    unit_of(problem.mechanism->dimensions[i].kind), problem.units));
    if (!problem.mechanism->assemblies.empty())
        line += "," + std::string(problem.mechanism->assemblies[design.assembly]);
    for (std::size_t i = 0; i < targets_of(problem); ++i)
        line += "," +
                (i < design.path_angles.size()
                     ? number_field(in_file_unit(design.path_angles[i], input_unit(*problem.mechanism), problem.units))
                     : std::string());
    return line + '\n';
}

}  // namespace

std::string solutions_table(const Problem& problem, const Result& result) {
    std::string text = header(problem);
    std::size_t number = 0;
    const bool verified = result.status != Status::infeasible && result.status != Status::unverified;
    if (result.best) text += row(problem, ++number, *result.best, verified ? "" : "it does not meet all requirements");
    for (const VerifiedDesign& other : result.alternatives)
        text += row(problem, ++number, other.solution, "");
    for (const ExcludedDesign& excluded : result.excluded)
        text += row(problem, ++number, excluded.solution, excluded.defect);
    return text;
}

}  // namespace mechwright
