#pragma once
/// \file
/// Linkages to be drawn in tests.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "synthesis/mechanism/linkage/drawing/drawing.h"
#include "synthesis/mechanism/linkage/table.h"
#include "synthesis/problem/linkage/linkage.h"
#include "synthesis/report/drawing/finished.h"

namespace mechwright::testing {

inline std::string shipped_linkage_file(const std::string& name) {
    return MECHWRIGHT_SOURCE_DIR "/problems/linkage/" + name + ".toml";
}

/// The model of a linkage of given dimensions, which stand in its numbers; "either" is taken as the first side.
inline LinkageModel model_of(const Linkage& l) {
    LinkageModel model;
    model.links = l.links;
    model.pins = l.pins;
    model.slides = l.slides;
    model.structure = l.structure;
    model.order = l.order;
    for (const double number : numbers_of(l, usual_dimensions(l)))
        model.numbers.push_back({number, {}});
    model.drives = l.drives;
    model.sides = {l.sides};
    for (std::int8_t& side : model.sides[0])
        side = side == 0 ? std::int8_t{1} : side;
    model.at = l.at;
    return model;
}

/// The design of a model, moved over a full turn where it closes everywhere, else over the interval around `at` in
/// which it does, or the first in which it does.
inline FinishedDesign design_of(LinkageModel model) {
    constexpr double turn = 2 * std::numbers::pi;
    auto mechanism = std::make_shared<Mechanism>();
    mechanism->name = "linkage";
    mechanism->table = linkage_table(model);
    mechanism->drawing = linkage_drawing();
    linkage::Driven<double> placed = driven(model, {}, 0);
    Motion motion;
    const double span = model.driven_by_slide() ? 20 : turn;
    const auto closes = [&](int degree) { return placed.place(span * degree / 720); };
    int from = model.at ? static_cast<int>(std::lround(*model.at / span * 720)) : 0, to = 0;
    while (!closes(from) && from < 720)
        ++from;
    EXPECT_LT(from, 720) << "closes nowhere";
    for (to = from; to < from + 720 && closes(to);)
        ++to;
    motion.full_turn = to == from + 720 && !model.driven_by_slide();
    if (!motion.full_turn)
        while (closes(from - 1))
            --from;
    const auto edge = [&](double inside, double outside) {
        for (int i = 0; i < 200; ++i) {
            const double middle = 0.5 * (inside + outside);
            (placed.place(middle) ? inside : outside) = middle;
        }
        return inside;
    };
    motion.from = motion.full_turn ? 0 : edge(span * from / 720, span * (from - 1) / 720);
    motion.to = motion.full_turn ? turn * model.turns : edge(span * (to - 1) / 720, span * to / 720);
    mechanism->model = Model(std::move(model));
    motion.model = mechanism->model.data();
    FinishedDesign design;
    design.mechanism = mechanism;
    design.motion = motion;
    return design;
}

inline Linkage read_well(const ReadLinkage& read) {
    for (const Message& message : read.messages)
        if (!message.warning) ADD_FAILURE() << to_string(message);
    return read.linkage;
}

inline LinkageModel shipped_linkage_model(const std::string& name) {
    return model_of(read_well(read_linkage(shipped_linkage_file(name))));
}

inline LinkageModel linkage_model(const std::string& text) {
    return model_of(read_well(parse_linkage("schema = 1\nmechanism = \"linkage\"\n" + text, "drawn.toml")));
}

/// A planet between a sun that stands still and nothing else, on an arm; and a ring that goes round with it.
inline const std::string planetary_text = R"(
[links]
frame  = { O = [0, 0] }
arm    = { O = [0, 0], P = [30, 0] }
planet = { P = [0, 0], T = [10, 2] }
ring   = { O = [0, 0] }
[[gear]]
links   = ["frame", "planet"]
carrier = "arm"
ratio   = -2
[[gear]]
links    = ["planet", "ring"]
carrier  = "arm"
teeth    = [20, 80]
internal = true
[drive]
link = "arm"
)";

inline const std::string rack_text = R"(
[links]
frame = { O = [0, 0], Q = [-5, -8] }
wheel = { O = [0, 0], K = [3, 0] }
bar   = { B = [1, 2] }
[[slide]]
link = "bar"
on = "frame"
point = "Q"
direction = 20
angle = 15
offset = 1.5
[[rack]]
link = "bar"
wheel = "wheel"
radius = -4
phase = 2
[drive]
link = "wheel"
)";

/// A block that slides on the rod of a crank, and a rod in a swivel.
inline const std::string sliding_text = R"(
[links]
frame = { A = [0, 0], D = [60, 10], G = [0, -50] }
crank = { A = [0, 0], B = [20, 0] }
rod   = { B = [0, 0], R = [90, 5] }
block = { D = [0, 0] }
lever = { G = [0, 0], L = [100, 0] }
[[slide]]
name = "sleeve"
link = "block"
on = "rod"
point = [0, 6]
direction = 4
angle = 30
[[slot]]
pin = "B"
in = "lever"
along = ["G", "L"]
[drive]
link = "crank"
)";

inline const std::string driven_slide_text = R"(
[links]
frame = { A = [0, 0], D = [60, 10] }
piston = { P = [0, 0], K = [0, 5] }
rod = { P = [0, 0], C = [50, 0] }
arm = { D = [0, 0], C = [30, 0], E = [40, 10] }
[[slide]]
name = "piston"
link = "piston"
on = "frame"
point = "A"
direction = 0
[drive]
slide = "piston"
)";

inline const std::string circular_text = R"(
[links]
frame = { A = [0, 0] }
crank = { A = [0, 0], B = [20, 0] }
rod   = { B = [0, 0], C = [70, 0] }
[[slot]]
pin = "C"
in = "frame"
centre = [60, -80]
radius = 75
[drive]
link = "crank"
)";

}  // namespace mechwright::testing
