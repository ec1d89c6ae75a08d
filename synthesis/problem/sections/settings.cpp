#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/units.h"

namespace mechwright::reading {

namespace {

/// A whole number between the key's limits, or what it is by default.
std::int64_t read_bounded(Section& section, std::string_view key, std::int64_t preset, Messages& messages) {
    const Limits& limits = find_key(section.known, key)->limits;
    const auto least = static_cast<std::int64_t>(limits.least);
    const auto most =
        std::isfinite(limits.most) ? static_cast<std::int64_t>(limits.most) : std::numeric_limits<std::int64_t>::max();
    const std::int64_t number = read_whole_number(section, key, messages).value_or(preset);
    if (number >= least && number <= most) return number;
    add_error(messages, place_of(section, key),
              fmt::format("{} must be between {} and {}, not {}", name_of(section, key), least, most, number));
    return preset;
}

/// A number above 0 and up to the key's limit, or what it is by default.
double read_positive(Section& section, std::string_view key, double preset, Messages& messages) {
    const double most = find_key(section.known, key)->limits.most;
    const double number = read_number(section, key, messages).value_or(preset);
    if (number > 0 && number <= most) return number;
    add_error(messages, place_of(section, key),
              fmt::format("{} must be greater than 0 and at most {}, not {}", name_of(section, key), most, number));
    return preset;
}

void check_crank_range(const Section& motion, double from, double to, double turn, Messages& messages) {
    const FilePlace place = place_of(motion, "crank_range");
    if (from >= to)
        add_error(messages, place,
                  fmt::format("crank_range must rise: its first angle {} must be less than its second {}", from, to));
    else if (to - from > turn)
        add_error(messages, place,
                  fmt::format("crank_range goes from {} to {}: it must be one full turn at most", from, to));
}

}  // namespace

double to_radians(const Units& units, double angle) { return units.degrees ? angle * std::numbers::pi / 180 : angle; }

double full_turn(const Units& units) {
    constexpr double turn_within = 1e-9;
    return (units.degrees ? 360.0 : 2 * std::numbers::pi) * (1 + turn_within);
}

/// Masses are converted where their unit is said: forces are then in newtons unless that is said, too.
void read_units_of_forces(Section& section, Units& units, Messages& messages) {
    if (const auto force = read_choice(section, "force", "unit of force", keys::force_units, messages))
        units.force = keys::force_units[*force];
    const auto mass = read_choice(section, "mass", "unit of mass", keys::mass_units, messages);
    if (!mass) return;
    units.mass = keys::mass_units[*mass];
    if (units.force.empty()) units.force = "N";
    if (const auto times = times_mass(units.mass, units.force, units.length))
        units.per_mass = *times;
    else
        add_error(messages, place_of(section, "mass"),
                  fmt::format("{} in '{}' go with lengths in mm, cm, m, in or ft, not in {}: name one of them as "
                              "'length', or leave 'mass' out and give masses in the unit that goes with the others",
                              name_of(section, "mass"), units.mass, reading::quoted(units.length)));
}

void read_units(Section& file, Problem& problem, Messages& messages) {
    std::optional<Section> section = read_section(file, "units", messages);
    if (!section) return;
    problem.units.degrees = read_choice(*section, "angle", "unit of angle", messages) != 1u;
    if (auto length = read_string(*section, "length", messages)) problem.units.length = *std::move(length);
    read_units_of_forces(*section, problem.units, messages);
    report_unknown_keys(*section, messages);
}

void read_motion(Section& file, Problem& problem, Messages& messages) {
    std::optional<Section> section = read_section(file, "motion", messages);
    if (!section) return;
    if (problem.mechanism != nullptr && has(*section, "crank_range") &&
        std::ranges::all_of(problem.mechanism->families, &Family::full_turn))
        add_error(messages, place_of(*section, "crank_range"),
                  fmt::format("a {} is judged over its full turn: leave crank_range out", problem.mechanism->name));
    if (const auto range = read_numbers(*section, "crank_range", messages)) {
        if (range->size() != 2) {
            add_error(messages, place_of(*section, "crank_range"),
                      fmt::format("crank_range must be two angles [from, to], not {}", range->size()));
        } else {
            check_crank_range(*section, (*range)[0], (*range)[1], full_turn(problem.units), messages);
            problem.crank_range = {to_radians(problem.units, (*range)[0]), to_radians(problem.units, (*range)[1])};
        }
    }
    accept_range_of_use(*section);
    report_unknown_keys(*section, messages);
}

void read_solver(Section& file, Problem& problem, Messages& messages) {
    std::optional<Section> section = read_section(file, "solver", messages);
    if (!section) return;
    SolverOptions& solver = problem.solver;
    if (auto method = read_string(*section, "method", messages)) solver.method = *std::move(method);
    solver.starts = static_cast<int>(read_bounded(*section, "starts", solver.starts, messages));
    solver.seed =
        static_cast<std::uint64_t>(read_bounded(*section, "seed", static_cast<std::int64_t>(solver.seed), messages));
    solver.time_limit = read_positive(*section, "time_limit", solver.time_limit, messages);
    solver.tolerance = read_positive(*section, "tolerance", solver.tolerance, messages);
    if (find(*section, "pareto") != nullptr)
        solver.pareto = static_cast<int>(read_bounded(*section, "pareto", solver.pareto, messages));
    if (const auto round = read_number(*section, "round", messages); round && !(*round > 0))
        add_error(messages, place_of(*section, "round"),
                  fmt::format("{} must be greater than 0, not {}", name_of(*section, "round"), *round));
    report_unknown_keys(*section, messages);
}

void check_front(const Section& file, const Problem& problem, Messages& messages) {
    const toml::node* pareto = file.table->at_path("solver.pareto").node();
    if (pareto != nullptr && !problem.wishes.empty())
        return add_error(messages, place_of(*pareto),
                         "'pareto' trades two objectives of one rank against each other: leave out 'rank' or 'pareto'");
    if (pareto != nullptr && (!problem.objective || problem.objective->terms.size() != 2 || problem.objective->worst))
        add_error(messages, place_of(*pareto),
                  "'pareto' needs two objectives to trade against each other: write two [[objective]] entries");
}

}  // namespace mechwright::reading
