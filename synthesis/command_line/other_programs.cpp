#include "synthesis/command_line/other_programs.h"

namespace mechwright {

std::filesystem::path called(std::string_view name) {
    const auto beside = std::filesystem::read_symlink("/proc/self/exe").replace_filename(name);
    return std::filesystem::exists(beside) ? beside : std::filesystem::path(name);
}

}  // namespace mechwright
