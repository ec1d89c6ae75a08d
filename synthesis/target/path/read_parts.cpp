#include "synthesis/target/path/read_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace mechwright {

void add_part(PathTarget& whole, PathTarget alone, std::string name, double weight) {
    const std::size_t before = whole.points.size(), count = alone.points.size();
    const bool guides_body = alone.guides_body();
    constexpr double any_direction = std::numeric_limits<double>::quiet_NaN();
    if (guides_body || whole.guides_body()) {
        whole.directions.resize(before, any_direction);
        alone.directions.resize(count, any_direction);
    }
    const auto append = [](auto& all, const auto& some) { all.insert(all.end(), some.begin(), some.end()); };
    append(whole.points, alone.points);
    append(whole.directions, alone.directions);
    append(whole.crank_angles, alone.crank_angles);
    whole.prescribed_timing = alone.prescribed_timing;
    whole.any_order = alone.any_order;
    whole.closed = whole.closed || alone.closed;
    whole.body_length = std::max(whole.body_length, alone.body_length);
    const double sum = std::accumulate(alone.weights.begin(), alone.weights.end(), 0.0);
    for (const double w : alone.weights)
        whole.weights.push_back(weight * w / sum);
    whole.part_of.resize(before + count, whole.parts.size());
    whole.parts.push_back({std::move(name),
                           weight,
                           {before, count},
                           std::move(alone.weights),
                           alone.closed,
                           guides_body,
                           alone.body_length});
}

std::string point_name(const PathTarget& path, std::size_t point) {
    if (path.parts.empty()) return fmt::format("point {}", point + 1);
    const PathPart& part = path.parts[path.part_of[point]];
    return fmt::format("point {} of '{}'", point - part.points.first + 1, part.name);
}

std::string_view timing_word(const PathTarget& path) {
    return path.prescribed_timing ? "prescribed" : path.any_order ? "none" : "free";
}

}  // namespace mechwright
