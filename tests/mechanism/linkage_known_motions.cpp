// Known positions, speeds, accelerations and extremes of shipped linkages that turn, swing and walk.

#include "tests/mechanism/linkage_known.h"

namespace mechwright::known_linkages {

namespace {

TEST(KnownLinkages, ABellCrankMovesItsSlideAsInExample31) {
    expect_known("bell-crank-slider",
                 {{"ram.at(30)", 1.181985794154482407},
                  {"ram.speed.at(30)", 17.82492485622566683},
                  {"ram.acceleration.at(30)", 14.42943383963697446},
                  {"coupler.at(30)", degrees(-0.4993509584909029775)},
                  {"coupler.speed.at(30)", -0.439702577506088949},
                  {"coupler.acceleration.at(30)", 0.2530875008847685055},
                  {"bell.at(30)", degrees(-1.318267870990814627)},
                  {"bell.speed.at(30)", -0.5843650816259443467},
                  {"bell.acceleration.at(30)", -0.4342728489132428484},
                  {"rod.at(30)", degrees(-2.949920840015968632)},
                  {"rod.speed.at(30)", 0.1205911097494752618},
                  {"rod.acceleration.at(30)", -0.1806577650804375304},
                  {"b-speed.at(30)", 30 * 0.5843650816259443467},
                  {"b-speed.least", 0}},
                 100);
}

TEST(KnownLinkages, ALeverAndRodMoveAsInExample32) {
    const double half = std::asin(0.6) / one_degree;
    expect_known("lever-and-rod",
                 {{"lever.at(150)", degrees(2.23774267129856085)},
                  {"lever.speed.at(150)", 0.66326530612244898},
                  {"lever.acceleration.at(150)", 0.08656647101552073104},
                  {"rod.speed.at(150)", 0.1301020504392596113},
                  {"rod.acceleration.at(150)", 0.1223689030685676688},
                  {"ram.at(150)", -50.7000819990510849},
                  {"ram.speed.at(150)", 8.378279732164404359},
                  {"ram.acceleration.at(150)", -4.937630061430372933},
                  {"ram.range", 40},
                  {"ram.time-ratio", (180 + 2 * half) / (180 - 2 * half)},
                  {"b-speed.at(150)", 20 * 0.66326530612244898}},
                 100);
}

TEST(KnownLinkages, GearsMakeStrokesDifferAsInExample34) {
    expect_known("differential-stroke",
                 {{"rod.at(90)", degrees(1.721364599571582646)},
                  {"rod.speed.at(90)", 0.1970855423349020171},
                  {"rod.acceleration.at(90)", -0.07944746220276180195},
                  {"lever.speed.at(90)", 0.617720506832670955},
                  {"lever.acceleration.at(90)", -0.7537603258081008448},
                  {"tie.speed.at(90)", -0.5324474373611315002},
                  {"tie.acceleration.at(90)", 0.4621462821909254622},
                  {"slide.at(90)", 312.1234044498977549},
                  {"slide.speed.at(90)", -35.51570783755882564},
                  {"slide.acceleration.at(90)", -43.15697799846448389},
                  {"e-speed.at(90)", 40.07239251986809353},
                  {"d-speed.at(90)", 38.40449196595368346},
                  {"g-speed.at(90)", 96.78977617807573652},
                  {"e-acceleration.at(90)", 41.21840865109382068},
                  {"d-acceleration.at(90)", 125.1227662160186103},
                  {"g-acceleration.at(90)", 44.91486733367918549}},
                 300);
}

TEST(KnownLinkages, TwoSlidesMoveAsInExample36) {
    expect_known("two-slides",
                 {{"down.speed.at(155)", 0.1281483698601835675},
                  {"down.acceleration.at(155)", -0.278933289621305521},
                  {"tie.speed.at(155)", 0.409481621282397954},
                  {"tie.acceleration.at(155)", 0.03581902201645254097},
                  {"rocker.at(155)", degrees(0.9740585914892102264)},
                  {"rocker.speed.at(155)", 0.1896998508094774927},
                  {"rocker.acceleration.at(155)", -0.114706131421049137},
                  {"link.speed.at(155)", -0.1434600352131336447},
                  {"link.acceleration.at(155)", 0.1135567213132956576},
                  {"upright.at(155)", -43.12896303255674674},
                  {"upright.speed.at(155)", -15.18434643940946568},
                  {"upright.acceleration.at(155)", -2.066631962941398276},
                  {"level.at(155)", 56.11585603489615312},
                  {"level.speed.at(155)", -9.698079894239494552},
                  {"level.acceleration.at(155)", 4.888448427697776808},
                  {"b-speed.at(155)", 12.33049030261603703},
                  {"c-speed.at(155)", 8.157093584807532187},
                  {"b-acceleration.at(155)", 7.814203430782396445},
                  {"c-acceleration.at(155)", 5.169396115748354571}},
                 100);
}

TEST(KnownLinkages, ALeverMovesASlideAsInExample37) {
    const double swing = 2 * std::asin(24 / std::sqrt(47. * 47 + 64));
    const double middle = std::atan2(-8, 47);
    expect_known("lever-and-slide",
                 {{"lever.at(45)", degrees(0.1393210643478463926)},
                  {"lever.speed.at(45)", 0.2966546341468050269},
                  {"lever.acceleration.at(45)", -0.09097155983240386076},
                  {"reach.at(45)", 64.59646967428805986},
                  {"reach.speed.at(45)", -14.44941118102256179},
                  {"height.at(45)", 12.62757490290786578},
                  {"height.speed.at(45)", 9.982108856436829383},
                  {"height.acceleration.at(45)", -2.230588647111524004},
                  {"height.least", 8 + 33 * std::tan(middle - swing / 2)},
                  {"height.greatest", 8 + 33 * std::tan(middle + swing / 2)},
                  {"lever.range", swing / one_degree},
                  {"lever.time-ratio", (std::numbers::pi + swing) / (std::numbers::pi - swing)},
                  {"joint-distance-least", 0}},
                 100);
}

TEST(KnownLinkages, ARodsMassCentreAcceleratesAsInExample41) {
    expect_known("connecting-rod",
                 {{"along.acceleration.at(30)", -4503721.225251494018},
                  {"across.acceleration.at(30)", -1880159.638407522817},
                  {"load.at(30)", 4880420.590551343606},
                  {"load.at(60)", 4016104.587014517226},
                  {"load.at(90)", 3774220.689388206599},
                  {"rod.acceleration.at(30)", 11842.41214688028297},
                  {"piston.acceleration.at(30)", -4988756.820757343209}},
                 5e6);
    expect_known("connecting-rod",
                 {{"piston.speed.at(30)", -9720.946711070108971}, {"rod.speed.at(30)", -68.55517208472575373}}, 2e4);
    expect_known("connecting-rod",
                 {{"piston.at(30)", 245.6003404153712863}, {"rod.at(30)", degrees(-0.1253278311680653969)}}, 250);
}

TEST(KnownLinkages, QuickReturnsKeepTheirTimes) {
    // The lever's direction from its pivot, the arm beyond it and the rod above.
    const auto ram = [](double crank) {
        const double x = 90 + 180 * std::cos(crank * one_degree), y = 180 * std::sin(crank * one_degree);
        const double across = -96 * x / std::hypot(x, y), up = -96 * y / std::hypot(x, y);
        return up + std::sqrt(490. * 490 - across * across);
    };
    expect_known("whitworth",
                 {{"stroke.time-ratio", 2},
                  {"stroke.range", 192},
                  {"stroke.least", 394},
                  {"stroke.greatest", 586},
                  {"stroke.at(0)", ram(0)},
                  {"stroke.at(150)", ram(150)},
                  {"stroke.at(280)", ram(280)}},
                 500);
    const auto shaper = [](double crank) {
        const double x = 60 * std::cos(crank * one_degree), y = 120 + 60 * std::sin(crank * one_degree);
        const double across = 200 * x / std::hypot(x, y), up = 200 * y / std::hypot(x, y);
        return across + std::sqrt(150. * 150 - (190 - up) * (190 - up));
    };
    expect_known("crank-shaper",
                 {{"stroke.range", 200},
                  {"stroke.time-ratio", 2},
                  {"swing.range", 60},
                  {"stroke.at(20)", shaper(20)},
                  {"stroke.at(250)", shaper(250)}},
                 250);
    const double slow = 317.8735841851048676 - 51.60695598079298264;
    expect_known("drag-link",
                 {{"stroke.least", 240},
                  {"stroke.greatest", 640},
                  {"stroke.time-ratio", slow / (360 - slow)},
                  {"pull.least", 10.26309589862255672},
                  {"pull.greatest", 73.1021274068343603},
                  {"coupler.speed.at(90)", 0.5867639753032264149},
                  {"coupler.acceleration.at(90)", -0.2416136885859455177},
                  {"follower.at(90)", degrees(0.8254448690947508791)},
                  {"follower.speed.at(90)", 1.036636751170329612},
                  {"follower.acceleration.at(90)", -0.409001444216704472},
                  {"rod.speed.at(90)", -0.407581872562940578},
                  {"rod.acceleration.at(90)", 0.5478279702402547184},
                  {"stroke.at(90)", 545.6457979078966863},
                  {"stroke.speed.at(90)", -212.2566894035422920},
                  {"stroke.acceleration.at(90)", -62.4546076267271238}},
                 600);
}

TEST(KnownLinkages, SixBarsMoveAsTheyDo) {
    expect_known("watt-one",
                 {{"across.at(60)", 1.221352551983289963},
                  {"up.at(60)", 5.051635884385100517},
                  {"turn.at(60)", 33.83886904236895234},
                  {"across.speed.at(60)", -0.3134955239330557761},
                  {"up.speed.at(60)", 0.3822214598405727214},
                  {"turn.speed.at(60)", 0.002594948005165097077},
                  {"across.acceleration.at(60)", -1.642691182441890132},
                  {"up.acceleration.at(60)", -0.8026038267979445908},
                  {"across.greatest", 1.249964343896452576},
                  {"across.least", -1.302118252308612662},
                  {"up.greatest", 5.139611525676106024},
                  {"up.least", 3.05454173809625483}},
                 50);
    expect_known("watt-two",
                 {{"output.at(60)", 98.13981159613540819},
                  {"output.speed.at(60)", -0.1475513684631487156},
                  {"output.acceleration.at(60)", -0.3580679702177876478},
                  {"output.greatest", 99.63518485181248487},
                  {"output.least", 80.88830170794295518},
                  {"output.greatest(174.6, 282.4)", 81.39834742972459231},
                  {"output.least(100, 228)", 80.88830170794295518}},
                 100);
    expect_known("stephenson-one",
                 {{"across.at(60)", -1.106461504030040072},
                  {"up.at(60)", 3.064727484377979055},
                  {"across.speed.at(60)", -0.9686288426086327841},
                  {"up.speed.at(60)", -0.9507799244490389615},
                  {"turn.speed.at(60)", 0.3758855634717137851},
                  {"across.acceleration.at(60)", -0.1116025803846298992},
                  {"up.acceleration.at(60)", -1.246056720923484895},
                  {"across.greatest", -0.3224458067975613378},
                  {"across.least", -2.059991110054392800},
                  {"up.greatest", 3.361574946543026179},
                  {"up.least", -0.5104941382097096715}},
                 5);
    expect_known("stephenson-three",
                 {{"output.at(60)", 120.5114867836394},
                  {"output.speed.at(60)", 0.03900277040044341775},
                  {"output.acceleration.at(60)", 0.450037752305867684},
                  {"output.greatest", 165.6756020328241448},
                  {"output.least", 120.416012870767492}},
                 100);
    expect_known("lambda-dwell",
                 {{"lever.at(90)", 0},
                  {"lever.at(180)", 0},
                  {"lever.at(270)", 0},
                  {"lever.least(90, 180)", -0.1168328945757679868},
                  {"lever.least(180, 270)", -0.07787943034851647098},
                  {"lever.least", -9.051178214559619450}},
                 10);
}

TEST(KnownLinkages, WalkersFeetGoAsTheyDo) {
    expect_known("jansen-leg",
                 {{"step.at(0)", -5.1601105241047233},
                  {"height.at(0)", -83.956932926123224},
                  {"step.at(90)", 30.310933769358341},
                  {"height.at(90)", -82.589351367404295},
                  {"step.at(180)", 4.2702704618303828},
                  {"height.at(180)", -65.717097409819483},
                  {"step.speed.at(90)", 15.510477033299311},
                  {"height.speed.at(90)", 3.1037368209964071},
                  {"step.acceleration.at(90)", -22.73423027444579},
                  {"height.acceleration.at(90)", 2.5151498521023302},
                  {"step.greatest", 34.386869451451592},
                  {"step.least", -33.521552240056649},
                  {"height.greatest", -61.576713158016015},
                  {"height.least", -84.033886742332222}},
                 100);
}

TEST(KnownLinkages, AndrewsSqueezerStandsAsItDoesAfter30Milliseconds) {
    // Crank angle 15.8107711951537070971 less two turns.
    const std::string crank = ".at(3.24440058079453416)";
    constexpr double right = std::numbers::pi / 2;
    expect_known("andrews-squeezer",
                 {{"leg" + crank, 0.0408222401196458048583 - right},
                  {"outer" + crank, 0.524409965879954069372},
                  {"upper" + crank, 1.04808074104193787307 - right},
                  {"inner" + crank, -0.534730116342079593770 + 0.524409965879954069372 - right}},
                 1);
}

TEST(KnownLinkages, SeveralDrivesGoTogether) {
    expect_known("geared-five-bar",
                 {{"height.at(0)", 2.349846672402644871},
                  {"height.at(60)", 1.597857504106796684},
                  {"height.at(120)", 3.080064731091721521},
                  {"height.at(240)", 0.9552566503241125626},
                  {"height.speed.at(60)", 0.06525279028230574388},
                  {"height.acceleration.at(60)", 3.727177770958841472},
                  {"height.greatest", 3.08508625160121672},
                  {"height.least", 0.3972460980525003183}},
                 3);
    expect_known("two-drives",
                 {{"across.at(50)", 0.9064860188689018907},
                  {"height.at(50)", 3.252098173229148297},
                  {"across.speed.at(50)", 0.9791001898035554003},
                  {"height.speed.at(50)", 0.4576782301421090501},
                  {"across.acceleration.at(50)", -1.570917831323957016},
                  {"height.acceleration.at(50)", -1.906425592133062777}},
                 3);
    const auto fore = [](double upper) { return (90 - upper / 2) * one_degree; };
    expect_known("belt-arm",
                 {{"head.least", 0},
                  {"head.greatest", 0},
                  {"across.at(70)", 50 + 400 * std::cos(70 * one_degree) + 300 * std::cos(fore(70))},
                  {"up.at(430)", 20 + 400 * std::sin(70 * one_degree) + 300 * std::sin(fore(430))},
                  {"up.greatest(430, 440)", 20 + 400 * std::sin(80 * one_degree) + 300 * std::sin(fore(440))},
                  {"up.least(-10, 5)", 20 + 400 * std::sin(-10 * one_degree) + 300 * std::sin(fore(710))},
                  {"up.speed.at(70)", 400 * std::cos(70 * one_degree) - 150 * std::cos(fore(70))}},
                 700);
}

TEST(KnownLinkages, LiftsWipersAndGearsKeepTheirTasks) {
    expect_known("scissors-lift",
                 {{"height.least", 2000 * std::sin(10 * one_degree) + 50},
                  {"height.greatest", 2000 * std::sin(60 * one_degree) + 50},
                  {"height.speed.at(30)", 2000 * std::cos(30 * one_degree)},
                  {"level.least", 0},
                  {"level.greatest", 0},
                  {"side.least", 500},
                  {"side.greatest", 500},
                  {"foot.at(30)", 1000 * std::cos(30 * one_degree)}},
                 2000);
    const double ground = std::hypot(150., 40.);
    const auto between = [&](double diagonal) {
        return std::acos((ground * ground + 60 * 60 - diagonal * diagonal) / (2 * ground * 60)) / one_degree;
    };
    expect_known("parallel-wiper",
                 {{"blade.least", 0}, {"blade.greatest", 0}, {"sweep.range", between(140 + 35) - between(140 - 35)}},
                 360);
    const double brace = std::hypot(450., 50.), towards = std::atan2(-50, 450);
    const auto leg = [&](double reach) {
        return (towards - std::acos((brace * brace + 500 * 500 - reach * reach) / (2 * brace * 500))) / one_degree;
    };
    expect_known("landing-gear",
                 {{"leg.least", -90}, {"leg.greatest", leg(450 * std::sqrt(2) - 520)}, {"wheel.least", -1200}}, 1200);
}

TEST(KnownLinkages, EveryJointDoesWhatItIs) {
    // The rocker of Freudenstein's equation by half angles, for the arc of a slot and for a rack's sector.
    const auto rocker = [](double crank) {
        const double x = 100 - 40 * std::cos(crank * one_degree), y = -40 * std::sin(crank * one_degree);
        const double squared = x * x + y * y;
        return std::atan2(-y, -x) - std::acos((squared + 80 * 80 - 110 * 110) / (2 * 80 * std::sqrt(squared)));
    };
    const auto positive = [](double angle) { return angle < 0 ? angle + 2 * std::numbers::pi : angle; };
    const auto extreme = [](double diagonal) {
        return std::acos((100. * 100 + 80 * 80 - diagonal * diagonal) / (2 * 100 * 80));
    };
    for (const double crank : {40., 200.}) {
        const double angle = positive(rocker(crank));
        expect_known("arc-slot",
                     {{at("across", crank), 100 + 80 * std::cos(angle)}, {at("up", crank), 80 * std::sin(angle)}}, 110);
        expect_known("crank-and-rack", {{at("swing", crank), angle / one_degree}, {at("stroke", crank), 60 * angle}},
                     400);
    }
    expect_known("crank-and-rack", {{"stroke.range", 60 * (extreme(150) - extreme(70))}}, 100);
    expect_known("cardan-gear",
                 {{"side.least", 0},
                  {"side.greatest", 0},
                  {"stroke.range", 120},
                  {"stroke.at(77)", 60 * std::cos(77 * one_degree)},
                  {"half-x.at(77)", 45 * std::cos(77 * one_degree)},
                  {"half-y.at(77)", 15 * std::sin(77 * one_degree)},
                  {"half-y.jerk.at(77)", -15 * std::cos(77 * one_degree)}},
                 60);
    expect_known("scotch-yoke",
                 {{"stroke.at(50)", 20 * std::cos(50 * one_degree)},
                  {"stroke.speed.at(50)", -20 * 4 * std::numbers::pi * std::sin(50 * one_degree)}},
                 250);
}

}  // namespace

}  // namespace mechwright::known_linkages
