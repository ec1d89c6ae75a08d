#include "synthesis/search/draws.h"

#include <algorithm>
#include <cmath>

#include "synthesis/search/path/path_timing.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Lengths are sampled evenly in their logarithm over at most this part of their greatest value.
constexpr double least_part_of_limit = 1e-3;

/// A value of variable v at the fraction u of its range.
double sampled(const Variable& v, DimensionKind kind, double u) {
    if (kind != DimensionKind::length) return v.lower + u * (v.upper - v.lower);
    const double low = std::max(v.lower, least_part_of_limit * v.upper);
    return low * std::pow(v.upper / low, u);
}

/// Of each dimension its coordinate of random starts: where it stands among the mechanism's dimensions and the numbers
/// of all targets, so that a start does not depend on which targets a problem has.
std::vector<std::size_t> coordinates_of_starts(const Mechanism& mechanism) {
    std::vector<std::size_t> all;
    for (const Dimension& dimension : mechanism.dimensions)
        all.push_back(static_cast<std::size_t>(find_dimension(whole_of(mechanism), dimension.name)));
    return all;
}

}  // namespace

Draws::Draws(const Program& program, std::uint64_t seed)
    : program_(program),
      coordinates_(coordinates_of_starts(*program.problem->mechanism)),
      timing_(whole_of(*program.problem->mechanism).dimensions.size()),
      sequence_(timing_ + 2, seed, program.variant.family * 16 + program.variant.assembly) {}

VectorXd Draws::operator()(std::uint64_t k) const {
    VectorXd x = VectorXd::Zero(static_cast<Index>(program_.size()));
    const auto& dimensions = program_.problem->mechanism->dimensions;
    for (std::size_t i = 0; i < program_.variable_of.size(); ++i)
        if (const std::ptrdiff_t v = program_.variable_of[i]; v >= 0)
            x[v] = sampled(program_.variables[static_cast<std::size_t>(v)], dimensions[i].kind,
                           sequence_(k, coordinates_[i]));
    if (program_.untimed_path()) set_path_angles(program_, sequence_(k, timing_), sequence_(k, timing_ + 1), x);
    return x;
}

void add_counts(SearchReport& report, const DrawCounts& counts, long StartSources::*source) {
    report.drawn += counts.drawn;
    report.assembled += counts.assembled;
    report.optimised += counts.optimised;
    report.sources.preferred += counts.preferred;
    report.sources.*source += counts.optimised - counts.preferred;
}

double linear_violation(const Program& program, const VectorXd& x) {
    double sum = 0;
    for (const Row& row : program.rows) {
        if (!row.form.outputs.empty()) continue;
        double c = row.form.constant;
        for (const LinearTerm& t : row.form.variables)
            c += t.factor * x[static_cast<Index>(t.index)];
        sum += std::max({0.0, row.lower - c, c - row.upper});
    }
    return sum;
}

void set_path_angles(const Program& program, double start, double span, VectorXd& x) {
    const std::vector<double> angles = path_angles(program, {start, span, 0.5, 0, 0});
    for (std::size_t i = 0; i < angles.size(); ++i)
        x[static_cast<Index>(program.first_path_angle + i)] = angles[i];
}

}  // namespace mechwright
