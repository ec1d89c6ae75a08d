#include "synthesis/command_line/exit_code.h"

#include <fmt/format.h>

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

std::span<const Meaning> meanings() {
    static constexpr std::array all{
        Meaning{solved, "solved and verified"},
        Meaning{internal_error, "out of memory; or a defect (the message says how to report it)"},
        Meaning{wrong_usage, "wrong usage"},
        Meaning{invalid_file, "invalid problem file, or not a result document"},
        Meaning{infeasible, "no feasible design: proven, or none found by a search that ran to its end"},
        Meaning{limit, "stopped at a limit; the best design so far is written"},
        Meaning{no_access, "a file could not be read or written"},
        Meaning{unverified, "a design was found but its verification failed"},
        Meaning{interrupted, "interrupted; what was done is written"}};
    return all;
}

std::string_view of_several() { return "With several files: the code that comes first in 1, 130, 6, 3, 7, 5, 4, 0."; }

std::string explained() {
    std::string text = "Exit codes:\n";
    for (const Meaning& meaning : meanings())
        text += fmt::format("  {:<3}  {}\n", meaning.code, meaning.text);
    return text.append(of_several());
}

}  // namespace mechwright::exit_code
