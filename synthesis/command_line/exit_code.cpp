#include "synthesis/command_line/exit_code.h"

#include <algorithm>
#include <array>

namespace mechwright::exit_code {

int of(Status status) {
    switch (status) {
        case Status::solved: return solved;
        case Status::infeasible: return infeasible;
        case Status::limit: return limit;
        case Status::unverified: return unverified;
        case Status::interrupted: return interrupted;
    }
    return internal_error;
}

int worse(int a, int b) {
    constexpr std::array by_severity{internal_error, wrong_usage, interrupted, no_access, invalid_file,
                                     unverified,     limit,       infeasible,  solved};
    const auto rank = [&](int code) { return std::find(by_severity.begin(), by_severity.end(), code); };
    return rank(a) <= rank(b) ? a : b;
}

const char* explained() {
    return "Exit codes:\n"
           "  0    solved and verified\n"
           "  1    internal error (a defect: the message says how to report it)\n"
           "  2    wrong usage\n"
           "  3    invalid problem file, or not a result document\n"
           "  4    no feasible design: proven, or none found by a search that ran to its end\n"
           "  5    stopped at a limit; the best design so far is written\n"
           "  6    a file could not be read or written\n"
           "  7    a design was found but its verification failed\n"
           "  130  interrupted; what was done is written\n"
           "With several files: the code that comes first in 1, 130, 6, 3, 7, 5, 4, 0.";
}

}  // namespace mechwright::exit_code
