// Six-bars of all five kinds with random dimensions, each against the equations of its joints in fifty digits, followed
// from a pose that is known because the dimensions were read off it. MECHWRIGHT_SIX_BARS in the environment asks for
// more of each kind than are tried otherwise.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/again/signals_again.h"
#include "synthesis/mechanism/linkage/measured_over.h"
#include "synthesis/problem/reader.h"

namespace mechwright {

namespace {

/// A chain: its links by their points, the frame first, and the dyads by inner pin and outer pins; none of what is
/// placed together.
struct SixBar {
    std::string name;
    std::vector<std::pair<std::string, std::string>> links;
    std::vector<std::string> dyads;
    std::string point;  ///< on the last link
};

const std::vector<SixBar> six_bars{
    {"Watt I",
     {{"frame", "AD"}, {"crank", "AB"}, {"coupler", "BCP"}, {"rocker", "DCQ"}, {"upper", "PE"}, {"last", "QET"}},
     {"CBD", "EPQ"},
     "T"},
    {"Watt II",
     {{"frame", "ADF"}, {"crank", "AB"}, {"coupler", "BC"}, {"rocker", "DCQ"}, {"rod", "QE"}, {"last", "FET"}},
     {"CBD", "EQF"},
     "T"},
    {"Stephenson I",
     {{"frame", "AD"}, {"crank", "ABQ"}, {"coupler", "BC"}, {"rocker", "DCR"}, {"rod", "QE"}, {"last", "RET"}},
     {"CBD", "EQR"},
     "T"},
    {"Stephenson II",
     {{"frame", "AG"}, {"crank", "ABC"}, {"upper", "BD"}, {"lower", "CE"}, {"plate", "DEF"}, {"last", "GFT"}},
     {},
     "T"},
    {"Stephenson III",
     {{"frame", "ADF"}, {"crank", "AB"}, {"coupler", "BCP"}, {"rocker", "DC"}, {"rod", "PE"}, {"last", "FET"}},
     {"CBD", "EPF"},
     "T"}};

using Places = std::map<char, Vector<double>>;

/// Every link in the place that it has at the crank angle 0, with sides and a sketch as its points stand there.
std::string text_of(const SixBar& kind, const Places& at) {
    std::string text = "schema = 1\nmechanism = \"linkage\"\n[links]\n";
    for (const auto& [link, points] : kind.links) {
        text += link + " = { ";
        for (std::size_t i = 0; i < points.size(); ++i)
            text += fmt::format("{}{} = [{:.17g}, {:.17g}]", i == 0 ? "" : ", ", points[i], at.at(points[i]).x,
                                at.at(points[i]).y);
        text += " }\n";
    }
    text += "[drive]\nlink = \"crank\"\n[motion]\nat = 0\n";
    if (kind.dyads.empty()) {
        text += "[sketch]\ncrank = 0\n[sketch.points]\n";
        for (const char pin : {'D', 'E', 'F'})
            text += fmt::format("{} = [{:.17g}, {:.17g}]\n", pin, at.at(pin).x, at.at(pin).y);
    } else {
        text += "[assembly]\n";
    }
    for (const std::string& dyad : kind.dyads) {
        const double side = cross(at.at(dyad[2]) - at.at(dyad[1]), at.at(dyad[0]) - at.at(dyad[1]));
        text += fmt::format("{} = {{ side = \"{}\", from = \"{}\", to = \"{}\" }}\n", dyad[0],
                            side > 0 ? "left" : "right", dyad[1], dyad[2]);
    }
    return text + "[signals]\nacross = { x = \"T\" }\nup = { y = \"T\" }\nturn = { angle = \"last\" }\n";
}

struct Tally {
    int compared = 0;
    double worst = 0;  ///< error of a value or a derivative, over what rounding can do there
};

/// The pose that is known, in doubles: every link stands at its own coordinates.
LoopPose<double> known_pose(std::size_t links) {
    return {std::vector<Vector<double>>(links, Vector<double>{0, 0}), std::vector<double>(links, 0.0)};
}

void compare(const SixBar& kind, std::mt19937_64& engine, Tally& tally) {
    std::uniform_real_distribution<double> place(-3, 3), share(0.02, 0.98);
    Places at;
    for (const auto& [link, points] : kind.links)
        for (const char pin : points)
            at[pin] = {place(engine), place(engine)};
    const std::string text = text_of(kind, at);
    const ReadProblem read = parse_problem(text, "six-bar.toml");
    for (const Message& message : read.messages)
        ASSERT_TRUE(message.warning) << to_string(message) << '\n' << text;
    const Mechanism& mechanism = *read.problem.mechanism;
    const LinkageModel& model = linkage_of(mechanism.model.data());
    std::vector<double> dimensions;
    for (const DimensionRange& range : read.problem.dimensions)
        dimensions.push_back(range.min);
    Motion motion = motion_of(mechanism, dimensions, 0, nullptr);
    // The pose at 0 belongs to the motion.
    const double turn = 2 * std::numbers::pi;
    const double from = motion.full_turn ? 0 : motion.from;
    const double zero = motion.full_turn ? 0 : turn * std::ceil((from - 1e-9) / turn);
    ASSERT_LE(zero, motion.to + 1e-9) << text;
    const double input = from + share(engine) * ((motion.full_turn ? turn : motion.to) - from);

    const std::vector<Digits50> exact(dimensions.begin(), dimensions.end());
    SignalsAgain<double> rough(model, std::span<const double>(dimensions), known_pose(model.links.size()).turns);
    ASSERT_TRUE(rough.follower.start(zero, known_pose(model.links.size()))) << text;
    ASSERT_TRUE(rough.follower.follow(input, 1e-9, [](const auto&) {})) << text;
    SignalsAgain<Digits50> signals(model, std::span<const Digits50>(exact), known_pose(model.links.size()).turns);
    ASSERT_TRUE(signals.follower.start(input, pose_as<Digits50>(rough.follower.pose)));

    constexpr std::size_t derivatives = 3;
    const LinkageMeasure measure{LinkageMeasure::Kind::total_length, model.signals};
    motion.model = mechanism.model.data();
    motion.of = &measure;
    const measuring::Over over(motion);
    auto values = measuring::measured<double, derivatives>(over, std::span<const double>(dimensions), model.signals);
    linkage::Driven<double> driven = over.driven(dimensions);
    ASSERT_TRUE(driven.place(input)) << text;
    std::vector<double> turns(model.links.size());
    linkage::Turns::of(driven.pose, rough.follower.pose.turns, turns);
    for (std::size_t i = 0; i < model.signals.size(); ++i) {
        const auto found = values.value(i, input, turns);
        // What the rounding of the input and of the links' numbers does grows with the next derivative.
        for (int order = 0; order <= 2; ++order) {
            const double expected = signals.by_input(model.signals[i], order, Digits50(input)).convert_to<double>();
            const double next = std::abs(found.derivative(order + 1));
            const double scale = 1 + std::abs(expected) + next;
            tally.worst = std::max(tally.worst, std::abs(found.derivative(order) - expected) / scale);
            ++tally.compared;
        }
    }
}

TEST(SixBars, OfRandomDimensionsMoveAsTheirJointsSayInFiftyDigits) {
    const char* asked = std::getenv("MECHWRIGHT_SIX_BARS");
    const int count = asked != nullptr ? std::atoi(asked) : 40;
    std::mt19937_64 engine(2026);
    for (const SixBar& kind : six_bars) {
        SCOPED_TRACE(kind.name);
        Tally tally;
        for (int i = 0; i < count && !HasFatalFailure(); ++i)
            compare(kind, engine, tally);
        EXPECT_EQ(tally.compared, 9 * count);
        EXPECT_LT(tally.worst, 1e-12);
        if (asked != nullptr) fmt::print("{}: worst {:.2g} of {}\n", kind.name, tally.worst, tally.compared);
    }
}

}  // namespace

}  // namespace mechwright
