#pragma once
/// \file
/// A folder for the files of one test, gone when the test is over.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "synthesis/report/files/temporary_folder.h"

namespace mechwright::testing {

struct TemporaryFolder {
    mechwright::TemporaryFolder folder{};
    std::filesystem::path path = folder.path;

    /// The full name of a file in the folder.
    std::string operator/(const std::string& name) const { return (path / name).string(); }

    /// Writes a file, with the folders above it, and returns its full name.
    std::string write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((path / name).parent_path());
        std::ofstream(path / name, std::ios::binary) << text;
        return *this / name;
    }
};

inline std::string content_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

inline std::size_t count_files(const std::filesystem::path& folder) {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder))
        ++count;
    return count;
}

}  // namespace mechwright::testing
