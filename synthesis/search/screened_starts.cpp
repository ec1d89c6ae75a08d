#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "synthesis/search/low_discrepancy.h"
#include "synthesis/search/path_timing.h"
#include "synthesis/search/starts.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t most_lengths = 8;
/// Shapes are drawn with lengths over this range, evenly in their logarithm.
constexpr double widest_ratio = 1e-2;
/// Draws for one candidate until the conditions of motion hold.
constexpr int most_draws = 60;
/// Score is multiplied by this power of the factor by which a length leaves its range.
constexpr double beyond_range_weight = 2;

struct Candidate {
    double score = unlimited;
    std::array<double, most_lengths> lengths{};
    int group = 0;
};

/// How a program's candidates are drawn: lengths first, then what the crank angles depend on.
struct Sampler {
    const Program& program;
    std::size_t lengths;
    PathFreedom free;
    std::array<double, most_lengths> lower{};
    std::array<double, most_lengths> upper{};

    explicit Sampler(const Program& p) : program(p), lengths(0), free{} {
        const Problem& problem = *p.problem;
        const auto& kinds = problem.mechanism->dimensions;
        const PathRoles& roles = problem.mechanism->path_roles;
        const auto is_free = [&](std::size_t i) { return p.variable_of[i] >= 0; };
        free.size = true;
        while (lengths < kinds.size() && kinds[lengths].kind == DimensionKind::length) {
            const auto i = lengths++;
            free.size = free.size && is_free(i);
            const double fixed = p.dimensions[i];
            const auto v = static_cast<std::size_t>(p.variable_of[i]);
            lower[i] = is_free(i) ? p.variables[v].lower : fixed;
            upper[i] = is_free(i) ? p.variables[v].upper : fixed;
        }
        free.origin = is_free(roles.origin_x) && is_free(roles.origin_y);
        free.tilt = is_free(roles.tilt);
        free.tilted = {std::cos(p.dimensions[roles.tilt]), std::sin(p.dimensions[roles.tilt])};
    }

    bool meets_conditions(const std::array<double, most_lengths>& x) const {
        const Family& family = program.problem->mechanism->families[program.variant.family];
        return std::all_of(family.conditions.begin(), family.conditions.end(), [&](const LinearCondition& c) {
            double sum = 0;
            for (std::size_t i = 0; i < c.coefficients.size(); ++i)
                sum += c.coefficients[i] * x[i];
            return sum > 0;
        });
    }

    /// Lengths within their ranges, or any proportions of lengths where the size is fitted.
    std::array<double, most_lengths> drawn(const LowDiscrepancy& sequence, std::uint64_t k) const {
        std::array<double, most_lengths> x{};
        for (std::size_t i = 0; i < lengths; ++i) {
            const double high = free.size ? 1 : upper[i];
            const double low = free.size ? widest_ratio : std::max(lower[i], widest_ratio * high);
            x[i] = low < high ? low * std::pow(high / low, sequence(k, i)) : high;
        }
        return x;
    }

    /// The greatest factor by which a length leaves its range at the fitted size.
    double beyond_range(const Candidate& c, double size) const {
        double worst = 1;
        for (std::size_t i = 0; i < lengths; ++i) {
            const double length = size * c.lengths[i];
            worst = std::max({worst, length / upper[i], lower[i] / length});
        }
        return worst;
    }
};

bool can_be_screened(const Program& program) {
    const Mechanism& mechanism = *program.problem->mechanism;
    return mechanism.path_screening && program.variable_of[mechanism.path_roles.along] >= 0 &&
           program.variable_of[mechanism.path_roles.across] >= 0;
}

}  // namespace

std::vector<VectorXd> screened_starts(const Program& program, std::uint64_t seed, int round, int groups, int keep) {
    std::vector<VectorXd> starts;
    if (!can_be_screened(program)) {
        for (int i = 0; i < keep; ++i)
            starts.push_back(start_point(program, seed, round * keep + i, groups));
        return starts;
    }
    const Problem& problem = *program.problem;
    const PathRoles& roles = problem.mechanism->path_roles;
    const Sampler sampler(program);
    const std::uint64_t stream =
        program.variant.family * 16 + program.variant.assembly * 2 + (program.variant.direction > 0 ? 0 : 1) + 1000;
    const LowDiscrepancy of_timing(path_timing_numbers, seed, stream);
    const LowDiscrepancy of_lengths(sampler.lengths, seed, stream + 500);
    const InstructionSet set = widest_instruction_set();

    std::vector<ScreenedPoint> points(program.targets.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].target = program.targets[i];
        if (!sampler.free.origin)
            points[i].target = points[i].target -
                               Vector<double>{program.dimensions[roles.origin_x], program.dimensions[roles.origin_y]};
        points[i].weight = problem.path->weights[i];
    }
    std::uint64_t draw = static_cast<std::uint64_t>(round) * static_cast<std::uint64_t>(groups) * 8 * most_draws;
    std::vector<Candidate> best(static_cast<std::size_t>(groups));
    VectorXd x = VectorXd::Zero(static_cast<Index>(program.size()));
    for (int g = 0; g < groups; ++g) {
        const auto number =
            static_cast<std::uint64_t>(round) * static_cast<std::uint64_t>(groups) + static_cast<std::uint64_t>(g);
        const std::vector<double> angles = drawn_path_angles(program, of_timing, number, x);
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i].half = {std::cos(angles[i] / 2), std::sin(angles[i] / 2)};
        std::array<Candidate, 8> candidates;
        std::array<Group, most_lengths> in_lanes{};
        for (std::size_t lane = 0; lane < candidates.size(); ++lane) {
            for (int tries = 0; tries < most_draws; ++tries) {
                candidates[lane].lengths = sampler.drawn(of_lengths, draw++);
                if (sampler.meets_conditions(candidates[lane].lengths)) break;
            }
            for (std::size_t i = 0; i < sampler.lengths; ++i)
                in_lanes[i][lane] = candidates[lane].lengths[i];
        }
        const Screened screened = problem.mechanism->path_screening(
            set, program.variant.assembly, std::span(in_lanes).first(sampler.lengths), points, sampler.free);
        Candidate& kept = best[static_cast<std::size_t>(g)];
        kept.group = g;
        for (std::size_t lane = 0; lane < candidates.size(); ++lane) {
            const double beyond = sampler.beyond_range(candidates[lane], screened.size[lane]);
            const double score = screened.score[lane] * std::pow(beyond, beyond_range_weight);
            if (!(score < kept.score)) continue;
            kept.score = score;
            for (std::size_t i = 0; i < sampler.lengths; ++i)
                kept.lengths[i] = candidates[lane].lengths[i] * screened.size[lane];
        }
    }
    std::stable_sort(best.begin(), best.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score < b.score; });
    for (const Candidate& c : best) {
        if (static_cast<int>(starts.size()) >= keep || !(c.score < unlimited)) break;
        const auto number = static_cast<std::uint64_t>(round) * static_cast<std::uint64_t>(groups) +
                            static_cast<std::uint64_t>(c.group);
        x = program.reference;
        drawn_path_angles(program, of_timing, number, x);
        for (std::size_t i = 0; i < sampler.lengths; ++i)
            if (program.variable_of[i] >= 0)
                x[program.variable_of[i]] = std::clamp(c.lengths[i], sampler.lower[i], sampler.upper[i]);
        fit_placement(program, x);
        starts.push_back(x);
    }
    return starts;
}

}  // namespace mechwright
