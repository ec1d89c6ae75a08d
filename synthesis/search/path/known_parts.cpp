#include "synthesis/search/path/known_parts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "synthesis/mechanism/linkage/targets/guiding_part.h"
#include "synthesis/search/optima.h"
#include "synthesis/search/path/cognate_starts.h"
#include "synthesis/search/path/path_rounds.h"
#include "synthesis/target/with_targets.h"

namespace mechwright {

namespace {

using Eigen::Index;

/// Parts that are searched for, each by itself, and of each so many designs that are put into the linkage.
constexpr std::size_t most_parts = 2;
constexpr std::size_t most_designs = 8;
/// What a start of a round takes with its short searches, and the best of them gone on with.
constexpr long evaluations_of_part_start = 400;
constexpr int evaluations_about_end = 200;

/// The path followed by a part alone, in the ranges that the linkage leaves it.
Problem problem_of_part(const Problem& problem, const LinkageModel& model, const GuidingPart& part, int starts) {
    std::vector<double> least, greatest;
    for (const DimensionRange& range : problem.dimensions) {
        least.push_back(range.min);
        greatest.push_back(range.max);
    }
    const PartRanges ranges = ranges_of_part(model, part, least, greatest);
    Problem alone;
    constexpr std::array<std::string_view, 1> targets{"path"};
    alone.mechanism = with_targets(kind_of_part(), targets);
    alone.units = problem.units;
    alone.dimensions.resize(alone.mechanism->dimensions.size());
    for (std::size_t i = 0; i < ranges.least.size(); ++i) {
        alone.dimensions[i].min = ranges.least[i];
        alone.dimensions[i].max = ranges.greatest[i];
    }
    const std::size_t start = alone.mechanism->point->roles.start;
    const std::size_t own_start = problem.mechanism->point->roles.start;
    if (start != no_dimension && own_start != no_dimension) alone.dimensions[start] = problem.dimensions[own_start];
    for (DimensionRange& range : alone.dimensions)
        range.named = true;
    alone.assemblies = {0, 1};
    for (std::size_t i = 0; i < alone.mechanism->settings.size(); ++i)
        alone.settings[i] = alone.mechanism->settings[i].preset;
    const auto rms = static_cast<std::size_t>(find_quantity(*alone.mechanism, "path-rms"));
    alone.objective = Objective{{{rms, false, 1}}, false};
    alone.path = problem.path;
    alone.solver = problem.solver;
    alone.solver.starts = starts;
    return alone;
}

/// A design of a part, and on which side it is closed.
struct FoundPart {
    PartDimensions four;
    bool open;
    double start = 0;
    std::vector<double> path_angles{};
};

/// The best designs of a part, each with its cognate behind it.
std::vector<FoundPart> found_parts(const Problem& alone, std::vector<Solution> designs) {
    std::vector<FoundPart> all;
    const std::size_t start = alone.mechanism->point->roles.start;
    for (Solution& solution : designs) {
        if (!solution.feasible || all.size() >= 2 * most_designs) break;
        Design& design = solution.design;
        FoundPart found{{}, design.assembly == 0, 0, std::move(design.path_angles)};
        std::copy_n(design.dimensions.begin(), found.four.size(), found.four.begin());
        if (start != no_dimension) found.start = design.dimensions[start];
        FoundPart other = found;
        other.four = cognate_of_part(found.four);
        other.open = !found.open;
        all.push_back(std::move(found));
        all.push_back(std::move(other));
    }
    return all;
}

/// What the first steps of a round of searches for a part come to.
std::vector<Solution> designs_of_part(const Problem& alone, const RunOptions& options,
                                      std::chrono::steady_clock::time_point deadline, long& evaluations) {
    RunOptions quietly;
    quietly.jobs = options.jobs;
    quietly.stop = options.stop;
    PathRounds rounds(alone, quietly, deadline);
    if (rounds.programs.all.empty()) return {};
    std::vector<Trial> trials = rounds.short_searches(0);
    keep_different(trials, alone.solver.starts);
    rounds.go_on(trials, evaluations_about_end);
    evaluations += rounds.report.evaluations;
    std::vector<Solution> ends;
    for (const Trial& trial : trials)
        ends.push_back(rounds.assessed(trial));
    std::vector<const Solution*> all;
    for (const Solution& end : ends)
        all.push_back(&end);
    return distinct_optima(alone, all, rounds.report);
}

/// Whether a crank that meets the points of a path at some angles turns the way of a program.
bool turns_as(const Program& program, const std::vector<double>& path_angles) {
    return !program.untimed_path() || program.problem->path->any_order || path_angles.size() < 2 ||
           (path_angles.back() > path_angles.front()) == (program.variant.direction > 0);
}

/// The point of a program with a design of a part, where it can have it.
std::optional<KnownPart> put_into(const Program& program, const LinkageModel& model, const GuidingPart& part,
                                  const FoundPart& found) {
    if (model.sides[program.variant.assembly][part.choice] != (found.open ? part.open : -part.open)) return {};
    if (!turns_as(program, found.path_angles)) return {};
    std::vector<bool> free;
    for (const std::ptrdiff_t v : program.variable_of)
        free.push_back(v >= 0);
    auto placed = with_part(model, part, found.four, free, design_at(program, program.reference).dimensions);
    if (!placed) return {};
    if (const std::size_t start = program.problem->mechanism->point->roles.start;
        start != no_dimension && !program.untimed_path() && free[start]) {
        placed->dimensions[start] = found.start;
        placed->chosen[start] = true;
    }
    Design design{std::move(placed->dimensions), program.variant.assembly, found.path_angles};
    auto x = turned_on(program, std::move(design), placed->crank_angle);
    if (!x) return {};
    KnownPart known{std::move(*x), {}};
    for (std::size_t i = 0; i < free.size(); ++i)
        if (placed->chosen[i] && free[i]) known.known.push_back(program.variable_of[i]);
    if (program.untimed_path())
        for (std::size_t i = 0; i < program.targets.size(); ++i)
            known.known.push_back(static_cast<Index>(program.first_path_angle + i));
    return known;
}

}  // namespace

bool has_guiding_part(const Problem& problem) {
    return is_path_of_linkage(problem) && !guiding_parts(linkage_of(problem.mechanism->model.data())).empty();
}

std::vector<std::vector<KnownPart>> known_parts(const Problem& problem, const std::vector<Program>& programs,
                                                const RunOptions& options,
                                                std::chrono::steady_clock::time_point deadline, long budget,
                                                long& evaluations) {
    std::vector<std::vector<KnownPart>> all(programs.size());
    if (!has_guiding_part(problem)) return all;
    const LinkageModel& model = linkage_of(problem.mechanism->model.data());
    std::vector<GuidingPart> parts = guiding_parts(model);
    parts.resize(std::min(parts.size(), most_parts));
    for (const GuidingPart& part : parts) {
        const long of_part = budget / static_cast<long>(parts.size());
        const auto starts = static_cast<int>(std::min<long>(of_part / evaluations_of_part_start, most_starts_of_round));
        if (starts == 0) break;
        const Problem alone = problem_of_part(problem, model, part, starts);
        for (const FoundPart& found : found_parts(alone, designs_of_part(alone, options, deadline, evaluations)))
            for (std::size_t p = 0; p < programs.size(); ++p)
                if (auto known = put_into(programs[p], model, part, found)) all[p].push_back(std::move(*known));
    }
    return all;
}

}  // namespace mechwright
