#include "synthesis/mechanism/drawing/motion_row.h"

#include <algorithm>

namespace mechwright {

MotionRow::MotionRow(const MovingDesign& design, double crank_angle)
    : design_(&design),
      values_(design.mechanism->table.columns.size()),
      assembled_(design.mechanism->table.row(design.motion, design.dimensions, crank_angle, values_)) {}

double MotionRow::operator[](std::string_view column) const {
    const auto& columns = design_->mechanism->table.columns;
    return values_[static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin())];
}

Vector<double> MotionRow::vector(std::string_view name) const {
    return {(*this)[std::string(name) + "-x"], (*this)[std::string(name) + "-y"]};
}

}  // namespace mechwright
