#include "synthesis/report/files/write_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>

namespace mechwright {

namespace {

std::string failure(const std::filesystem::path& path, int error) {
    return "cannot write '" + path.string() + "': " + std::generic_category().message(error);
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

/// A name that no other process and no other call of this one uses.
std::filesystem::path temporary_beside(const std::filesystem::path& path) {
    static std::atomic<unsigned> count{0};
    std::string name = path.filename().string();
    name.insert(0, 1, '.').append(".").append(std::to_string(::getpid()));
    name.append("-").append(std::to_string(count++)).append(".part");
    return folder_of(path) / name;
}

/// 0 or the error.
int write_all(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

/// 0 or the error. File systems that cannot synchronise say EINVAL; that is no reason not to write.
int synchronise(int file) { return ::fsync(file) == 0 || errno == EINVAL ? 0 : errno; }

/// Creates a new file with the text in it. 0 or the error; after an error there is no such file.
int create(const std::filesystem::path& path, std::string_view text) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0) return errno;
    int error = write_all(file, text);
    if (error == 0) error = synchronise(file);
    if (::close(file) != 0 && error == 0) error = errno;
    if (error != 0) ::unlink(path.c_str());
    return error;
}

/// Makes a rename last; where a folder cannot be synchronised the file is whole all the same.
void synchronise_folder(const std::filesystem::path& folder) {
    const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) return;
    synchronise(file);
    ::close(file);
}

}  // namespace

std::optional<std::string> write_atomically(const std::filesystem::path& path, std::string_view text) {
    const std::filesystem::path temporary = temporary_beside(path);
    if (const int error = create(temporary, text)) return failure(path, error);
    if (::rename(temporary.c_str(), path.c_str()) != 0) {
        const int error = errno;
        ::unlink(temporary.c_str());
        return failure(path, error);
    }
    synchronise_folder(folder_of(path));
    return std::nullopt;
}

std::optional<std::string> prepare_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error && !std::filesystem::is_directory(folder))
        return "cannot make the folder '" + folder.string() + "': " + std::generic_category().message(error.value());
    const std::filesystem::path probe = temporary_beside(folder / "probe");
    if (const int failed = create(probe, "")) return failure(folder, failed);
    ::unlink(probe.c_str());
    return std::nullopt;
}

}  // namespace mechwright
