#include "synthesis/program/number_memory.h"

#include <gmp.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace mechwright {

namespace {

void* checked(void* memory) {
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

void* allocate(std::size_t size) { return checked(std::malloc(size)); }
void* reallocate(void* memory, std::size_t, std::size_t size) { return checked(std::realloc(memory, size)); }
void release(void* memory, std::size_t) { std::free(memory); }

}  // namespace

void throw_where_numbers_get_no_memory() { mp_set_memory_functions(allocate, reallocate, release); }

}  // namespace mechwright
