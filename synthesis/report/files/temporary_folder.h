#pragma once
/// \file
/// A folder for files that are needed for a while.

#include <filesystem>

namespace mechwright {

/// A new folder where the system keeps temporary files, removed with all that is in it at the end.
struct TemporaryFolder {
    std::filesystem::path path;

    /// Throws std::filesystem::filesystem_error where none can be made.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

}  // namespace mechwright
