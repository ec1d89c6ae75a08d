#pragma once
/// \file
/// Long work that leaves Python its interpreter and heeds Ctrl-C.

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <future>

namespace mechwright::python {

/// Runs work(stop) in a thread of its own, without the interpreter's lock. A signal that Python's handlers turn into an
/// exception, such as Ctrl-C, sets `stop`; once the work has ended, that exception is thrown. Only Python's main thread
/// receives signals.
template <class Work>
auto interruptible(const Work& work) {
    constexpr std::chrono::milliseconds between_looks{20};
    std::atomic<bool> stop{false};
    auto running = std::async(std::launch::async, [&] { return work(stop); });
    const auto done_within = [&](std::chrono::milliseconds time) {
        const pybind11::gil_scoped_release release;
        return running.wait_for(time) == std::future_status::ready;
    };
    while (!done_within(between_looks)) {
        if (PyErr_CheckSignals() == 0) continue;
        const pybind11::error_already_set interrupt;
        stop = true;
        while (!done_within(between_looks)) {
        }
        throw interrupt;
    }
    return running.get();
}

}  // namespace mechwright::python
