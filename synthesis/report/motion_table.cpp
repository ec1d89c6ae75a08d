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

std::vector<double> motion_angles(const Problem& problem, const Motion& motion, int steps) {
    std::vector<double> angles;
    if (!(motion.from <= motion.to)) return angles;
    // Steps are taken in the file's unit, so that whole degrees stay whole degrees.
    const double from = in_file_unit(motion.from, Unit::angle, problem.units);
    const double to = in_file_unit(motion.to, Unit::angle, problem.units);
    angles.push_back(motion.from);
    for (int i = 1; i < steps; ++i)
        angles.push_back(from_file_unit(from + (to - from) * i / steps, Unit::angle, problem.units));
    angles.push_back(motion.to);
    return angles;
}

bool motion_row(const Problem& problem, const Motion& motion, const Design& design, double crank_angle,
                std::span<double> row) {
    const Mechanism& mechanism = *problem.mechanism;
    if (!mechanism.motion_row(motion, design.dimensions, crank_angle, row)) return false;
    for (std::size_t c = 0; c < row.size(); ++c)
        row[c] = in_file_unit(row[c], mechanism.motion_units[c], problem.units);
    return true;
}

std::string motion_table(const Problem& problem, const Design& design, int steps) {
    std::string text = motion_header(problem);
    const Motion motion = motion_of(problem, design);
    std::vector<double> row(problem.mechanism->motion_columns.size());
    for (const double angle : motion_angles(problem, motion, steps)) {
        if (!motion_row(problem, motion, design, angle, row)) continue;
        for (std::size_t c = 0; c < row.size(); ++c) {
            if (c > 0) text += ',';
            text += csv_number(row[c]);
        }
        text += '\n';
    }
    return text;
}

}  // namespace mechwright
