// Runs gnuplot.

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "synthesis/study/charts.h"

extern "C" char** environ;

namespace mechwright {

namespace {

const char* terminal(PictureFormat format) {
    return format == PictureFormat::svg
               ? "set terminal svg size 900,640 dynamic font 'sans-serif,13' background '#ffffff'"
               : "set terminal pngcairo size 1350,960 font 'sans,13' fontscale 1.3";
}

std::string read_all(int pipe) {
    std::string text;
    std::array<char, 1 << 16> buffer{};
    for (;;) {
        const ssize_t got = ::read(pipe, buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return text;
        text.append(buffer.data(), static_cast<std::size_t>(got));
    }
}

}  // namespace

std::string drawn(const std::filesystem::path& script, PictureFormat format) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
        throw ChartFault("cannot run gnuplot: " + std::generic_category().message(errno));
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
    std::string program = "gnuplot", option = "-e", setting = terminal(format), file = script.string();
    std::array<char*, 5> arguments{program.data(), option.data(), setting.data(), file.data(), nullptr};
    pid_t child = -1;
    const int error = ::posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(pipe[1]);
    if (error != 0) {
        ::close(pipe[0]);
        throw ChartFault(error == ENOENT ? "there is no gnuplot: install it (Debian: gnuplot-nox)"
                                         : "cannot run gnuplot: " + std::generic_category().message(error));
    }
    std::string picture = read_all(pipe[0]);
    ::close(pipe[0]);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (status != 0 || picture.empty())
        throw ChartFault(fmt::format("gnuplot could not draw '{}'; it says why above", file));
    return picture;
}

}  // namespace mechwright
