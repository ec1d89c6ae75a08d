#pragma once
/// \file
/// How often memory was asked for.

namespace mechwright::testing {

/// Whether requests are counted: not under the sanitizers, which have an allocator of their own.
bool allocations_are_counted();

/// Requests of this thread to malloc and its like, by way of which the library's operator new and Eigen get theirs,
/// since the program began.
long allocations();

}  // namespace mechwright::testing
