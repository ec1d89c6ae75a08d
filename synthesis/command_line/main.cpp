#include <signal.h>
#include <unistd.h>

#include <iostream>

#include "synthesis/command_line/run.h"

int main(int argc, char** argv) {
    // A closed pipe and a full file are errors of writing, not the end of the program.
    ::signal(SIGPIPE, SIG_IGN);
    ::signal(SIGXFSZ, SIG_IGN);
    mechwright::Console console{std::cout, std::cerr, ::isatty(STDOUT_FILENO) == 1, ::isatty(STDERR_FILENO) == 1};
    return mechwright::run(argc, argv, console);
}
