/// \file
/// What must hold of the problem reader for any bytes at all, and of one evaluation of what it takes for a problem. The
/// target of the preset `fuzz`; replay.cpp calls the same function over the corpus and changes of it, with any
/// compiler.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/problem/reader.h"
#include "synthesis/target/path/read_points.h"
#include "tests/fuzz/evaluation.h"
#include "tests/fuzz/require.h"

namespace mechwright::test {

namespace {

void check_messages(const std::vector<Message>& messages, std::size_t bytes) {
    constexpr std::size_t most = reading::Messages::most_shown + 1;
    require(messages.size() <= most, "the messages are not too many");
    for (const Message& message : messages) {
        require(!message.text.empty(), "a message has a text");
        require(message.text.size() < 1000, "a message is not too long");
        require(message.text.find('\n') == std::string::npos, "a message is one line");
        require((message.line == 0) == (message.column == 0), "a place is a line and a column");
        require(message.line >= 0 && message.column >= 0, "a place is not negative");
        const auto last = static_cast<int>(bytes) + 1;
        require(message.line <= last && message.column <= last + 1, "a place is not behind the end");
    }
}

void check_order(const std::vector<Message>& messages) {
    for (std::size_t i = 1; i < messages.size(); ++i) {
        const Message& before = messages[i - 1];
        const Message& after = messages[i];
        if (before.file != after.file || before.line == 0 || after.line == 0) continue;
        require(before.line < after.line || (before.line == after.line && before.column <= after.column),
                "messages come in the order of their places");
    }
}

/// Of a cam: laws and senses of rotation.
std::size_t assembly_count(const Problem& problem) {
    if (const MotionProgram* program = program_of(*problem.mechanism)) return 2 * law_choices(*program);
    return std::max<std::size_t>(problem.mechanism->assemblies.size(), 1);
}

void check_dimensions(const Problem& problem) {
    const Mechanism& mechanism = *problem.mechanism;
    require(problem.dimensions.size() == mechanism.dimensions.size(), "there is every dimension");
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i) {
        const DimensionRange& range = problem.dimensions[i];
        require(std::isfinite(range.min) && std::isfinite(range.max) && range.min <= range.max, "a range rises");
        require(!range.start || (range.min <= *range.start && *range.start <= range.max), "a start is in its range");
        require(range.named || !mechanism.dimensions[i].required, "what is required is named");
        require(range.named || (range.min == 0 && range.max == 0), "what is not named is 0");
        if (mechanism.dimensions[i].kind == DimensionKind::length && range.named)
            require(range.min >= 0 && range.max > 0, "a length is positive");
    }
    require(!problem.assemblies.empty(), "there is an assembly");
    for (const std::size_t assembly : problem.assemblies)
        require(assembly < assembly_count(problem), "an assembly is one of the mechanism");
    for (std::size_t i = 0; i < mechanism.settings.size(); ++i)
        require(
            problem.settings[i] == mechanism.settings[i].preset || mechanism.settings[i].allows(problem.settings[i]),
            "a setting is in its range");
}

void check_quantity(const Problem& problem, std::size_t quantity) {
    require(quantity < problem.mechanism->quantities.size(), "a quantity is one of the mechanism");
    require(problem.mechanism->quantities[quantity].path == PathMeasure::none || problem.path.has_value(),
            "a path quantity has a path");
}

void check_targets(const Problem& problem) {
    for (const Requirement& requirement : problem.requirements) {
        check_quantity(problem, requirement.quantity);
        require(requirement.equal.has_value() != (requirement.min || requirement.max), "a requirement is of one kind");
        for (const auto& value : {requirement.equal, requirement.min, requirement.max})
            require(!value || std::isfinite(*value), "a value is finite");
        require(!requirement.min || !requirement.max || *requirement.min <= *requirement.max, "a requirement rises");
    }
    if (!problem.objective) return;
    require(!problem.objective->terms.empty(), "an objective has a term");
    for (const ObjectiveTerm& term : problem.objective->terms) {
        check_quantity(problem, term.quantity);
        require(std::isfinite(term.weight) && term.weight > 0, "a weight is positive");
    }
}

void check_path(const PathTarget& path) {
    require(!path.points.empty() && path.points.size() <= reading::most_points, "a path has points");
    require(path.weights.size() == path.points.size(), "every point has a weight");
    for (const double weight : path.weights)
        require(std::isfinite(weight) && weight > 0, "a weight is positive");
    require(path.crank_angles.size() == (path.prescribed_timing ? path.points.size() : 0),
            "every point has a crank angle if timing is prescribed");
    for (const double angle : path.crank_angles)
        require(std::isfinite(angle), "a crank angle is finite");
    for (const Vector<double>& point : path.points)
        require(std::isfinite(point.x) && std::isfinite(point.y), "a point is finite");
    for (std::size_t i = 1; i < path.points.size(); ++i)
        require(path.points[i].x != path.points[i - 1].x || path.points[i].y != path.points[i - 1].y,
                "neighbouring points differ");
}

void check_problem(const Problem& problem) {
    require(problem.mechanism != nullptr, "the mechanism is known");
    check_dimensions(problem);
    check_targets(problem);
    if (problem.path) check_path(*problem.path);
    if (problem.crank_range) require(problem.crank_range->x < problem.crank_range->y, "the crank range rises");
    const SolverOptions& solver = problem.solver;
    require(solver.starts >= 1 && solver.starts <= 100000, "starts are within limits");
    require(solver.time_limit > 0 && std::isfinite(solver.time_limit), "the time limit is positive");
    require(solver.tolerance > 0 && solver.tolerance <= 1e-2, "the tolerance is positive and small");
}

void check_reader(std::string_view text) {
    const ReadProblem read = parse_problem(text, "/nowhere/problem.toml");
    check_messages(read.messages, text.size());
    check_order(read.messages);
    require(read.problem.sha256.size() == 64, "the checksum is whole");
    require(!read.ok() || !read.unreadable, "what cannot be read is not valid");
    if (!read.ok()) return;
    check_problem(read.problem);
    check_round_trip(text, read.problem);
    check_evaluation(read.problem);
}

void check_point_table(std::string_view text) {
    reading::Messages messages{.file = "problem.toml"};
    reading::PointList list{.file = "points.csv"};
    reading::read_point_table(text, list, messages);
    require(list.whole != messages.failed, "a list is whole if nothing is wrong with it");
    require(list.points.size() == list.places.size(), "every point has a place");
    require(list.points.size() <= reading::most_points, "the points are not too many");
    check_messages(reading::sorted(std::move(messages)), text.size());
}

}  // namespace

}  // namespace mechwright::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    mechwright::test::check_reader(text);
    mechwright::test::check_point_table(text);
    return 0;
}
