#include "synthesis/mechanism/slider_crank/slider_crank.h"

#include <cmath>

#include "analysis/four_bar/exact_turn.h"
#include "analysis/numbers/interval.h"
#include "synthesis/mechanism/measure_by.h"
#include "synthesis/mechanism/quick_return/drive.h"
#include "synthesis/mechanism/slider_crank/again.h"
#include "synthesis/mechanism/slider_crank/layout.h"
#include "synthesis/mechanism/slider_crank/ram_function.h"
#include "synthesis/mechanism/slider_crank/rod_path.h"
#include "synthesis/target/followed/arc.h"
#include "synthesis/target/followed/line.h"

namespace mechwright {

namespace {

using namespace quick_return;

std::vector<Dimension> dimensions() {
    return {
        {"crank", DimensionKind::length, true, "crank, crank pivot to crank pin"},
        {"rod", DimensionKind::length, true, "rod, crank pin to ram"},
        {"offset", DimensionKind::coordinate, true,
         "distance of the slide line from the crank pivot, positive to its left"},
        {"point-along", DimensionKind::coordinate, false, "point of the rod along the line from crank pin to ram"},
        {"point-across", DimensionKind::coordinate, false, "point of the rod to the left of that line"},
        {"origin-x", DimensionKind::coordinate, false, "crank pivot in the drawing"},
        {"origin-y", DimensionKind::coordinate, false, "crank pivot in the drawing"},
        {"tilt", DimensionKind::angle, false, "direction of the slide in the drawing"},
    };
}

FunctionGeneration ram_function() {
    FunctionGeneration f;
    f.output = {DimensionKind::coordinate, "position of the ram at the start of a function's range",
                "way of the ram over the range of a function"};
    f.quantities = function_quantities<RamPosition, RamPositionAgain>(
        ram_links, Unit::length, "greatest difference of the ram's position from the function",
        "root mean square difference of the ram's position from the function");
    f.fit = fit_ram_function;
    f.extremes = function_extremes_by<RamPosition>;
    f.loop_row = ram_loop_row<Interval>;
    return f;
}

std::vector<Quantity> over_input() {
    return {
        input_transmission_quantity<RodTransmission, TransmissionExtreme::least>("transmission-angle-min", ram_links),
        input_transmission_quantity<RodTransmission, TransmissionExtreme::least>("transmission-angle-worst", ram_links),
        moving_quantity<TransmissionAngleMax<SliderCrank>, limited_range, quick_return::detail::limited_places>(
            "transmission-angle-max", ram_links, Unit::angle, Reduce::greatest),
        moving_quantity<Stroke<SliderCrank>, limited_range, Stroke<SliderCrank>::most>("stroke", ram_links,
                                                                                       Unit::length, Reduce::greatest),
        moving_quantity<RamSpeedMax<SliderCrank>, limited_range, RamSpeedMax<SliderCrank>::most>(
            "ram-speed-max", ram_links, Unit::length, Reduce::greatest),
        moving_quantity<RamAccelerationMax<SliderCrank>, limited_range, RamAccelerationMax<SliderCrank>::most>(
            "ram-acceleration-max", ram_links, Unit::length, Reduce::greatest)};
}

// Coefficients of crank, rod, offset.
std::vector<Family> families() {
    return {
        {"crank turns fully",
         true,
         {{"the crank turns past the side away from the slide line", {-1, 1, -1}},
          {"the crank turns past the side of the slide line", {-1, 1, 1}}},
         {}},
        {"limited crank range", false, {}, assembly_margin_quantity<SliderCrank>()},
    };
}

std::string describe(Form, std::span<const double> d) {
    const SliderCrank<double> m = drive_of<SliderCrank>(d, 0);
    const RodMargins<double> margin = rod_margins(m);
    const double least = std::min(margin.crank_right, margin.crank_left);
    std::string text = m.offset == 0 ? "in-line slider-crank" : "offset slider-crank";
    if (least < 0) text += ", crank does not turn fully";
    if (least == 0) text += ", rod square to the slide once in a turn";
    return text;
}

std::vector<std::string> columns() {
    return {"crank-angle",  "rod-angle",    "transmission-angle", "rod-velocity", "rod-acceleration",
            "ram-position", "ram-velocity", "ram-acceleration",   "point-x",      "point-y"};
}

std::vector<Unit> units() {
    return {Unit::angle,  Unit::angle,  Unit::angle,  Unit::none,   Unit::none,
            Unit::length, Unit::length, Unit::length, Unit::length, Unit::length};
}

bool motion_row(const Motion&, std::span<const double> d, double crank_angle, std::span<double> row) {
    const SliderCrank<double> m = drive_of<SliderCrank>(d, 0);
    auto p = pose(m, exact_direction(crank_angle));
    // Crank and rod square to the slide, in one line: odd about it, as a four-bar is about the ground line.
    const bool change_point = p.crank.x == 0 && (p.left == 0 || p.right == 0);
    if (change_point) p = pose(m, crank_angle);
    if (!p.assembled()) return false;
    const auto v = velocity(m, p);
    const auto a = change_point ? SliderCrankAcceleration<double>{} : acceleration(m, p, v);
    const auto point = placed(position(m, CouplerPoint<double>{d[3], d[4]}, p), Placement<double>{{d[5], d[6]}, d[7]});
    const std::array<double, 10> values{crank_angle,
                                        std::atan2(p.rod.y, p.rod.x),
                                        transmission_angle(p),
                                        v.rod,
                                        a.rod,
                                        p.position,
                                        v.ram,
                                        a.ram,
                                        point.x,
                                        point.y};
    std::copy(values.begin(), values.end(), row.begin());
    return true;
}

std::vector<Quantity> quantities() {
    return ram_quantities<SliderCrank, SliderCrankAgain>(
        "crank and rod together",
        "least angle at the ram over the motion: 90 deg less the angle from slide line to rod",
        "greatest angle at the ram over the motion", "least angle at the ram over the motion");
}

// Made here and not within the braces of the mechanism: where memory runs out between them, GCC 12 destroys it twice.
MotionTable table() {
    MotionTable t;
    t.columns = columns();
    t.units = units();
    t.row = motion_row;
    return t;
}

}  // namespace

std::shared_ptr<const Mechanism> slider_crank_mechanism() {
    static const auto mechanism = std::make_shared<const Mechanism>(
        Mechanism{.name = "slider-crank",
                  .meaning = "a crank drives a ram on a straight slide through a rod",
                  .dimensions = dimensions(),
                  .assemblies = {},
                  .quantities = quantities(),
                  .families = families(),
                  .settings = settings(),
                  .rod_sloped_by_stroke = quick_return::Layout<SliderCrank>::links[1],
                  .motion = motion_by_drive<SliderCrank>,
                  .motion_again = SliderCrankAgain::motion,
                  .ways_again = slider_crank_ways,
                  .describe = describe,
                  .check_motion = SliderCrankAgain::check_motion,
                  .table = table(),
                  .formulas = slider_crank_formulas(),
                  .tasks = slider_crank_tasks(),
                  .drawing = slider_crank_drawing(),
                  .as_linkage = slider_crank_as_linkage(),
                  .point = PointGuidance{.reads = RodPath::reads,
                                         .roles = {3, 4, 5, 6, 7},
                                         .miss = path_miss_by<RodPath>,
                                         .point = rod_path_point},
                  .body = BodyGuidance{RodPath::reads, "that of the rod", pose_miss_by<RodPose>},
                  .input = InputRange{ram_links, input_margin_quantity<RamInputMargin>(ram_links), over_input()},
                  .function = ram_function(),
                  .line = followed_shape<RodPath, rod_path_point, LineShape>(),
                  .arc = followed_shape<RodPath, rod_path_point, ArcShape>(),
                  .targets = {"path", "poses", "function", "line", "arc"}});
    return mechanism;
}

bool is_slider_crank(const Mechanism& mechanism) { return mechanism.motion == motion_by_drive<SliderCrank>; }

}  // namespace mechwright
