#pragma once
/// \file
/// A disk of its own, small enough to be filled. Only root can mount one, and not in every container.

#include <sys/mount.h>
#include <sys/statvfs.h>

#include <cstdio>
#include <string>

#include "tests/report/temporary_folder.h"

namespace mechwright::testing {

class SmallDisk {
public:
    explicit SmallDisk(std::size_t kilobytes) { mounted_ = mount_with(0, kilobytes); }
    ~SmallDisk() {
        if (mounted_) ::umount2(folder_.path.c_str(), MNT_DETACH);
    }

    bool mounted() const { return mounted_; }
    const std::filesystem::path& path() const { return folder_.path; }
    std::string operator/(const std::string& name) const { return folder_ / name; }

    /// Gives it another size; what is on it stays.
    bool resize(std::size_t kilobytes) { return mount_with(MS_REMOUNT, kilobytes); }

    /// Takes all room but so many pages of 4096 bytes.
    void fill_but(std::size_t pages) {
        struct statvfs room {};
        ASSERT_EQ(::statvfs(folder_.path.c_str(), &room), 0);
        const std::size_t free = room.f_bfree * room.f_bsize;
        ASSERT_GT(free, pages * 4096);
        std::ofstream(filler(), std::ios::binary) << std::string(free - pages * 4096, 'x');
    }

    void make_room() { std::filesystem::remove(filler()); }

private:
    std::filesystem::path filler() const { return folder_.path / "filler"; }

    bool mount_with(unsigned long flags, std::size_t kilobytes) {
        const std::string size = "size=" + std::to_string(kilobytes) + "k";
        return ::mount("tmpfs", folder_.path.c_str(), "tmpfs", flags, size.c_str()) == 0;
    }

    TemporaryFolder folder_;
    bool mounted_ = false;
};

}  // namespace mechwright::testing
