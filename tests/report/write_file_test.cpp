#include "synthesis/report/files/write_file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/report/temporary_folder.h"

namespace mechwright {
namespace {

using testing::content_of;
using testing::count_files;
using testing::TemporaryFolder;

TEST(WriteAtomically, WritesAndReplaces) {
    const TemporaryFolder folder;
    EXPECT_EQ(write_atomically(folder / "a.json", "first"), std::nullopt);
    EXPECT_EQ(write_atomically(folder / "a.json", "second\n"), std::nullopt);
    EXPECT_EQ(content_of(folder / "a.json"), "second\n");
    EXPECT_EQ(count_files(folder.path), 1u);
}

TEST(WriteAtomically, WritesMoreThanAPipeHolds) {
    const TemporaryFolder folder;
    const std::string text(3'000'000, 'x');
    EXPECT_EQ(write_atomically(folder / "a.csv", text), std::nullopt);
    EXPECT_EQ(content_of(folder / "a.csv"), text);
}

TEST(WriteAtomically, GivesTheRightsOfAnyNewFile) {
    const TemporaryFolder folder;
    const mode_t before = ::umask(027);
    EXPECT_EQ(write_atomically(folder / "a.json", "text"), std::nullopt);
    ::umask(before);
    struct stat status {};
    ASSERT_EQ(::stat((folder / "a.json").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(WriteAtomically, AFolderInTheWayIsNamedAndStays) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path / "a.json" / "inside");
    const auto fault = write_atomically(folder / "a.json", "text");
    ASSERT_TRUE(fault);
    EXPECT_NE(fault->find("a.json"), std::string::npos) << *fault;
    EXPECT_NE(fault->find("directory"), std::string::npos) << *fault;
    EXPECT_EQ(count_files(folder.path), 1u);
    EXPECT_TRUE(std::filesystem::is_directory(folder.path / "a.json" / "inside"));
}

TEST(WriteAtomically, BelowAFileOrNowhereIsAnError) {
    const TemporaryFolder folder;
    folder.write("file", "text");
    const auto below_a_file = write_atomically(folder / "file" + "/a.json", "text");
    ASSERT_TRUE(below_a_file);
    EXPECT_NE(below_a_file->find("Not a directory"), std::string::npos) << *below_a_file;
    const auto nowhere = write_atomically(folder / "missing" + "/a.json", "text");
    ASSERT_TRUE(nowhere);
    EXPECT_NE(nowhere->find("No such file"), std::string::npos) << *nowhere;
    EXPECT_EQ(count_files(folder.path), 1u);
}

/// What a process finds that may write 4096 bytes into a file and no more, as on a full disk.
bool fails_cleanly_without_room(const TemporaryFolder& folder) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const auto fault = write_atomically(folder / "a.json", std::string(10000, 'x'));
    return fault && fault->find("File too large") != std::string::npos;
}

TEST(WriteAtomically, WithoutRoomTheOldFileStaysAndNothingElse) {
    const TemporaryFolder folder;
    folder.write("a.json", "old");
    const pid_t child = ::fork();
    if (child == 0) ::_exit(fails_cleanly_without_room(folder) ? 0 : 1);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(content_of(folder / "a.json"), "old");
    EXPECT_EQ(count_files(folder.path), 1u);
}

TEST(PrepareFolder, MakesFoldersAndLeavesThemEmpty) {
    const TemporaryFolder folder;
    EXPECT_EQ(prepare_folder(folder.path / "a" / "b"), std::nullopt);
    EXPECT_EQ(prepare_folder(folder.path / "a" / "b"), std::nullopt);
    EXPECT_EQ(count_files(folder.path / "a" / "b"), 0u);
}

TEST(PrepareFolder, SaysWhatStandsInTheWay) {
    const TemporaryFolder folder;
    folder.write("file", "text");
    for (const std::filesystem::path& path :
         {folder.path / "file", folder.path / "file" / "below", std::filesystem::path("/dev/full"),
          std::filesystem::path("/proc/mechwright")}) {
        const auto fault = prepare_folder(path);
        ASSERT_TRUE(fault) << path;
        EXPECT_NE(fault->find(path.string()), std::string::npos) << *fault;
    }
}

}  // namespace
}  // namespace mechwright
