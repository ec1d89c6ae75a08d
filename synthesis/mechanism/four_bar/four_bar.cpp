#include "synthesis/mechanism/four_bar/four_bar.h"

#include <cmath>
#include <numbers>

#include "analysis/four_bar.h"
#include "analysis/four_bar/exact_turn.h"
#include "analysis/numbers/interval.h"
#include "synthesis/mechanism/four_bar/as_linkage.h"
#include "synthesis/mechanism/four_bar/cognates.h"
#include "synthesis/mechanism/four_bar/coupler_path.h"
#include "synthesis/mechanism/four_bar/drawing.h"
#include "synthesis/mechanism/four_bar/explained.h"
#include "synthesis/mechanism/four_bar/formulas.h"
#include "synthesis/mechanism/four_bar/function.h"
#include "synthesis/mechanism/four_bar/instant.h"
#include "synthesis/mechanism/four_bar/measure_again.h"
#include "synthesis/mechanism/four_bar/path/curve.h"
#include "synthesis/mechanism/four_bar/path/screening.h"
#include "synthesis/mechanism/four_bar/tasks.h"
#include "synthesis/mechanism/measure_by.h"
#include "synthesis/target/followed/arc.h"
#include "synthesis/target/followed/line.h"

namespace mechwright {

namespace {

using namespace four_bar;

std::vector<Dimension> dimensions() {
    return {
        {"ground", DimensionKind::length, true, "ground link, crank pivot to rocker pivot"},
        {"crank", DimensionKind::length, true, "crank, crank pivot to crank pin"},
        {"coupler", DimensionKind::length, true, "coupler, crank pin to rocker pin"},
        {"rocker", DimensionKind::length, true, "rocker, rocker pivot to rocker pin"},
        {"point-along", DimensionKind::coordinate, false, "coupler point along the line from crank pin to rocker pin"},
        {"point-across", DimensionKind::coordinate, false, "coupler point to the left of that line"},
        {"origin-x", DimensionKind::coordinate, false, "crank pivot in the drawing"},
        {"origin-y", DimensionKind::coordinate, false, "crank pivot in the drawing"},
        {"tilt", DimensionKind::angle, false, "direction of the ground link in the drawing"},
    };
}

bool of_crank_rocker(const Motion& motion) { return motion.family == crank_rocker; }
bool of_any(const Motion&) { return true; }
bool of_known_range(const Motion& motion) { return motion.full_turn || motion.from <= motion.to; }

template <std::size_t count>
std::size_t components(const Motion&) {
    return count;
}
std::size_t link_ratio_components(const Motion& motion) { return motion.family == limited_range ? 12 : 3; }
std::size_t grashof_components(const Motion& motion) { return motion.family == limited_range ? 1 : 3; }
std::size_t transmission_components(const Motion& motion) {
    return motion.full_turn ? 1 : transmission_extremes_of(motion).count;
}
std::size_t worst_transmission_components(const Motion& motion) { return 2 * transmission_components(motion); }
std::size_t velocity_ratio_components(const Motion& motion) { return VelocityRatioExtreme<1>::places(motion); }
std::size_t assembly_margin_components(const Motion& motion) { return 2 * transmission_extremes_of(motion).count; }

FunctionGeneration rocker_function() {
    FunctionGeneration f;
    f.output = {DimensionKind::angle, "rocker angle at the start of a function's range",
                "rocker angle over the range of a function"};
    f.quantities = function_quantities<RockerAngle, RockerAngleAgain>(
        links, Unit::angle, "greatest difference of the rocker angle from the function",
        "root mean square difference of the rocker angle from the function");
    f.fit = fit_function;
    f.extremes = function_extremes_by<RockerAngle>;
    f.loop_row = rocker_loop_row<Interval>;
    return f;
}

std::vector<Quantity> over_input() {
    return {
        input_transmission_quantity<RockerTransmission, TransmissionExtreme::least>("transmission-angle-min", links),
        input_transmission_quantity<RockerTransmission, TransmissionExtreme::greatest>("transmission-angle-max", links),
        input_transmission_quantity<RockerTransmission, TransmissionExtreme::worst>("transmission-angle-worst", links),
        moving_quantity<VelocityRatioExtreme<-1>, limited_range, VelocityRatioExtreme<-1>::most>(
            "velocity-ratio-min", links, Unit::none, Reduce::least, true),
        moving_quantity<VelocityRatioExtreme<1>, limited_range, VelocityRatioExtreme<1>::most>(
            "velocity-ratio-max", links, Unit::none, Reduce::greatest, true)};
}

std::vector<Quantity> quantities() {
    std::vector<Quantity> all{
        {"time-ratio", Unit::none, "time of the slow stroke over time of the fast stroke, >= 1", Reduce::greatest,
         links, of_crank_rocker, components<2>, measure_by<TimeRatio>, time_ratio_again},
        {"swing", Unit::angle, "angle through which the rocker swings over a full turn of the crank", Reduce::only,
         links, of_crank_rocker, components<1>, measure_by<Swing>, swing_again},
        {"transmission-angle-min", Unit::angle, "least angle between coupler and rocker over the motion", Reduce::least,
         links, of_known_range, transmission_components, measure_by<TransmissionAngleMin>,
         transmission_angle_min_again},
        {"transmission-angle-max", Unit::angle, "greatest angle between coupler and rocker over the motion",
         Reduce::greatest, links, of_known_range, transmission_components, measure_by<TransmissionAngleMax>,
         transmission_angle_max_again},
        {"transmission-angle-worst", Unit::angle, "least of the transmission angle and its supplement over the motion",
         Reduce::least, links, of_known_range, worst_transmission_components, measure_by<TransmissionAngleWorst>,
         transmission_angle_worst_again},
        {"velocity-ratio-min", Unit::none, "least angular velocity of the rocker over that of the crank (signed)",
         Reduce::least, links, of_known_range, velocity_ratio_components, measure_by<VelocityRatioExtreme<-1>>,
         velocity_ratio_min_again, PathMeasure::none, true},
        {"velocity-ratio-max", Unit::none, "greatest angular velocity of the rocker over that of the crank (signed)",
         Reduce::greatest, links, of_known_range, velocity_ratio_components, measure_by<VelocityRatioExtreme<1>>,
         velocity_ratio_max_again, PathMeasure::none, true},
        {"link-ratio", Unit::none, "longest link over shortest link", Reduce::greatest, links, of_any,
         link_ratio_components, measure_by<LinkRatio>, link_ratio_again},
        {"total-length", Unit::length, "sum of the four link lengths", Reduce::only, links, of_any, components<1>,
         measure_by<TotalLength>, total_length_again},
        {"grashof-margin", Unit::length,
         "p + q - s - l: the middle links less shortest and longest; < 0: no link turns fully", Reduce::least, links,
         of_any, grashof_components, measure_by<GrashofMargin>, grashof_margin_again},
    };
    for (Quantity& quantity : all)
        quantity.of_motion = quantity.defined == of_known_range;
    return all;
}

std::vector<Quantity> at_an_instant() {
    return {
        instant_quantity<OfLink::coupler, Rate::velocity>(
            "instant-coupler-velocity",
            "angular velocity of the coupler over that of the crank at the "
            "crank angle crank-start"),
        instant_quantity<OfLink::rocker, Rate::velocity>("instant-rocker-velocity",
                                                         "angular velocity of the rocker over that of the crank there"),
        instant_quantity<OfLink::coupler, Rate::acceleration>(
            "instant-coupler-acceleration",
            "angular acceleration of the coupler there, for unit velocity of the crank"),
        instant_quantity<OfLink::rocker, Rate::acceleration>(
            "instant-rocker-acceleration", "angular acceleration of the rocker there, for unit velocity of the crank"),
    };
}

/// Not a quantity of the contract: what keeps a design of limited range assembled.
Quantity assembly_margin() {
    return {.name = "assembly margin",
            .unit = Unit::length,
            .meaning = "the mechanism assembles",
            .reduce = Reduce::least,
            .reads = links,
            .defined = of_known_range,
            .components = assembly_margin_components,
            .measure = measure_by<AssemblyMargin>};
}

// Coefficients of ground, crank, coupler, rocker.
std::vector<Family> families() {
    return {
        {"crank-rocker",
         true,
         {{"the crank turns past the longest ground link", {-1, -1, 1, 1}},
          {"the crank turns past the longest coupler", {1, -1, -1, 1}},
          {"the crank turns past the longest rocker", {1, -1, 1, -1}}},
         {}},
        {"double crank",
         true,
         {{"the links turn past the longest crank", {-1, -1, 1, 1}},
          {"the links turn past the longest coupler", {-1, 1, -1, 1}},
          {"the links turn past the longest rocker", {-1, 1, 1, -1}}},
         {}},
        {"limited crank range", false, {}, assembly_margin()},
    };
}

FourBar<double> linkage_of(std::span<const double> d) { return {d[0], d[1], d[2], d[3]}; }

Motion motion_by_links(Form form, std::span<const double> d, const double* crank_range) {
    const FourBar<double> m = linkage_of(d);
    const Grashof grashof = classify(m);
    Motion motion;
    motion.assembly = form.assembly;
    motion.family = grashof.kind == FourBarClass::crank_rocker   ? crank_rocker
                    : grashof.kind == FourBarClass::double_crank ? double_crank
                                                                 : limited_range;
    const CrankRange<double> range = assembled_range(m);
    motion.full_turn = range.full_turn && crank_range == nullptr;
    motion.from = crank_range ? crank_range[0] : range.from;
    motion.to = crank_range ? crank_range[1] : range.to;
    return motion;
}

std::string describe(Form, std::span<const double> d) {
    const Grashof grashof = classify(linkage_of(d));
    std::string text = name_of(grashof.kind);
    if (grashof.parallelogram)
        text += ", parallelogram";
    else if (grashof.kite)
        text += ", kite";
    if (grashof.change_point) text += ", with change points";
    return text;
}

std::vector<std::string> columns() {
    return {"crank-angle",      "coupler-angle",   "rocker-angle",         "transmission-angle",
            "coupler-velocity", "rocker-velocity", "coupler-acceleration", "rocker-acceleration",
            "point-x",          "point-y"};
}

std::vector<Unit> units() {
    return {Unit::angle, Unit::angle, Unit::angle, Unit::angle,  Unit::none,
            Unit::none,  Unit::none,  Unit::none,  Unit::length, Unit::length};
}

bool motion_row(const Motion& motion, std::span<const double> d, double crank_angle, std::span<double> row) {
    const FourBar<double> m = linkage_of(d);
    const Assembly assembly = motion.assembly == 0 ? Assembly::open : Assembly::crossed;
    auto p = pose(m, exact_half_turn(crank_angle), assembly);
    const bool change_point = is_change_point(p);
    if (change_point) p = pose(m, beside_change_point(crank_angle), assembly);
    if (!p.assembled()) return false;
    const auto v = velocity(m, p);
    const auto a = change_point ? FourBarAcceleration<double>{} : acceleration(m, p, v);
    const Placement<double> placement{{d[6], d[7]}, d[8]};
    const auto point = placed(position(m, CouplerPoint<double>{d[4], d[5]}, p), placement);
    const std::array<double, 10> values{crank_angle,
                                        std::atan2(p.coupler.y, p.coupler.x),
                                        std::atan2(p.rocker.y, p.rocker.x),
                                        std::abs(std::atan2(p.transmission_sine, p.transmission_cosine)),
                                        v.coupler,
                                        v.rocker,
                                        a.coupler,
                                        a.rocker,
                                        point.x,
                                        point.y};
    std::copy(values.begin(), values.end(), row.begin());
    return true;
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

std::shared_ptr<const Mechanism> four_bar_mechanism() {
    static const auto mechanism = std::make_shared<const Mechanism>(
        Mechanism{.name = "four-bar",
                  .meaning = "four links, four pins: crank, coupler, rocker on a ground link",
                  .dimensions = dimensions(),
                  .assemblies = {"open", "crossed"},
                  .quantities = quantities(),
                  .families = families(),
                  .motion = motion_by_links,
                  .motion_again = four_bar_motion_again,
                  .ways_again = four_bar_ways_again,
                  .describe = describe,
                  .check_motion = four_bar_check_motion,
                  .table = table(),
                  .formulas = four_bar_formulas(),
                  .tasks = four_bar_tasks(),
                  .drawing = four_bar_drawing(),
                  .as_linkage = four_bar_as_linkage(),
                  .point = PointGuidance{.reads = CouplerPath::reads,
                                         .roles = {4, 5, 6, 7, 8},
                                         .miss = path_miss_by<CouplerPath>,
                                         .point = four_bar_path_point,
                                         .screening = four_bar_screening,
                                         .curve = four_bar_curve_fit(),
                                         .draws_same_curve = are_cognates},
                  .body = BodyGuidance{CouplerPath::reads, "the line of the coupler's pins", pose_miss_by<CouplerPose>},
                  .input = InputRange{links, input_margin_quantity<InputMargin>(links), over_input()},
                  .function = rocker_function(),
                  .line = followed_shape<CouplerPath, four_bar_path_point, LineShape>(),
                  .arc = followed_shape<CouplerPath, four_bar_path_point, ArcShape>(),
                  .at_instant = at_an_instant(),
                  .targets = {"path", "function", "poses", "line", "arc", "instant"}});
    return mechanism;
}

bool is_four_bar(const Mechanism& mechanism) { return mechanism.motion == motion_by_links; }

}  // namespace mechwright
