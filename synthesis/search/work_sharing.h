#pragma once
/// \file
/// The only place with threads: independent tasks, numbered, shared between workers. Whatever a task computes goes into
/// a slot of its own, so that results do not depend on who did what when.

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace mechwright {

/// Runs task(0) ... task(count - 1) on up to `jobs` threads, the calling one included, and returns when all are done.
inline void share_work(int count, int jobs, const std::function<void(int)>& task) {
    std::atomic<int> next{0};
    const auto work = [&] {
        for (int i = next++; i < count; i = next++)
            task(i);
    };
    std::vector<std::jthread> helpers;
    for (int i = 1; i < jobs && i < count; ++i)
        helpers.emplace_back(work);
    work();
}

}  // namespace mechwright
