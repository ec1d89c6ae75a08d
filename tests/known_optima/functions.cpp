// Function generators of least structural error: the exercises of the source, the logarithm in five parameters, and
// what a minimax optimum must look like.

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "synthesis/mechanism/four_bar/function.h"
#include "tests/degree.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

/// The greatest structural error by a scan of the rocker angle as the loop gives it: B from the circles about A and B0.
double scanned_error(const Solved& s, double (*y)(double), double from, double to) {
    const auto radians = [&](const char* name) { return s.dimension(name); };
    const double g = s.dimension("ground"), a = s.dimension("crank"), b = s.dimension("coupler"),
                 c = s.dimension("rocker");
    const double side = s.result.best->design.assembly == 0 ? 1 : -1;
    double greatest = 0;
    for (int i = 0; i <= 20000; ++i) {
        const double u = i / 20000.0;
        const double input = radians("input-start") + radians("input-range") * u;
        const double part = (y(from + u * (to - from)) - y(from)) / (y(to) - y(from));
        const double dx = g - a * std::cos(input), dy = -a * std::sin(input);
        const double d = std::hypot(dx, dy);
        const double at_pin = std::acos((b * b + d * d - c * c) / (2 * b * d));
        const double coupler = std::atan2(dy, dx) + side * at_pin;
        const double rocker =
            std::atan2(a * std::sin(input) + b * std::sin(coupler), a * std::cos(input) + b * std::cos(coupler) - g);
        const double error = rocker - radians("output-start") - radians("output-range") * part;
        greatest = std::max(greatest, std::abs(std::remainder(error, 2 * std::numbers::pi)));
    }
    return greatest / degree;
}

struct FunctionCase {
    const char* file;
    double known;   ///< degrees, as printed
    double within;  ///< half a unit of its last digit
    double (*y)(double);
    double from, to;
    int alternating;
};

class KnownFunctions : public ::testing::TestWithParam<FunctionCase> {};

TEST_P(KnownFunctions, HaveTheirLeastGreatestError) {
    const FunctionCase& c = GetParam();
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Solved s = solved(shipped(c.file, "function"), "auto", seed);
        ASSERT_EQ(s.result.status, Status::solved);
        const double error = s.result.best->objective;
        EXPECT_LE(error, c.known + c.within) << c.file << ", seed " << seed;
        EXPECT_GE(error, c.known - 5e-5) << c.file << ", seed " << seed;
        EXPECT_NEAR(error, scanned_error(s, c.y, c.from, c.to), 1e-8);
        const auto json = document(s.problem, s.result);
        EXPECT_EQ(json["function"]["alternating"], c.alternating);
        EXPECT_EQ(json["function"]["free"].get<int>() + 1, c.alternating);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Source, KnownFunctions,
    ::testing::Values(FunctionCase{"power.toml", 0.610531, 5e-7, [](double x) { return std::pow(x, 1.5); }, 1, 4, 4},
                      FunctionCase{"tangent.toml", 0.2503, 5e-5, [](double x) { return std::tan(x * degree); }, 0, 45,
                                   4},
                      FunctionCase{"reciprocal.toml", 1.247067, 5e-7, [](double x) { return 1 / x; }, 1, 2, 4},
                      FunctionCase{"logarithm.toml", 0.0069708, 5e-8, [](double x) { return std::log10(x); }, 1, 2, 6}),
    [](const auto& test) { return std::string(test.param.file, std::string(test.param.file).find('.')); });

/// A rocker that goes the other way round passes half a turn of error between two ends of 63 deg.
TEST(Functions, ErrorsThatPassHalfATurnAreKnownToTheSearch) {
    const Solved s = solved(R"toml(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 50
crank = { min = 1, max = 1000 }
coupler = { min = 1, max = 1000 }
rocker = { min = 1, max = 1000 }
assembly = "either"
[function]
expression = "exp(x/3)"
x = [1.8897043327040863, 2.9214566884937847]
input = { start = 227.2015790995493, range = 83.5178489936719 }
output = { start = 118.22207675179419, range = -87.93618674823684 }
[objective]
minimize = "function-max"
[solver]
starts = 1
)toml");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_LT(s.result.best->objective, 2);
    EXPECT_NEAR(s.result.best->objective,
                scanned_error(
                    s, [](double x) { return std::exp(x / 3); }, 1.8897043327040863, 2.9214566884937847),
                1e-8);
}

