#include "synthesis/command_line/console.h"

#include <cerrno>
#include <cstdlib>

namespace mechwright {

namespace {

bool terminal_is_dumb() {
    const char* terminal = std::getenv("TERM");
    return !terminal || std::string_view(terminal) == "dumb";
}

}  // namespace

void print(Console& console, std::string_view data) {
    if (console.out_error != 0) return;
    errno = 0;
    console.out << data << std::flush;
    if (!console.out) console.out_error = errno != 0 ? errno : EIO;
}

void complain(Console& console, std::string_view text) { console.err << "mechwright: " << text << std::endl; }

bool colour_wanted(const Console& console) {
    const char* no_colour = std::getenv("NO_COLOR");
    return console.out_is_terminal && !(no_colour && *no_colour) && !terminal_is_dumb();
}

bool progress_wanted(const Console& console) { return console.err_is_terminal && !terminal_is_dumb(); }

}  // namespace mechwright
