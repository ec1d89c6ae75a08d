// Known straight lines, curves, couplings and steering of shipped linkages.

#include "synthesis/verify/verify.h"
#include "tests/mechanism/linkage_known.h"

namespace mechwright::known_linkages {

namespace {

TEST(KnownLinkages, WattsLineDeviatesAsItDoes) {
    // Theory of Machines prints 2.24410e-4 over a travel of 0.483870.
    expect_known("watt-line",
                 {{"side.greatest", 1.000224410281207421},
                  {"side.least", 0.9997838370925298936},
                  {"side.at(-14)", 1.000224410281207421},
                  {"side.at(0)", 1},
                  {"side.at(14)", 0.9997838370925298936},
                  {"travel.at(-14)", 0.2571815745082010229},
                  {"travel.at(14)", 0.741051589487410535}},
                 1);
}

TEST(KnownLinkages, RobertsLineDeviatesAsItDoes) {
    expect_known("roberts-line",
                 {{"height.least", -0.6821011438064160838},
                  {"height.at(80.643279916757671)", -0.6821011438064160838},
                  {"travel.least", 0},
                  {"travel.greatest", 100},
                  {"height.at(65.375681647835924)", 0},
                  {"travel.at(65.375681647835924)", 50}},
                 100);
}

TEST(KnownLinkages, ChebyshevsLineDeviatesAsItDoes) {
    expect_known("chebyshev-line",
                 {{"height.greatest", 4.009753733086360006},
                  {"height.least", 4},
                  {"height.at(53.130102354155979)", 4},
                  {"height.at(73.350559342972807)", 4.009753733086360006},
                  {"travel.at(90)", 0}},
                 4);
}

void expect_all_verified(const std::string& text) {
    const ReadProblem read = parse_problem(text, "line.toml");
    ASSERT_TRUE(read.ok());
    for (const Check& check : verify(analysis_document(read.problem, evaluate_given(read.problem))))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

/// Its crank range ends where a lever stands in line with the coupler: the document says that the margin there is 0.
TEST(KnownLinkages, AMotionToTheVeryLimitIsVerified) {
    std::string text = shipped_text("chebyshev-line");
    const std::string range = "[37, 90]";
    text.replace(text.find(range), range.size(), "[36.869897645844021, 90]");
    expect_all_verified(text);
}

/// Its line is straight but for what rounding makes of sums over eight lengths.
TEST(KnownLinkages, AnExactLineIsVerifiedToRounding) {
    std::string text = shipped_text("hart-inversor");
    text.replace(text.find("a   = 4"), 7, "a   = 3");
    text.erase(text.find("travel = "));  // and the signals that follow
    expect_all_verified(text);
}

TEST(KnownLinkages, TheLambdaLinkageDrawsChebyshevsLine) {
    expect_known("lambda-line",
                 {{"height.at(90)", 4},
                  {"height.at(180)", 4},
                  {"height.greatest(90, 270)", 4.009753733086360006},
                  {"height.least(90, 270)", 4},
                  {"travel.at(90)", 4},
                  {"travel.at(270)", 0},
                  {"travel.speed.at(90)", -1},
                  {"travel.speed.at(120)", -1.279035943438030984},
                  {"travel.speed.at(150)", -1.335301858580826668},
                  {"travel.speed.at(180)", -4. / 3}},
                 4);
}

TEST(KnownLinkages, EvansLineDeviatesAsItDoes) {
    expect_known("evans-line",
                 {{"side.greatest", 0.002990233056595349312},
                  {"side.at(0)", 1.685272454331291032e-7},
                  {"side.at(6.7098069614945908)", 4.360142729563566312e-5},
                  {"side.least", 0},
                  {"travel.at(0)", 5.805639176394152668e-4},
                  {"travel.at(30)", 1.005143835047763769}},
                 2);
}

TEST(KnownLinkages, ExactLinesAreStraight) {
    expect_known("peaucellier", {{"line.least(-110, 110)", 2.5}, {"line.greatest(-110, 110)", 2.5}}, 3);
    expect_known("hart-inversor",
                 {{"line.least(-110, 110)", -8. / 3 / 1.8},
                  {"line.greatest(-110, 110)", -8. / 3 / 1.8},
                  {"inner.at(40)", 1.8 * std::cos(20 * one_degree)},
                  {"outer.at(40)", 8. / 3 / (1.8 * std::cos(20 * one_degree))},
                  {"travel.at(60)", -8. / 3 / 1.8 * std::tan(30 * one_degree)}},
                 4);
    // To its ends, where all bars lie in one line: from beside them.
    expect_known("hart-inversor", {{"inner.least", 2. / 3}, {"outer.greatest", 4}}, 4, 1e-11);
    expect_known("scott-russell",
                 {{"side.least", 0},
                  {"side.greatest", 0},
                  {"travel.at(30)", 1},
                  {"travel.greatest", 2 * std::sin(80 * one_degree)},
                  {"travel.speed.at(60)", 1}},
                 2);
}

TEST(KnownLinkages, ATrammelDrawsEllipsesAndACircle) {
    const double across = 50 * std::cos(70 * one_degree), up = 150 * std::sin(70 * one_degree);
    expect_known("trammel",
                 {{"across.at(70)", across},
                  {"up.at(70)", up},
                  {"across.acceleration.at(70)", -across},
                  {"up.jerk.at(70)", -150 * std::cos(70 * one_degree)},
                  {"across.range", 100},
                  {"up.range", 300},
                  {"radius.least", 50},
                  {"radius.greatest", 50}},
                 150);
}

TEST(KnownLinkages, OldhamsCouplingTurnsItsShaftsAlike) {
    expect_known("oldham",
                 {{"lag.least", 0},
                  {"lag.greatest", 0},
                  {"turn.range", 360},
                  {"turn.speed.at(200)", 1},
                  {"sliding.at(25)", 5 * std::cos(25 * one_degree)},
                  {"other.at(25)", -5 * std::sin(25 * one_degree)},
                  {"other.speed.at(0)", -5},
                  {"centre.at(25)", 2.5 + 2.5 * std::cos(50 * one_degree)}},
                 360);
}

TEST(KnownLinkages, APantographDrawsLarger) {
    expect_known("pantograph",
                 {{"pen-x.least", 2.5 * 33},
                  {"pen-x.greatest", 2.5 * 57},
                  {"pen-y.least", 2.5 * -2},
                  {"pen-y.greatest", 2.5 * 22},
                  {"pen-x.at(130)", 2.5 * (45 + 12 * std::cos(130 * one_degree))},
                  {"pen-y.speed.at(130)", 30 * std::cos(130 * one_degree)}},
                 150);
}

TEST(KnownLinkages, AToggleMultipliesForces) {
    for (const double angle : {1., 5., 10., 30.}) {
        const double sine = std::sin(angle * one_degree);
        expect_known("toggle",
                     {{at("link-force", angle), 1 / (2 * sine)},
                      {at("ram-force", angle), std::cos(angle * one_degree) / (2 * sine)}},
                     1 / sine);
    }
    expect_known("toggle", {{"stroke.at(30)", 200 * std::cos(30 * one_degree)}}, 200);
}

TEST(KnownLinkages, DavisSteersExactly) {
    const auto of_right = [](double left) {
        return std::atan(1 / (0.4 + 1 / std::tan(left * one_degree))) / one_degree;
    };
    expect_known("davis-steering",
                 {{at("outer", -25), of_right(-25)},
                  {at("outer", 10), of_right(10)},
                  {at("outer", 25), of_right(25)},
                  {at("outer", 40), of_right(40)}},
                 90);
}

TEST(KnownLinkages, AckermannSteersAlmost) {
    expect_known("ackermann-steering",
                 {{"outer.at(0)", 0},
                  {"outer.at(10)", 9.415190956993862192},
                  {"outer.at(20)", 17.70071767505178101},
                  {"outer.at(30)", 24.80299158512363384},
                  {"outer.at(40)", 30.5549596426234775}},
                 90);
}

TEST(KnownLinkages, KlannsLegStepsAsItDoes) {
    expect_known("klann-leg",
                 {{"step.at(0)", 1.000129503046536668},
                  {"height.at(0)", 3.470403522063467680e-5},
                  {"step.at(90)", 0.49671655705424742},
                  {"height.at(90)", 0.0045807619921161699},
                  {"step.at(180)", 0},
                  {"height.at(180)", 0},
                  {"step.at(225)", 0.27936903054752927},
                  {"height.at(225)", 0.39813069346223261},
                  {"step.greatest", 1.0077391802595025},
                  {"height.greatest", 0.47862591804084478},
                  {"height.least(0, 90)", -0.048786109131603676}},
                 1);
}

}  // namespace

}  // namespace mechwright::known_linkages
