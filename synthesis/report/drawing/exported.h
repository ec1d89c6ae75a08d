#pragma once
/// \file
/// A design for other programs: CAD, spreadsheets and scripts.

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "synthesis/report/drawing/finished.h"

namespace mechwright {

inline constexpr std::array<std::string_view, 4> export_formats{"dxf", "slvs", "csv", "json"};

/// What is wrong with the name of a format; empty if nothing is.
std::string export_format_fault(const std::string& format);

/// What of a design is exported, where that is not all of it.
struct ExportedPart {
    std::optional<double> at;        ///< crank angle, or displacement, of a drawing, in the unit of the problem
    std::optional<double> fineness;  ///< deviation of curves over the drawing
    int steps = 360;                 ///< over the motion, of tables
};

struct Exported {
    std::string text;
    std::string fault;  ///< "ANGLE: ...": why there is none at that angle; empty if there is one
};

/// Preconditions: the format is one of those, and the design assembles somewhere.
Exported exported(const FinishedDesign& design, const std::string& format, const ExportedPart& part);

}  // namespace mechwright
