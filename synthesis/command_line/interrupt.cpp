#include "synthesis/command_line/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <string_view>

namespace mechwright {

namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> stop_requested{false};
std::atomic<bool> acknowledge{false};
static_assert(std::atomic<bool>::is_always_lock_free);

std::array<struct sigaction, signals.size()> before;

// Only what is safe in a signal handler.
void on_signal(int) {
    stop_requested = true;
    for (const int signal_number : signals)
        ::signal(signal_number, SIG_DFL);
    if (!acknowledge) return;
    constexpr std::string_view text =
        "\r\x1b[Kstopping with the best design so far (Ctrl-C again ends the program at once)\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

Interrupt::Interrupt(bool announce) {
    stop_requested = false;
    acknowledge = announce;
    for (std::size_t i = 0; i < signals.size(); ++i) {
        ::sigaction(signals[i], nullptr, &before[i]);
        if (before[i].sa_handler == SIG_IGN) continue;
        struct sigaction action {};
        action.sa_handler = on_signal;
        action.sa_flags = SA_RESTART;
        ::sigemptyset(&action.sa_mask);
        ::sigaction(signals[i], &action, nullptr);
    }
}

Interrupt::~Interrupt() {
    for (std::size_t i = 0; i < signals.size(); ++i)
        ::sigaction(signals[i], &before[i], nullptr);
}

const std::atomic<bool>& Interrupt::requested() { return stop_requested; }

}  // namespace mechwright
