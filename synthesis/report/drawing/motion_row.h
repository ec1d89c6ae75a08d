#pragma once
/// \file
/// The motion of a finished design: crank angles over it, and at each of them the columns of the motion table by their
/// names.

#include <string_view>
#include <vector>

#include "synthesis/report/drawing/finished.h"

namespace mechwright {

/// Values in radians and the problem's lengths.
class MotionRow {
public:
    MotionRow(const FinishedDesign& design, double crank_angle);

    /// False where the mechanism does not assemble; then there are no values.
    bool assembled() const { return assembled_; }
    const std::vector<double>& values() const { return values_; }
    /// A value as files have it.
    double in_file_unit(std::size_t column) const;
    /// Precondition: the mechanism has a column of this name.
    double operator[](std::string_view column) const;
    /// The vector of the columns NAME-x and NAME-y.
    Vector<double> vector(std::string_view name) const;

private:
    const FinishedDesign* design_;
    std::vector<double> values_;
    bool assembled_;
};

/// `steps` + 1 crank angles (radians) from one end of the motion to the other, even in the file's unit, so that whole
/// degrees stay whole degrees; none where it does not assemble.
std::vector<double> even_angles(const FinishedDesign& design, int steps);

}  // namespace mechwright
