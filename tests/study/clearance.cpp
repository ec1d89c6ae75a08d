// Clearance in the pins of linkages.

#include <cmath>

#include "analysis/four_bar.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/study/tolerance.h"
#include "tests/degree.h"
#include "tests/study/studies.h"

namespace mechwright::testing {
namespace {

const FourBar<double> links{100, 35, 95, 80};

/// These as a linkage.
const std::string crank_rocker = R"(schema = 1
mechanism = "linkage"
[dimensions]
ground = 100
crank = 35
coupler = 95
rocker = 80
[links]
frame   = { A = [0, 0], D = ["ground", 0] }
crank   = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = ["coupler", 0] }
rocker  = { D = [0, 0], C = ["rocker", 0] }
[drive]
link = "crank"
[signals]
rocker-angle = { angle = "rocker" }
[[require]]
quantity = "rocker-angle.range"
max = 56
)";

const std::string clearances = "[study]\ncount = 2000\nclearance = ";

TolerancedDesign toleranced(const PreparedStudy& study) {
    std::string why;
    auto design = toleranced_design(study, {}, why);
    if (!design) throw std::runtime_error(why);
    return *design;
}

double swing_of(const FourBar<double>& four_bar) { return swing(four_bar); }

double swing_of(const Piece& piece) {
    const int range = find_quantity(*piece.problem.mechanism, "rocker-angle.range");
    return *quantity_value(piece.problem, static_cast<std::size_t>(range), piece.solution.design);
}

/// A pin that is off makes a link as long as it then is from pin to pin: each of the four joints moves the hole of one
/// link, that of the link further down in the file.
TEST(Clearance, MakesLinksAsLongAsTheyAreFromPinToPin) {
    const TemporaryFolder folder;
    const PreparedStudy study = prepared(folder.write("a.toml", crank_rocker + clearances + "0.4\n"));
    const TolerancedDesign design = toleranced(study);
    ASSERT_EQ(design.sizes, std::vector<double>(4, 0.2));
    const Off off{0.11, -0.16};
    const auto with = [&](std::size_t joint) {
        std::vector<Off> offs(4, {0, 0});
        offs[joint] = off;
        return swing_of(piece_of(design, *study.study, offs));
    };
    const auto longer = [&](double length) { return std::hypot(length + off.x, off.y); };
    const auto shorter = [&](double length) { return std::hypot(length - off.x, off.y); };
    const std::vector<std::string> names{"A", "D", "B", "C"};
    for (std::size_t j = 0; j < 4; ++j) {
        FourBar<double> as_made = links;
        const std::string& name = design.problem.mechanism->pin_joints->names[j];
        if (name == "A") as_made.crank = shorter(links.crank);
        if (name == "B") as_made.coupler = shorter(links.coupler);
        if (name == "C") as_made.rocker = longer(links.rocker);
        if (name == "D") as_made.rocker = shorter(links.rocker);
        EXPECT_NEAR(with(j), swing_of(as_made), 1e-12) << name;
    }
}

/// What is a sum of lengths of links, or a ratio of them, is as it is drawn.
TEST(Clearance, MakesNoLinkLonger) {
    const TemporaryFolder folder;
    const PreparedStudy study = prepared(folder.write("a.toml", crank_rocker + clearances + "0.4\n"));
    const TolerancedDesign design = toleranced(study);
    const Piece piece = piece_of(design, *study.study, std::vector<Off>(4, {0.1, 0.1}));
    for (const auto& [name, value] : {std::pair("total-length", 310.0), std::pair("link-ratio", 100.0 / 35)}) {
        const int quantity = find_quantity(*piece.problem.mechanism, name);
        EXPECT_NEAR(*quantity_value(piece.problem, static_cast<std::size_t>(quantity), piece.solution.design), value,
                    1e-12);
    }
}

/// To first order: a pin moves a length by the part of its way that lies along the link.
TEST(Clearance, SpreadsAndIsWorstAsPredicted) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", crank_rocker + clearances + "{ B = 0.02, C = 0.04 }\n");
    const std::filesystem::path data = folder / "a.sqlite";
    run_to_end(file, data);
    const PreparedStudy study = prepared(file);
    const ToleranceReport report = tolerance_report(study, toleranced(study), data);
    EXPECT_EQ(report.dimensions, (std::vector<std::string>{"clearance B", "clearance C"}));
    EXPECT_EQ(report.assembled, 2000u);
    const double h = 1e-4;
    const auto by = [&](double FourBar<double>::*length) {
        FourBar<double> more = links, less = links;
        more.*length += h;
        less.*length -= h;
        return std::abs(swing_of(more) - swing_of(less)) / (2 * h) / degree;
    };
    const double of_coupler = by(&FourBar<double>::coupler), of_rocker = by(&FourBar<double>::rocker);
    int compared = 0;
    for (const QuantitySpread& s : report.quantities) {
        if (s.quantity != "rocker-angle.range") continue;
        ++compared;
        EXPECT_NEAR(s.derivatives[0], of_coupler, 1e-5 * of_coupler);
        EXPECT_NEAR(s.derivatives[1], of_rocker, 1e-5 * of_rocker);
        EXPECT_NEAR(s.worst, 0.01 * of_coupler + 0.02 * of_rocker, 1e-5 * s.worst);
        EXPECT_NEAR(*s.first_order, std::hypot(0.01 * of_coupler, 0.02 * of_rocker) / std::sqrt(2), 1e-5);
        EXPECT_NEAR(s.deviation, *s.first_order, 0.05 * *s.first_order);
        EXPECT_LT(s.greatest - s.nominal, s.worst * 1.001);
        EXPECT_GT(s.greatest - s.nominal, 0.97 * s.worst);
    }
    EXPECT_EQ(compared, 1);
}

