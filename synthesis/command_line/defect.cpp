#include "synthesis/command_line/defect.h"

#include <exception>
#include <new>
#include <string>

#include "synthesis/command_line/exit_code.h"
#include "synthesis/document/versions.h"

namespace mechwright {

int report_defect(Console& console, std::string_view working_on) {
    std::string what = "unknown exception";
    try {
        throw;
    } catch (const std::bad_alloc&) {
        complain(console, "out of memory");
        return exit_code::internal_error;
    } catch (const std::exception& exception) {
        what = exception.what();
    } catch (...) {
    }
    const std::string place = working_on.empty() ? "" : std::string(working_on) + ": ";
    complain(console, place + "internal error: " + what + "\nThis is a defect of mechwright " + program_version() +
                          ". Please report it to its developers, with the command line, the problem\n"
                          "file and what 'mechwright --version' prints.");
    return exit_code::internal_error;
}

}  // namespace mechwright
