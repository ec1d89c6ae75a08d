#pragma once
/// \file
/// Drawings for CAD: DXF release 12, in the lengths of the problem.

#include <string>
#include <vector>

#include "synthesis/report/drawing/scene.h"

namespace mechwright {

struct DxfCurve {
    std::string layer;  ///< of capitals, digits, "-" and "_"
    std::vector<ArcVertex> vertices;
    bool closed = false;
};

struct DxfCircle {
    std::string layer;
    Vector<double> centre;
    double radius;
};

struct DxfText {
    std::string layer;
    Vector<double> at;  ///< its lower left corner
    double height;
    std::string text;  ///< UTF-8
};

/// What a drawing consists of, and the unit of its lengths as problem files name it.
struct DxfDrawing {
    std::vector<DxfCurve> curves;
    std::vector<DxfCircle> circles{};
    std::vector<DxfText> texts{};
    std::string unit{};
};

/// Lines are LINE, anything longer a POLYLINE whose bulges are circular arcs; every layer has an entry in the table of
/// layers, and the header says the unit ($INSUNITS), where it is one that CAD programs know.
std::string dxf_text(const DxfDrawing& drawing);

/// A mechanism at a crank angle: each body on a layer of its own name, the curves on layers GROUND, PATH and FOLLOW,
/// pins and pivots as circles on PINS and PIVOTS, target points on TARGETS, names of bodies and points on NAMES;
/// rollers and wheels are circles. Precondition: it assembles there.
std::string dxf_of(const FinishedDesign& design, const Scene& scene, double crank_angle);

}  // namespace mechwright
