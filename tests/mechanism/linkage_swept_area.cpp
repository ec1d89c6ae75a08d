// What the line between two points sweeps: against closed forms, the slices of verification and differences.

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "synthesis/solve/solve.h"
#include "tests/long_form.h"
#include "tests/mechanism/kinds_with_rooms.h"

namespace mechwright::linkage_scans {

namespace {

std::string blade_of(const std::string& one, const std::string& other, const std::string& screen = "") {
    return "[[room]]\nname = \"blade\"\nof = [\"" + one + "\", \"" + other + "\"]\n" +
           (screen.empty() ? "" : "screen = " + screen + "\n");
}

/// A wiper on a crank that turns by a given range, from 10 to 30 from its pivot.
std::string turning_wiper(const std::string& range) {
    return "schema = 1\nmechanism = \"linkage\"\n[dimensions]\narm = 10\n[links]\nframe = { A = [0, 0] }\narm = { A = "
           "[0, 0], P = [\"arm\", 0], Q = [30, 0] }\n[drive]\nlink = \"arm\"\n[motion]\ncrank_range = " +
           range + "\n";
}

/// The slopes of a quantity's first component by the dimensions of a given linkage.
std::vector<double> slopes_of(const std::string& text, const std::string& name) {
    const ReadProblem read = testing::read_without_fault(text);
    const Mechanism& m = *read.problem.mechanism;
    std::vector<double> arguments;
    for (const DimensionRange& range : read.problem.dimensions)
        arguments.push_back(range.min);
    Motion motion = finished_design(read.problem, evaluate_given(read.problem).design).motion;
    const Quantity& quantity = m.quantities[static_cast<std::size_t>(find_quantity(m, name))];
    motion.model = m.model.data();
    motion.of = quantity.of.data();
    std::vector<double> value(quantity.components(motion)), gradient(value.size() * arguments.size());
    quantity.measure(motion, arguments, {value, gradient, {}});
    return gradient;
}

/// Where no outline closes, a document states no value, and nothing is verified.
void expect_measured(const Json& document) {
    EXPECT_TRUE(std::isfinite(value_in(document, "blade.swept-area")));
    EXPECT_TRUE(std::isfinite(value_in(document, "blade.uncovered")));
}

TEST(SweptArea, OfAWiperThatTurnsIsThatOfItsSector) {
    const Json sector = analysed_room(turning_wiper("[20, 140]") + blade_of("P", "Q")).document;
    EXPECT_NEAR(value_in(sector, "blade.swept-area"), 400 * 120 * one_degree, 1e-10);
    expect_verified(sector);
    const Json quarter =
        analysed_room(turning_wiper("[0, 90]") + blade_of("A", "P", "[[0, 0], [10, 0], [10, 10], [0, 10]]")).document;
    EXPECT_NEAR(value_in(quarter, "blade.uncovered"), 100 - 25 * std::numbers::pi, 1e-11);
    expect_verified(quarter);
    const Json all =
        analysed_room(turning_wiper("[0, 360]") + blade_of("A", "Q", "[[-3, -5], [5, -9], [2, 8]]")).document;
    EXPECT_EQ(value_in(all, "blade.uncovered"), 0);
    expect_verified(all);
    expect_room_slopes(turning_wiper("[20, 140]") + blade_of("P", "Q", "[[-9, 4], [12, 6], [10, 25]]"),
                       {"blade.swept-area", "blade.uncovered"});
}

/// The rocker of a crank-rocker comes back over the same places.
TEST(SweptArea, OfARockerIsCountedOnce) {
    const AnalysedRoom found = analysed_room(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 4\ncrank = 1.5\ncoupler = 4\nrocker = 4.5\n" +
        blade_of("D", "C"));
    double least = 1e9, greatest = -1e9;
    for (const double in_line : {4 - 1.5, 4 + 1.5}) {  // from A to C where crank and coupler are in line
        const double angle = std::acos((4 * 4 + 4.5 * 4.5 - in_line * in_line) / (2 * 4 * 4.5));
        least = std::min(least, angle);
        greatest = std::max(greatest, angle);
    }
    EXPECT_NEAR(value_in(found.document, "blade.swept-area"), 4.5 * 4.5 / 2 * (greatest - least), 1e-11);
    expect_verified(found.document);
}

/// A bar of length 2 that is moved along an arc without turning, over its top: slices across are two bars side by side,
/// or one that is longer.
TEST(SweptArea, OfABarThatDoesNotTurnIsThatOfItsSlices) {
    const Json document =
        analysed_room(
            "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = { A = [0, 0], D = [6, 0] }\ncrank = { A = [0, 0], B "
            "= [3, 0] }\nbar = { B = [0, 0], C = [6, 0], P = [2, 1], Q = [4, 1] }\nrocker = { D = [0, 0], C = [3, 0] "
            "}\n[drive]\nlink = \"crank\"\n[motion]\ncrank_range = [30, 150]\n" +
            blade_of("P", "Q"))
            .document;
    const double apart = std::acos(1.0 / 3), half = std::numbers::pi / 2;
    const auto cosines = [](double a) { return std::sin(a); };
    const auto squares = [](double a) { return a / 2 + std::sin(2 * a) / 4; };
    const double area = 12 * (cosines(apart) - cosines(half / 3)) + 6 * (cosines(half) - cosines(apart)) +
                        18 * (squares(half) - squares(apart));
    EXPECT_NEAR(value_in(document, "blade.swept-area"), area, 1e-11);
    expect_verified(document);
}

/// A ladder that slides on two walls: what it sweeps is within an astroid (3/8 pi of the square of its length).
TEST(SweptArea, OfALadderIsAnAstroid) {
    const Json document =
        analysed_room(
            "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = { O = [0, 0] }\nbar = { A = [0, 0], B = [5, 0] "
            "}\n[[slot]]\npin = \"A\"\nin = \"frame\"\npoint = \"O\"\ndirection = 0\n[[slot]]\npin = \"B\"\nin = "
            "\"frame\"\npoint = \"O\"\ndirection = 90\n[drive]\nlink = \"bar\"\n" +
            blade_of("A", "B", "[[0, 0], [5, 0], [5, 5], [0, 5]]"))
            .document;
    const double whole = 25 * 3 * std::numbers::pi / 8;
    EXPECT_NEAR(value_in(document, "blade.swept-area"), whole, 1e-11);
    EXPECT_NEAR(value_in(document, "blade.uncovered"), 25 - whole / 4, 1e-11);
    expect_verified(document);
}

/// Couplers over a turn, whose lines have envelopes with cusps, and over motions that end at limits.
TEST(SweptArea, IsThatOfItsSlices) {
    const std::string screen = "[[-1, -2], [5, -1], [6, 4], [1, 3], [-3, 3]]";
    for (const std::string lengths :
         {"ground = 4\ncrank = 1.5\ncoupler = 4\nrocker = 4.5\npoint-along = 6\npoint-across = 1\n",
          "ground = 2\ncrank = 4\ncoupler = 3.5\nrocker = 4.5\npoint-along = 3\npoint-across = -2\n",
          "ground = 5\ncrank = 4\ncoupler = 2\nrocker = 4\npoint-along = 3\npoint-across = 1\n"})
        for (const std::string end : {"B", "C"}) {
            if (!in_long_form() && (end == "C") == lengths.starts_with("ground = 2")) continue;
            SCOPED_TRACE(lengths + end);
            const std::string text =
                "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\n" + lengths + blade_of(end, "P", screen);
            const Json document = analysed_room(text).document;
            expect_measured(document);
            expect_verified(document);
            // Beyond the limits of one design those of others lie.
            if (lengths.starts_with("ground = 5")) continue;
            expect_room_slopes(text, {end == "C" ? "blade.swept-area" : "blade.uncovered"});
        }
}

/// A line whose one end stays where it is turns back where the other moves along it: all of it is a border there. A
/// rocker's pin goes over its path again, of which a part is a border for the one pass alone.
TEST(SweptArea, IsThatOfItsSlicesWhereTheLineTurnsBack) {
    const std::string screen = "[[-1, -2], [5, -1], [6, 4], [1, 3], [-3, 3]]";
    const std::string crank_rocker =
        "ground = 4\ncrank = 1.5\ncoupler = 4\nrocker = 4.5\npoint-along = 6\npoint-across = 1\n";
    const std::string to_limits = "ground = 5\ncrank = 4\ncoupler = 2\nrocker = 4\npoint-along = 3\npoint-across = 1\n";
    // A short stroke goes over places of a longer one, beside whose rest it is.
    const std::string to_and_fro = "ground = 1.058\ncrank = 4.69\ncoupler = 1.952\nrocker = 5.737\n";
    for (const auto& [lengths, one, other] :
         {std::tuple(crank_rocker, "A", "P"), std::tuple(crank_rocker, "B", "C"), std::tuple(crank_rocker, "D", "P"),
          std::tuple(to_limits, "A", "P"), std::tuple(to_limits, "B", "C"), std::tuple(to_limits, "C", "P"),
          std::tuple(to_and_fro, "D", "C")}) {
        // Of each kind of end one pair.
        if (!in_long_form() && (lengths == to_limits ? one[0] != 'C' : one[0] == 'A')) continue;
        SCOPED_TRACE(lengths + one + other);
        const Json document = analysed_room("schema = 1\nmechanism = \"four-bar\"\n[dimensions]\n" + lengths +
                                            blade_of(one, other, screen))
                                  .document;
        expect_measured(document);
        expect_verified(document);
    }
}

/// Where limits end the motion, they move with the dimensions, and the foot on the blade there: against differences of
/// designs that are measured by themselves.
TEST(SweptArea, HasExactDerivativesWhereLimitsMove) {
    const auto text = [](double ground, double coupler) {
        return fmt::format(
            "schema = 1\nmechanism = \"linkage\"\n[dimensions]\nground = {}\ncoupler = {}\n[links]\nframe = {{ A = "
            "[0, 0], D = [\"ground\", 0] }}\ncrank = {{ A = [0, 0], B = [4, 0] }}\ncoupler = {{ B = [0, 0], C = "
            "[\"coupler\", 0], P = [3, 1] }}\nrocker = {{ D = [0, 0], C = [4, 0] }}\n[drive]\nlink = \"crank\"\n",
            ground, coupler);
    };
    for (const char* end : {"B", "C"}) {
        SCOPED_TRACE(end);
        const std::vector<double> slopes = slopes_of(text(5, 2) + blade_of(end, "P"), "blade.swept-area");
        for (const std::size_t by : {0u, 1u}) {
            const auto at = [&](double h) {
                const std::string moved = by == 0 ? text(5 + h, 2) : text(5, 2 + h);
                return value_in(analysed_room(moved + blade_of(end, "P")).document, "blade.swept-area");
            };
            constexpr double h = 2e-3;
            const double once = (at(h) - at(-h)) / (2 * h), twice = (at(2 * h) - at(-2 * h)) / (4 * h),
                         thrice = (at(3 * h) - at(-3 * h)) / (6 * h);
            EXPECT_NEAR(slopes[by], 1.5 * once - 0.6 * twice + 0.1 * thrice, 1e-7);
        }
    }
}

/// A rocker whose blade is to leave as little of a screen as its frame and its length allow.
TEST(SweptArea, OfAScreenCanBeMadeGreat) {
    const ReadProblem read = parse_problem(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 4\ncrank = { min = 0.5, max = 2 }\ncoupler = { "
        "min = 3, max = 6 }\nrocker = 3\n" +
            blade_of("D", "C", "[[2, 0.5], [6, 0.5], [6, 3], [2, 3]]") +
            "[[require]]\nquantity = \"transmission-angle-worst\"\nmin = 30\n[objective]\nminimize = "
            "\"blade.uncovered\"\n[solver]\nstarts = 4\n",
        "p.toml");
    ASSERT_TRUE(read.ok()) << read.messages.front().text;
    const Result result = solve(read.problem, {});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_TRUE(result.verified());
}

TEST(SweptArea, IsOfTwoPoints) {
    for (const auto& [room, message] :
         {std::pair(std::string("of = [\"B\"]\n[[require]]\nquantity = \"blade.swept-area\"\nmin = 1\n"),
                    "is of the line between two points"),
          std::pair(std::string("of = [\"A\", \"B\"]\n[[require]]\nquantity = \"blade.uncovered\"\nmax = 1\n"),
                    "is of the screen of a room"),
          std::pair(std::string("of = [\"A\", \"B\"]\nscren = [[0, 0], [1, 0], [0, 1]]\n"), "did you mean 'screen'"),
          std::pair(std::string("of = [\"B\"]\nscreen = [[0, 0], [1, 0], [0, 1]]\n"), "two points"),
          std::pair(std::string("of = [\"A\", \"B\"]\nscreen = [[0, 0], [1, 0]]\n"), "three corners")}) {
        const ReadProblem read = parse_problem(
            "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = { A = [0, 0] }\ncrank = { A = [0, 0], B = [10, 0] "
            "}\n[drive]\nlink = \"crank\"\n[[room]]\nname = \"blade\"\n" +
                room,
            "p.toml");
        ASSERT_FALSE(read.ok()) << room;
        EXPECT_NE(read.messages.front().text.find(message), std::string::npos) << read.messages.front().text;
    }
}

}  // namespace

}  // namespace mechwright::linkage_scans
