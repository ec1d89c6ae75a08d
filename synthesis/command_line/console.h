#pragma once
/// \file
/// Where a command writes: data to `out`, everything about the run to `err`.

#include <ostream>
#include <string_view>

namespace mechwright {

struct Console {
    std::ostream& out;
    std::ostream& err;
    bool out_is_terminal = false;
    bool err_is_terminal = false;
    int out_error = 0;  ///< the system's reason why `out` could not be written, the first time; then nothing more is
};

/// Writes data and hands them on at once.
void print(Console& console, std::string_view data);

/// "mechwright: text" on `err`.
void complain(Console& console, std::string_view text);

/// Whether data may be coloured: on a terminal that can, unless NO_COLOR is set (https://no-color.org).
bool colour_wanted(const Console& console);

/// Whether a line on `err` can be drawn over again and again.
bool progress_wanted(const Console& console);

}  // namespace mechwright
