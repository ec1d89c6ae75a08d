#pragma once
/// \file
/// Other programs that this one hands work to, such as those that draw.

#include <string>
#include <string_view>
#include <vector>

namespace mechwright {

struct ProgramRun {
    int error = 0;       ///< why it could not be started (errno), or 0
    int status = 0;      ///< as waitpid gives it
    std::string output;  ///< on its standard output

    bool succeeded() const { return error == 0 && status == 0; }
};

/// Runs a program, found as the shell finds it, with arguments and a text on its standard input, to its end. Its
/// standard error is that of this program, or, if `quiet`, nobody's.
ProgramRun run_program(std::vector<std::string> command, std::string_view input, bool quiet = false);

}  // namespace mechwright
