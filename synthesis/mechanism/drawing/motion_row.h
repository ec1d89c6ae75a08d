#pragma once
/// \file
/// The columns of the motion table at a crank angle, by their names.

#include <string_view>
#include <vector>

#include "synthesis/mechanism/drawing/moving_design.h"

namespace mechwright {

/// Values in radians and the problem's lengths.
class MotionRow {
public:
    MotionRow(const MovingDesign& design, double crank_angle);

    /// False where the mechanism does not assemble; then there are no values.
    bool assembled() const { return assembled_; }
    const std::vector<double>& values() const { return values_; }
    /// Precondition: the mechanism has a column of this name.
    double operator[](std::string_view column) const;
    /// The vector of the columns NAME-x and NAME-y.
    Vector<double> vector(std::string_view name) const;

private:
    const MovingDesign* design_;
    std::vector<double> values_;
    bool assembled_;
};

}  // namespace mechwright
