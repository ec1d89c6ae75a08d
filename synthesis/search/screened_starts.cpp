#include "synthesis/search/screened_starts.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/search/path/path_timing.h"
#include "synthesis/search/starts.h"
#include "synthesis/target/path/fit.h"
#include "synthesis/target/path/rows/path_outputs.h"
#include "synthesis/target/path/rows/stretch.h"

namespace mechwright {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Shapes are drawn with lengths over this range, evenly in their logarithm.
constexpr double widest_ratio = 1e-2;
constexpr std::size_t shape_count = 2048;
/// A length whose range is narrower than by this factor says how large a linkage is: lengths are drawn in their ranges
/// then, where a size that is fitted to any proportions would leave them.
constexpr double narrow = 3;
/// Draws for one shape until the conditions of motion hold.
constexpr int most_draws = 60;
/// Where lengths or guided point are given, starts are drawn among so many for each variable: few variables are filled
/// by few.
constexpr int candidates_per_variable = 12;
/// Where few random designs close, for each start that is kept: draws go on until so many assemble, and end at so many.
constexpr int enough_assembled = 80;
constexpr int most_drawn = 4000;

bool is_free(const Program& program, std::size_t dimension) {
    return dimension != no_dimension && program.variable_of[dimension] >= 0;
}

}  // namespace

struct ScreenedStarts::Candidate {
    double score = unlimited;
    Lengths lengths{};
    int group = 0;
};

ScreenedStarts::ScreenedStarts(const Program& program, std::uint64_t seed)
    : program_(program),
      seed_(seed),
      stream_(program.variant.family * 16 + program.variant.assembly * 2 + (program.variant.direction > 0 ? 0 : 1) +
              1000) {
    const Mechanism& mechanism = *program.problem->mechanism;
    const PathRoles& roles = mechanism.point->roles;
    const auto& dimensions = mechanism.dimensions;
    const auto links = std::find_if(dimensions.begin(), dimensions.end(),
                                    [](const Dimension& d) { return d.kind != DimensionKind::length; });
    lengths_ = static_cast<std::size_t>(links - dimensions.begin());
    can_screen_ = mechanism.point->screening && !has_ties(*program.problem) && program.problem->path->parts.empty() &&
                  lengths_ <= most_lengths && is_free(program, roles.along) && is_free(program, roles.across);
    if (!can_screen_) return;
    free_.size = true;
    for (std::size_t i = 0; i < lengths_; ++i) {
        const bool free = is_free(program, i);
        const auto v = static_cast<std::size_t>(program.variable_of[i]);
        lower_[i] = free ? program.variables[v].lower : program.dimensions[i];
        upper_[i] = free ? program.variables[v].upper : program.dimensions[i];
        free_.size = free_.size && upper_[i] >= narrow * lower_[i];
    }
    free_.origin = is_free(program, roles.origin_x) && is_free(program, roles.origin_y);
    free_.tilt = is_free(program, roles.tilt);
    free_.tilted = {std::cos(program.dimensions[roles.tilt]), std::sin(program.dimensions[roles.tilt])};
    free_.body_length = program.problem->path->body_length / program.length;
    draw_shapes();
}

bool ScreenedStarts::meets_conditions(const Lengths& x) const {
    const Family& family = program_.problem->mechanism->families[program_.variant.family];
    return std::all_of(family.conditions.begin(), family.conditions.end(), [&](const LinearCondition& c) {
        double sum = 0;
        for (std::size_t i = 0; i < c.coefficients.size(); ++i)
            sum += c.coefficients[i] * x[i];
        return sum > 0;
    });
}

