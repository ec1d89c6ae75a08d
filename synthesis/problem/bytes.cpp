#include "synthesis/problem/bytes.h"

#include <fmt/format.h>
#include <nettle/sha2.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <new>
#include <system_error>

namespace mechwright::reading {

namespace {

Bytes unreadable(std::string why) {
    return {.bytes = {}, .failure = "cannot be read: " + std::move(why), .unreadable = true};
}

std::string reason(int error_number) {
    if (error_number == ENOMEM) throw std::bad_alloc();
    return error_number == 0 ? "input error" : std::generic_category().message(error_number);
}

/// Why this path cannot be a file to read; empty if it can.
std::string objection(const std::string& file, bool special_files) {
    if (file.empty()) return "its name is empty";
    if (file.find('\0') != std::string::npos) return "its name has a NUL character";
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found) return reason(ENOENT);
    if (error) return error.message();
    if (std::filesystem::is_directory(status)) return "it is a directory";
    if (!special_files && !std::filesystem::is_regular_file(status)) return "it is not a regular file";
    return {};
}

Bytes too_large(std::size_t most_bytes) {
    return {.bytes = {}, .failure = fmt::format("larger than {} MB", most_bytes >> 20), .unreadable = false};
}

}  // namespace

Bytes read_bytes(const std::string& named, std::size_t most_bytes, bool special_files) {
    const std::string file = special_files && named == "-" ? "/dev/stdin" : named;
    if (std::string why = objection(file, special_files); !why.empty()) return unreadable(std::move(why));
    // What is known to be too large is not read at all; special files say nothing of their size.
    std::error_code unknown;
    if (const auto size = std::filesystem::file_size(file, unknown); !unknown && size > most_bytes)
        return too_large(most_bytes);
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return unreadable(reason(errno));
    Bytes all;
    std::array<char, 65536> block;
    while (stream) {
        errno = 0;
        stream.read(block.data(), block.size());
        if (stream.bad()) return unreadable(reason(errno));
        all.bytes.append(block.data(), static_cast<std::size_t>(stream.gcount()));
        if (all.bytes.size() > most_bytes) return too_large(most_bytes);
    }
    return all;
}

std::string sha256(std::string_view bytes) {
    sha256_ctx context;
    sha256_init(&context);
    sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest;
    sha256_digest(&context, digest.size(), digest.data());
    return fmt::format("{:02x}", fmt::join(digest, ""));
}

}  // namespace mechwright::reading
