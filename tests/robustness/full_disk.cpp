// A disk that is full: the program says so with exit code 6, what stood on the disk stays whole, and with room again
// the same command line goes on.

#include "tests/robustness/problems.h"
#include "tests/robustness/small_disk.h"

namespace mechwright::testing {
namespace {

constexpr std::size_t disk_kilobytes = 2048;

/// A command that writes the file DISK/name.
struct Writer {
    std::vector<std::string> arguments;
    std::string name;
};

class FullDisk : public ::testing::TestWithParam<Writer> {};

Start start_of(const Writer& writer, const std::string& folder) {
    Start how;
    for (std::string argument : writer.arguments) {
        if (const auto at = argument.find("DISK"); at != std::string::npos) argument.replace(at, 4, folder);
        how.arguments.push_back(argument);
    }
    return how;
}

/// The names in a folder and below.
std::vector<std::string> names_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        names.push_back(entry.path().lexically_relative(folder).string());
    std::sort(names.begin(), names.end());
    return names;
}

/// The result that report and draw start from.
void put_result(const std::filesystem::path& folder) {
    const Outcome solved = run({"solve", "--quiet", "--out", folder.string(), problem_file("cam/roller-uneven")});
    ASSERT_EQ(solved.exit_code, 0) << solved.err;
}

TEST_P(FullDisk, IsToldAndLeavesWhatStoodThere) {
    SmallDisk disk(disk_kilobytes);
    if (!disk.mounted()) GTEST_SKIP() << "a disk cannot be mounted here; tests with the largest size of a file remain";
    put_result(disk.path());
    std::ofstream(disk.path() / GetParam().name) << earlier_content;
    const Start how = start_of(GetParam(), disk.path().string());
    disk.fill_but(0);
    const std::vector<std::string> names = names_in(disk.path());
    const Outcome full = run(how);
    EXPECT_EQ(full.killed_by, 0);
    EXPECT_EQ(full.exit_code, 6) << full.err;
    expect_has(full.err, "No space left on device");
    expect_has(full.err, disk.path().string());
    EXPECT_EQ(content_of(disk.path() / GetParam().name), earlier_content);
    EXPECT_EQ(names_in(disk.path()), names);
    disk.make_room();
    const Outcome again = run(how);
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_NE(content_of(disk.path() / GetParam().name), earlier_content);
}

TEST_P(FullDisk, IsTheSameWhereNoFileMayGrow) {
    const TemporaryFolder folder;
    put_result(folder.path);
    folder.write(GetParam().name, earlier_content);
    Start how = start_of(GetParam(), folder.path.string());
    how.largest_file = 1000;
    const std::vector<std::string> names = names_in(folder.path);
    const Outcome full = run(how);
    EXPECT_EQ(full.killed_by, 0);
    EXPECT_EQ(full.exit_code, 6) << full.err;
    expect_has(full.err, "File too large");
    EXPECT_EQ(content_of(folder.path / GetParam().name), earlier_content);
    EXPECT_EQ(names_in(folder.path), names);
    how.largest_file.reset();
    EXPECT_EQ(run(how).exit_code, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Commands, FullDisk,
    ::testing::Values(
        Writer{{"solve", "--quiet", "--out", "DISK", problem_file("four-bar/crank-rocker")}, "crank-rocker.json"},
        Writer{{"report", "DISK"}, "report.html"},
        Writer{{"draw", problem_file("quick-return/drag-link-given"), "--out", "DISK/a.svg"}, "a.svg"},
        Writer{{"export", problem_file("quick-return/drag-link-given"), "--out", "DISK/a.dxf"}, "a.dxf"},
        Writer{{"export", problem_file("quick-return/drag-link-given"), "--out", "DISK/a.csv"}, "a.csv"},
        Writer{{"export", problem_file("quick-return/drag-link-given"), "--out", "DISK/a.slvs"}, "a.slvs"}),
    [](const auto& test) { return "N" + std::to_string(test.index); });

std::string points_in(const std::string& folder) {
    const Outcome exported = run({"study", "export", folder, "--csv"});
    EXPECT_EQ(exported.exit_code, 0) << exported.err;
    return exported.out;
}

TEST(FullDiskUnderAStudy, KeepsWhatWasDoneAndGoesOnWithRoom) {
    SmallDisk disk(disk_kilobytes);
    if (!disk.mounted()) GTEST_SKIP() << "a disk cannot be mounted here";
    constexpr int points = 300;
    const TemporaryFolder elsewhere;
    const std::string problem = elsewhere.write("a.toml", closed_form_study(points));
    ASSERT_EQ(run({"study", problem, "--out", elsewhere / "out", "--quiet"}).exit_code, 0);
    const std::string data = elsewhere / "out/study.sqlite";
    // Room for a part of the data and of the journal beside them.
    ASSERT_TRUE(disk.resize(std::filesystem::file_size(data) / 1024 * 2 / 3));
    const Outcome full = run({"study", problem, "--out", disk / "out", "--quiet"});
    EXPECT_EQ(full.killed_by, 0);
    EXPECT_EQ(full.exit_code, 6) << full.err;
    expect_has(full.err, "study.sqlite");
    ASSERT_TRUE(disk.resize(16 * disk_kilobytes));
    const Outcome status = run({"study", "status", disk / "out"});
    EXPECT_EQ(status.exit_code, 0) << status.err;
    expect_has(status.out, " of 300 points: ");
    expect_has_not(status.out, "\n0 of ");
    EXPECT_EQ(run({"study", problem, "--out", disk / "out", "--quiet"}).exit_code, 0);
    EXPECT_EQ(points_in(disk / "out"), points_in(elsewhere / "out"));
}

}  // namespace
}  // namespace mechwright::testing
