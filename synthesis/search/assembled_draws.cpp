#include "synthesis/search/assembled_draws.h"

#include <algorithm>
#include <array>

#include "synthesis/mechanism/linkage/targets/margins_in_lanes.h"
#include "synthesis/target/path/fit.h"
#include "synthesis/target/path/rows/path_outputs.h"

namespace mechwright {

namespace {

constexpr std::size_t of_group = std::tuple_size_v<Group>;

/// A draw as its dimensions.
struct DrawnDimensions {
    std::size_t draw;
    std::vector<double> dimensions;
};

/// The margins of so many candidates from one on at a target; lanes that are left over repeat the last of them.
Group margins_of(const Program& program, const std::vector<NumberedDraw>& draws, const DrawnDimensions* first,
                 std::size_t count, std::size_t target) {
    const PointGuidance& point = *program.problem->mechanism->point;
    std::array<Group, Reads::most> arguments;
    Group angles;
    std::array<double, Reads::most> room;
    std::size_t reads = 0;
    for (std::size_t lane = 0; lane < of_group; ++lane) {
        const DrawnDimensions& drawn = first[std::min(lane, count - 1)];
        const std::span<const double> own = point.reads.of(drawn.dimensions, room);
        reads = own.size();
        for (std::size_t i = 0; i < reads; ++i)
            arguments[i][lane] = own[i];
        angles[lane] = path_angle(program, drawn.dimensions, draws[drawn.draw].x, target).angle;
    }
    const std::size_t guided = program.problem->path->target_of(target);
    return margins_in_lanes(widest_instruction_set(), program.form(guided), std::span(arguments).first(reads), angles);
}

/// Leaves out those that do not assemble at a target.
void keep_assembled_at(const Program& program, const std::vector<NumberedDraw>& draws, std::size_t target,
                       std::vector<DrawnDimensions>& left) {
    std::size_t kept = 0;
    for (std::size_t first = 0; first < left.size(); first += of_group) {
        const std::size_t count = std::min(of_group, left.size() - first);
        const Group margins = margins_of(program, draws, left.data() + first, count, target);
        for (std::size_t lane = 0; lane < count; ++lane) {
            if (margins[lane] < 0) continue;
            if (kept != first + lane) left[kept] = std::move(left[first + lane]);
            ++kept;
        }
    }
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(kept), left.end());
}

}  // namespace

void keep_assembled(const Program& program, std::vector<NumberedDraw>& draws) {
    if (!has_margins_in_lanes(*program.problem->mechanism)) return;
    std::vector<DrawnDimensions> left;
    left.reserve(draws.size());
    for (std::size_t i = 0; i < draws.size(); ++i)
        left.push_back({i, dimensions_at(program, draws[i].x)});
    for (const std::size_t target : spread_out(program.targets.size())) {
        if (left.empty()) break;
        keep_assembled_at(program, draws, target, left);
    }
    for (std::size_t k = 0; k < left.size(); ++k)
        if (left[k].draw != k) draws[k] = std::move(draws[left[k].draw]);
    draws.erase(draws.begin() + static_cast<std::ptrdiff_t>(left.size()), draws.end());
}

}  // namespace mechwright
