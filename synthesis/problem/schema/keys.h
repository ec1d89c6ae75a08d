#pragma once
/// \file
/// Every section of a problem file with its keys. What follows from the mechanism (its dimensions, quantities,
/// settings) is not repeated here.

#include <array>
#include <span>
#include <string_view>

#include "synthesis/mechanism/cam/read/keys.h"
#include "synthesis/problem/schema/key.h"
#include "synthesis/problem/schema/linkage_keys.h"

namespace mechwright::keys {

inline constexpr Words<2> angle_units{"deg", "rad"};
inline constexpr Words<4> force_units{"N", "kN", "kgf", "lbf"};
inline constexpr Words<4> mass_units{"g", "kg", "t", "lb"};
inline constexpr Words<3> path_timings{"free", "prescribed", "none"};
inline constexpr Words<2> pose_timings{"free", "prescribed"};
inline constexpr Words<1> use_begins{"first-target"};
inline constexpr Words<1> use_ends{"last-target"};
inline constexpr Words<1> reductions{"max"};
inline constexpr Words<4> designs{"grid", "one-at-a-time", "sobol", "latin-hypercube"};
inline constexpr Words<2> spacings{"linear", "log"};
inline constexpr Words<2> distributions{"normal", "uniform"};
inline constexpr Words<4> charts{"map", "contours", "curves", "front"};

/// Grades of ISO 286 that tolerances can have.
inline constexpr int least_grade = 5, greatest_grade = 13;
inline constexpr std::array<std::string_view, 4> general_tolerances{"ISO 2768-f", "ISO 2768-m", "ISO 2768-c",
                                                                    "ISO 2768-v"};

inline constexpr std::array units{
    Key{"angle", Shape::word, "Unit of all angles of the file. Preset: deg.", false, angle_units},
    Key{"length", Shape::text, "Name of the unit of all lengths, which are never converted. Preset: mm."},
    Key{"force", Shape::word, "Unit of forces, and with that of lengths of torques and spring rates.", false,
        force_units},
    Key{"mass", Shape::word,
        "Unit of masses, which are converted. Preset: the one that goes with force and length, t with N and mm.", false,
        mass_units}};

inline constexpr std::array path{
    Key{"points", Shape::pairs, "Points that the coupler point shall pass: [x, y]."},
    Key{"points_file", Shape::text, "File with two columns, in place of points."},
    Key{"timing", Shape::word,
        "free: at any crank angles, in this order; prescribed: at crank_angles; none: each point counts by the nearest "
        "point of the curve. Preset: free.",
        false, path_timings},
    Key{"closed", Shape::flag, "Whether the crank has to turn fully. Preset: false."},
    Key{"weights", Shape::numbers, "Weight of each point. Preset: 1.", false, {}, {}, positive},
    Key{"crank_angles", Shape::numbers,
        "Crank angle at each point, or displacement of a driven slide, counted from crank-start; all rise or all "
        "fall."},
    Key{"point", Shape::text, "Of a linkage: the point that is guided."},
    Key{"link", Shape::text, "Of a linkage: the link on which it is guided. Preset: the first that has it."},
    Key{"crank-start", Shape::range, "Of a linkage: the crank angle from which crank_angles are counted. Preset: 0."},
    Key{"name", Shape::text, "Of a linkage with several paths and poses: what quantities and results call it."},
    Key{"weight",
        Shape::number,
        "Of a linkage with several paths and poses: weight of its mean square in that of all. Preset: 1.",
        false,
        {},
        {},
        positive}};

inline constexpr std::array poses{
    Key{"poses", Shape::poses, "Poses of the guided body: [x, y, angle], or [x, y] where any angle will do.", true},
    Key{"timing", Shape::word, "Whether the crank angles are prescribed. Preset: free.", false, pose_timings},
    Key{"length",
        Shape::number,
        "Length by which angles are weighed against distances. Preset: half the greatest distance from the first pose.",
        false,
        {},
        {},
        positive},
    Key{"weights", Shape::numbers, "Weight of each pose. Preset: 1.", false, {}, {}, positive},
    Key{"crank_angles", Shape::numbers,
        "Crank angle at each pose, or displacement of a driven slide, counted from crank-start; all rise or all fall."},
    Key{"point", Shape::text, "Of a linkage: the point of the body that is guided."},
    Key{"link", Shape::text, "Of a linkage: the link that is the body, or carries it."},
    Key{"crank-start", Shape::range, "Of a linkage: the crank angle from which crank_angles are counted. Preset: 0."},
    Key{"body-angle", Shape::range, "Of a linkage: the direction of the body, from the x axis of its link. Preset: 0."},
    path[path.size() - 2],
    path[path.size() - 1]};

inline constexpr std::array objective{
    Key{"minimize", Shape::name, "Quantity to be made least; of a list the greatest counts, with reduce = \"max\"."},
    Key{"maximize", Shape::name, "Quantity to be made greatest; of a list the least counts, with reduce = \"max\"."},
    Key{"reduce", Shape::word, "Of a list of quantities the worst counts.", false, reductions},
    Key{"weight", Shape::number, "Weight of one of several objectives. Preset: 1.", false, {}, {}, positive},
    Key{"rank",
        Shape::whole_number,
        "Of several: those of a lower rank come first. Preset: 1.",
        false,
        {},
        {},
        {1, 1000}},
    Key{"within",
        Shape::number,
        "By how much it may be worse than its best for the sake of those that come after. Preset: 0.",
        false,
        {},
        {},
        not_negative}};

inline constexpr std::array requirement{Key{"quantity", Shape::text, "What is limited.", true},
                                        Key{"equal", Shape::number, "The value that it has to have."},
                                        Key{"min", Shape::number, "Its least value."},
                                        Key{"max", Shape::number, "Its greatest value."}};

inline constexpr std::array motion{
    Key{"crank_range", Shape::ends, "Crank angles over which the mechanism is judged, where not over a full turn."},
    Key{"at", Shape::number, "Of a linkage: a crank angle of the motion that is meant."},
    Key{"from", Shape::word, "Beside [path] or [poses]: judged is from the first target that is met, ...", false,
        use_begins},
    Key{"to", Shape::word, "... to the last; NAME.whole is the quantity NAME over the whole motion.", false, use_ends},
    Key{"before",
        Shape::number,
        "Crank angle that is judged before the first target, too. Preset: 0.",
        false,
        {},
        {},
        not_negative},
    Key{"after",
        Shape::number,
        "Crank angle that is judged after the last target, too. Preset: 0.",
        false,
        {},
        {},
        not_negative}};

inline constexpr std::array scale{
    Key{"start", Shape::tied_range, "Where it stands at the first x: a number, or a range that is designed.", true},
    Key{"range", Shape::tied_range, "How far it moves over the range of x, with its sign.", true}};

/// Of one of several.
inline constexpr Key name_over_input{
    "name", Shape::text, "Of a linkage with several functions, lines and arcs: what quantities and results call it."};
inline constexpr Key weight_over_input{
    "weight",
    Shape::number,
    "Of a linkage with several functions, lines and arcs: weight of its mean square in that of all. Preset: 1.",
    false,
    {},
    {},
    positive};

inline constexpr std::array function{
    Key{"expression", Shape::text, "The function of x, as in \"x^2 + sin(x)\"."},
    Key{"x", Shape::ends, "Range of x of an expression."},
    Key{"samples", Shape::pairs, "[x, y], x rising, in place of an expression."},
    Key{"accuracy_points", Shape::value,
        "Where method = \"exact\" meets the expression: 3, 4 or 5 values of x, or only how many."},
    Key{"input", Shape::table, "The crank angle that stands for x.", true, {}, scale},
    Key{"output", Shape::table, "The output that stands for y.", true, {}, scale},
    Key{"signal", Shape::text, "Of a linkage: the signal that is the output."},
    name_over_input,
    weight_over_input};

inline constexpr std::array line{
    Key{"start", Shape::tied_range, "Crank angle, or displacement, at which the stretch begins.", true},
    Key{"range", Shape::tied_range, "Crank angle, or displacement, that the stretch takes, with its sign.", true},
    Key{"angle", Shape::range, "Direction of the line. Preset: any."},
    Key{"offset", Shape::range, "Distance of the line from the origin, to the left of its direction. Preset: any."},
    Key{"full_turn", Shape::flag, "Whether the crank has to turn fully. Preset: false."},
    Key{"point", Shape::text, "Of a linkage: the point that follows the line."},
    Key{"link", Shape::text, "Of a linkage: the link on which it does. Preset: the first that has it."},
    name_over_input,
    weight_over_input};

inline constexpr std::array arc{
    Key{"start", Shape::tied_range, "Crank angle, or displacement, at which the stretch begins.", true},
    Key{"range", Shape::tied_range, "Crank angle, or displacement, that the stretch takes, with its sign.", true},
    Key{"centre-x", Shape::range, "Centre of the arc. Preset: any."},
    Key{"centre-y", Shape::range, "Centre of the arc. Preset: any."},
    Key{"radius", Shape::range, "Radius of the arc. Preset: any."},
    Key{"full_turn", Shape::flag, "Whether the crank has to turn fully. Preset: false."},
    Key{"point", Shape::text, "Of a linkage: the point that follows the arc."},
    line[line.size() - 3],
    name_over_input,
    weight_over_input};

inline constexpr std::array rates{Key{"crank", Shape::number, "Of the crank."},
                                  Key{"coupler", Shape::number, "Of the coupler."},
                                  Key{"rocker", Shape::number, "Of the rocker."}};

inline constexpr std::array instant{
    Key{"velocity",
        Shape::table,
        "Angular velocities of the links at one crank angle, that of the crank not 0.",
        true,
        {},
        rates},
    Key{"acceleration", Shape::table, "Angular accelerations of links whose velocities are given.", false, {}, rates}};

inline constexpr std::array solver{
    Key{"method", Shape::name, "Method of synthesis. Preset: auto."},
    Key{"starts", Shape::whole_number, "Local searches. Preset: 32.", false, {}, {}, {1, 100'000}},
    Key{"seed",
        Shape::whole_number,
        "What the starts are drawn from: the same seed, the same result. Preset: 1.",
        false,
        {},
        {},
        {.least = 0}},
    // A billion seconds are thirty years, and safe for every clock.
    Key{"time_limit",
        Shape::number,
        "Seconds after which the run ends with the best design so far. Preset: 60.",
        false,
        {},
        {},
        {0, 1e9, true}},
    Key{"tolerance", Shape::number, "Relative, on every requirement. Preset: 1e-9.", false, {}, {}, {0, 1e-2, true}},
    Key{"pareto", Shape::whole_number, "Designs on the front between two objectives.", false, {}, {}, {2, 1000}},
    Key{"round",
        Shape::number,
        "Lengths that are designed are multiples of this, but for those with choices, step or round of their own.",
        false,
        {},
        {},
        positive}};

inline constexpr std::array tie{Key{"of", Shape::name, "The dimension that it follows.", true},
                                Key{"times", Shape::number, "How many times that. Preset: 1."},
                                Key{"plus", Shape::number, "What is added to it. Preset: 0."}};

inline constexpr std::array dimension_range{
    Key{"min", Shape::number, "Least value.", true}, Key{"max", Shape::number, "Greatest value.", true},
    Key{"start", Shape::number, "Where one of the local searches begins."},
    Key{"step", Shape::number, "It is the least value or whole steps more.", false, {}, {}, positive},
    Key{"round", Shape::number, "It is a multiple of this.", false, {}, {}, positive}};

inline constexpr std::array dimension_choices{Key{"choices", Shape::numbers, "The values that it may have.", true},
                                              Key{"start", Shape::number, "Where one of the local searches begins."}};

inline constexpr std::array steps{
    Key{"from", Shape::number, "First value.", true}, Key{"to", Shape::number, "Last value.", true},
    Key{"count", Shape::whole_number, "How many values.", false, {}, {}, {.least = 1}},
    Key{"spacing", Shape::word, "Evenly, or evenly in their logarithms. Preset: linear.", false, spacings}};

inline constexpr std::array deviation{
    Key{"normal", Shape::number, "Standard deviation.", false, {}, {}, positive},
    Key{"uniform", Shape::number, "Half the width.", false, {}, {}, positive},
    Key{"grade", Shape::name, "Tolerance of this grade of ISO 286, or of this class of ISO 2768."},
    Key{"distribution", Shape::word, "Of a grade or a class. Preset: normal.", false, distributions}};

inline constexpr std::array chart{
    Key{"kind", Shape::word, "What is drawn.", true, charts},
    Key{"name", Shape::text, "Name of its file: letters, digits, - and _."},
    Key{"title", Shape::text, "What stands above it."},
    Key{"x", Shape::text, "Column to the right.", true},
    Key{"y", Shape::text, "Column upwards, of all but curves."},
    Key{"value", Shape::text, "Column that is drawn, of all but fronts; of curves upwards."},
    Key{"family", Shape::text, "Column: a curve for each of its values."},
    Key{"each", Shape::text, "Column: a picture for each of its values."},
    Key{"where", Shape::text, "SQL: only points for which this is so. Preset: status = 'solved'."},
    Key{"log", Shape::flag, "Whether the axis of x is logarithmic. Preset: false."},
    Key{"levels", Shape::numbers, "Of contours. Preset: chosen."},
    Key{"maximize", Shape::texts, "Columns of a front in which more is better: x, y or both."}};

inline constexpr std::array allocation{
    Key{"share",
        Shape::number,
        "Percent of pieces that are to meet all limits. Preset: 99.73.",
        false,
        {},
        {},
        {50, 100, true, true}},
    Key{"exponent",
        Shape::number,
        "A tolerance costs its weight over this power of its width, in units of the one given. Preset: 1.",
        false,
        {},
        {},
        {0, 10, true, true}},
    Key{"weights", Shape::value,
        "Of dimensions, and of pins by \"clearance C\": what the tolerance of one costs. Preset: 1 for each."}};

/// Everything else in [study] is the path of a value.
inline constexpr std::array study{
    Key{"design", Shape::word, "How values are combined. Preset: grid.", false, designs},
    Key{"count",
        Shape::whole_number,
        "Points of a random design, or samples of tolerances.",
        false,
        {},
        {},
        {.least = 1}},
    Key{"seed", Shape::whole_number, "What random points are drawn from. Preset: 1.", false, {}, {}, {.least = 0}},
    Key{"quantities", Shape::texts, "Quantities that are kept. Preset: all."},
    Key{"tolerance", Shape::value,
        "By how much dimensions are off from piece to piece: a grade of ISO 286 (\"IT7\"), a class of ISO 2768 (\"ISO "
        "2768-m\"), { normal = ... } or { uniform = ... }; "
        "'lengths' for all lengths that are not named."},
    Key{"clearance", Shape::value,
        "Of the pins of a linkage: a diameter by which holes are wider, for all, or a table { C = 0.05 } of pins."},
    Key{"allocation",
        Shape::table,
        "Tolerances in place of those given: as wide as the limits allow, the cheapest of all such.",
        false,
        {},
        allocation},
    Key{"case", Shape::value, "A named set of values, by their paths, that change together."},
    Key{"chart", Shape::tables, "A picture of the study's data.", false, {}, chart}};

inline constexpr Limits first_schema{1, 1};

inline constexpr std::array file{
    Key{"schema", Shape::whole_number, "Version of the format: 1.", true, {}, {}, first_schema},
    Key{"mechanism", Shape::name, "What is designed.", true},
    Key{"title", Shape::text, "What results are headed with."},
    Key{"units", Shape::table, "Units of the file's numbers.", false, {}, units},
    Key{"cam", Shape::table, "What kind of cam it is.", false, {}, cam},
    Key{"dimensions", Shape::names,
        "Each a number, a range { min = ..., max = ... } that is designed, or tied to another: { of = ..., times = ... "
        "}."},
    Key{"segment",
        Shape::tables,
        "A part of the motion of a cam; together they make up a full turn.",
        false,
        {},
        segment},
    Key{"path", Shape::table, "A path that the coupler point shall follow.", false, {}, path},
    Key{"poses", Shape::table, "Poses that a body on the coupler shall pass.", false, {}, poses},
    Key{"objective",
        Shape::value,
        "What is made least or greatest; several are summed with their weights.",
        false,
        {},
        objective},
    Key{"require", Shape::tables, "What a design has to meet.", false, {}, requirement},
    Key{"motion", Shape::table, "The motion over which the mechanism is judged.", false, {}, motion},
    Key{"function", Shape::table, "A function that the output shall be of the input.", false, {}, function},
    Key{"line", Shape::table, "A straight line that the coupler point shall follow.", false, {}, line},
    Key{"arc", Shape::table, "An arc that the coupler point shall follow.", false, {}, arc},
    Key{"solver", Shape::table, "How the design is sought.", false, {}, solver},
    Key{"instant", Shape::table, "Velocities and accelerations at one crank angle.", false, {}, instant},
    Key{"links", Shape::names, "Of a linkage: its rigid links, each with its points in its own frame."},
    Key{"slide", Shape::tables, "Of a linkage: a link that slides on a line of another.", false, {}, slide},
    Key{"slot", Shape::tables, "Of a linkage: a point that stays in a slot of another link.", false, {}, slot},
    Key{"gear", Shape::tables, "Of a linkage: two links that turn in a ratio.", false, {}, gear},
    Key{"belt", Shape::tables, "Of a linkage: two links that turn in a ratio by a belt.", false, {}, belt},
    Key{"rack", Shape::tables, "Of a linkage: a wheel that turns as a link slides.", false, {}, rack},
    Key{"drive", Shape::value, "Of a linkage: what moves it; further drives follow the first.", false, {}, drive},
    Key{"assembly", Shape::names, "Of a linkage: on which side a dyad is closed, by its inner point or its slide."},
    Key{"sketch", Shape::table, "Of a linkage: where points are about.", false, {}, sketch},
    Key{"placement", Shape::table, "Of a linkage: where its frame stands in the drawing.", false, {}, placement},
    Key{"signals", Shape::names, "Of a mechanism of links: what is measured along the motion."},
    Key{"room", Shape::tables, "A box that parts of a mechanism of links need over the motion.", false, {}, room},
    Key{"region", Shape::tables, "A region that parts of a mechanism of links keep in, or out of.", false, {}, region},
    Key{"study",
        Shape::value,
        "The problem for many values of what the file says: \"dimensions.ground\" = { from = ..., to = ..., count = "
        "... }.",
        false,
        {},
        study}};

/// All sections of a problem file, with those that settings of mechanisms stand in.
std::span<const Key> of_file();

}  // namespace mechwright::keys
