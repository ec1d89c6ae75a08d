#include "synthesis/report/csv/motion_table.h"

#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/csv/csv_text.h"

namespace mechwright {

namespace {

std::string header(const Mechanism& mechanism, const Units& units) {
    std::string line;
    for (std::size_t c = 0; c < mechanism.table.columns.size(); ++c) {
        std::string name(mechanism.table.columns[c]);
        const std::string unit = unit_label(mechanism.table.units[c], units);
        if (!unit.empty()) name += " [" + unit + "]";
        if (c > 0) line += ',';
        line += csv_field(name);
    }
    return line + '\n';
}

}  // namespace

std::string motion_header(const Problem& problem) { return header(*problem.mechanism, problem.units); }

std::string motion_table(const Problem& problem, const Design& design, int steps) {
    return motion_table(finished_design(problem, design), steps);
}

std::string motion_table(const FinishedDesign& design, int steps) {
    std::string text = header(*design.mechanism, design.units);
    for (const double angle : even_angles(design, steps)) {
        const MotionRow row(design, angle);
        if (!row.assembled()) continue;
        for (std::size_t c = 0; c < row.values().size(); ++c) {
            if (c > 0) text += ',';
            text += csv_number(in_file_unit(design, row, c));
        }
        text += '\n';
    }
    return text;
}

}  // namespace mechwright
