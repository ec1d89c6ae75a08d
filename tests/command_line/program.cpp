#include "tests/command_line/program.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>

namespace mechwright::testing {

namespace {

/// A terminal where the system has mounted none, as in a bare root file system: from a mount of our own, which is gone
/// with the last file in it. Only root can do that.
bool open_terminal_of_our_own(std::array<int, 2>& ends) {
    std::string folder = "/tmp/mechwright-terminals-XXXXXX";
    if (::mkdtemp(folder.data()) == nullptr) return false;
    if (::mount("devpts", folder.c_str(), "devpts", 0, "newinstance,ptmxmode=0666") == 0) {
        ends[0] = ::open((folder + "/ptmx").c_str(), O_RDWR | O_NOCTTY);
        ends[1] = ends[0] >= 0 && ::unlockpt(ends[0]) == 0 ? ::ioctl(ends[0], TIOCGPTPEER, O_RDWR | O_NOCTTY) : -1;
        ::umount2(folder.c_str(), MNT_DETACH);
    }
    ::rmdir(folder.c_str());
    return ends[1] >= 0;
}

bool open_terminal(std::array<int, 2>& ends) {
    return ::openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr) == 0 || open_terminal_of_our_own(ends);
}

/// Two ends: the test reads at the first, the program writes at the second.
std::array<int, 2> open_ends(bool terminal) {
    std::array<int, 2> ends{-1, -1};
    if (terminal ? !open_terminal(ends) : ::pipe(ends.data()) != 0)
        throw std::runtime_error("cannot open a pipe or a terminal");
    ::fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    return ends;
}

/// The other way round: what the program is to read is written at the first end, which stays open if it is a
/// terminal's: closing that would hang up. A pipe takes the few lines of a test at once.
std::array<int, 2> open_input(const Start& how) {
    std::array<int, 2> ends = open_ends(how.in_on_terminal);
    if (!how.in_on_terminal) {
        std::swap(ends[0], ends[1]);
        ::fcntl(ends[0], F_SETFD, FD_CLOEXEC);
        ::fcntl(ends[1], F_SETFD, 0);
    }
    if (::write(ends[0], how.in.data(), how.in.size()) != static_cast<ssize_t>(how.in.size()))
        throw std::runtime_error("cannot write the program's input");
    if (!how.in_on_terminal) {
        ::close(ends[0]);
        ends[0] = -1;
    }
    return ends;
}

/// In the child; does not return.
[[noreturn]] void become_program(const Start& how, int in, int out, int err) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ})
        ::signal(number, SIG_DFL);
    if (!how.out_to.empty()) out = ::open(how.out_to.c_str(), O_WRONLY);
    ::dup2(in, STDIN_FILENO);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    if (how.out_closed) ::close(STDOUT_FILENO);
    for (const int file : {in, out, err})
        if (file > STDERR_FILENO) ::close(file);
    if (how.largest_file) {
        const rlimit limit{*how.largest_file, *how.largest_file};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    if (how.most_memory) {
        const rlimit limit{*how.most_memory, *how.most_memory};
        ::setrlimit(RLIMIT_AS, &limit);
    }
    if (!how.folder.empty() && ::chdir(how.folder.c_str()) != 0) ::_exit(98);
    ::setenv("TERM", "xterm", 1);
    ::unsetenv("NO_COLOR");
    for (const auto& [name, value] : how.environment) {
        if (value.empty())
            ::unsetenv(name.c_str());
        else
            ::setenv(name.c_str(), value.c_str(), 1);
    }
    std::vector<char*> arguments{const_cast<char*>(MECHWRIGHT_PROGRAM)};
    for (const std::string& argument : how.arguments)
        arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    ::execv(MECHWRIGHT_PROGRAM, arguments.data());
    ::_exit(99);
}

/// Appends what there is to read. Returns false at the end; a terminal whose other end is closed says EIO.
bool read_some(int file, std::string& text) {
    std::array<char, 65536> buffer;
    const ssize_t count = ::read(file, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) return true;
    if (count <= 0) return false;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    return true;
}

void close_end(int& file) {
    if (file >= 0) ::close(file);
    file = -1;
}

}  // namespace

Running start(const Start& how) {
    const auto in = open_input(how);
    const auto out = open_ends(how.out_on_terminal);
    const auto err = open_ends(how.err_on_terminal);
    const pid_t id = ::fork();
    if (id < 0) throw std::runtime_error("cannot fork");
    if (id == 0) become_program(how, in[1], out[1], err[1]);
    ::close(in[1]);
    ::close(out[1]);
    ::close(err[1]);
    return {id, in[0], out[0], err[0], how.out_read};
}

Outcome finish(Running running) {
    using namespace std::chrono;
    const auto deadline = steady_clock::now() + minutes(9);
    Outcome outcome;
    while (running.out >= 0 || running.err >= 0) {
        if (steady_clock::now() > deadline) {
            ::kill(running.id, SIGKILL);
            ADD_FAILURE() << "the program did not end";
            break;
        }
        std::array<pollfd, 2> ends{{{running.out, POLLIN, 0}, {running.err, POLLIN, 0}}};
        if (::poll(ends.data(), ends.size(), 1000) <= 0) continue;
        if (ends[0].revents != 0 && !read_some(running.out, outcome.out)) close_end(running.out);
        if (ends[1].revents != 0 && !read_some(running.err, outcome.err)) close_end(running.err);
        if (running.out_read && outcome.out.size() >= *running.out_read) close_end(running.out);
    }
    close_end(running.in);
    close_end(running.out);
    close_end(running.err);
    int status = 0;
    while (::waitpid(running.id, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) outcome.killed_by = WTERMSIG(status);
    return outcome;
}

Outcome run(const Start& how) { return finish(start(how)); }

Outcome run(std::vector<std::string> arguments) {
    Start how;
    how.arguments = std::move(arguments);
    return run(how);
}

nlohmann::ordered_json parsed(const std::string& text) {
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(text, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << "not JSON: " << text.substr(0, 500);
    return json;
}

nlohmann::ordered_json without_times(nlohmann::ordered_json json) {
    if (json.is_array()) {
        for (auto& one : json)
            one = without_times(one);
        return json;
    }
    EXPECT_TRUE(json.contains("search") && json["search"].contains("seconds"));
    if (json.contains("search")) json["search"].erase("seconds");
    return json;
}

void expect_has(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n--- is not in\n" << text;
}

void expect_has_not(const std::string& text, const std::string& part) {
    EXPECT_EQ(text.find(part), std::string::npos) << part << "\n--- is in\n" << text;
}

}  // namespace mechwright::testing
