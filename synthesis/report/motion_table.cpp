#include "synthesis/report/motion_table.h"

#include "synthesis/problem/units.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/report/csv_text.h"

namespace mechwright {

std::string motion_header(const Problem& problem) {
    const Mechanism& mechanism = *problem.mechanism;
    std::string line;
    for (std::size_t c = 0; c < mechanism.motion_columns.size(); ++c) {
        std::string name(mechanism.motion_columns[c]);
        const std::string unit = unit_label(mechanism.motion_units[c], problem.units);
        if (!unit.empty()) name += " [" + unit + "]";
        if (c > 0) line += ',';
        line += csv_field(name);
    }
    return line + '\n';
}

std::string motion_table(const Problem& problem, const Design& design, int steps) {
    const Mechanism& mechanism = *problem.mechanism;
    std::string text = motion_header(problem);
    const Motion motion = motion_of(problem, design);
    if (!(motion.from <= motion.to)) return text;

    // Steps are taken in the file's unit, so that whole degrees stay whole degrees.
    const double from = in_file_unit(motion.from, Unit::angle, problem.units);
    const double to = in_file_unit(motion.to, Unit::angle, problem.units);
    std::vector<double> row(mechanism.motion_columns.size());
    for (int i = 0; i <= steps; ++i) {
        const double angle = i == 0       ? motion.from
                             : i == steps ? motion.to
                                          : from_file_unit(from + (to - from) * i / steps, Unit::angle, problem.units);
        if (!mechanism.motion_row(motion, design.dimensions, angle, row)) continue;
        for (std::size_t c = 0; c < row.size(); ++c) {
            if (c > 0) text += ',';
            text += csv_number(in_file_unit(row[c], mechanism.motion_units[c], problem.units));
        }
        text += '\n';
    }
    return text;
}

}  // namespace mechwright
