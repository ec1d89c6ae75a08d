#include "synthesis/program/standing/singular.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "synthesis/mechanism/input.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/target/path/read_parts.h"
#include "synthesis/target/path/rows/stretch.h"

namespace mechwright {

namespace {

struct Margins {
    double longest;
    std::vector<SingularMargin> found{};

    void add(std::string name, double margin) {
        if (is_small(margin)) found.push_back({std::move(name), margin, margin / longest});
    }
    bool is_small(double margin) const { return margin < singular_below * longest; }
};

void add_conditions(const Mechanism& mechanism, const Motion& motion, const Design& design, Margins& margins) {
    const Family& family = mechanism.families[motion.family];
    for (const LinearCondition& condition : family.conditions) {
        double value = 0;
        for (std::size_t i = 0; i < condition.coefficients.size(); ++i)
            value += condition.coefficients[i] * design.dimensions[i];
        margins.add(std::string(condition.name), value);
    }
    if (!family.assembly_margin) return;
    const double margin = least_component(*family.assembly_margin, motion, design.dimensions);
    if (!mechanism.nearest_limit || !margins.is_small(margin))
        return margins.add(family.assembly_margin->meaning, margin);
    constexpr double rounding = 1e-9;  // of a margin over the longest length
    margins.add(mechanism.nearest_limit(motion, design.dimensions), margin);
    margins.found.back().impossible = margin < -rounding * margins.longest;
}

void add_over_range(const Problem& problem, const Motion& motion, const Design& design, Margins& margins) {
    if (covers_several(problem) && !problem.crank_range)
        return margins.add("the mechanism assembles over its targets", least_margin_along(problem, design));
    if (moves_over_targets(problem) && has_moving_ends(problem) && problem.mechanism->input)
        return margins.add("the mechanism assembles over its input range",
                           least_component(problem.mechanism->input->margin, motion, design.dimensions));
    const auto& families = problem.mechanism->families;
    const auto limited = std::find_if(families.begin(), families.end(), [](const Family& f) { return !f.full_turn; });
    if ((!problem.crank_range && !problem.use) || limited == families.end() || !limited->assembly_margin) return;
    // What does not assemble is not close to it.
    if (!assembles_over_range(problem, design)) return;
    Motion over = motion;
    over.family = static_cast<std::size_t>(limited - families.begin());
    const std::string_view range = problem.use ? "use" : input_word(*problem.mechanism);
    margins.add(fmt::format("the mechanism assembles over the range of {}{}", range, problem.use ? "" : "s"),
                least_component(*limited->assembly_margin, over, design.dimensions));
}

void add_points(const Problem& problem, const Design& design, Margins& margins) {
    const std::vector<double>& angles = design.path_angles;
    if (!problem.path || angles.size() != problem.path->points.size()) return;
    double least = std::numeric_limits<double>::infinity();
    std::size_t at = 0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        PathMiss miss{};
        miss_of_point(*problem.mechanism, problem.mechanism->form(design.assembly, problem.path->target_of(i)),
                      design.dimensions, angles[i], problem.path->points[i], miss);
        if (miss.margin >= least) continue;
        least = miss.margin;
        at = i;
    }
    margins.add("the mechanism assembles at " + point_name(*problem.path, at), least);
}

}  // namespace

std::vector<SingularMargin> singular_margins(const Problem& problem, const Design& design) {
    const Motion motion = motion_of(problem, design);
    Margins margins{longest_length(*problem.mechanism, design.dimensions)};
    if (!(margins.longest > 0) || !(motion.from <= motion.to)) return {};
    if (motion.full_turn && motion.family < problem.mechanism->families.size())
        add_conditions(*problem.mechanism, motion, design, margins);
    else if (!motion.full_turn)
        add_over_range(problem, motion, design, margins);
    add_points(problem, design, margins);
    return margins.found;
}

std::string to_text(const SingularMargin& margin, const Units& units) {
    if (margin.impossible) return margin.name;
    return fmt::format("{}: by {:.2g} {}, {:.2g} of the longest length", margin.name, margin.margin, units.length,
                       margin.relative);
}

}  // namespace mechwright
