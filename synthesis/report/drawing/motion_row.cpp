#include "synthesis/report/drawing/motion_row.h"

#include <algorithm>

#include "synthesis/problem/units.h"

namespace mechwright {

MotionRow::MotionRow(const FinishedDesign& design, double crank_angle)
    : design_(&design),
      values_(design.mechanism->table.columns.size()),
      assembled_(design.mechanism->table.row(design.motion, design.dimensions, crank_angle, values_)) {}

double MotionRow::in_file_unit(std::size_t column) const {
    return mechwright::in_file_unit(values_[column], design_->mechanism->table.units[column], design_->units);
}

double MotionRow::operator[](std::string_view column) const {
    const auto columns = design_->mechanism->table.columns;
    return values_[static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin())];
}

Vector<double> MotionRow::vector(std::string_view name) const {
    return {(*this)[std::string(name) + "-x"], (*this)[std::string(name) + "-y"]};
}

std::vector<double> even_angles(const FinishedDesign& design, int steps) {
    const Motion& motion = design.motion;
    if (!design.assembles()) return {};
    const double from = in_file_unit(motion.from, Unit::angle, design.units);
    const double to = in_file_unit(motion.to, Unit::angle, design.units);
    std::vector<double> angles{motion.from};
    for (int i = 1; i < steps; ++i)
        angles.push_back(from_file_unit(from + (to - from) * i / steps, Unit::angle, design.units));
    angles.push_back(motion.to);
    return angles;
}

}  // namespace mechwright
