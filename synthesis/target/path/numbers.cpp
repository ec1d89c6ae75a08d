#include "synthesis/target/path/numbers.h"

#include <algorithm>
#include <string>
#include <utility>

#include "synthesis/mechanism/input.h"

namespace mechwright {

namespace {

/// A number in the section of a target, where the file names what it guides.
std::size_t add_number(Mechanism& m, std::string name, std::string meaning, DimensionKind kind = DimensionKind::angle) {
    m.dimensions.push_back({std::move(name), kind, false, std::move(meaning), false, m.point->named});
    return m.dimensions.size() - 1;
}

std::string of_target(const GuidedTarget& target) { return " of '" + target.name + "'"; }

/// Those of one of several targets.
std::vector<Quantity> named_quantities(std::vector<Quantity> quantities, const Mechanism& m, std::size_t target) {
    for (Quantity& quantity : quantities) {
        quantity.name = m.guided[target].name + "." + quantity.name;
        quantity.meaning += of_target(m.guided[target]);
        quantity.of_target = target;
    }
    return quantities;
}

}  // namespace

void add_crank_start(Mechanism& m) {
    const DimensionKind kind = kind_of_input(m);
    const std::string meaning = kind == DimensionKind::angle
                                    ? "crank angle from which prescribed crank angles are counted"
                                    : "displacement from which prescribed ones are counted";
    for (GuidedTarget& target : m.guided)
        target.roles.start = add_number(m, target.name + ".crank-start", meaning + of_target(target), kind);
    m.point->roles.start =
        m.guided.empty() ? add_number(m, "crank-start", meaning, kind) : m.guided.front().roles.start;
}

void add_body_angle(Mechanism& m) {
    const auto meaning = [](const BodyGuidance& body) { return "direction of a guided body, from " + body.angle_from; };
    const auto read = [](BodyGuidance& body, std::size_t angle) { body.reads = body.reads.and_then(angle, 1); };
    for (GuidedTarget& target : m.guided) {
        if (!target.body) continue;
        target.roles.body = add_number(m, target.name + ".body-angle", meaning(*target.body) + of_target(target));
        read(*target.body, target.roles.body);
        if (m.point->roles.body != no_dimension) continue;
        m.point->roles.body = target.roles.body;
        m.body = target.body;
    }
    if (!m.guided.empty()) return;
    m.point->roles.body = add_number(m, "body-angle", meaning(*m.body));
    read(*m.body, m.point->roles.body);
}

std::vector<Quantity> quantities_of_targets(const Mechanism& m) {
    std::vector<Quantity> all = m.body ? pose_quantities() : path_quantities();
    const bool has_path = std::any_of(m.guided.begin(), m.guided.end(), [](const auto& one) { return !one.body; });
    if (has_path) all = path_quantities();
    // Of several targets a sum of squares would depend on how many points each has.
    std::erase_if(all, [](const Quantity& q) { return q.path == PathMeasure::sum_of_squares; });
    for (Quantity& quantity : all)
        quantity.meaning = quantity.path == PathMeasure::greatest
                               ? "greatest distance from a target of all paths and poses"
                               : "root of the weighted mean of the squares of what all paths and poses have";
    for (std::size_t i = 0; i < m.guided.size(); ++i)
        for (Quantity& quantity : named_quantities(m.guided[i].body ? pose_quantities() : path_quantities(), m, i))
            all.push_back(std::move(quantity));
    return all;
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
