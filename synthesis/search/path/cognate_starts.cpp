#include "synthesis/search/path/cognate_starts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "synthesis/mechanism/linkage/targets/cognates.h"

namespace mechwright {

namespace {

using Eigen::VectorXd;

/// The program for the same motion where dyads are closed on these sides; as many as there are where there is none.
std::size_t closed_on(const std::vector<Program>& programs, const Variant& own, const LinkageModel& model,
                      const std::vector<std::int8_t>& sides) {
    const auto at = std::find_if(programs.begin(), programs.end(), [&](const Program& p) {
        return p.variant.family == own.family && p.variant.direction == own.direction &&
               p.variant.choices == own.choices && model.sides[p.variant.assembly] == sides;
    });
    return static_cast<std::size_t>(at - programs.begin());
}

}  // namespace

bool is_path_of_linkage(const Problem& problem) {
    return problem.path && problem.path->parts.empty() && !problem.path->guides_body() && problem.mechanism->point &&
           is_described(*problem.mechanism) && !has_ties(problem);
}

std::optional<VectorXd> turned_on(const Program& program, Design design, double crank_angle) {
    constexpr double same_angle_within = 1e-9;
    const Problem& problem = *program.problem;
    if (!program.untimed_path()) {
        const std::size_t start = problem.mechanism->point->roles.start;
        const bool free = program.variable_of[start] >= 0;
        if (!free && std::abs(std::sin(crank_angle / 2)) > same_angle_within) return {};
        if (free) design.dimensions[start] += crank_angle;
    }
    for (double& angle : design.path_angles)
        angle += crank_angle;
    VectorXd x = point_of(program, design);
    for (std::size_t i = 0; i < program.variable_of.size(); ++i) {
        const std::ptrdiff_t v = program.variable_of[i];
        if (v < 0 || problem.mechanism->dimensions[i].kind != DimensionKind::angle) continue;
        const Variable& range = program.variables[static_cast<std::size_t>(v)];
        x[v] = into_range(x[v], range.lower, range.upper);
    }
    return within_bounds(program, std::move(x));
}

std::vector<PointOfProgram> cognates_of(const std::vector<Program>& programs, std::size_t program, const VectorXd& x) {
    const Program& own = programs[program];
    std::vector<PointOfProgram> all;
    if (!is_path_of_linkage(*own.problem)) return all;
    const LinkageModel& model = linkage_of(own.problem->mechanism->model.data());
    const Design design = design_at(own, x);
    std::vector<bool> free;
    for (const std::ptrdiff_t v : own.variable_of)
        free.push_back(v >= 0);
    const double input = model.input_of(design.path_angles.front());
    for (LinkageCognate& cognate : linkage_cognates(model, design.dimensions, own.variant.assembly, free, input)) {
        const std::size_t other = closed_on(programs, own.variant, model, cognate.sides);
        if (other == programs.size()) continue;
        Design moved{std::move(cognate.dimensions), programs[other].variant.assembly, design.path_angles};
        if (auto point = turned_on(programs[other], std::move(moved), cognate.crank_angle))
            all.push_back({other, std::move(*point)});
    }
    return all;
}

}  // namespace mechwright
