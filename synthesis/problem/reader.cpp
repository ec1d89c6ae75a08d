#include "synthesis/problem/reader.h"

#include <fmt/format.h>

#include <exception>

#include "synthesis/problem/bytes.h"
#include "synthesis/problem/linkage/mechanism.h"
#include "synthesis/problem/linkage/of_kinds/measures_of_kind.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/kinds_with_sections.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/study/varied_problem.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/toml/made_table.h"
#include "synthesis/problem/toml/toml_text.h"
#include "synthesis/target/function/function_target.h"
#include "synthesis/target/with_targets.h"

namespace mechwright {

namespace reading {

namespace {

void read_schema(Section& file, Messages& messages) {
    if (!has(file, "schema")) add_error(messages, file.place, "'schema' is missing: write schema = 1");
    const auto schema = read_whole_number(file, "schema", messages);
    if (schema && *schema != 1)
        add_error(messages, place_of(file, "schema"),
                  fmt::format("schema {} is not known to this version: write schema = 1", *schema));
}

void read_mechanism(Section& file, Problem& problem, Messages& messages) {
    std::vector<std::string_view> names;
    for (const auto& mechanism : mechanisms())
        if (names.empty() || names.back() != mechanism->name) names.push_back(mechanism->name);
    names.push_back("linkage");
    if (!has(file, "mechanism")) add_error(messages, file.place, "'mechanism' is missing: known are " + listed(names));
    if (const auto index = read_choice(file, "mechanism", "mechanism", names, messages))
        problem.mechanism = find_mechanism(names[*index]);
}

void add_names(const toml::node& node, std::vector<std::string_view>& names) {
    if (const toml::array* list = node.as_array(); list != nullptr && list->is_array_of_tables())
        for (const toml::node& entry : *list)
            add_names(entry, names);
    if (!node.is_table()) return;
    for (const auto& [key, value] : *node.as_table()) {
        const std::string_view path = key.str();
        names.push_back(path.substr(path.rfind('.') + 1));  // a study names values by where they stand
        add_names(value, names);
    }
}

/// The numbers and quantities of the targets that the file names, and of the dimensions.
void add_targets(const Section& file, Problem& problem) {
    if (problem.mechanism == nullptr) return;
    std::vector<std::string_view> names;
    add_names(*file.table, names);
    problem.mechanism = with_targets(problem.mechanism, names);
}

/// Accuracy points that no method will look at.
void warn_of_accuracy_points(const Section& file, const Problem& problem, Messages& messages) {
    if (!problem.function || problem.function->accuracy_points.empty() || problem.solver.method == "exact") return;
    if (const toml::node* node = file.table->at_path("function.accuracy_points").node())
        add_warning(messages, place_of(*node),
                    "accuracy points are met by method = \"exact\" in [solver]; every other method passes them over");
}

}  // namespace

void read_problem_table(const toml::table& table, Problem& problem, Messages& messages) {
    if (names_linkage(table)) return read_linkage_problem(table, problem, messages);
    Section file{&table, "", {1, 1}, keys::of_file()};
    read_schema(file, messages);
    read_mechanism(file, problem, messages);
    if (auto title = read_string(file, "title", messages)) problem.title = *std::move(title);
    read_units(file, problem, messages);
    read_kind(file, problem, messages);
    add_targets(file, problem);
    read_measures_of_kind(file, problem, messages);
    add_whole_quantities(table, problem);
    read_dimensions(file, problem, messages);
    read_motion_of_kind(file, problem, messages);
    read_path(file, problem, messages);
    read_poses(file, problem, messages);
    read_range_of_use(file, problem, messages);
    read_objective(file, problem, messages);
    read_motion(file, problem, messages);
    read_function(file, problem, messages);
    read_followed(file, problem, messages);
    conclude_dimensions(file, problem, messages);
    set_crank_range(problem);
    read_settings(file, problem, messages);
    read_solver(file, problem, messages);
    round_lengths(file, problem, messages);
    check_front(file, problem, messages);
    warn_of_accuracy_points(file, problem, messages);
    read_requirements(file, problem, messages);
    check_quantities_over_range(file, problem, messages);
    read_instant(file, problem, messages);
    require_regions(problem);
    read_study(file, problem, messages);
    report_unknown_keys(file, messages);
}

void conclude(ReadProblem& read, Messages&& messages) {
    read.unreadable = messages.unreadable;
    read.named_files = std::move(messages.named_files);
    read.messages = sorted(std::move(messages));
}

namespace {

/// Reads a table and, where it holds a study, the ends of that, from what `varied` makes.
template <class MakeVaried>
void read_whole(const toml::table& table, const MakeVaried& varied, Problem& problem, Messages& messages) {
    if (table.empty())
        return add_error(messages, FilePlace{},
                         "the file is empty: a problem needs at least schema = 1, mechanism = \"...\" and a section "
                         "[dimensions]");
    read_problem_table(table, problem, messages);
    if (problem.study) check_ends(varied(), place_of(*table.get("study")), *problem.study, messages);
}

ReadProblem concluded(Problem&& problem, Messages&& messages, std::string text) {
    ReadProblem read;
    read.problem = std::move(problem);
    conclude(read, std::move(messages));
    read.problem.sha256 = sha256(text);
    if (read.ok() && read.named_files.empty()) read.problem.text = std::move(text);
    return read;
}

}  // namespace

}  // namespace reading

ReadProblem parse_problem(std::string_view text, const std::string& file) {
    Problem problem;
    problem.file = file;
    reading::Messages messages{.file = file};
    const auto table = reading::parse_toml(text, messages);
    if (table)
        reading::read_whole(
            *table, [&] { return VariedProblem(text, file); }, problem, messages);
    return reading::concluded(std::move(problem), std::move(messages), std::string(text));
}

ReadProblem take_problem(const nlohmann::ordered_json& tables, const std::string& file) {
    const reading::MadeTable made = reading::made_table(tables);
    Problem problem;
    problem.file = file;
    reading::Messages messages{.file = file, .nodes = &made.nodes};
    reading::read_whole(
        made.table, [&] { return VariedProblem(made.table, file); }, problem, messages);
    return reading::concluded(std::move(problem), std::move(messages), reading::text_of(made.table));
}

ReadProblem read_problem(const std::string& file) {
    constexpr std::size_t most_bytes = 64 << 20;
    const reading::Bytes read = reading::read_bytes(file, most_bytes, true);
    if (read.failure.empty()) return parse_problem(read.bytes, file);
    ReadProblem failed;
    failed.problem.file = file;
    failed.messages.push_back({file, 0, 0, read.failure});
    failed.unreadable = read.unreadable;
    return failed;
}

}  // namespace mechwright
