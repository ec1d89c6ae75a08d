#include <algorithm>
#include <cmath>

#include "synthesis/program/program.h"

namespace mechwright {

namespace {

bool has_limits_along_normals(const Program& program) {
    // Of several targets each may have a limit of its own.
    return program.path && program.path->squares && program.untimed_path() && residuals_per_point(program) == 2 &&
           program.problem->path->parts.empty();
}

/// Takes the limits on squared distances out of the rows: the least one, as a distance, or nothing where not every
/// point has one.
std::optional<double> take_limit(Program& program) {
    const std::size_t first = *program.path->squares;
    const std::size_t points = program.targets.size();
    double least = unlimited;
    const std::size_t taken = std::erase_if(program.rows, [&](const Row& row) {
        if (!row.requirement || row.form.outputs.size() != 1) return false;
        const LinearTerm& output = row.form.outputs.front();
        if (output.index < first || output.index >= first + points) return false;
        least = std::min(least, std::sqrt(row.upper / output.factor));
        return true;
    });
    if (taken < points) return std::nullopt;
    return least;
}

}  // namespace

std::optional<Program> met_along_normals(const Program& limited, const Eigen::VectorXd& x) {
    if (!has_limits_along_normals(limited)) return std::nullopt;
    Program program = limited;
    const std::optional<double> limit = take_limit(program);
    if (!limit) return std::nullopt;
    program.path->misses = program.outputs;
    program.outputs += 2 * program.targets.size();
    ProgramValues values;
    evaluate(program, x, true, values);
    if (!values.assembled) return std::nullopt;
    for (std::size_t i = 0; i < program.targets.size(); ++i) {
        const std::size_t miss = *program.path->misses + 2 * i;
        const auto row = static_cast<Eigen::Index>(miss);
        const auto angle = static_cast<Eigen::Index>(program.first_path_angle + i);
        const double by_x = values.outputs.jacobian(row, angle), by_y = values.outputs.jacobian(row + 1, angle);
        const double speed = std::hypot(by_x, by_y);
        if (!(speed > 0)) return std::nullopt;
        const double along_x = by_x / speed, along_y = by_y / speed;
        const std::string point = std::to_string(i + 1);
        program.rows.push_back(
            {"miss along the curve at point " + point, {{{miss, along_x}, {miss + 1, along_y}}, {}}, 0, 0, true});
        program.rows.push_back({"miss along the normal at point " + point,
                                {{{miss, -along_y}, {miss + 1, along_x}}, {}},
                                -*limit,
                                *limit,
                                true});
    }
    return program;
}

}  // namespace mechwright
