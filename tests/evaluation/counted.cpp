// malloc and its like of this executable: the C library's, and a count. Whatever is linked into it asks here.

#include "tests/evaluation/counted.h"

#include <cstddef>

#ifdef __SANITIZE_ADDRESS__

namespace mechwright::testing {

bool allocations_are_counted() { return false; }
long allocations() { return 0; }

}  // namespace mechwright::testing

#else

namespace {

thread_local long requests = 0;

}  // namespace

extern "C" {

// The C library's own names for its allocator.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
    ++requests;
    return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
    ++requests;
    return __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) {
    ++requests;
    return __libc_realloc(old, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
    ++requests;
    return __libc_memalign(alignment, size);
}
}

namespace mechwright::testing {

bool allocations_are_counted() { return true; }
long allocations() { return requests; }

}  // namespace mechwright::testing

#endif
