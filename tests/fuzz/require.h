#pragma once
/// \file
/// What must hold of any input.

#include <cstdio>
#include <cstdlib>

namespace mechwright::test {

/// Ends the process where it does not hold, with any build: libFuzzer keeps the input that did it.
inline void require(bool condition, const char* what) {
    if (condition) return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

}  // namespace mechwright::test
