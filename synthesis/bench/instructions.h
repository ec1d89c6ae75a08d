#pragma once
/// \file
/// How many instructions a piece takes: the same number on every run, whatever else the machine does.

#include <functional>
#include <optional>

namespace mechwright::bench {

/// The instructions that one call executes after a first one has warmed it up, counted step by step in a child process
/// (ptrace; about 40 us each, so for pieces of thousands, not of millions). Nothing where the system does not let a
/// process be traced, or where they are more than `most`.
std::optional<long> instructions_of(const std::function<void()>& call, long most = 2'000'000);

}  // namespace mechwright::bench
