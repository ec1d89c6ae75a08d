#include "synthesis/bench/instructions.h"

#include <signal.h>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mechwright::bench {

namespace {

[[noreturn]] void traced_child(const std::function<void()>& call) {
    if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) ::_exit(1);
    call();
    ::raise(SIGSTOP);
    call();
    ::raise(SIGSTOP);
    ::_exit(0);
}

/// Waits for the child; whether it has stopped with this signal.
bool stopped_by(pid_t child, int signal) {
    int status = 0;
    return ::waitpid(child, &status, 0) == child && WIFSTOPPED(status) && WSTOPSIG(status) == signal;
}

/// Steps from the first stop to the second, the way out of one `raise` and into the other included.
std::optional<long> steps_between_stops(pid_t child, long most) {
    if (!stopped_by(child, SIGSTOP)) return std::nullopt;
    for (long steps = 0; steps < most; ++steps) {
        if (::ptrace(PTRACE_SINGLESTEP, child, nullptr, nullptr) != 0) return std::nullopt;
        if (!stopped_by(child, SIGTRAP)) return steps;
    }
    return std::nullopt;
}

std::optional<long> steps_of(const std::function<void()>& call, long most) {
    const pid_t child = ::fork();
    if (child < 0) return std::nullopt;
    if (child == 0) traced_child(call);
    const std::optional<long> steps = steps_between_stops(child, most);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    return steps;
}

}  // namespace

std::optional<long> instructions_of(const std::function<void()>& call, long most) {
    const auto all = steps_of(call, most);
    const auto nothing = steps_of([] {}, most);
    if (!all || !nothing) return std::nullopt;
    return *all - *nothing;
}

}  // namespace mechwright::bench
