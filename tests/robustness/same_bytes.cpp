// Results are the same to the last byte for any number of threads, any instructions, and whatever memory held before.

#include <fstream>
#include <iterator>

#include "analysis/numbers/instruction_set.h"
#include "tests/long_form.h"
#include "tests/replaced.h"
#include "tests/robustness/problems.h"

namespace mechwright::testing {
namespace {

/// Of each family one that is solved quickly.
const std::vector<std::string> of_each_family{"four-bar/crank-rocker",
                                              "four-bar/drag-link-velocity-ratio",
                                              "path/case-1",
                                              "path/case-2",
                                              "function/power",
                                              "exact/problem-3",
                                              "exact/five-timed-points",
                                              "exact/three-poses-four-points",
                                              "poses/tipper",
                                              "poses/five-poses",
                                              "quick-return/shaper-stroke-100",
                                              "quick-return/uniform-speed-whitworth",
                                              "quick-return/drag-link-compact",
                                              "cam/roller-uneven",
                                              "cam/oscillating-roller",
                                              "cam/choice-of-law",
                                              "line/lambda-120",
                                              "trade-off/case-4-margin"};

/// Those that screen candidates or follow paths in lanes.
const std::vector<std::string> in_lanes{"path/case-1",      "path/case-2",
                                        "path/yu1-compact", "poses/tipper",
                                        "exact/problem-3",  "exact/three-poses-four-points",
                                        "poses/five-poses", "trade-off/case-4-margin"};

/// The document of a problem file, solved with a number of threads and up to an instruction set (empty: any). Where no
/// set is asked for, new memory holds a byte that follows from the number of threads (glibc's MALLOC_PERTURB_): what
/// reads it before it is set is seen. Memory that was freed is kept: pages that the system gives anew a thousand times
/// would take most of the time.
std::string document_of_file(const std::vector<std::string>& file, const std::string& jobs,
                             const std::string& set = "") {
    Start how;
    how.arguments = with({"solve", "--json", "--quiet", "--time-limit", "1000", "--jobs", jobs}, file);
    how.environment = {{"MECHWRIGHT_INSTRUCTIONS", set}};
    if (set.empty())
        how.environment.insert(how.environment.end(), {{"MALLOC_PERTURB_", jobs == "1" ? "85" : "170"},
                                                       {"MALLOC_TRIM_THRESHOLD_", "268435456"},
                                                       {"MALLOC_MMAP_THRESHOLD_", "268435456"}});
    const Outcome outcome = run(how);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_has(outcome.out, "\"search\"");
    return without_seconds(outcome.out);
}

/// All but the longest searches, which are left to the long form.
std::vector<std::string> but_for(std::vector<std::string> names, const std::vector<std::string>& longest) {
    if (in_long_form()) return names;
    for (const std::string& name : longest)
        std::erase(names, name);
    return names;
}

/// The file of a problem that comes with mechwright; the longest search begins at fewer places, and the longest front
/// has fewer designs except in the long form.
std::vector<std::string> file_of(const std::string& name) {
    const std::vector<std::string> file = problem_files({name});
    const bool has_front = name == "trade-off/case-4-margin";
    if (name != "path/case-1" && (in_long_form() || !has_front)) return file;
    std::ifstream in(file.front());
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (has_front)
        text = replaced(text, "pareto = 8", "pareto = 2");
    else
        text += "\n[solver]\nstarts = 6\n";
    static const TemporaryFolder folder;
    return {folder.write("problem.toml", text)};
}

std::string document_of(const std::string& name, const std::string& jobs, const std::string& set = "") {
    return document_of_file(file_of(name), jobs, set);
}

std::string test_name(const ::testing::TestParamInfo<std::string>& test) {
    std::string name = test.param;
    for (char& c : name)
        if (c == '/' || c == '-') c = '_';
    return name;
}

class WithThreads : public ::testing::TestWithParam<std::string> {};

TEST_P(WithThreads, OfAnyNumber) {
    const std::string one = document_of(GetParam(), "1");
    EXPECT_EQ(document_of(GetParam(), "3"), one);
}

INSTANTIATE_TEST_SUITE_P(SameBytes, WithThreads, ::testing::ValuesIn(but_for(of_each_family, {"path/case-1"})),
                         test_name);

/// A heart, which no coupler curve is: searches of it begin where rows beside the path have no value.
TEST(SameBytes, OfACurveThatNoLinkageMakes) {
    const TemporaryFolder folder;
    const std::string heart = folder.write("heart.toml", R"(
schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 0, max = 200 }
crank = { min = 0, max = 200 }
coupler = { min = 0, max = 200 }
rocker = { min = 0, max = 200 }
point-along = { min = -200, max = 200 }
point-across = { min = -200, max = 200 }
origin-x = { min = -200, max = 200 }
origin-y = { min = -200, max = 200 }
tilt = { min = 0, max = 360 }
assembly = "either"
[path]
timing = "none"
closed = true
points = [[0.000000, 5.000000], [6.664558, 11.833269], [15.168638, 7.419902], [13.616864, -2.092941],
          [6.220752, -9.114306], [0.000000, -17.000000], [-6.220752, -9.114306], [-13.616864, -2.092941],
          [-15.168638, 7.419902], [-6.664558, 11.833269]]
[objective]
minimize = "path-rms"
[solver]
starts = 1
)");
    const std::string one = document_of_file({heart}, "1");
    EXPECT_EQ(document_of_file({heart}, "3"), one);
}

class WithInstructions : public ::testing::TestWithParam<std::string> {};

/// Except in the long form, long searches by the widest set alone.
TEST_P(WithInstructions, AreThoseOfTheBaseline) {
    const bool by_every_set = in_long_form() || GetParam() != "path/yu1-compact";
    const std::string baseline = document_of(GetParam(), "2", "baseline");
    for (const auto& [name, set] :
         {std::pair("avx2", InstructionSet::avx2), std::pair("avx512", InstructionSet::avx512)})
        if (is_available(set)) {
            if (set != widest_instruction_set() && !by_every_set) continue;
            EXPECT_EQ(document_of(GetParam(), "2", name), baseline) << name;
        }
}

INSTANTIATE_TEST_SUITE_P(SameBytes, WithInstructions,
                         ::testing::ValuesIn(but_for(in_lanes, {"path/case-1", "trade-off/case-4-margin"})), test_name);

/// All points of a study, run with a number of threads and up to an instruction set.
std::string points_of_study(const std::string& jobs, const std::string& set) {
    const TemporaryFolder folder;
    Start how;
    how.arguments = {"study", folder.write("a.toml", small_study()), "--out", folder / "out", "--quiet", "--jobs",
                     jobs};
    how.environment = {{"MECHWRIGHT_INSTRUCTIONS", set}};
    EXPECT_EQ(run(how).exit_code, 0);
    const Outcome exported = run({"study", "export", folder / "out", "--csv"});
    EXPECT_EQ(exported.exit_code, 0) << exported.err;
    expect_has(exported.out, "solved");
    return exported.out;
}

TEST(SameBytes, OfAStudyToo) {
    const std::string one = points_of_study("1", "");
    EXPECT_EQ(points_of_study("2", "baseline"), one);
    EXPECT_EQ(points_of_study("7", ""), one);
}

TEST(Instructions, ThatAreNoneAreRefused) {
    for (const char* wrong : {"sse", "AVX2", "avx2 ", "4"}) {
        Start how;
        how.arguments = {"quantities"};
        how.environment = {{"MECHWRIGHT_INSTRUCTIONS", wrong}};
        const Outcome outcome = run(how);
        EXPECT_EQ(outcome.exit_code, 2) << wrong;
        expect_has(outcome.err, "MECHWRIGHT_INSTRUCTIONS must be baseline, avx2 or avx512");
        expect_has(outcome.err, wrong);
        EXPECT_EQ(outcome.out, "");
    }
}

TEST(Instructions, AreNeverWiderThanAllowed) {
    const InstructionSet widest = widest_instruction_set();
    EXPECT_TRUE(is_available(widest));
    for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
        allow_instruction_sets_up_to(set);
        EXPECT_LE(widest_instruction_set(), set);
        EXPECT_TRUE(is_available(widest_instruction_set()));
    }
    EXPECT_EQ(widest_instruction_set(), widest);
}

}  // namespace
}  // namespace mechwright::testing
