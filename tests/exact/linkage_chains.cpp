// Linkages whose guided link hangs on the crank and on a rocker, a slide or a block: the same solutions as of the kinds
// that they are, and the linkage that made the places.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <tuple>
#include <utility>
#include <vector>

#include "synthesis/exact/exact.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/quantity_value.h"
#include "tests/degree.h"
#include "tests/exact/all_solutions.h"
#include "tests/long_form.h"

namespace mechwright {
namespace {

ReadProblem read_exact(const std::string& text, const std::string& objective = "transmission-angle-worst") {
    return parse_problem("schema = 1\n" + text + "\n[objective]\nmaximize = \"" + objective +
                             "\"\n[solver]\nmethod = \"exact\"\nstarts = 4\n",
                         "p.toml");
}

std::string free_numbers(std::initializer_list<const char*> lengths, std::initializer_list<const char*> coordinates) {
    std::string text = "[dimensions]\n";
    for (const char* name : lengths)
        text += fmt::format("{} = {{ min = 0, max = 1000 }}\n", name);
    for (const char* name : coordinates)
        text += fmt::format("{} = {{ min = -1000, max = 1000 }}\n", name);
    return text;
}

const std::string tilted = "tilt = { min = -180, max = 180 }\n";
const std::string five_poses =
    "poses = [[41.3244716175607, 91.6938596021461, 47.4521000244343], [10.8568842824795, 102.034253021982, "
    "23.7812336418016], [-16.0052091517422, 74.3252986011383, 32.3025452091702], [-20.143386508954, 33.0979184806705, "
    "74.0727228822669], [40, 60, 80]]\n";

/// A point of the rod of a slider-crank with crank 40, rod 120, offset 15.
std::string rod_points(std::size_t count) {
    std::string list;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = (10 + 45 * static_cast<double>(i)) * degree, s = (15 - 40 * std::sin(t)) / 120,
                     c = std::sqrt(1 - s * s);
        list +=
            fmt::format("[{:.17g}, {:.17g}], ", 40 * std::cos(t) + 60 * c - 50 * s, 40 * std::sin(t) + 60 * s + 50 * c);
    }
    return "points = [" + list + "]\ntiming = \"free\"\n";
}

/// Sizes of cranks of all designs without a defect, sorted.
std::vector<double> cranks_of(const ReadProblem& read, const Result& result) {
    const auto crank = static_cast<std::size_t>(find_dimension(*read.problem.mechanism, "crank"));
    std::vector<double> cranks;
    if (result.best) cranks.push_back(result.best->design.dimensions[crank]);
    for (const auto& other : result.alternatives)
        cranks.push_back(other.solution.design.dimensions[crank]);
    std::sort(cranks.begin(), cranks.end());
    return cranks;
}

void expect_same_designs(const ReadProblem& linkage, const ReadProblem& kind) {
    ASSERT_TRUE(linkage.ok()) << linkage.messages.front().text;
    ASSERT_TRUE(kind.ok()) << kind.messages.front().text;
    const Result one = all_solutions(linkage.problem), other = all_solutions(kind.problem);
    EXPECT_EQ(one.status, other.status);
    ASSERT_TRUE(one.search.solutions && other.search.solutions);
    EXPECT_EQ(one.search.solutions->real, other.search.solutions->real);
    EXPECT_TRUE(one.search.complete());
    const std::vector<double> a = cranks_of(linkage, one), b = cranks_of(kind, other);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_NEAR(a[i], b[i], 1e-7 * b[i]);
    ASSERT_EQ(one.best.has_value(), other.best.has_value());
    if (one.best) {
        EXPECT_NEAR(one.best->objective, other.best->objective, 1e-9);
    }
}

const std::string four_bar_links =
    "[links]\nframe = { A = [0, 0], D = [\"ground\", 0] }\ncrank = { A = [0, 0], B = [\"crank\", 0] }\n"
    "coupler = { B = [0, 0], C = [\"coupler\", 0], P = [\"point-along\", \"point-across\"] }\n"
    "rocker = { D = [0, 0], C = [\"rocker\", 0] }\n[drive]\nlink = \"crank\"\n[assembly]\nC = \"either\"\n";

TEST(GuidedChains, OfAFourBarHaveItsFivePoses) {
    const std::string numbers = free_numbers({"ground", "crank", "coupler", "rocker"}, {"point-along", "point-across"});
    const std::string placed =
        "origin-x = { min = -1000, max = 1000 }\norigin-y = { min = -1000, max = 1000 }\n" + tilted;
    const std::string body = "body-angle = { min = -180, max = 180 }\n";
    expect_same_designs(read_exact("mechanism = \"linkage\"\n" + numbers + "[placement]\n" + placed + four_bar_links +
                                   "[poses]\npoint = \"P\"\nlink = \"coupler\"\n" + five_poses + body),
                        read_exact("mechanism = \"four-bar\"\n" + numbers + placed + body +
                                   "assembly = \"either\"\n[poses]\n" + five_poses));
}

const std::string slider_numbers = free_numbers({"crank", "rod"}, {"offset", "point-along", "point-across"});

TEST(GuidedChains, OfASliderCrankHaveItsEightPoints) {
    const std::string placed =
        "origin-x = { min = -1000, max = 1000 }\norigin-y = { min = -1000, max = 1000 }\n" + tilted;
    const ReadProblem kind =
        read_exact("mechanism = \"slider-crank\"\n" + slider_numbers + placed + "[path]\n" + rod_points(8));
    const std::string links =
        "[links]\nframe = { O = [0, 0] }\ncrank = { O = [0, 0], A = [\"crank\", 0] }\n"
        "rod = { A = [0, 0], B = [\"rod\", 0], P = [\"point-along\", \"point-across\"] }\n";
    const std::string path = "[drive]\nlink = \"crank\"\n[path]\npoint = \"P\"\n" + rod_points(8);
    expect_same_designs(
        read_exact("mechanism = \"linkage\"\n" + slider_numbers + "[placement]\n" + placed + links +
                   "ram = { B = [0, 0] }\n[[slide]]\nname = \"ram\"\nlink = \"ram\"\non = \"frame\"\npoint = \"O\"\n"
                   "direction = 0\noffset = \"offset\"\n" +
                   path),
        kind);
    // The line of a slot through a point above the crank's pivot.
    expect_same_designs(
        read_exact("mechanism = \"linkage\"\n" + slider_numbers + "[placement]\n" + placed + links +
                   "[[slot]]\npin = \"B\"\nin = \"frame\"\npoint = [0, \"offset\"]\ndirection = 0\n" + path),
        kind);
}

const std::string inverted =
    "mechanism = \"linkage\"\n" +
    free_numbers({"crank"}, {"a-x", "a-y", "d-x", "d-y", "offset", "point-along", "point-across"}) +
    "[links]\nframe = { A = [\"a-x\", \"a-y\"], D = [\"d-x\", \"d-y\"] }\ncrank = { A = [0, 0], B = [\"crank\", 0] }\n"
    "rod = { B = [0, 0], P = [\"point-along\", \"point-across\"] }\nblock = { D = [0, 0] }\n"
    "[[slide]]\nname = \"block\"\nlink = \"block\"\non = \"rod\"\npoint = \"B\"\ndirection = 0\noffset = \"offset\"\n"
    "[drive]\nlink = \"crank\"\n[assembly]\nblock = \"either\"\n";

/// A point of a rod that slides through a block on (110, 20), 8 to the left of its line; some of the places as poses.
std::string block_places(std::size_t poses, std::size_t points) {
    std::string list;
    for (std::size_t i = 0; i < poses + points; ++i) {
        const double t = (15 + 40 * static_cast<double>(i)) * degree;
        const std::complex<double> pin = std::polar(40.0, t), to = std::complex<double>(110, 20) - pin;
        const double along = std::sqrt(std::norm(to) - 64);
        const std::complex<double> rod = to / std::complex<double>(along, 8),
                                   at = pin + std::complex<double>(70, 25) * rod;
        list += fmt::format("[{:.17g}, {:.17g}", at.real(), at.imag());
        list += i < poses ? fmt::format(", {:.17g}], ", std::arg(rod) / degree) : "], ";
    }
    if (poses == 0) return "[path]\npoint = \"P\"\npoints = [" + list + "]\ntiming = \"free\"\n";
    return "[poses]\npoint = \"P\"\nlink = \"rod\"\nposes = [" + list + "]\nbody-angle = { min = -180, max = 180 }\n";
}

TEST(GuidedChains, OfAnInvertedSliderCrankMadeThePlaces) {
    for (const auto& [poses, points, orbits] :
         {std::tuple<std::size_t, std::size_t, std::size_t>{0, 8, 2220}, {2, 5, 448}, {3, 3, 56}, {4, 1, 6}}) {
        if (poses <= 2 && !in_long_form()) continue;
        const ReadProblem read = read_exact(inverted + block_places(poses, points));
        ASSERT_TRUE(read.ok()) << read.messages.front().text;
        const Result result = all_solutions(read.problem);
        ASSERT_EQ(result.status, Status::solved) << poses;
        EXPECT_TRUE(result.verified());
        EXPECT_TRUE(result.search.complete());
        ASSERT_TRUE(result.search.solutions);
        EXPECT_EQ(result.search.solutions->tracked, orbits);
        EXPECT_EQ(result.search.solutions->certified, result.search.solutions->real);
        bool again = false;
        for (const double crank : cranks_of(read, result))
            again = again || std::abs(crank - 40) < 1e-5;
        EXPECT_TRUE(again) << poses;
    }
}

/// Fewer places: a member of the family, with a block as with a ram.
TEST(GuidedChains, HaveFamiliesThroughFewerPlaces) {
    if (!in_long_form()) GTEST_SKIP() << "of the long form";
    for (const auto& [poses, points] : {std::pair<std::size_t, std::size_t>{4, 0}, {3, 0}, {0, 4}}) {
        const ReadProblem read = read_exact(inverted + block_places(poses, points));
        ASSERT_TRUE(read.ok()) << read.messages.front().text;
        const Result result = all_solutions(read.problem);
        ASSERT_EQ(result.status, Status::solved) << poses;
        EXPECT_TRUE(result.verified());
        EXPECT_FALSE(result.search.complete());
        EXPECT_LT(path_values(read.problem, result.best->design)->greatest, 1e-7);
    }
}

TEST(GuidedChains, AreToldWhatTheyLack) {
    const auto why = [](std::string text, const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
        const ReadProblem read = read_exact(text);
        EXPECT_TRUE(read.ok()) << read.messages.front().text;
        return why_not_exact(read.problem);
    };
    const auto has = [](const std::string& text, std::string_view part) {
        return text.find(part) != std::string::npos;
    };
    const std::string eight = inverted + block_places(0, 8), seven = inverted + block_places(0, 7);
    EXPECT_EQ(why(eight, "", ""), "");
    EXPECT_TRUE(has(why(seven, "a-x = { min = -1000, max = 1000 }", "a-x = 0"), "leaves 7 of the 8 numbers"));
    EXPECT_TRUE(has(why(eight, "rod = { B = [0, 0]", "rod = { B = [\"a-x\", \"a-y\"]"), "frames show in their points"));
    EXPECT_TRUE(has(why(eight, "timing = \"free\"", "timing = \"none\""), "timing = \"free\""));
    // A number that places something else.
    EXPECT_TRUE(has(why(eight, "block = { D = [0, 0] }",
                        "block = { D = [0, 0], E = [\"extra\", 0] }\n[dimensions.extra]\nmin = 0\nmax = 10"),
                    "'extra' does not say where"));
}

}  // namespace
}  // namespace mechwright
