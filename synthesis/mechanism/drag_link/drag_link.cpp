#include "synthesis/mechanism/drag_link/drag_link.h"

#include <cmath>

#include "analysis/four_bar/exact_turn.h"
#include "synthesis/mechanism/drag_link/again.h"
#include "synthesis/mechanism/drag_link/layout.h"
#include "synthesis/mechanism/measure_by.h"
#include "synthesis/mechanism/quick_return/drive.h"

namespace mechwright {

namespace {

using namespace quick_return;

std::vector<Dimension> dimensions() {
    return {
        {"ground", DimensionKind::length, true, "ground link, crank pivot to follower pivot"},
        {"crank", DimensionKind::length, true, "crank, crank pivot to crank pin"},
        {"coupler", DimensionKind::length, true, "coupler, crank pin to follower pin"},
        {"follower", DimensionKind::length, true, "follower, its pivot to the follower pin"},
        {"arm", DimensionKind::length, true, "arm on the follower, follower pivot to rod pin"},
        {"arm-angle", DimensionKind::angle, true, "from follower to arm"},
        {"rod", DimensionKind::length, true, "rod, rod pin to ram"},
        {"slide-angle", DimensionKind::angle, true, "from the ground link to the slide line"},
        {"slide-offset", DimensionKind::coordinate, true,
         "distance of the slide line from the follower pivot, positive to its left"},
    };
}

// Coefficients of ground, crank, coupler, follower, arm, arm-angle, rod, slide-angle, slide-offset.
std::vector<Family> families() {
    return {
        {"crank and follower turn fully",
         true,
         {{"the links turn past the longest crank", {-1, -1, 1, 1}},
          {"the links turn past the longest coupler", {-1, 1, -1, 1}},
          {"the links turn past the longest follower", {-1, 1, 1, -1}},
          {"the arm turns past the side away from the slide line", {0, 0, 0, 0, -1, 0, 1, 0, -1}},
          {"the arm turns past the side of the slide line", {0, 0, 0, 0, -1, 0, 1, 0, 1}}},
         {}},
        {"limited crank range", false, {}, assembly_margin_quantity<DragLink>()},
    };
}

std::string describe(Form, std::span<const double> d) {
    const DragLink<double> m = drive_of<DragLink>(d, 0);
    const Grashof grashof = classify(m.links);
    std::string text = grashof.kind == FourBarClass::double_crank
                           ? "drag link"
                           : "no drag link: " + std::string(name_of(grashof.kind));
    if (grashof.change_point) text += ", with change points";
    if (!makes_two_strokes(output_of(m))) text += ", rod too short for a full turn of the arm";
    return text;
}

std::vector<std::string> columns() {
    return {"crank-angle",        "follower-angle",   "rod-angle",         "coupler-transmission-angle",
            "transmission-angle", "coupler-velocity", "follower-velocity", "follower-acceleration",
            "rod-velocity",       "rod-acceleration", "ram-position",      "ram-velocity",
            "ram-acceleration"};
}

std::vector<Unit> units() {
    return {Unit::angle, Unit::angle, Unit::angle, Unit::angle,  Unit::angle,  Unit::none,  Unit::none,
            Unit::none,  Unit::none,  Unit::none,  Unit::length, Unit::length, Unit::length};
}

bool motion_row(const Motion& motion, std::span<const double> d, double crank_angle, std::span<double> row) {
    const DragLink<double> m = drive_of<DragLink>(d, motion.assembly);
    auto p = pose(m, exact_half_turn(crank_angle));
    const bool change_point = is_change_point(p.input);
    if (change_point) p = pose_at(m, beside_change_point(crank_angle));
    if (!p.input.assembled() || !p.output.assembled()) return false;
    const auto v = velocity(m, p);
    const auto a = change_point ? DragLinkAcceleration<double>{{}, acceleration(output_of(m), p.output, v.output, 0.0)}
                                : acceleration(m, p, v);
    const std::array<double, 13> values{crank_angle,
                                        std::atan2(p.input.rocker.y, p.input.rocker.x),
                                        std::atan2(p.output.rod.y, p.output.rod.x),
                                        std::abs(std::atan2(p.input.transmission_sine, p.input.transmission_cosine)),
                                        transmission_angle(p.output),
                                        v.input.coupler,
                                        v.input.rocker,
                                        a.input.rocker,
                                        v.output.rod,
                                        a.output.rod,
                                        p.output.position,
                                        v.output.ram,
                                        a.output.ram};
    std::copy(values.begin(), values.end(), row.begin());
    return true;
}

std::vector<Quantity> quantities() {
    return ram_quantities<DragLink, DragLinkAgain>(
        "ground link, crank, coupler, follower, arm and rod together",
        "least of the angle between coupler and follower and that at the ram (90 deg less the angle from slide line to "
        "rod) over the motion",
        "greatest of the angle between coupler and follower and that at the ram over the motion",
        "least of both angles and their supplements over the motion");
}

}  // namespace

std::shared_ptr<const Mechanism> drag_link_mechanism() {
    static const auto mechanism = std::make_shared<const Mechanism>(
        Mechanism{.name = "drag-link",
                  .meaning = "a four-bar with two full cranks, whose follower drives a ram through a rod",
                  .dimensions = dimensions(),
                  .assemblies = {"open", "crossed"},
                  .quantities = quantities(),
                  .families = families(),
                  .settings = settings(),
                  .motion = motion_by_drive<DragLink>,
                  .motion_again = DragLinkAgain::motion,
                  .ways_again = drag_link_ways,
                  .describe = describe,
                  .check_motion = DragLinkAgain::check_motion,
                  .table = {columns(), units(), motion_row},
                  .formulas = drag_link_formulas(),
                  .tasks = drag_link_tasks(),
                  .drawing = drag_link_drawing(),
                  .as_linkage = drag_link_as_linkage()});
    return mechanism;
}

}  // namespace mechwright
