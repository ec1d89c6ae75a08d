#pragma once
/// \file
/// Lets one allocation of this process fail: `operator new` is replaced in the tests that link it.

namespace mechwright::testing {

/// From now on: the allocation with this number, counted from 0, throws std::bad_alloc; no other does.
void fail_allocation(long number);

/// No more fail. Returns how many there were since fail_allocation.
long let_allocations_succeed();

}  // namespace mechwright::testing
