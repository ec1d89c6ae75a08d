#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/mechanism/cycle.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/target/path/read_parts.h"

namespace mechwright::reading {

namespace {

constexpr std::size_t most_free_points = 200;

/// A list that goes with the points must have as many entries.
bool same_length(const Section& path, std::string_view key, std::size_t length, const PointList& list,
                 Messages& messages) {
    if (!list.whole || length == list.points.size()) return true;
    add_error(messages, place_of(path, key),
              fmt::format("{} has {} numbers for {} points: give one for each point", name_of(path, key), length,
                          list.points.size()));
    return false;
}

FilePlace element_place(const Section& path, std::string_view key, std::size_t i) {
    return place_of((*path.table->get_as<toml::array>(key))[i]);
}

std::vector<double> read_weights(Section& path, const PointList& list, Messages& messages) {
    const auto weights = read_numbers(path, "weights", messages);
    std::vector<double> even(list.points.size(), 1.0);
    if (!weights) return even;
    same_length(path, "weights", weights->size(), list, messages);
    for (std::size_t i = 0; i < weights->size(); ++i)
        if ((*weights)[i] <= 0)
            add_error(messages, element_place(path, "weights", i),
                      fmt::format("the weight of point {} must be greater than 0, not {}", i + 1, (*weights)[i]));
    return *weights;
}

/// Whether the problem's mechanism is one that a slide drives: crank angles then are its displacements.
bool is_driven_by_slide(const Problem& problem) {
    return problem.mechanism != nullptr && !comes_round(*problem.mechanism);
}

/// The mechanism passes the points in one direction; false where it does not.
bool check_order(const Section& path, const std::vector<double>& angles, Messages& messages) {
    if (angles.size() < 2) return true;
    const bool rising = angles[1] > angles[0];
    for (std::size_t i = 1; i < angles.size(); ++i) {
        const bool follows = rising ? angles[i] > angles[i - 1] : angles[i] < angles[i - 1];
        if (follows) continue;
        add_error(messages, element_place(path, "crank_angles", i),
                  fmt::format("crank angle {} ({}) breaks the order: crank_angles must all rise or all fall", i + 1,
                              angles[i]));
        return false;
    }
    return true;
}

/// It passes them in one turn, or as many as its cycle has.
void check_turns(const Section& path, const std::vector<double>& angles, double turn, int turns, Messages& messages) {
    if (angles.size() > 1 && std::abs(angles.back() - angles.front()) > turns * turn)
        add_error(messages, place_of(path, "crank_angles"),
                  fmt::format("crank_angles go from {} to {}: they must stay within {}", angles.front(), angles.back(),
                              turns == 1 ? "one full turn" : fmt::format("{} turns", turns)));
}

std::vector<double> read_crank_angles(Section& path, const Problem& problem, const PointList& list,
                                      Messages& messages) {
    const Units& units = problem.units;
    if (!has(path, "crank_angles"))
        add_error(messages, place_of(path, "timing"),
                  "timing = \"prescribed\" needs 'crank_angles', one for each point");
    auto angles = read_numbers(path, "crank_angles", messages);
    if (!angles) return {};
    same_length(path, "crank_angles", angles->size(), list, messages);
    const bool ordered = check_order(path, *angles, messages);
    if (is_driven_by_slide(problem)) return *angles;
    if (ordered)
        check_turns(path, *angles, full_turn(units), problem.mechanism ? turns_of_cycle(*problem.mechanism) : 1,
                    messages);
    for (double& angle : *angles)
        angle = to_radians(units, angle);
    return *angles;
}

/// Each freely timed point brings a variable of its own.
void check_free_timing(Section& path, const PointList& list, Messages& messages) {
    if (const toml::node* angles = find(path, "crank_angles"); angles != nullptr)
        add_error(messages, place_of(*angles),
                  fmt::format("'crank_angles' in {} need timing = \"prescribed\"; with any other leave them out",
                              path.title));
    if (list.points.size() > most_free_points)
        add_error(messages, list.named_at,
                  fmt::format("{} points are too many for free timing: thin the list to at most {}, or prescribe the "
                              "timing",
                              list.points.size(), most_free_points));
}

}  // namespace

namespace {

/// What a target says of its own where the file names its point: the point and its link, its name and its weight, which
/// are known already, and the numbers that else are dimensions of the mechanism.
void read_named_point(Section& target, std::size_t number, Problem& problem, Messages& messages) {
    if (problem.mechanism == nullptr || !problem.mechanism->point->named) return;
    for (const char* key : {"point", "link", "name", "weight"})
        find(target, key);
    const auto& dimensions = problem.mechanism->dimensions;
    const PathRoles& roles = problem.mechanism->roles_of(number);
    for (const auto& [key, i] : {std::pair("crank-start", roles.start), {"body-angle", roles.body}}) {
        if (i == no_dimension || find_key(target.known, key) == nullptr) continue;
        const toml::node* node = find(target, key);
        if (node == nullptr) continue;
        if (const auto range = to_dimension(*node, dimensions[i], problem.units, messages))
            problem.dimensions[i] = *range;
    }
}

/// A target beside those that were read: all points have one timing, for they are met in one motion.
void add_target(PathTarget&& target, const Section& section, Problem& problem, Messages& messages) {
    if (problem.mechanism == nullptr || problem.mechanism->guided.empty()) {
        problem.path = std::move(target);
        return;
    }
    const std::size_t number = problem.path ? problem.path->parts.size() : 0;
    if (number >= problem.mechanism->guided.size()) return;
    if (!problem.path) problem.path.emplace();
    PathTarget& whole = *problem.path;
    if (number > 0 && timing_word(whole) != timing_word(target))
        add_error(messages, place_of(section, "timing"),
                  fmt::format("{} has timing = \"{}\", and '{}' has \"{}\": give all paths and poses of a problem one "
                              "timing",
                              section.title, timing_word(target), whole.parts.front().name, timing_word(whole)));
    if (!target.prescribed_timing && whole.points.size() + target.points.size() > most_free_points)
        add_error(messages, section.place,
                  fmt::format("{} points of all paths and poses are too many for any timing but a prescribed one: thin "
                              "their lists to at most {}",
                              whole.points.size() + target.points.size(), most_free_points));
    const double weight = section.table->get("weight") ? (*section.table)["weight"].value<double>().value_or(1) : 1;
    add_part(whole, std::move(target), problem.mechanism->guided[number].name, weight > 0 ? weight : 1);
}

/// The number of the target that is read next.
std::size_t next_target(const Problem& problem) { return problem.path ? problem.path->parts.size() : 0; }

/// Whether a mechanism without points of names in files can have so many targets; says so where it cannot.
bool is_one_target(const std::vector<Section>& sections, const Problem& problem, Messages& messages) {
    const bool named = problem.mechanism != nullptr && problem.mechanism->point && problem.mechanism->point->named;
    if (named || sections.size() < 2) return true;
    add_error(
        messages, sections[1].place,
        fmt::format("a {} has one path or poses in this version: leave {} out, or describe the mechanism by its "
                    "links, mechanism = \"linkage\", whose points and bodies may have several ('mechwright expand' "
                    "writes it so)",
                    problem.mechanism == nullptr ? "mechanism" : problem.mechanism->name, sections[1].title));
    return false;
}

/// Displacements that are counted from where the file says are on the stroke of the slide that drives.
void check_stroke(const Section& target, const PathTarget& path, std::size_t number, const Problem& problem,
                  Messages& messages) {
    if (!path.prescribed_timing || path.crank_angles.empty() || !is_driven_by_slide(problem)) return;
    const DimensionRange& start = problem.dimensions[problem.mechanism->roles_of(number).start];
    const auto reach = reach_of_input(*problem.mechanism);
    if (!start.fixed() || !reach) return;
    for (const double displacement : path.crank_angles) {
        const double at = start.min + displacement;
        if (at >= (*reach)[0] && at <= (*reach)[1]) continue;
        return add_error(
            messages, place_of(target, "crank_angles"),
            fmt::format("the displacement {} is not on the stroke of the slide that drives, which goes from "
                        "{} to {}: give displacements between its stops, or other stops",
                        at, (*reach)[0], (*reach)[1]));
    }
}

/// Nothing goes round that a slide drives.
void check_closed(const Section& path, const PathTarget& target, const Problem& problem, Messages& messages) {
    if (target.closed && is_driven_by_slide(problem))
        add_error(messages, place_of(path, "closed"),
                  "the linkage is driven by a slide, which goes to and fro and never round: leave 'closed' out");
}

}  // namespace

namespace {

void read_one_path(Section& path, Problem& problem, Messages& messages) {
    if (problem.mechanism != nullptr && !problem.mechanism->point)
        return add_error(messages, path.place,
                         fmt::format("a {} guides no point along a path: leave [path] out", problem.mechanism->name));
    read_named_point(path, next_target(problem), problem, messages);
    PointList list = read_points(path, problem, messages);
    PathTarget target;
    const auto timing = read_choice(path, "timing", "timing", messages);
    target.prescribed_timing = timing == 1u;
    target.any_order = timing == 2u;
    target.closed = read_bool(path, "closed", messages).value_or(false);
    target.weights = read_weights(path, list, messages);
    if (target.prescribed_timing)
        target.crank_angles = read_crank_angles(path, problem, list, messages);
    else if (timing || !has(path, "timing"))
        check_free_timing(path, list, messages);
    find(path, "crank_angles");
    report_unknown_keys(path, messages);
    check_closed(path, target, problem, messages);
    check_stroke(path, target, next_target(problem), problem, messages);
    target.points = std::move(list.points);
    add_target(std::move(target), path, problem, messages);
}

}  // namespace

void read_path(Section& file, Problem& problem, Messages& messages) {
    std::vector<Section> paths = read_sections(file, "path", messages);
    if (!is_one_target(paths, problem, messages)) return;
    for (Section& path : paths)
        read_one_path(path, problem, messages);
}

namespace {

/// The poses [x, y, angle] and points [x, y], as points and directions.
PointList read_pose_list(Section& poses, const Problem& problem, PathTarget& target, Messages& messages) {
    PointList list;
    const toml::node* node = find(poses, "poses");
    if (node == nullptr) {
        add_error(messages, poses.place, "[poses] needs poses = [[x, y, angle], ...]");
        return list;
    }
    list.named_at = place_of(*node);
    if (!node->is_array()) {
        report_kind(*node, name_of(poses, "poses"), "a list of [x, y, angle]", messages);
        return list;
    }
    list.whole = true;
    for (const toml::node& entry : *node->as_array()) {
        const std::string what = fmt::format("pose {}", list.points.size() + 1);
        const toml::array* numbers = entry.as_array();
        std::array<std::optional<double>, 3> pose;
        bool right = numbers != nullptr && (numbers->size() == 2 || numbers->size() == 3);
        if (!right)
            add_error(messages, place_of(entry),
                      fmt::format("{} must be [x, y, angle], or [x, y] where any angle will do", what));
        for (std::size_t k = 0; right && k < numbers->size(); ++k)
            pose[k] = to_number((*numbers)[k], fmt::format("each number of {}", what), messages);
        right = right && pose[0] && pose[1] && (pose[2] || numbers->size() == 2);
        list.whole = list.whole && right;
        add_point(list, right ? std::optional(Vector<double>{*pose[0], *pose[1]}) : std::nullopt, place_of(entry));
        target.directions.push_back(right && pose[2] ? to_radians(problem.units, *pose[2]) : std::nan(""));
    }
    if (list.whole && !list.points.empty() && target.poses() == 0) {
        add_error(messages, list.named_at, "no pose has an angle: points alone are a [path]");
        list.whole = false;
    }
    if (list.points.size() < 2 || list.points.size() > most_free_points) {
        add_error(messages, list.named_at,
                  fmt::format("{} must have from 2 to {} poses, not {}", name_of(poses, "poses"), most_free_points,
                              list.points.size()));
        list.whole = false;
    }
    for (std::size_t i = 1; i < list.points.size() && list.whole; ++i)
        if (list.points[i].x == list.points[i - 1].x && list.points[i].y == list.points[i - 1].y &&
            !(target.faces(i) && target.faces(i - 1) && target.directions[i] != target.directions[i - 1]))
            add_error(messages, list.places[i],
                      fmt::format("poses {} and {} are one pose: leave one of them out", i, i + 1));
    return list;
}

/// The length that angles are weighed by: given, or half the greatest distance from the first pose.
double read_body_length(Section& poses, const PointList& list, Messages& messages) {
    if (const auto length = read_number(poses, "length", messages)) {
        if (*length > 0) return *length;
        add_error(messages, place_of(poses, "length"),
                  fmt::format("{} must be greater than 0, not {}", name_of(poses, "length"), *length));
        return 1;
    }
    double farthest = 0;
    for (const Vector<double>& p : list.points)
        farthest = std::max(farthest, std::hypot(p.x - list.points.front().x, p.y - list.points.front().y));
    if (farthest > 0) return 0.5 * farthest;
    if (list.whole && !has(poses, "length"))
        add_error(
            messages, poses.place,
            "all poses stand at one place: give the body a length, by which angles are weighed against distances");
    return 1;
}

}  // namespace

namespace {

void read_these_poses(Section& poses, Problem& problem, Messages& messages) {
    if (problem.mechanism != nullptr && !problem.mechanism->body)
        return add_error(messages, poses.place,
                         fmt::format("a {} guides no body through poses: leave [poses] out", problem.mechanism->name));
    if (problem.path && (problem.mechanism == nullptr || problem.mechanism->guided.empty()))
        return add_error(messages, poses.place, "a problem has a [path] or [poses], not both");
    read_named_point(poses, next_target(problem), problem, messages);
    PathTarget target;
    PointList list = read_pose_list(poses, problem, target, messages);
    target.prescribed_timing = read_choice(poses, "timing", "timing", messages) == 1u;
    target.body_length = read_body_length(poses, list, messages);
    target.weights = read_weights(poses, list, messages);
    if (target.prescribed_timing)
        target.crank_angles = read_crank_angles(poses, problem, list, messages);
    else if (const toml::node* angles = find(poses, "crank_angles"); angles != nullptr)
        add_error(messages, place_of(*angles),
                  fmt::format("'crank_angles' in {} need timing = \"prescribed\"; with free timing leave them out",
                              poses.title));
    report_unknown_keys(poses, messages);
    check_stroke(poses, target, next_target(problem), problem, messages);
    target.points = std::move(list.points);
    add_target(std::move(target), poses, problem, messages);
}

}  // namespace

void read_poses(Section& file, Problem& problem, Messages& messages) {
    std::vector<Section> all = read_sections(file, "poses", messages);
    if (!is_one_target(all, problem, messages)) return;
    for (Section& poses : all)
        read_these_poses(poses, problem, messages);
}

}  // namespace mechwright::reading