TEST(Functions, OfThreeAccuracyPointsHaveTheErrorOfTheSource) {
    // Example 9-2, computed: the exact design through the three points, its links to six decimals, which is to 1e-5
    // deg.
    const Solved s = solved(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 5
crank = 8.499825
coupler = 14.051129
rocker = 11.119001
assembly = "crossed"
[function]
expression = "x^1.5"
x = [1, 4]
input = { start = 210, range = 90 }
output = { start = 270, range = 90 }
)");
    EXPECT_NEAR(s.value("function-max") / degree, 0.831477, 1e-5);
}

TEST(Functions, LeastSquaresBySlsqpAndByIpoptAgree) {
    const double here = solved(shipped("power-rms.toml", "function")).result.best->objective;
    EXPECT_NEAR(solved(shipped("power-rms.toml", "function"), "ipopt").result.best->objective / here, 1, 1e-9);
}

/// With the least mean square no other design near has a smaller one, but one has a smaller greatest error.
TEST(Functions, LeastSquaresAndMinimaxDiffer) {
    const Solved squares = solved(shipped("power-rms.toml", "function"));
    const Solved minimax = solved(shipped("power.toml", "function"));
    EXPECT_LT(squares.value("function-rms"), minimax.value("function-rms"));
    EXPECT_GT(squares.value("function-max"), minimax.value("function-max"));
}

/// The least velocity ratio of a four-bar over crank angles from 30 to 130 deg, by the triangles of the loop; where it
/// does not close, none.
double least_velocity_ratio(double crank, double coupler, double rocker, double side) {
    constexpr double ground = 5;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 200; ++i) {
        const double angle = (30 + 0.5 * i) * degree;
        const std::complex<double> pin = std::polar(crank, angle), across = ground - pin;
        const double d = std::abs(across);
        const double cosine = (coupler * coupler + d * d - rocker * rocker) / (2 * coupler * d);
        if (!(std::abs(cosine) < 1)) return -std::numeric_limits<double>::infinity();
        const double of_coupler = std::arg(across) + side * std::acos(cosine);
        const double of_rocker = std::arg(pin + std::polar(coupler, of_coupler) - ground);
        least = std::min(least, crank * std::sin(angle - of_coupler) / (rocker * std::sin(of_rocker - of_coupler)));
    }
    return least;
}

/// A function of which nothing is asked gives the input range alone, and searches begin at designs of all kinds.
TEST(Functions, OfWhichNothingIsAskedLeaveTheDesignToTheObjective) {
    const Solved s = solved(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 5\ncrank = { min = 1, max = 20 }\n"
        "coupler = { min = 13, max = 15 }\nrocker = { min = 1, max = 20 }\nassembly = \"either\"\n"
        "[function]\nexpression = \"1/x\"\nx = [1, 2]\ninput = { start = 30, range = 100 }\n"
        "output = { start = 120, range = 90 }\n[objective]\nmaximize = \"velocity-ratio-min\"\n");
    ASSERT_EQ(s.result.status, Status::solved);
    double best = 0;
    for (double crank = 1; crank <= 20; crank += 0.5)
        for (double rocker = 1; rocker <= 20; rocker += 0.5)
            for (const double coupler : {13.0, 14.0, 15.0})
                for (const double side : {1.0, -1.0})
                    best = std::max(best, least_velocity_ratio(crank, coupler, rocker, side));
    EXPECT_GT(best, 0);
    EXPECT_GE(s.value("velocity-ratio-min"), best - 1e-9);
    const double reached = least_velocity_ratio(s.dimension("crank"), s.dimension("coupler"), s.dimension("rocker"),
                                                s.result.best->design.assembly == 0 ? 1 : -1);
    EXPECT_NEAR(s.value("velocity-ratio-min"), reached, 1e-3);
}

/// The size of an error that passes half a turn has a kink there; its mean by quadrature in 25 digits between them.
TEST(Functions, ThatPassHalfATurnHaveTheirMeanError) {
    const Solved s = solved(R"toml(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 1200
crank = 182.0009999999998
coupler = 1199.9988010800364
rocker = 182.0009999999998
[function]
expression = "atan(tan(x * pi / 180) / (1 + 1200 / 2600 * tan(x * pi / 180))) * 180 / pi"
x = [-30, 38.2064]
input = { start = 318.5043467728543, range = 68.2064 }
output = { start = 153.2892532271457, range = 68.2064 }
[objective]
minimize = "function-rms"
)toml");
    EXPECT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.result.best->objective, 154.0236905369319, 1e-10);
}

