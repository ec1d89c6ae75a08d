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

/// Lines are LINE, anything longer a POLYLINE whose bulges are circular arcs; every layer has an entry in the table of
/// layers.
std::string dxf_text(const std::vector<DxfCurve>& curves, const std::vector<DxfCircle>& circles);

/// A mechanism at a crank angle: each body on a layer of its own name, the curves on layers GROUND, PATH and FOLLOW,
/// pins and pivots as circles on PINS and PIVOTS, target points on TARGETS. Precondition: it assembles there.
std::string dxf_of(const FinishedDesign& design, const Scene& scene, double crank_angle);

}  // namespace mechwright
