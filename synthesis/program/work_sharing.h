#pragma once
/// \file
/// The only place with threads: independent tasks, numbered, shared between workers. Whatever a task computes goes into
/// a slot of its own, so that results do not depend on who did what when.

#include <mpfr.h>

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace mechwright {

/// Runs task(0) ... task(count - 1) on up to `jobs` threads, the calling one included, and returns when all are done.
/// After an exception no other task is begun, and once those under way are over it is thrown here. Where the system has
/// no more threads to give, those there are do the work.
inline void share_work(int count, int jobs, const std::function<void(int)>& task) {
    std::atomic<int> next{0};
    std::mutex mutex;
    std::exception_ptr thrown;
    const auto work = [&] {
        try {
            for (int i = next++; i < count; i = next++)
                task(i);
        } catch (...) {
            next = count;
            const std::lock_guard lock(mutex);
            if (!thrown) thrown = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> helpers;
        helpers.reserve(static_cast<std::size_t>(jobs > 1 ? jobs - 1 : 0));
        try {
            for (int i = 1; i < jobs && i < count; ++i)
                helpers.emplace_back([&] {
                    work();
                    mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE);  // what fifty digits keep for each thread
                });
        } catch (const std::exception&) {  // no more threads, or no memory for one
        }
        work();
    }
    if (thrown) std::rethrow_exception(thrown);
}

}  // namespace mechwright
