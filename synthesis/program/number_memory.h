#pragma once
/// \file
/// What happens where the arithmetic of fifty digits gets no memory.

namespace mechwright {

/// GMP, on which MPFR stands, ends the process where memory is short. From here on it throws std::bad_alloc, in all of
/// the process: for the main function of a program, or the start of a module. What was being computed is lost with the
/// few numbers that it held.
void throw_where_numbers_get_no_memory();

}  // namespace mechwright
