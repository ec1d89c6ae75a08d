#include <clocale>

#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

std::vector<std::string> shipped_problems() {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(MECHWRIGHT_SOURCE_DIR "/problems"))
        if (entry.path().extension() == ".toml") files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

TEST(Files, EveryShippedProblemIsValid) {
    const std::vector<std::string> files = shipped_problems();
    EXPECT_GE(files.size(), 1u);
    for (const std::string& file : files) {
        const ReadProblem problem = read_problem(file);
        EXPECT_TRUE(problem.ok()) << all_messages(problem);
        EXPECT_FALSE(problem.problem.title.empty()) << file;
    }
}

TEST(Files, AFileIsReadLikeItsText) {
    const TemporaryFolder folder;
    const ReadProblem problem = read_problem(folder.write("p.toml", valid));
    ASSERT_TRUE(accepted(problem));
    EXPECT_EQ(problem.problem.file, folder.file("p.toml"));
    EXPECT_EQ(problem.problem.sha256, parse_problem(valid, "x").problem.sha256);
    EXPECT_EQ(problem.problem.dimensions[0].min, 100);
}

TEST(Files, AMissingFileIsUnreadable) {
    const ReadProblem problem = read_problem("/no/such/file.toml");
    EXPECT_TRUE(only_says(problem, "/no/such/file.toml", {"cannot be read", "No such file"}));
    EXPECT_TRUE(problem.unreadable);
}

TEST(Files, ADirectoryIsUnreadable) {
    const TemporaryFolder folder;
    const ReadProblem problem = read_problem(folder.path);
    EXPECT_TRUE(only_says(problem, folder.path, {"cannot be read", "directory"}));
    EXPECT_TRUE(problem.unreadable);
}

TEST(Files, AnEmptyNameIsUnreadable) {
    EXPECT_TRUE(read_problem("").unreadable);
    EXPECT_TRUE(read_problem(std::string(5000, 'x')).unreadable);
    EXPECT_TRUE(read_problem(std::string("a\0b", 3)).unreadable);
}

TEST(Files, AFileThatFailsWhileItIsReadIsUnreadable) {
    const ReadProblem problem = read_problem("/proc/self/mem");
    EXPECT_TRUE(only_says(problem, "/proc/self/mem", {"cannot be read"}));
    EXPECT_TRUE(problem.unreadable);
}

TEST(Files, AFileWithoutPermissionIsUnreadable) {
    const TemporaryFolder folder;
    const std::string file = folder.write("p.toml", valid);
    std::filesystem::permissions(file, std::filesystem::perms::none);
    // The system administrator reads it all the same.
    const bool open = std::ifstream(file).is_open();
    EXPECT_EQ(read_problem(file).unreadable, !open);
    EXPECT_EQ(read_problem(file).ok(), open);
}

TEST(Files, AMissingPointsFileIsUnreadable) {
    const ReadProblem problem = parse_problem(valid + "[path]\npoints_file = \"none.csv\"\n", "/no/where/p.toml");
    EXPECT_TRUE(only_says(problem, "/no/where/none.csv", {"cannot be read", "No such file"}));
    EXPECT_TRUE(problem.unreadable);
}

TEST(Files, APointsFileThatIsNoRegularFileIsUnreadable) {
    const TemporaryFolder folder;
    for (const std::string name : {".", "/dev/zero", "/dev/tty"}) {
        const ReadProblem problem =
            parse_problem(valid + "[path]\npoints_file = \"" + name + "\"\n", folder.file("p.toml"));
        EXPECT_EQ(problem.messages.size(), 1u);
        EXPECT_TRUE(problem.unreadable) << name;
    }
}

TEST(Files, ThePointsFileHasAName) {
    EXPECT_TRUE(only_says(read(valid + "[path]\npoints_file = \"\"\n"), "p.toml:9:15", {"'points_file'", "empty"}));
    EXPECT_TRUE(only_says(read(valid + "[path]\npoints_file = 3\n"), "p.toml:9:15", {"'points_file'", "string"}));
    EXPECT_TRUE(read(valid + "[path]\npoints_file = \"a\\u0000b\"\n").unreadable);
}

TEST(Files, APointsFileIsSoughtBesideTheProblem) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("data"));
    folder.write("data/points.csv", "1,2\n3,4\n");
    const std::string relative = folder.write("p.toml", valid + "[path]\npoints_file = \"data/points.csv\"\n");
    EXPECT_TRUE(accepted(read_problem(relative)));
    const std::string absolute =
        folder.write("q.toml", valid + "[path]\npoints_file = \"" + folder.file("data/points.csv") + "\"\n");
    EXPECT_TRUE(accepted(read_problem(absolute)));
}

TEST(Files, TheLocaleDoesNotMatter) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    const char* comma = std::setlocale(LC_ALL, "de_DE.UTF-8");
    const ReadProblem problem = read(with_line(4, "ground = 1234.5"));
    const ReadProblem wrong = read(with_line(4, "ground = -1234.5"));
    std::setlocale(LC_ALL, before.c_str());
    RecordProperty("decimal_comma", comma != nullptr ? "yes" : "no such locale here");
    EXPECT_EQ(problem.problem.dimensions[0].min, 1234.5);
    EXPECT_TRUE(only_says(wrong, "p.toml:4:10", {"not -1234.5"}));
}

}  // namespace mechwright::test