/// What only rules out designs must not keep a search from the best one: some ratio of two links has to be as great as
/// that of the best logarithm, and each of the twelve ratios is a program with starts of its own.
TEST(Functions, RequirementsThatOneOfManyValuesMeetsHideNoOptimum) {
    const Solved s = solved(R"toml(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 1
crank = { min = 2.014, max = 3.743 }
coupler = { min = 0, max = 20 }
rocker = { min = 0, max = 20 }
assembly = "either"
[function]
expression = "log10(x)"
x = [1, 2]
input = { start = { min = 0, max = 360 }, range = 60 }
output = { start = { min = 0, max = 360 }, range = 90 }
[objective]
minimize = "function-max"
[[require]]
quantity = "link-ratio"
equal = 18.915675234943635
[[require]]
quantity = "function-max"
max = 0.007
)toml");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.result.best->objective, 0.00697066066, 1e-11);
}

/// A design that does not assemble over its input range has lengths, too, and less of them; its link ratio is no value.
TEST(Functions, AreNoneOfWhatDoesNotAssembleOverTheInputRange) {
    const std::string text = R"toml(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 1
crank = { min = 2.73, max = 3.03 }
coupler = { min = 16.08, max = 17.78 }
rocker = { min = 0, max = 20 }
assembly = "either"
[function]
expression = "log10(x)"
x = [1, 2]
input = { start = { min = 0, max = 360 }, range = 60 }
output = { start = { min = 0, max = 360 }, range = 90 }
[objective]
minimize = "total-length"
[[require]]
quantity = "link-ratio"
min = 15
)toml";
    const Solved s = solved(text);
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_TRUE(all_passed(s.result.verification));
    Design shorter = s.result.best->design;
    shorter.dimensions[static_cast<std::size_t>(find_dimension(*s.problem.mechanism, "rocker"))] -= 1e-3;
    EXPECT_FALSE(assembles_over_range(s.problem, shorter));
    EXPECT_FALSE(quantity_value(s.problem, static_cast<std::size_t>(find_quantity(*s.problem.mechanism, "link-ratio")),
                                shorter));
}

/// A margin over the input range of a shipped problem, whose dimensions are drawn 300 times, and the least of a scan of
/// what `margin_at` says of links and crank angle.
template <class MarginAt>
void expect_least_margins(const char* file, std::size_t lengths, const MarginAt& margin_at) {
    const Problem problem = parse_problem(shipped(file, "function"), file).problem;
    const Mechanism& mechanism = *problem.mechanism;
    std::vector<double> dimensions(problem.dimensions.size(), 1);
    double draw = 0;
    const auto next = [&] { return draw = std::fmod(draw + 0.6180339887498949, 1); };
    for (int k = 0; k < 300; ++k) {
        for (std::size_t i = 0; i < lengths; ++i)
            dimensions[i] = 1 + 4 * next();
        const double start = dimensions[mechanism.input->start] = 7 * next();
        const double range = dimensions[mechanism.input->start + 1] = 12 * next() - 6;
        constexpr int steps = 2000;
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i <= steps; ++i)
            least = std::min(least, margin_at(dimensions, start + range * i / steps));
        EXPECT_NEAR(least_component(mechanism.input->margin, {}, dimensions), least, 1e-4) << file << ' ' << k;
    }
}

TEST(Functions, HaveTheLeastMarginOfAssemblyOverTheirInput) {
    expect_least_margins("logarithm.toml", 4, [](const std::vector<double>& x, double angle) {
        const double apart = std::hypot(x[0] - x[1] * std::cos(angle), x[1] * std::sin(angle));
        return std::min(x[2] + x[3] - apart, apart - std::abs(x[2] - x[3]));
    });
    expect_least_margins("ram-square.toml", 3, [](const std::vector<double>& x, double angle) {
        return x[1] - std::abs(x[2] - x[0] * std::sin(angle));
    });
}

/// The ram by the loop equation, scanned: five dimensions are free, so that six extremes alternate.
TEST(Functions, OfARamAlternateToo) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Solved s = solved(shipped("ram-square.toml", "function"), "auto", seed);
        ASSERT_EQ(s.result.status, Status::solved);
        const auto json = document(s.problem, s.result);
        EXPECT_EQ(json["function"]["alternating"], 6);
        EXPECT_EQ(json["function"]["free"], 5);
        const double a = s.dimension("crank"), l = s.dimension("rod"), e = s.dimension("offset");
        double greatest = 0, worst = 90;
        for (int i = 0; i <= 20000; ++i) {
            const double x = 1 + 2 * (i / 20000.0);
            const double angle = s.dimension("input-start") + s.dimension("input-range") * i / 20000.0;
            const double height = e - a * std::sin(angle);
            const double position = a * std::cos(angle) + std::sqrt(l * l - height * height);
            const double asked = s.dimension("output-start") + s.dimension("output-range") * (x * x - 1) / 8;
            greatest = std::max(greatest, std::abs(position - asked));
            worst = std::min(worst, std::acos(std::abs(height) / l) / degree);
        }
        EXPECT_NEAR(greatest / s.result.best->objective, 1, 1e-6);
        EXPECT_NEAR(worst, s.value("transmission-angle-worst") / degree, 1e-6);
    }
}

