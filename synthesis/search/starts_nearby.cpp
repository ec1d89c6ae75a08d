#include "synthesis/search/starts_nearby.h"

#include <cmath>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/search/starts.h"
#include "synthesis/target/path/fit.h"

namespace mechwright {

Eigen::VectorXd start_nearby(const Program& program, Eigen::VectorXd x, double spread, std::uint64_t seed) {
    const auto way = [&] {  // from -spread to spread
        seed = mixed(seed);
        return spread * (std::ldexp(static_cast<double>(seed >> 11), -52) - 1);
    };
    const auto& kinds = program.problem->mechanism->dimensions;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const std::ptrdiff_t v = program.variable_of[i];
        if (v < 0) continue;
        if (kinds[i].kind == DimensionKind::length)
            x[v] *= std::exp(way());
        else
            x[v] += way();
    }
    if (program.untimed_path()) {
        // The points are met a little earlier or later, all by the same and each a little more than the one before.
        const PathTarget& path = *program.problem->path;
        for (std::size_t target = 0; target < path.targets(); ++target) {
            const PointRange points = path.points_of(target);
            const double shift = way(), stretch = way();
            const auto n = static_cast<double>(points.count);
            for (std::size_t i = 0; i < points.count; ++i)
                x[static_cast<Eigen::Index>(program.first_path_angle + points.first + i)] +=
                    shift + program.variant.direction * stretch * static_cast<double>(i) / n;
        }
    }
    x = within_bounds(program, std::move(x));
    fit_placement(program, x);
    settle_epigraphs(program, x);
    return x;
}

}  // namespace mechwright
