#include "synthesis/target/path/numbers.h"

namespace mechwright {

void add_crank_start(Mechanism& m) {
    m.point->roles.start = m.dimensions.size();
    m.dimensions.push_back({"crank-start", DimensionKind::angle, false,
                            "crank angle from which prescribed crank angles are counted", false, m.point->named});
}

void add_body_angle(Mechanism& m) {
    m.point->roles.body = m.dimensions.size();
    m.body->reads = m.body->reads.and_then(m.dimensions.size(), 1);
    m.dimensions.push_back({"body-angle", DimensionKind::angle, false,
                            "direction of a guided body, from " + m.body->angle_from, false, m.point->named});
}

std::vector<Quantity> path_quantities() {
    return {
        {.name = "path-sse",
         .unit = Unit::area,
         .meaning = "weighted sum of squared distances from the target points",
         .path = PathMeasure::sum_of_squares,
         .section = "path"},
        {.name = "path-rms",
         .unit = Unit::length,
         .meaning = "root of the weighted mean of squared distances from the target points",
         .path = PathMeasure::root_mean_square,
         .section = "path"},
        {.name = "path-max",
         .unit = Unit::length,
         .meaning = "greatest distance from a target point",
         .path = PathMeasure::greatest,
         .section = "path"},
    };
}

std::vector<Quantity> pose_quantities() {
    return {
        {.name = "pose-rms",
         .unit = Unit::length,
         .meaning = "root of the weighted mean of squared distances of the body from the target poses",
         .path = PathMeasure::root_mean_square,
         .section = "poses"},
        {.name = "pose-max",
         .unit = Unit::length,
         .meaning = "greatest distance of the body from a target pose",
         .path = PathMeasure::greatest,
         .section = "poses"},
    };
}

}  // namespace mechwright
