#pragma once
/// \file
/// Ctrl-C: the first asks a run to end with what it has, the second ends the program.

#include <atomic>

namespace mechwright {

/// While one exists, the first SIGINT, SIGTERM or SIGHUP only sets requested(); the next one is not held up any more. A
/// signal that the program was started to ignore stays ignored. At most one at a time.
struct Interrupt {
    /// With `announce` the first signal is acknowledged on standard error.
    explicit Interrupt(bool announce);
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    static const std::atomic<bool>& requested();
};

}  // namespace mechwright