/// Lengths within their ranges, or any proportions of lengths where the size is fitted. Of the latter every second
/// shape is drawn by its margins to the limits of its motion, which reaches the shapes next to them: there many of the
/// best designs are.
void ScreenedStarts::draw_shapes() {
    const LowDiscrepancy sequence(lengths_, seed_, stream_ + 500);
    const std::optional<Eigen::MatrixXd> of_margins = free_.size ? lengths_of_margins() : std::nullopt;
    const auto n = static_cast<Index>(lengths_);
    std::uint64_t k = 0;
    shapes_.resize(shape_count);
    for (std::size_t shape = 0; shape < shape_count; ++shape) {
        Lengths& x = shapes_[shape];
        for (int tries = 0; tries < most_draws; ++tries) {
            ++k;
            for (std::size_t i = 0; i < lengths_; ++i) {
                const double high = free_.size ? 1 : upper_[i];
                const double low = free_.size ? widest_ratio : std::max(lower_[i], widest_ratio * high);
                x[i] = low < high ? low * std::pow(high / low, sequence(k, i)) : high;
            }
            if (of_margins && shape % 2 == 1) {
                const VectorXd lengths = *of_margins * Eigen::Map<const VectorXd>(x.data(), n);
                std::copy_n(lengths.data(), lengths_, x.begin());
            }
            if (meets_conditions(x)) break;
        }
    }
}

/// The lengths as linear functions of one length and the margins of the conditions of motion, where those are as many
/// as it takes: the length is the one that every condition wants short.
std::optional<Eigen::MatrixXd> ScreenedStarts::lengths_of_margins() const {
    const Family& family = program_.problem->mechanism->families[program_.variant.family];
    if (family.conditions.size() + 1 != lengths_) return std::nullopt;
    const auto n = static_cast<Index>(lengths_);
    Eigen::MatrixXd margins = Eigen::MatrixXd::Zero(n, n);
    for (Index shortest = 0; shortest < n; ++shortest) {
        const auto wants_short = [&](const LinearCondition& c) {
            return c.coefficients[static_cast<std::size_t>(shortest)] < 0;
        };
        if (!std::all_of(family.conditions.begin(), family.conditions.end(), wants_short)) continue;
        margins(0, shortest) = 1;
        for (Index r = 1; r < n; ++r)
            for (Index i = 0; i < n; ++i)
                margins(r, i) =
                    family.conditions[static_cast<std::size_t>(r - 1)].coefficients[static_cast<std::size_t>(i)];
        return margins.inverse();
    }
    return std::nullopt;
}

/// The greatest factor by which a length leaves its range at the fitted size.
double ScreenedStarts::beyond_range(const Lengths& x, double size) const {
    double worst = 1;
    for (std::size_t i = 0; i < lengths_; ++i)
        worst = std::max({worst, size * x[i] / upper_[i], lower_[i] / (size * x[i])});
    return worst;
}

std::vector<ScreenedPoint> ScreenedStarts::points() const {
    const PathRoles& roles = program_.problem->mechanism->point->roles;
    const Vector<double> origin =
        free_.origin ? Vector<double>{0, 0}
                     : Vector<double>{program_.dimensions[roles.origin_x], program_.dimensions[roles.origin_y]};
    std::vector<ScreenedPoint> all;
    const PathTarget& path = *program_.problem->path;
    for (std::size_t i = 0; i < program_.targets.size(); ++i) {
        all.push_back({program_.targets[i] - origin, path.weights[i], {1, 0}});
        if (path.faces(i))
            all.back().facing = {std::cos(path.directions[i]), std::sin(path.directions[i])};
        else if (path.guides_body())
            all.back().facing = {0, 0};
    }
    return all;
}

/// Variables that are drawn and not fitted.
int ScreenedStarts::random_variables() const {
    const PathRoles& roles = program_.problem->mechanism->point->roles;
    const auto fitted = [&](std::size_t i, std::size_t j) {
        return is_free(program_, i) && is_free(program_, j) ? 2 : 0;
    };
    return static_cast<int>(program_.size()) - fitted(roles.origin_x, roles.origin_y) -
           fitted(roles.along, roles.across);
}

