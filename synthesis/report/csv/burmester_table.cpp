#include "synthesis/report/csv/burmester_table.h"

#include "synthesis/exact/poses/burmester_curve.h"
#include "synthesis/exact/poses/pose_targets.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/csv/csv_text.h"

namespace mechwright {

bool has_burmester_curves(const Problem& problem) {
    return problem.solver.method == "exact" && problem.path && !problem.path->prescribed_timing &&
           problem.path->points.size() == 4 && problem.path->poses() == 4;
}

std::string burmester_table(const Problem& problem) {
    constexpr double step = 0.02, reach = 10;
    const PoseTargets targets = pose_targets(problem);
    const std::string label = unit_label(Unit::length, problem.units);
    std::string text = "stretch";
    for (const char* name : {"fixed-x", "fixed-y", "moving-x", "moving-y"})
        text += "," + csv_field(std::string(name) + " [" + label + "]");
    text += '\n';
    std::size_t number = 0;
    for (const BurmesterStretch& stretch :
         burmester_curves(std::span<const Displacement, 3>(targets.displacements), step, reach)) {
        ++number;
        for (const Dyad& dyad : stretch.dyads) {
            const auto fixed = targets.place.origin + targets.place.size * dyad.fixed;
            const auto moving = targets.place.origin + targets.place.size * dyad.moving;
            text += std::to_string(number);
            for (const double value : {fixed.real(), fixed.imag(), moving.real(), moving.imag()})
                text += "," + csv_number(value);
            text += '\n';
        }
    }
    return text;
}

}  // namespace mechwright