/// Where the input range is free its ends move with the design, and a limit on the transmission angle must know that.
TEST(Functions, OfAFreeInputRangeKeepALimitOnTheTransmissionAngle) {
    std::string text = shipped("logarithm.toml", "function");
    const Solved free = solved(text);
    const double limit = 45;
    ASSERT_LT(free.value("transmission-angle-worst") / degree, limit);
    text += "\n[[require]]\nquantity = \"transmission-angle-worst\"\nmin = 45\n";
    const Solved limited = solved(text);
    ASSERT_EQ(limited.result.status, Status::solved);
    EXPECT_NEAR(limited.value("transmission-angle-worst") / degree, limit, 1e-6);
    EXPECT_GT(limited.result.best->objective, free.result.best->objective);
}

/// A rod that comes out of a dead position has a square root at the end of its range: both quadratures know it.
TEST(Functions, FromADeadPositionKeepTheirMeanError) {
    const Solved s = solved(R"toml(schema = 1
mechanism = "slider-crank"
[dimensions]
crank  = 10.0
rod    = 173.86061757149636
offset = -174.50058437083882
[function]
expression = "log10(x)"
x      = [1, 10]
input  = { start = 184.46427668230632, range = 90 }
output = { start = -2.330455928702171, range = 60 }
[objective]
minimize = "function-max"
)toml");
    EXPECT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.value("function-rms"), 0.493011826, 1e-8);
}

/// Where a linkage passes close by a toggle or a change point its error has all but a kink.
TEST(Functions, CloseByTogglesAndChangePointsKeepTheirMeanError) {
    const std::string reciprocal = "[function]\nexpression = \"1/x\"\nx = [1, 2]\n";
    const std::string from_30 =
        reciprocal + "input = { start = 30, range = 200 }\noutput = { start = 120, range = 90 }\n";
    const std::string from_100 =
        reciprocal + "input = { start = 100, range = 150 }\noutput = { start = 70, range = 60 }\n";
    const std::string cube = R"([function]
expression = "x^3"
x = [0.5034254776702357, 1.870193139569234]
input = { start = 295.3749282931735, range = 110.89436646608065 }
output = { start = 266.5812282599507, range = -94.73119206979837 }
)";
    const auto given = [](const char* lengths, const char* assembly) {
        return std::string(lengths) + "\nassembly = \"" + assembly + "\"\n";
    };
    struct Case {
        std::string dimensions;
        std::string function;
        double rms;  ///< degrees, integrated in forty digits by mpmath between the kinks
    };
    for (const Case& c :
         {Case{given("ground = 5\ncrank = 4.953461163009182\ncoupler = 3.706225973569235\nrocker = 6.282759467025265",
                     "crossed"),
               from_30, 9.287396370078872},
          Case{given("ground = 10\ncrank = 6.560169360359591\ncoupler = 5.386803894828668\nrocker = 6.772103420691056",
                     "crossed"),
               cube, 8.420479889290726},
          Case{given("ground = 4\ncrank = 2\ncoupler = 3.000001\nrocker = 3", "open"), from_100, 54.45717785276263},
          Case{given("ground = 4\ncrank = 2\ncoupler = 3.0000000001\nrocker = 3", "crossed"), from_100,
               90.37227947067849}}) {
        const Solved s = solved("schema = 1\nmechanism = \"four-bar\"\n[dimensions]\n" + c.dimensions + c.function);
        EXPECT_EQ(s.result.status, Status::solved) << c.dimensions;
        EXPECT_NEAR(s.value("function-rms") / degree / c.rms, 1, 1e-12) << c.dimensions;
    }
}

/// An expression and dense samples of it are the same function.
TEST(Functions, SamplesOfAnExpressionGiveItsErrors) {
    std::string samples = "samples = [";
    for (int i = 0; i <= 600; ++i) {
        const double x = 1 + i / 200.0;
        samples += "[" + std::to_string(x) + ", " + std::to_string(std::pow(x, 1.5)) + "],";
    }
    std::string text = shipped("power.toml", "function");
    const auto at = text.find("expression");
    text.replace(at, text.find("input") - at, samples + "]\n");
    const Solved s = solved(text);
    EXPECT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.result.best->objective, 0.610531, 1e-4);
}

}  // namespace

}  // namespace mechwright