/// Whether a start stays assembled from the first to the last target.
bool ScreenedStarts::stays_assembled(const VectorXd& x) const {
    const QuantityBlock* block = stretch_block(program_);
    if (block == nullptr) return true;
    Outputs out;
    out.value.setZero(static_cast<Index>(program_.outputs));
    set_dimensions(program_, x, out.dimensions);
    evaluate_block(program_, *block, x, false, out);
    return out.value.segment(static_cast<Index>(block->first), static_cast<Index>(block->count)).minCoeff() >= 0;
}

std::vector<VectorXd> ScreenedStarts::one_by_one(int round, int groups, int keep, DrawCounts& counts) const {
    if (program_.problem->mechanism->families[program_.variant.family].assembly_margin)
        return DrawnStarts(program_, seed_).of_round(round, keep, enough_assembled, most_drawn, counts);
    std::vector<VectorXd> starts;
    const int candidates = std::min(groups, 1 + candidates_per_variable * random_variables());
    for (int i = 0; i < keep; ++i) {
        Start start = screened_start(program_, seed_, round * keep + i, candidates);
        counts += start.counts;
        counts.preferred += start.preferred ? 1 : 0;
        starts.push_back(std::move(start.x));
    }
    return starts;
}

std::vector<VectorXd> ScreenedStarts::of_round(int round, int groups, int keep, DrawCounts& counts) const {
    if (!can_screen_) return one_by_one(round, groups, keep, counts);
    std::vector<VectorXd> starts;
    counts.drawn += 8L * groups;
    const LowDiscrepancy of_timing(path_timing_numbers, seed_, stream_);
    const InstructionSet set = widest_instruction_set();
    const auto first = static_cast<std::uint64_t>(round) * static_cast<std::uint64_t>(groups);
    const auto group_number = [&](int g) { return first + static_cast<std::uint64_t>(g); };
    std::vector<ScreenedPoint> targets = points();
    std::vector<Candidate> best(static_cast<std::size_t>(groups));
    VectorXd x = VectorXd::Zero(static_cast<Index>(program_.size()));
    for (int g = 0; g < groups; ++g) {
        const std::vector<double> angles = random_path_angles(program_, of_timing, group_number(g), x);
        for (std::size_t i = 0; i < targets.size(); ++i)
            targets[i].half = {std::cos(angles[i] / 2), std::sin(angles[i] / 2)};
        std::array<Group, most_lengths> lengths{};
        const auto shape = [&](std::size_t lane) -> const Lengths& {
            return shapes_[mixed(group_number(g) * 8 + lane) % shape_count];
        };
        for (std::size_t lane = 0; lane < 8; ++lane)
            for (std::size_t i = 0; i < lengths_; ++i)
                lengths[i][lane] = shape(lane)[i];
        const Screened screened = program_.problem->mechanism->point->screening(
            set, program_.variant.assembly, std::span(lengths).first(lengths_), targets, free_);
        Candidate& kept = best[static_cast<std::size_t>(g)];
        kept.group = g;
        for (std::size_t lane = 0; lane < 8; ++lane) {
            const double size = screened.size[lane];
            const double beyond = beyond_range(shape(lane), size);
            const double score = screened.score[lane] * beyond * beyond;
            if (screened.score[lane] < unlimited) ++counts.assembled;
            if (!(score < kept.score)) continue;
            kept.score = score;
            for (std::size_t i = 0; i < lengths_; ++i)
                kept.lengths[i] = shape(lane)[i] * size;
        }
    }
    std::stable_sort(best.begin(), best.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score < b.score; });
    for (const Candidate& c : best) {
        if (static_cast<int>(starts.size()) >= keep || !(c.score < unlimited)) break;
        x = program_.reference;
        random_path_angles(program_, of_timing, group_number(c.group), x);
        for (std::size_t i = 0; i < lengths_; ++i)
            if (is_free(program_, i)) x[program_.variable_of[i]] = std::clamp(c.lengths[i], lower_[i], upper_[i]);
        fit_placement(program_, x);
        if (stays_assembled(x)) starts.push_back(x);
    }
    return starts;
}

}  // namespace mechwright
