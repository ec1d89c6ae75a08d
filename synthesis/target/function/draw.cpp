#include "synthesis/target/function/draw.h"

#include <cmath>
#include <numbers>

#include "synthesis/target/function/function_target.h"

namespace mechwright {

double function_error(const FinishedDesign& design, const MotionRow& row, double share) {
    const double asked = design["output-start"] + design["output-range"] * part_at(*design.function, share);
    return deviation_from(*design.mechanism, "function").unit == Unit::angle
               ? std::remainder(row["rocker-angle"] - asked, 2 * std::numbers::pi)
               : row["ram-position"] - asked;
}

}  // namespace mechwright
