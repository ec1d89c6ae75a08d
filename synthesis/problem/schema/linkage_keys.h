#pragma once
/// \file
/// The sections that only files of a linkage have, with their keys. What stands behind names that the file itself makes
/// (links, points, assembly, signals) is in `problem_schema.cpp`.

#include <array>
#include <string_view>

#include "synthesis/mechanism/cam/read/keys.h"
#include "synthesis/problem/schema/key.h"

namespace mechwright::keys {

inline constexpr std::array drive_segment{
    Key{"kind", Shape::word, "What the input does; cycle: a whole turn by a table of points.", true,
        segment_kind_names},
    Key{"angle", Shape::number, "Angle of the first drive that the segment takes.", false, {}, {}, positive},
    Key{"lift", Shape::number, "By how much the input grows in a rise, or falls in a return.", false, {}, {}, positive},
    Key{"law", Shape::name, "Law of motion of a rise or return."},
    Key{"start", Shape::value,
        "Derivatives of a polynomial at its start: a list of numbers, the first the velocity; or its kind after "
        "VDI 2143.",
        false, ends_of_polynomials, end_of_polynomial},
    Key{"end", Shape::value, "The same at its end.", false, ends_of_polynomials, end_of_polynomial},
    Key{"shape", Shape::numbers, "Further terms of a polynomial or a spline."},
    Key{"points", Shape::pairs, "Table of a cycle: [angle of the first drive, lift]."}};

inline constexpr std::array line_of_slot{
    Key{"along", Shape::texts, "Two points of the link that the line is on: it runs from the first to the second."},
    Key{"point", Shape::place, "A place on the line, by name or as [x, y]."},
    Key{"direction", Shape::expression, "Angle of the line to the x axis of its link."}};

inline constexpr std::array slide{
    Key{"link", Shape::text, "What slides, without turning.", true},
    Key{"on", Shape::text, "The link that it slides on.", true},
    line_of_slot[0],
    line_of_slot[1],
    line_of_slot[2],
    Key{"angle", Shape::expression, "Angle of what slides to the x axis of the link that it slides on. Preset: 0."},
    Key{"offset", Shape::expression, "Distance of its origin from the line, positive to the left. Preset: 0."},
    Key{"name", Shape::text, "What drives, sides and signals call it."},
    Key{"min", Shape::expression, "Stop: its least displacement."},
    Key{"max", Shape::expression, "Stop: its greatest displacement."}};

inline constexpr std::array slot{
    Key{"pin", Shape::text, "The point that stays in the slot.", true},
    Key{"in", Shape::text, "The link that has the slot.", true},
    line_of_slot[0],
    line_of_slot[1],
    line_of_slot[2],
    Key{"centre", Shape::place, "Of a circular slot: its centre, by name or as [x, y]."},
    Key{"radius", Shape::expression, "Of a circular slot: the same as a link of this length from centre to pin."},
    Key{"min", Shape::expression,
        "Stop: the least displacement of the pin along the slot; of a circular one the direction from its centre, to "
        "the "
        "x axis of the link that has it, in which it begins."},
    Key{"max", Shape::expression,
        "Stop: its greatest displacement; of a circular one the direction in which it ends."}};

inline constexpr std::array gear{
    Key{"links", Shape::texts, "The two links that turn.", true},
    Key{"carrier", Shape::text, "What both turn against. Preset: frame."},
    Key{"ratio", Shape::expression, "Turn of the second over that of the first."},
    Key{"teeth",
        Shape::numbers,
        "Teeth of the first and of the second, in place of the ratio.",
        false,
        {},
        {},
        positive},
    Key{"internal", Shape::flag, "With teeth: both turn the same way. Preset: false."},
    Key{"phase", Shape::expression, "Turn of the second where that of the first is 0. Preset: 0."}};

inline constexpr std::array belt{gear[0],
                                 gear[1],
                                 gear[2],
                                 gear[3],
                                 Key{"crossed", Shape::flag, "Whether they turn in opposite senses. Preset: false."},
                                 gear[5]};

inline constexpr std::array rack{
    Key{"link", Shape::text, "The link that slides.", true}, Key{"wheel", Shape::text, "The link that turns.", true},
    Key{"carrier", Shape::text, "What it turns against. Preset: frame."},
    Key{"radius", Shape::expression, "Displacement of the slide for a turn of one radian, of either sign.", true},
    Key{"phase", Shape::expression, "Displacement where the turn is 0. Preset: 0."}};

inline constexpr std::array drive{
    Key{"link", Shape::text, "The link whose angle is the input."},
    Key{"on", Shape::text, "The link that its angle counts from. Preset: frame."},
    Key{"slide", Shape::value, "The slide whose displacement is the input: its name or its number from 1."},
    Key{"ratio", Shape::number, "Of a further drive: its input over that of the first. Preset: 1."},
    Key{"phase", Shape::number, "Of a further drive: its input where that of the first is 0. Preset: 0."},
    Key{"segment",
        Shape::tables,
        "Of a further drive, in place of the ratio: a part of its motion over a turn of the first; `phase` is the "
        "input "
        "at its start.",
        false,
        {},
        drive_segment},
    Key{"speed", Shape::number, "Turns per minute."},
    Key{"min", Shape::expression, "Stop: the least input."},
    Key{"max", Shape::expression, "Stop: the greatest input."}};

inline constexpr std::array sketch{
    Key{"crank", Shape::number, "The input at which points are given.", true},
    Key{"points", Shape::names, "Where points are about, in the frame's axes: { P = [x, y] }.", true}};

inline constexpr std::array placement{
    Key{"origin-x", Shape::range_or_sum, "Where the frame's origin is. Preset: 0."},
    Key{"origin-y", Shape::range_or_sum, "Where the frame's origin is. Preset: 0."},
    Key{"tilt", Shape::range_or_sum, "Direction of the frame's x axis. Preset: 0."},
    Key{"scale", Shape::range_or_sum, "By which every length is multiplied. Preset: 1.", false, {}, {}, positive}};

inline constexpr Key parts_of_linkage{
    "of", Shape::value,
    "What it is about: \"mechanism\", all links and pivots; \"pivots\"; or a list of links and points, of a built-in "
    "kind those that 'mechwright expand' writes. Preset: mechanism."};

inline constexpr std::array room{
    Key{"name", Shape::text, "What quantities call it: NAME.width, NAME.height, NAME.area, NAME.swept-area.", true},
    parts_of_linkage,
    Key{"direction", Shape::value,
        "Angle of the width to the drawing's x axis; or \"least-width\" or \"least-area\", turned so that this is "
        "least. "
        "Preset: 0."},
    Key{"screen", Shape::pairs,
        "Where the room is of two points, as the ends of a wiper's blade: corners of a polygon in their order around "
        "it, [x, y] in the drawing's axes. NAME.uncovered is the area of it that the line between the points does not "
        "sweep."}};

inline constexpr std::array<std::string_view, 2> turns_of_rooms{"least-width", "least-area"};

inline constexpr std::array<std::string_view, 2> ways_to_keep{"in", "out"};

inline constexpr std::array region_circle{Key{"centre", Shape::value, "[x, y] in the drawing's axes.", true},
                                          Key{"radius", Shape::number, "Its radius.", true, {}, {}, positive}};

inline constexpr std::array region_half_plane{
    Key{"through", Shape::value, "[x, y] of a place on its border, in the drawing's axes.", true},
    Key{"direction", Shape::number, "Angle of the border, to the left of which it lies.", true}};

inline constexpr std::array region_link{Key{"name", Shape::text, "The link.", true},
                                        Key{"width",
                                            Shape::number,
                                            "How wide it is about the outline of its points. Preset: 0.",
                                            false,
                                            {},
                                            {},
                                            not_negative}};

inline constexpr std::array region{
    Key{"name", Shape::text, "What its quantity is called by: NAME.margin.", true},
    Key{"keep", Shape::word, "Whether parts have to stay in it, or out.", true, ways_to_keep},
    parts_of_linkage,
    Key{"polygon", Shape::pairs, "Corners of a polygon in their order around it, [x, y] in the drawing's axes."},
    Key{"circle", Shape::table, "A disc.", false, {}, region_circle},
    Key{"half-plane", Shape::table, "All that is to the left of a straight line.", false, {}, region_half_plane},
    Key{"link", Shape::table, "Another link, which moves.", false, {}, region_link},
    Key{"margin",
        Shape::number,
        "Least distance from its border that is asked for. Preset: 0.",
        false,
        {},
        {},
        not_negative}};

}  // namespace mechwright::keys
