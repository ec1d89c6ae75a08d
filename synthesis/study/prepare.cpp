#include "synthesis/study/prepare.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "synthesis/document/versions.h"
#include "synthesis/problem/bytes.h"
#include "synthesis/problem/input_tasks.h"
#include "synthesis/problem/linkage/of_kinds/expand.h"
#include "synthesis/problem/study/varied_problem.h"

namespace mechwright {

namespace {

/// Combinations of values that are not numbers: more of them than this are taken to be like the first.
constexpr std::size_t most_combinations = 10000;

void add_new(std::vector<std::string>& names, std::string_view name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
}

bool has_section(const Problem& problem, std::string_view section) {
    if (section.empty()) return true;
    if (section == "instant") return problem.has_instant;
    const std::vector<InputTask> tasks = input_tasks(problem);
    if (std::any_of(tasks.begin(), tasks.end(), [&](const InputTask& task) { return task.section() == section; }))
        return true;
    // A mechanism whose targets have names has the quantities of those alone.
    if (problem.path && !problem.path->parts.empty()) return section == "path" || section == "poses";
    if (section == "path") return problem.path && !problem.path->guides_body();
    return section == "poses" && problem.path && problem.path->guides_body();
}

void add_columns(const Problem& problem, const Study& study, StudyColumns& columns) {
    const Mechanism& mechanism = *problem.mechanism;
    for (std::size_t i = 0; i < mechanism.dimensions.size(); ++i)
        if (mechanism.dimensions[i].required || problem.dimensions[i].named)
            add_new(columns.dimensions, mechanism.dimensions[i].name);
    const auto wanted = [&](std::string_view name) {
        const auto& names = study.quantities;
        return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const Quantity& quantity : mechanism.quantities)
        if (wanted(quantity.name) && has_section(problem, quantity.section)) add_new(columns.quantities, quantity.name);
}

struct Looked {
    StudyColumns columns;
    std::set<std::pair<std::string, std::string>> files;  ///< name, SHA-256
};

void look_at(const ReadProblem& read, const Study& study, Looked& looked) {
    for (const NamedFile& file : read.named_files)
        looked.files.emplace(file.name, file.sha256);
    if (read.problem.mechanism != nullptr && !read.problem.dimensions.empty())
        add_columns(read.problem, study, looked.columns);
}

/// Looks at the problems of all combinations of what is not a number: those differ in mechanism and targets.
void look_at_all(const PreparedStudy& prepared, Looked& looked) {
    const Study& study = *prepared.study;
    VariedProblem varied(prepared.text, prepared.file);
    std::vector<AxisValue> values;
    std::size_t combinations = 1;
    for (const StudyAxis& axis : study.axes) {
        values.push_back(axis.range ? AxisValue{.number = axis.range->from} : AxisValue{});
        if (!axis.numeric() && combinations <= most_combinations) combinations *= axis.values.size();
    }
    for (std::size_t k = 0; k < std::min(combinations, most_combinations); ++k) {
        std::size_t rest = k;
        for (std::size_t i = values.size(); i-- > 0;) {
            if (study.axes[i].numeric()) continue;
            values[i].index = rest % study.axes[i].values.size();
            rest /= study.axes[i].values.size();
        }
        if (varied.put(study, values).empty()) look_at(varied.read(), study, looked);
    }
}

}  // namespace

std::vector<std::string> StudyColumns::names() const {
    std::vector<std::string> names = given;
    for (const char* name : {"status", "start", "differed", "objective", "violation", "proved"})
        names.emplace_back(name);
    for (const std::string& dimension : dimensions)
        names.push_back("design." + dimension);
    names.emplace_back("design.assembly");
    names.insert(names.end(), quantities.begin(), quantities.end());
    names.emplace_back("note");
    return names;
}

PreparedOrNot prepare_study(const std::string& file) {
    const reading::Bytes bytes = reading::read_bytes(file, most_bytes_of_a_study, true);
    if (bytes.failure.empty()) return prepare_study(bytes.bytes, file);
    PreparedOrNot outcome;
    outcome.messages.push_back({file, 0, 0, bytes.failure});
    outcome.unreadable = bytes.unreadable;
    return outcome;
}

PreparedOrNot prepare_study(const std::string& text, const std::string& file) {
    PreparedOrNot outcome;
    PreparedStudy& prepared = outcome.prepared;
    ReadProblem read = parse_problem(text, file);
    outcome.unreadable = read.unreadable;
    outcome.messages = read.messages;
    if (!read.ok()) return outcome;
    if (!read.problem.study) {
        outcome.messages.push_back({file, 0, 0,
                                    "there is no [study] in it: write [study] and below it what to vary, as in "
                                    "\"dimensions.ground\" = [100, 120, 140]"});
        return outcome;
    }
    if (read.problem.study->as_linkage) {
        ExpandedProblem linkage = expand_problem(text, file);
        if (linkage.ok()) return prepare_study(linkage.text, file);
        outcome.messages = std::move(linkage.messages);
        return outcome;
    }
    prepared.text = text;
    prepared.file = file;
    prepared.study = read.problem.study;
    prepared.base = read.problem;
    Looked looked;
    for (const StudyAxis& axis : prepared.study->axes)
        looked.columns.given.push_back(axis.name);
    for (const FollowingValue& following : prepared.study->following)
        looked.columns.given.push_back(following.path);
    if (prepared.study->tolerances()) look_at(read, *prepared.study, looked);
    look_at_all(prepared, looked);
    std::string told_by = fmt::format("mechwright {}\n{}\n", program_version(), reading::sha256(prepared.text));
    for (const auto& [name, sha] : looked.files) {
        prepared.named_files.push_back(name);
        told_by += name + ' ' + sha + '\n';
    }
    prepared.columns = std::move(looked.columns);
    prepared.fingerprint = reading::sha256(told_by);
    outcome.ok = true;
    return outcome;
}

}  // namespace mechwright
