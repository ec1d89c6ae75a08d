#pragma once
/// \file
/// Files as bytes.

#include <cstddef>
#include <string>
#include <string_view>

namespace mechwright::reading {

struct Bytes {
    std::string bytes;
    std::string failure;      ///< why there are none; empty if all is well
    bool unreadable = false;  ///< the file cannot be opened or read; else it is too large
};

/// A whole file. Special files (terminals, pipes, devices) are read only if asked for: reading them can take forever.
Bytes read_bytes(const std::string& file, std::size_t most_bytes, bool special_files);

/// SHA-256 as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace mechwright::reading
