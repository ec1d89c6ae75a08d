#include "synthesis/report/files/temporary_folder.h"

#include <stdlib.h>

#include <cerrno>

namespace mechwright {

TemporaryFolder::TemporaryFolder() {
    const std::filesystem::path place = std::filesystem::temp_directory_path();
    std::string name = (place / "mechwright-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
        throw std::filesystem::filesystem_error("cannot make a folder", place,
                                                std::error_code(errno, std::generic_category()));
    path = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

}  // namespace mechwright
