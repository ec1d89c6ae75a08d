#include "tests/robustness/allocation.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> done = 0;
std::atomic<long> failing = -1;

}  // namespace

namespace mechwright::testing {

void fail_allocation(long number) {
    done = 0;
    failing = number;
}

long let_allocations_succeed() {
    failing = -1;
    return done;
}

}  // namespace mechwright::testing

void* operator new(std::size_t size) {
    const long number = done++;
    void* memory = number == failing ? nullptr : std::malloc(size > 0 ? size : 1);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

// The library's would do; the address sanitizer's own takes memory that the `delete` below may not return.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    try {
        return operator new(size);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
