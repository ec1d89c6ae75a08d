#pragma once
/// \file
/// When a run has to end: by the clock, or because it was asked to.

#include <atomic>
#include <chrono>

namespace mechwright {

struct RunEnd {
    std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
    const std::atomic<bool>* stop = nullptr;  ///< set from outside

    bool reached() const {
        return (stop && stop->load(std::memory_order_relaxed)) || std::chrono::steady_clock::now() >= deadline;
    }
};

}  // namespace mechwright
