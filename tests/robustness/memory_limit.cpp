// With too little memory the program ends with a message and the exit code for it: never by a signal, never with half a
// file, never with another result.

#include "tests/robustness/problems.h"

#if defined(__SANITIZE_ADDRESS__)
constexpr bool takes_all_address_space = true;  // the sanitizer does
#else
constexpr bool takes_all_address_space = false;
#endif

namespace mechwright::testing {
namespace {

constexpr std::size_t kilobyte = 1024;

/// The least memory, in steps of a page, in which the program and its libraries are loaded and say their version. Below
/// it the system's loader has the word.
std::size_t memory_of_the_program() {
    std::size_t low = 0, high = 4 * 1024 * 1024;  // kilobytes
    while (high - low > 4) {
        const std::size_t middle = (low + high) / 2;
        Start how;
        how.arguments = {"--version"};
        how.most_memory = middle * kilobyte;
        (run(how).exit_code == 0 ? high : low) = middle;
    }
    return high * kilobyte;
}

struct Attempt {
    Outcome outcome;
    std::string file;  ///< what stands in the result file afterwards
    std::size_t files;
};

/// A command that writes folder/out.FORMAT, with so much memory.
Attempt attempt(std::vector<std::string> arguments, const std::string& name, std::optional<std::size_t> memory) {
    const TemporaryFolder folder;
    folder.write("out/" + name, earlier_content);
    Start how;
    for (std::string& argument : arguments)
        if (const auto at = argument.find("OUT"); at != std::string::npos) argument.replace(at, 3, folder / "out");
    how.arguments = std::move(arguments);
    how.most_memory = memory;
    Attempt done{run(how), {}, 0};
    done.file = without_seconds(content_of(folder / ("out/" + name)));
    done.files = count_files(folder.path / "out");
    return done;
}

class LittleMemory : public ::testing::TestWithParam<std::pair<std::vector<std::string>, const char*>> {};

TEST_P(LittleMemory, EndsWithAMessage) {
    if (takes_all_address_space) GTEST_SKIP() << "the address sanitizer needs all address space";
    static const std::size_t least = memory_of_the_program();
    const auto& [arguments, name] = GetParam();
    const Attempt full = attempt(arguments, name, std::nullopt);
    ASSERT_EQ(full.outcome.exit_code, 0) << full.outcome.err;
    ASSERT_NE(full.file, earlier_content);
    bool enough = false;
    int lacked = 0;
    for (std::size_t more = 0; !enough && more < 2'000'000; more += std::max<std::size_t>(160, more / 4)) {
        const Attempt a = attempt(arguments, name, least + more * kilobyte);
        EXPECT_EQ(a.outcome.killed_by, 0) << more << " kB more: " << a.outcome.err;
        if (a.outcome.exit_code == 0) {
            EXPECT_EQ(a.file, full.file) << more;
            enough = true;
        } else {
            ++lacked;
            EXPECT_EQ(a.outcome.exit_code, 1) << more << " kB more: " << a.outcome.err;
            expect_has(a.outcome.err, "out of memory");
            EXPECT_TRUE(a.file == earlier_content || a.file == full.file) << more << " kB more: " << a.file;
        }
        EXPECT_EQ(a.files, full.files) << more;
    }
    EXPECT_TRUE(enough);
    EXPECT_GT(lacked, 0);
}

using Arguments = std::vector<std::string>;

INSTANTIATE_TEST_SUITE_P(
    Commands, LittleMemory,
    ::testing::Values(
        std::pair(Arguments{"solve", "--quiet", "--out", "OUT", problem_file("four-bar/crank-rocker")},
                  "crank-rocker.json"),
        std::pair(Arguments{"solve", "--quiet", "--jobs", "2", "--method", "slsqp", "--out", "OUT",
                            problem_file("quick-return/slider-crank-compact")},
                  "slider-crank-compact.json"),
        std::pair(Arguments{"solve", "--quiet", "--jobs", "1", "--method", "ipopt", "--out", "OUT",
                            problem_file("quick-return/slider-crank-compact")},
                  "slider-crank-compact.json"),
        std::pair(Arguments{"solve", "--quiet", "--jobs", "2", "--out", "OUT", problem_file("path/yu1-compact")},
                  "yu1-compact.json"),
        std::pair(Arguments{"solve", "--quiet", "--jobs", "2", "--out", "OUT",
                            problem_file("exact/three-poses-four-points")},
                  "three-poses-four-points.json"),
        std::pair(Arguments{"solve", "--quiet", "--out", "OUT", problem_file("cam/roller-uneven")},
                  "roller-uneven.json"),
        std::pair(Arguments{"draw", problem_file("quick-return/drag-link-given"), "--out", "OUT/a.svg"}, "a.svg"),
        std::pair(Arguments{"export", problem_file("quick-return/drag-link-given"), "--steps", "36000", "--out",
                            "OUT/a.csv"},
                  "a.csv")),
    [](const auto& test) { return "N" + std::to_string(test.index); });

}  // namespace
}  // namespace mechwright::testing
