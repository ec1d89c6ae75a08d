#include "synthesis/search/path/path_programs.h"

#include <algorithm>

#include "synthesis/program/without_margins.h"

namespace mechwright {

namespace {

/// Whether points of one program are points of the other. A quantity with one value in one kind of motion and several
/// in another has a variable for the worst of these there alone.
bool have_same_variables(const Program& a, const Program& b) {
    return std::equal(a.variables.begin(), a.variables.end(), b.variables.begin(), b.variables.end(),
                      [](const Variable& one, const Variable& other) { return one.name == other.name; });
}

/// The program of the same assembly, direction and variables whose designs may have any motion; without one the program
/// itself.
std::size_t widest(const std::vector<Program>& programs, std::size_t program) {
    const Variant& own = programs[program].variant;
    const auto at = std::find_if(programs.begin(), programs.end(), [&](const Program& p) {
        return !p.problem->mechanism->families[p.variant.family].full_turn && p.variant.assembly == own.assembly &&
               p.variant.direction == own.direction && p.variant.choices == own.choices &&
               have_same_variables(p, programs[program]);
    });
    return at == programs.end() ? program : static_cast<std::size_t>(at - programs.begin());
}

}  // namespace

PathPrograms::PathPrograms(const Problem& problem) {
    for (const Variant& variant : variants(problem))
        all.push_back(build_program(problem, variant));
    if (std::all_of(all.begin(), all.end(), has_margins_of_motion))
        for (const Program& program : all)
            free_of_margins.push_back(without_margins(program));
    for (std::size_t i = 0; i < all.size(); ++i)
        fitted_as.push_back(widest(all, i));
}

LocalOutcome PathPrograms::short_search(std::size_t program, const Eigen::VectorXd& start,
                                        const LocalLimits& few) const {
    return levenberg_marquardt(skip_margins() ? free_of_margins[program] : all[program], start, few);
}

LocalOutcome PathPrograms::long_search(std::size_t program, const Eigen::VectorXd& start,
                                       const LocalLimits& whole) const {
    if (!skip_margins()) return levenberg_marquardt(all[program], start, whole);
    LocalLimits along_valleys = whole;
    along_valleys.follows_valleys = true;
    LocalOutcome outcome = levenberg_marquardt(free_of_margins[program], start, along_valleys);
    if (outcome.x.size() == 0) return outcome;
    ProgramValues values;
    evaluate(all[program], outcome.x, false, values);
    ++outcome.evaluations;
    outcome.violation = violation(all[program], outcome.x, values);
    if (outcome.violation <= LocalOutcome::feasible_below) return outcome;
    LocalOutcome closed = levenberg_marquardt(all[program], outcome.x, whole);
    closed.evaluations += outcome.evaluations;
    return closed;
}

}  // namespace mechwright
