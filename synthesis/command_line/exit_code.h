#pragma once
/// \file
/// What the program's exit codes mean.

#include <span>
#include <string>
#include <string_view>

#include "synthesis/program/result.h"

namespace mechwright::exit_code {

inline constexpr int solved = 0;
inline constexpr int internal_error = 1;  ///< a defect of the program; or out of memory
inline constexpr int wrong_usage = 2;
inline constexpr int invalid_file = 3;
inline constexpr int infeasible = 4;
inline constexpr int limit = 5;
inline constexpr int no_access = 6;  ///< a file could not be read or written
inline constexpr int unverified = 7;
inline constexpr int interrupted = 130;

/// The code for a result.
int of(Status status);

/// The code of a run over several files: the more severe of two, in the order 1, 2, 130, 6, 3, 7, 5, 4, 0.
int worse(int a, int b);

struct Meaning {
    int code;
    std::string_view text;
};

/// Every code with its meaning.
std::span<const Meaning> meanings();

/// Which code a run over several files ends with.
std::string_view of_several();

/// All of this as a table for the help.
std::string explained();

}  // namespace mechwright::exit_code
