// Result documents of every kind with one member changed after another, in the short form with every fifth:
// verification notices every change but those of words and of what a search says of itself.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"
#include "tests/long_form.h"
#include "tests/verify/documents.h"

namespace mechwright {

namespace {

using namespace test;

/// Members that claim nothing which follows from problem and design.
bool is_free(const std::string& place) {
    static const std::regex free(
        "/problem/file|/program/.*|/note"
        "|(/front/\\d+|/alternatives/\\d+)?/verification/checks/\\d+/(name|detail)"
        "|/search/.*");
    return std::regex_match(place, free);
}

Json changed(const Json& value) {
    if (value.is_boolean()) return !value.get<bool>();
    if (value.is_string()) return value.get<std::string>() + "x";
    if (value.is_number_integer()) return value.get<long long>() + 1;
    if (value.is_number()) {
        const double number = value.get<double>();
        return std::abs(number) < 1e-8 ? 0.01 : number * 1.01;  // what is smaller is rounding
    }
    return "something else";
}

struct Tampering {
    Json document;
    int members = 0, changes = 0;
    std::vector<std::string> believed{};

    void tamper(Json& at, const std::string& place) {
        if (at.is_object() && at.contains("defect")) return;  // stated to be no use
        if (at.is_structured()) {
            // Of long lists the first and the last entry stand for all.
            std::size_t i = 0;
            for (auto& [name, child] : at.items()) {
                const bool shown = !at.is_array() || i == 0 || i + 1 == at.size();
                ++i;
                if (shown) tamper(child, place + "/" + name);
            }
            return;
        }
        if (at.is_null() || is_free(place) || ++members % cases_to_try(5, 1) != 0) return;
        const Json kept = at;
        at = changed(kept);
        ++changes;
        if (failures(document).empty()) believed.push_back(place + ": " + kept.dump() + " -> " + at.dump());
        at = kept;
    }
};

void expect_noticed(const std::string& text, Status status = Status::solved) {
    const ReadProblem read = parse_problem((text.starts_with("schema") ? "" : "schema = 1\n") + text, "given.toml");
    for (const Message& m : read.messages)
        ASSERT_TRUE(m.warning) << to_string(m);
    RunOptions options;
    options.jobs = 2;
    const Result result = solve(read.problem, options);
    ASSERT_EQ(result.status, status) << told(result.verification);
    // As it stands in a file.
    Tampering tampering{Json::parse(document(read.problem, result).dump())};
    // One of the alternatives stands for all.
    Json& alternatives = tampering.document["alternatives"];
    while (alternatives.size() > 1)
        alternatives.erase(alternatives.size() - 1);
    ASSERT_TRUE(failures(tampering.document).empty()) << told(verify(tampering.document));
    tampering.tamper(tampering.document, "");
    EXPECT_GT(tampering.members, 20);
    for (const std::string& one : tampering.believed)
        ADD_FAILURE() << "believed: " << one;
}

constexpr const char* links =
    "mechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = { min = 5, max = 90 }\n"
    "coupler = { min = 20, max = 300 }\nrocker = { min = 20, max = 300 }\n";

TEST(TamperedDocument, OfARequirementAndAnObjectiveIsNoticed) {
    expect_noticed(
        std::string(links) +
        "[[require]]\nquantity = \"swing\"\nequal = 60\n[[require]]\nquantity = \"time-ratio\"\n"
        "min = 1.1\nmax = 1.4\n[objective]\nmaximize = \"transmission-angle-worst\"\n[solver]\nstarts = 6\n");
}

TEST(TamperedDocument, OfARangeOfCrankAnglesIsNoticed) {
    expect_noticed(std::string(links) +
                   "[motion]\ncrank_range = [20, 80]\n[[require]]\nquantity = \"velocity-ratio-max\"\nmax = 0.7\n"
                   "[objective]\nmaximize = \"transmission-angle-worst\"\n[solver]\nstarts = 4\n");
}

TEST(TamperedDocument, OfAPathAndItsAlternativesIsNoticed) {
    expect_noticed(
        "mechanism = \"four-bar\"\n[dimensions]\nground = { min = 5, max = 60 }\ncrank = { min = 5, max = 60 }\n"
        "coupler = { min = 5, max = 60 }\nrocker = { min = 5, max = 60 }\npoint-along = { min = -60, max = 60 }\n"
        "point-across = { min = -60, max = 60 }\norigin-x = { min = -60, max = 60 }\norigin-y = { min = -60, max = 60 "
        "}\n"
        "tilt = { min = 0, max = 360 }\n[path]\npoints = [[20, 20], [20, 25], [20, 30], [20, 35], [20, 40], [20, 45]]\n"
        "timing = \"free\"\n[objective]\nminimize = \"path-rms\"\n[solver]\nstarts = 12\n");
}

TEST(TamperedDocument, OfARangeOfUseIsNoticed) {
    expect_noticed(
        "mechanism = \"four-bar\"\n[dimensions]\nground = { min = 60, max = 300 }\ncrank = { min = 60, max = 400 }\n"
        "coupler = { min = 60, max = 300 }\nrocker = { min = 60, max = 400 }\npoint-along = { min = -900, max = 900 }\n"
        "point-across = { min = -900, max = 900 }\norigin-x = { min = -100, max = 250 }\n"
        "origin-y = { min = -200, max = 0 }\ntilt = { min = 0, max = 360 }\nbody-angle = { min = 0, max = 360 }\n"
        "[poses]\nposes = [[0, 0, 0], [-30, 150, 25], [-120, 350, 60]]\nlength = 300\n[motion]\n"
        "from = \"first-target\"\nto = \"last-target\"\nbefore = 2\nafter = 1\n"
        "[[require]]\nquantity = \"pose-max\"\nmax = 0.5\n[[require]]\n"
        "quantity = \"transmission-angle-worst\"\nmin = 20\n[objective]\nminimize = \"total-length\"\n"
        "[solver]\nstarts = 8\n");
}

TEST(TamperedDocument, OfTiesIsNoticed) {
    expect_noticed(
        "mechanism = \"four-bar\"\n[dimensions]\nground = { min = 80, max = 120 }\ncrank = { min = 5, max = 60 }\n"
        "coupler = { of = \"crank\", times = -1, plus = 130 }\nrocker = \"0.5 ground + crank - 3\"\n"
        "[[require]]\nquantity = \"swing\"\nequal = 40\n[objective]\nmaximize = \"transmission-angle-worst\"\n"
        "[solver]\nstarts = 6\n");
}

TEST(TamperedDocument, OfWishesAndAllowedValuesIsNoticed) {
    expect_noticed(
        "mechanism = \"four-bar\"\n[dimensions]\nground = { choices = [80, 100, 120] }\n"
        "crank = { min = 20, max = 40, step = 5 }\ncoupler = { min = 60, max = 200 }\nrocker = { min = 40, max = 150 "
        "}\n"
        "[[require]]\nquantity = \"swing\"\nmin = 40\n[[objective]]\nmaximize = \"transmission-angle-worst\"\n"
        "within = 3\n[[objective]]\nminimize = \"total-length\"\nrank = 2\n[solver]\nstarts = 6\n");
}

class TamperedShippedDocument : public ::testing::TestWithParam<const char*> {};

TEST_P(TamperedShippedDocument, IsNoticed) {
    std::ifstream in(std::string(MECHWRIGHT_SOURCE_DIR "/problems/") + GetParam() + ".toml");
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    expect_noticed(text.substr(text.find("schema")));
}

INSTANTIATE_TEST_SUITE_P(Kinds, TamperedShippedDocument,
                         ::testing::Values("function/power", "cam/oscillating-roller", "quick-return/whitworth",
                                           "exact/velocities-of-an-instant"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::erase_if(name, [](char c) { return c == '/' || c == '-'; });
                             return name;
                         });

TEST(TamperedDocument, OfAFrontIsNoticed) {
    expect_noticed(std::string(links) +
                   "[[require]]\nquantity = \"swing\"\nequal = 60\n[[objective]]\nmaximize = \"time-ratio\"\n"
                   "[[objective]]\nmaximize = \"transmission-angle-worst\"\n[solver]\npareto = 3\nstarts = 6\n");
}

}  // namespace

}  // namespace mechwright
