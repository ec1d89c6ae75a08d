#include "synthesis/report/drawing/exported.h"

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/mechanism/input.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/csv/motion_table.h"
#include "synthesis/report/drawing/dxf.h"
#include "synthesis/report/drawing/motion_json.h"
#include "synthesis/report/drawing/sketch.h"
#include "synthesis/report/drawing/svg.h"
#include "synthesis/report/json_text.h"

namespace mechwright {

namespace {

std::string exported_at(const FinishedDesign& design, const std::string& format, const ExportedPart& part,
                        double angle) {
    if (format == "csv") return motion_table(design, part.steps);
    // A sketch is to be worked on: fewer arcs, each still within a thousandth of the drawing.
    const Scene scene = scene_of(design, part.fineness.value_or(format == "slvs" ? 1e-3 : 1e-6));
    if (format == "json") return json_text(motion_json(design, scene, part.steps));
    if (format == "dxf") return dxf_of(design, scene, angle);
    return sketch_of(design, scene, angle);
}

}  // namespace

std::string export_format_fault(const std::string& format) {
    if (std::find(export_formats.begin(), export_formats.end(), format) != export_formats.end()) return {};
    return fmt::format("unknown format {}; {}", reading::quoted(format), reading::remedy(format, export_formats));
}

Exported exported(const FinishedDesign& design, const std::string& format, const ExportedPart& part) {
    const Unit unit = input_unit(design);
    const double angle = part.at ? from_file_unit(*part.at, unit, design.units) : pictured_angle(design);
    if (MotionRow(design, angle).assembled()) return {exported_at(design, format, part, angle), {}};
    return {{},
            fmt::format("{}: the mechanism does not assemble at this {}; it does from {} to {}", part.at.value_or(0),
                        input_word(*design.mechanism), in_file_unit(design.motion.from, unit, design.units),
                        in_file_unit(design.motion.to, unit, design.units))};
}

}  // namespace mechwright
