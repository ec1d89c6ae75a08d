#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "synthesis/problem/bytes.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

bool is_wrong(const Vector<double>& point) { return std::isnan(point.x); }

std::optional<Vector<double>> to_point(const toml::node& node, std::size_t number, Messages& messages) {
    const std::string what = fmt::format("point {}", number);
    if (!node.is_array()) {
        report_kind(node, what, "a pair [x, y]", messages);
        return {};
    }
    const toml::array& pair = *node.as_array();
    if (pair.size() != 2) {
        add_error(messages, place_of(node), fmt::format("{} must be a pair [x, y], not {} values", what, pair.size()));
        return {};
    }
    const auto x = to_number(pair[0], "x of " + what, messages);
    const auto y = to_number(pair[1], "y of " + what, messages);
    if (!x || !y) return {};
    return Vector<double>{*x, *y};
}

void read_inline_points(const toml::node& node, PointList& list, Messages& messages) {
    list.named_at = place_of(node);
    if (!node.is_array()) return report_kind(node, "'points' in [path]", "a list of pairs [x, y]", messages);
    const toml::array& points = *node.as_array();
    if (points.size() > most_points)
        return add_error(
            messages, list.named_at,
            fmt::format("{} points are too many: thin the list to at most {}", points.size(), most_points));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto point = to_point(points[i], i + 1, messages);
        add_point(list, point, place_of(points[i]));
    }
    list.whole = std::none_of(list.points.begin(), list.points.end(), is_wrong);
}

void read_named_file(Section& path, const toml::node& node, const Problem& problem, PointList& list,
                     Messages& messages) {
    constexpr std::size_t most_bytes = 64 << 20;
    constexpr std::size_t longest_name = 4096;
    list.named_at = place_of(node);
    const auto name = read_string(path, "points_file", messages);
    if (!name) return;
    if (name->empty()) return add_error(messages, list.named_at, "'points_file' in [path] is empty: name a file");
    const std::string file = (std::filesystem::path(problem.file).parent_path() / *name).string();
    list.file = printable(file, longest_name);
    const Bytes read = read_bytes(file, most_bytes, false);
    messages.unreadable |= read.unreadable;
    if (!read.failure.empty()) return add_point_error(list, {0, 0}, read.failure, messages);
    if (const auto bad = find_bad_text(read.bytes))
        return add_point_error(list, bad->place, std::string(bad->why), messages);
    messages.named_files.push_back({*name, sha256(read.bytes)});
    read_point_table(read.bytes, list, messages);
}

void check_points(PointList& list, Messages& messages) {
    if (list.points.empty()) {
        if (!list.whole) return;  // something has been said about it
        add_point_error(list, list.file.empty() ? list.named_at : FilePlace{},
                        "empty point list: a path needs at least one point", messages);
        list.whole = false;
    }
    for (std::size_t i = 1; i < list.points.size(); ++i) {
        const Vector<double> step = list.points[i] - list.points[i - 1];
        if (step.x != 0 || step.y != 0) continue;
        add_point_error(list, list.places[i], fmt::format("points {} and {} coincide: leave one of them out", i, i + 1),
                        messages);
    }
}

}  // namespace

void add_point(PointList& list, const std::optional<Vector<double>>& point, FilePlace place) {
    constexpr double wrong = std::numeric_limits<double>::quiet_NaN();
    list.points.push_back(point.value_or(Vector<double>{wrong, wrong}));
    list.places.push_back(place);
}

void add_point_error(const PointList& list, FilePlace place, std::string text, Messages& messages) {
    if (list.file.empty())
        add_error(messages, place, std::move(text));
    else
        add_error_elsewhere(messages, list.named_at, list.file, place, std::move(text));
}

PointList read_points(Section& path, const Problem& problem, Messages& messages) {
    PointList list;
    const toml::node* points = find(path, "points");
    const toml::node* file = find(path, "points_file");
    if (points != nullptr && file != nullptr)
        add_error(messages, place_of(*file), "a path takes either 'points' or 'points_file', not both");
    if (points != nullptr)
        read_inline_points(*points, list, messages);
    else if (file != nullptr)
        read_named_file(path, *file, problem, list, messages);
    else
        add_error(messages, path.place, "a path needs 'points', a list of pairs [x, y], or a 'points_file'");
    check_points(list, messages);
    return list;
}

}  // namespace mechwright::reading
