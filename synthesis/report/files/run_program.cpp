#include "synthesis/report/files/run_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>

extern "C" char** environ;

namespace mechwright {

namespace {

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

/// An unnamed file with the text in it, at its start; null if there is no room.
std::FILE* file_of(std::string_view text) {
    std::FILE* file = std::tmpfile();
    if (!file) return nullptr;
    if (std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0) {
        std::rewind(file);
        return file;
    }
    std::fclose(file);
    return nullptr;
}

/// The environment of this process but for its locale, so that other programs too write the same everywhere.
std::vector<char*> environment_without_locale() {
    static std::string locale = "LC_ALL=C.UTF-8";
    std::vector<char*> variables;
    for (char** variable = environ; *variable != nullptr; ++variable)
        if (!std::string_view(*variable).starts_with("LC_ALL=")) variables.push_back(*variable);
    variables.push_back(locale.data());
    variables.push_back(nullptr);
    return variables;
}

}  // namespace

ProgramRun run_program(std::vector<std::string> command, std::string_view input, bool quiet) {
    ProgramRun run;
    std::FILE* in = file_of(input);
    std::array<int, 2> pipe{};
    if (!in || ::pipe2(pipe.data(), O_CLOEXEC) != 0) {
        run.error = errno;
        if (in) std::fclose(in);
        return run;
    }
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ::fileno(in), STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
    if (quiet) ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    std::vector<char*> arguments;
    for (std::string& word : command)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = -1;
    run.error =
        ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environment_without_locale().data());
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(pipe[1]);
    if (run.error == 0) {
        run.output = read_all(pipe[0]);
        while (::waitpid(child, &run.status, 0) < 0 && errno == EINTR) {
        }
    }
    ::close(pipe[0]);
    std::fclose(in);
    return run;
}

}  // namespace mechwright