/// A limit of the swing and a clearance: as wide as lets the share of pieces meet it.
TEST(Clearance, IsAllocatedBesideTolerances) {
    const TemporaryFolder folder;
    const PreparedStudy study = prepared(folder.write(
        "a.toml", crank_rocker + clearances +
                      "0.02\n[study.tolerance]\nrocker = { normal = 0.01 }\n[study.allocation]\nshare = 95\n"
                      "[study.allocation.weights]\n\"clearance C\" = 3\n"));
    const TolerancedDesign design = toleranced(study);
    ASSERT_TRUE(design.allocated);
    EXPECT_GE(design.allocated->share, 0.95);
    EXPECT_EQ(study.study->allocation->weights, (std::vector<double>{1, 1, 1, 1, 3}));
}

std::string fault_of(const std::string& text) {
    const ReadProblem read = parse_problem(text, "p.toml");
    return read.messages.empty() ? "" : read.messages.front().text;
}

TEST(Clearance, SaysWhatIsWrong) {
    const auto fault = [](const std::string& said) { return fault_of(crank_rocker + clearances + said + "\n"); };
    EXPECT_NE(fault("0").find("must be greater than 0, not 0"), std::string::npos);
    EXPECT_NE(fault("\"H7\"").find("must be a number or a table"), std::string::npos) << fault("\"H7\"");
    EXPECT_NE(fault("{ CC = 0.1 }").find("did you mean 'C'"), std::string::npos) << fault("{ CC = 0.1 }");
    EXPECT_NE(fault("{ C = nan }").find("must be greater than 0"), std::string::npos) << fault("{ C = nan }");
}

const std::string four_bar =
    "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = 35\ncoupler = 95\nrocker = 80\n"
    "[[require]]\nquantity = \"swing\"\nmax = 56\n";

/// A built-in kind is studied as the linkage that it is.
TEST(Clearance, OfABuiltInKindIsThatOfItsLinkage) {
    const TemporaryFolder folder;
    const std::string rest = clearances + "{ B = 0.02, C = 0.04 }\n[study.tolerance]\nlengths = \"IT7\"\n";
    const PreparedStudy own = prepared(folder.write("a.toml", four_bar + rest)),
                        linkage = prepared(folder.write("b.toml", crank_rocker + rest));
    const TolerancedDesign one = toleranced(own), other = toleranced(linkage);
    for (const std::uint64_t number : {1, 2, 3})
        EXPECT_NEAR(swing_of(sample(one, *own.study, number)), swing_of(sample(other, *linkage.study, number)), 1e-12);
    PreparedOrNot wrong = prepare_study(four_bar + clearances + "{ X = 0.1 }\n", "p.toml");
    ASSERT_FALSE(wrong.ok);
    EXPECT_NE(wrong.messages.front().text.find("'X'"), std::string::npos) << wrong.messages.front().text;
}

/// Of a pin of three links two are joints, each with a name of its own; a link whose line runs through the pin stays.
TEST(Clearance, IsOfEveryJointOfAPin) {
    std::string text = crank_rocker;
    text.replace(text.find("[drive]"), 0,
                 "rod     = { C = [0, 0], E = [70, 0] }\nblock   = { E = [0, 0] }\n[[slide]]\nlink = \"block\"\non = "
                 "\"frame\"\nalong = [\"A\", \"D\"]\n");
    const ReadProblem read = parse_problem(text, "p.toml");
    ASSERT_TRUE(read.ok()) << read.messages.front().text;
    const std::vector<std::string>& names = read.problem.mechanism->pin_joints->names;
    const std::vector<std::string> expected{"A", "D", "B", "C on rocker", "C on rod", "E"};
    EXPECT_TRUE(std::is_permutation(names.begin(), names.end(), expected.begin(), expected.end()));
}

}  // namespace
}  // namespace mechwright::testing
