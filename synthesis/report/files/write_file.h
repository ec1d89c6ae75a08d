#pragma once
/// \file
/// Files that are either whole or not there.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mechwright {

/// Writes the text beside its place, in the same folder, forces it to the disk and then renames it, so that nobody ever
/// sees half a file; what stood there before stays until then. Returns what went wrong (naming the file and saying
/// why), or nothing; nothing is left behind.
std::optional<std::string> write_atomically(const std::filesystem::path& path, std::string_view text);

/// Makes the folder, with the folders above it, and finds out whether files can be written there. Returns what went
/// wrong, or nothing.
std::optional<std::string> prepare_folder(const std::filesystem::path& folder);

}  // namespace mechwright
