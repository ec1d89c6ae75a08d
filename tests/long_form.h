#pragma once
/// \file
/// How much of a long test is run. `ctest --preset test` goes through a part of its cases, `ctest --preset long`, which
/// sets MECHWRIGHT_LONG_TESTS, through all: the part means the same, with less chance of meeting what is rare.

#include <cstdlib>

namespace mechwright {

inline bool in_long_form() { return std::getenv("MECHWRIGHT_LONG_TESTS") != nullptr; }

/// As many cases as a test has in the form that is run.
inline int cases_to_try(int few, int all) { return in_long_form() ? all : few; }

}  // namespace mechwright
