// Signals of the built-in kinds: against all poses of a fine scan by each kind's own drawing, differences, and the
// linkage that `expand` makes of it.

#include <fstream>
#include <iterator>

#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/linkage/of_kinds/expand.h"
#include "synthesis/solve/solve.h"
#include "tests/long_form.h"
#include "tests/mechanism/kinds_with_rooms.h"

namespace mechwright::linkage_scans {

namespace {

/// A kind by its own names.
struct KindWithSignals {
    KindWithRooms kind;
    std::string point;
    std::size_t of_drawing;  ///< the same among `points_of`
    std::string link;        ///< that turns and is not driven
    std::string own;         ///< a quantity of a signal that the kind has without any [signals]

    std::string text() const {
        return kind.text() + "[signals]\nhigh = { along = 35, point = \"" + point + "\" }\nquick = { speed-of = \"" +
               point + "\" }\nhard = { acceleration-of = \"" + point + "\" }\nturn = { angle = \"" + link +
               "\" }\nlow = { y = \"" + point +
               "\" }\nboth = { sum = { high = 2, low = 1 } }\npart = { ratio = [\"hard\", \"quick\"] }\n";
    }
};

const std::vector<KindWithSignals> kinds_with_signals{
    {kinds_with_rooms[0], "P", 4, "coupler", "rocker-angle.acceleration.greatest"},
    {kinds_with_rooms[1], "P", 3, "rod", "ram-position.acceleration.greatest"},
    {kinds_with_rooms[2], "B", 3, "lever", "ram-position.jerk.greatest"},
    {kinds_with_rooms[3], "B", 3, "rod", "ram-position.acceleration.greatest"},
    {kinds_with_rooms[4], "C", 4, "coupler", "follower-angle.speed.least"}};

const std::vector<std::string> of_signals{
    "high.mean",         "high.rms",          "high.deviation",           "high.at(60)",         "high.least(30, 80)",
    "high.jerk.rms",     "turn.speed.at(50)", "high.acceleration.at(70)", "high.speed.greatest", "turn.range(45, 90)",
    "part.mean(40, 90)", "both.greatest",     "quick.deviation(40, 100)"};

std::string asked_for(const std::vector<std::string>& quantities) {
    std::string text;
    for (const std::string& one : quantities)
        text += "[[require]]\nquantity = \"" + one + "\"\nmin = -1e9\n";
    return text;
}

/// What the point does along 35 degrees in a scan of the kind's own drawing.
TEST(SignalsOfKinds, AreThoseOfAScanOfTheirOwnDrawings) {
    for (const KindWithSignals& of : kinds_with_signals) {
        SCOPED_TRACE(of.kind.kind);
        const AnalysedRoom found = analysed_room(of.text() + asked_for({"high.mean", "high.rms", "high.deviation"}));
        constexpr int steps = 20000;
        const std::vector<Places> poses = poses_of(found.design, steps);
        ASSERT_EQ(poses.size(), steps + 1u);
        double least = 1e9, greatest = -1e9, sum = 0, squares = 0, quickest = 0;
        for (int i = 0; i < steps; ++i) {
            const Vector<double> here = poses[static_cast<std::size_t>(i)][of.of_drawing],
                                 next = poses[static_cast<std::size_t>(i + 1)][of.of_drawing];
            const double high = along_way(here, 35);
            least = std::min(least, high);
            greatest = std::max(greatest, high);
            sum += high / steps;
            squares += high * high / steps;
            quickest = std::max(quickest, std::hypot(next.x - here.x, next.y - here.y) * steps / (360 * one_degree));
        }
        // What lies between steps goes like the square of one.
        EXPECT_NEAR(value_in(found.document, "high.least"), least, 1e-6);
        EXPECT_NEAR(value_in(found.document, "high.greatest"), greatest, 1e-6);
        EXPECT_NEAR(value_in(found.document, "high.range"), greatest - least, 1e-6);
        EXPECT_NEAR(value_in(found.document, "high.deviation"), (greatest - least) / 2, 1e-6);
        EXPECT_NEAR(value_in(found.document, "quick.greatest"), quickest, 1e-5);
        // Sums over a period of a smooth function are as exact as its series.
        EXPECT_NEAR(value_in(found.document, "high.mean"), sum, 1e-10);
        EXPECT_NEAR(value_in(found.document, "high.rms"), std::sqrt(squares), 1e-10);
    }
}

/// All quantities of signals of both are the same, and verified from the document alone.
void expect_as_expanded(const std::string& text) {
    const ExpandedProblem expanded = expand_problem(text, "kind.toml");
    ASSERT_TRUE(expanded.ok()) << to_string(expanded.messages.front());
    const Json document = analysed_room(text).document;
    const AnalysedRoom linkage = analysed_room(expanded.text);
    std::size_t compared = 0;
    for (const auto& [name, value] : document["quantities"].items()) {
        if (without_whole(name).find('.') == std::string_view::npos) continue;
        EXPECT_NEAR(value_in(linkage.document, name), value.get<double>(), 1e-12 * (1 + std::abs(value.get<double>())))
            << name;
        ++compared;
    }
    EXPECT_GE(compared, of_signals.size());
    expect_verified(document);
}

/// Except in the long form of every kind another third of all that is asked for.
TEST(SignalsOfKinds, AreThoseOfTheLinkagesThatTheyAre) {
    std::size_t turn = 0;
    for (const KindWithSignals& of : kinds_with_signals) {
        SCOPED_TRACE(of.kind.kind);
        std::vector<std::string> asked;
        for (const std::string& one : of_signals)
            if (in_long_form() || turn++ % 3 == 0) asked.push_back(one);
        asked.push_back(of.own);
        expect_as_expanded(of.text() + asked_for(asked));
        if (&of == &kinds_with_signals[0] || in_long_form())
            expect_as_expanded(of.text() + "[motion]\ncrank_range = [25, 110]\n" + asked_for(asked));
    }
}

TEST(SignalsOfKinds, HaveExactDerivatives) {
    for (const KindWithSignals& of : kinds_with_signals) {
        SCOPED_TRACE(of.kind.kind);
        std::vector<std::string> names{"high.mean", "high.range", "high.least(30, 80)", "turn.speed.at(50)"};
        expect_room_slopes(of.text() + asked_for(names), names);
    }
}

TEST(SignalsOfKinds, OverInputRangesAreThoseOfTheLinkages) {
    for (const KindWithSignals& of : {kinds_with_signals[0], kinds_with_signals[1]}) {
        SCOPED_TRACE(of.kind.kind);
        const std::string line = "[line]\nstart = 25\nrange = 80\nangle = 20\noffset = 3\n";
        expect_as_expanded(of.text() + line + asked_for(of_signals));
    }
}

TEST(SignalsOfKinds, AreOfTheKindWithoutASection) {
    const KindWithSignals& of = kinds_with_signals[0];
    const Json document = analysed_room(of.kind.text() + asked_for({of.own, "rocker-angle.speed.at(60)"})).document;
    EXPECT_FALSE(document.contains("signals"));
    expect_verified(document);
    Json changed = document;
    changed["quantities"][of.own] = value_in(document, of.own) * (1 + 1e-7);
    EXPECT_TRUE(is_refused(changed));
}

TEST(SignalsOfKinds, AreRefusedWhereDocumentsAreChanged) {
    const Json document = analysed_room(kinds_with_signals[0].text() + asked_for(of_signals)).document;
    expect_verified(document);
    const auto expect_refused = [&](const auto& change) {
        Json changed = document;
        change(changed);
        EXPECT_TRUE(is_refused(changed)) << changed["signals"];
    };
    expect_refused([](Json& json) { json["signals"]["high"]["along"] = 36; });
    expect_refused([](Json& json) { json["signals"]["quick"]["speed-of"] = "C"; });
    expect_refused([](Json& json) { json.erase("signals"); });
    expect_refused([](Json& json) { json["signals"] = 3; });
    expect_refused([](Json& json) { json["signals"]["high"] = nullptr; });
}

TEST(SignalsOfKinds, SayWhatIsWrong) {
    const auto expect_error = [&](const std::string& part, const std::string& begins) {
        const std::string error = testing::first_error(kinds_with_rooms[0].text() + part);
        EXPECT_EQ(error.substr(0, begins.size()), begins) << error;
    };
    expect_error("[signals]\nswings = { angle = \"rokcer\" }\n",
                 "'angle' in the signal 'swings': there is no link 'rokcer'; did you mean 'rocker'?");
    expect_error("[signals]\nhigh = { y = \"Q\" }\n", "'y' in the signal 'high': there is no point 'Q'");
    expect_error("[signals]\nswing = { angle = \"rocker\" }\n",
                 "'swing' cannot be the name of a signal: it is a quantity already");
    expect_error("[signals]\nrocker-angle = { angle = \"rocker\" }\n",
                 "'rocker-angle' is a signal of this mechanism already, which can be asked for as it is");
    expect_error("[signals]\nway = { slide = \"A\" }\n",
                 "'slide' in the signal 'way': there is no slide 'A'; the mechanism has none");
    expect_error("[signals]\nbad = { transmission-angle = \"P\" }\n",
                 "the signal 'bad' is the transmission angle of a dyad, and none is closed at 'P'");
    expect_error("[signals]\nhigh = { y = \"P\" }\n" + asked_for({"high.highest"}),
                 "'high.highest' is no quantity of a signal; ");
    const ReadProblem read = parse_problem(kinds_with_rooms[0].text() + asked_for({"rocker-angle.highest"}), "a.toml");
    ASSERT_EQ(read.messages.size(), 1u);
    EXPECT_EQ(to_string(read.messages.front()).substr(0, 13), "a.toml:15:12:");
    const ReadProblem cam = parse_problem(
        "schema = 1\nmechanism = \"cam\"\n[cam]\nfollower = \"flat\"\ncontour = \"eccentric\"\n[signals]\nhigh = { y = "
        "\"P\" }\n",
        "cam.toml");
    EXPECT_TRUE(std::any_of(cam.messages.begin(), cam.messages.end(), [](const Message& message) {
        return to_string(message).find("[signals] is of links and joints, and a cam has none") != std::string::npos;
    }));
}

/// The optimum is that of the linkage that it is, too, solved by itself.
TEST(SignalsOfKinds, AreSolvedForAnEvenPace) {
    std::ifstream in(MECHWRIGHT_SOURCE_DIR "/problems/four-bar/even-pace.toml");
    std::string text{std::istreambuf_iterator<char>(in), {}};
    text.replace(text.find("starts = 24"), 11, in_long_form() ? "starts = 4" : "starts = 2");
    const ExpandedProblem expanded = expand_problem(text, "even-pace.toml");
    ASSERT_TRUE(expanded.ok());
    for (const std::string& one : {text, expanded.text}) {
        ReadProblem read = testing::read_without_fault(one);
        ASSERT_TRUE(read.ok());
        const Json document = mechwright::document(read.problem, solve(read.problem, {}));
        EXPECT_EQ(document["status"], "solved");
        EXPECT_NEAR(document["objective"]["value"].get<double>(), 0.721553, 1e-6);
        EXPECT_NEAR(value_in(document, "pace.mean(150, 240)"), 60, 1e-6);
        EXPECT_NEAR(value_in(document, "level.deviation(150, 240)"), 1, 1e-6);
        expect_verified(document);
    }
}

}  // namespace

}  // namespace mechwright::linkage_scans
