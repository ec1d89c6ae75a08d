#pragma once
/// \file
/// What a search has been through, for whoever asks to see it (RunOptions::trace). Nothing that is found depends on it.

#include <atomic>
#include <chrono>
#include <optional>
#include <string_view>
#include <vector>

#include "synthesis/program/result.h"

namespace mechwright {

/// How one local search ended.
struct SearchEnd {
    std::string_view from;     ///< where it began: "screened", "preferred values", ...
    std::string_view verdict;  ///< what the solver says of its end: shown, never believed
    long evaluations = 0;
    double seconds = 0;
    std::optional<Solution> solution{};  ///< what it ended at, evaluated by us; nothing if nothing assembled
};

using Seconds = std::atomic<double>;

/// Times are sums over all threads.
struct SearchTrace {
    long cut_off = 0;             ///< of these and of the starts asked for: cut off or never begun
    std::vector<SearchEnd> ends;  ///< in the order of the starts, whatever the threads did
    double reading = 0;           ///< of the file
    Seconds screening = 0;
    Seconds searching = 0;  ///< local searches, their polishing too
    Seconds polishing = 0;
    Seconds proving = 0;
    Seconds verification = 0;
};

/// Adds the seconds that it lives to a sum, if there is one.
class Timed {
public:
    explicit Timed(Seconds* sum) : sum_(sum), begin_(sum ? Clock::now() : Clock::time_point()) {}
    Timed(const Timed&) = delete;
    Timed& operator=(const Timed&) = delete;
    ~Timed() {
        if (sum_) sum_->fetch_add(seconds(), std::memory_order_relaxed);
    }

    /// Since its beginning; 0 where there is no sum.
    double seconds() const { return sum_ ? std::chrono::duration<double>(Clock::now() - begin_).count() : 0; }

private:
    using Clock = std::chrono::steady_clock;
    Seconds* sum_;
    Clock::time_point begin_;
};

/// One of the sums of a trace that may not be there: seconds_of(trace, &SearchTrace::proving).
inline Seconds* seconds_of(SearchTrace* trace, Seconds SearchTrace::*sum) { return trace ? &(trace->*sum) : nullptr; }

}  // namespace mechwright
