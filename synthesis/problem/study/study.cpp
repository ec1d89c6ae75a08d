#include "synthesis/problem/study/study.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/study/study_sections.h"
#include "synthesis/problem/study/value_path.h"
#include "synthesis/problem/text.h"

namespace mechwright {

namespace {

/// The number with fifteen significant digits.
double as_written(double number) {
    std::array<char, 32> text{};
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 15);
    std::from_chars(text.data(), end, number);
    return number;
}

}  // namespace

double StudyRange::at(double part) const {
    if (part <= 0) return from;
    if (part >= 1) return to;
    if (!logarithmic) return as_written(from + part * (to - from));
    return as_written(
        std::copysign(std::exp(std::log(std::abs(from)) * (1 - part) + std::log(std::abs(to)) * part), from));
}

bool StudyAxis::numeric() const {
    return range || std::all_of(values.begin(), values.end(), [](const toml::node& v) { return v.is_number(); });
}

namespace reading {

namespace {

constexpr std::uint64_t most_points_of_study = 100'000'000;
/// What [study] says of itself; everything else in it is the path of a value.
bool is_own(std::string_view key) { return find_key(keys::study, key) != nullptr; }

std::optional<StudyRange> read_range(Section& section, const Study& study, Messages& messages) {
    StudyRange range;
    for (const std::string_view end : {"from", "to"})
        if (!has(section, end)) add_error(messages, section.place, fmt::format("{} is missing", name_of(section, end)));
    const auto from = read_number(section, "from", messages), to = read_number(section, "to", messages);
    const auto count = read_whole_number(section, "count", messages);
    range.logarithmic = read_choice(section, "spacing", "spacing", messages) == 1u;
    report_unknown_keys(section, messages);
    if (!from || !to) return {};
    range.from = *from;
    range.to = *to;
    range.whole = section.table->get("from")->is_integer() && section.table->get("to")->is_integer();
    if (range.logarithmic && !(range.from * range.to > 0))
        add_error(messages, place_of(section, "spacing"),
                  fmt::format("{}: logarithmic steps need two ends of one sign, neither of them 0", section.title));
    if (study.random()) {
        if (has(section, "count"))
            add_error(messages, place_of(section, "count"),
                      "a random design has one 'count', in [study] itself: leave this one out");
        return range;
    }
    if (!count && !has(section, "count"))
        add_error(messages, section.place, fmt::format("{} is missing: how many values", name_of(section, "count")));
    if (count && *count < (range.from == range.to ? 1 : 2))
        add_error(messages, place_of(section, "count"),
                  fmt::format("{} must be 2 or more, not {}", name_of(section, "count"), *count));
    range.count = count && *count > 0 ? static_cast<std::uint64_t>(*count) : 1;
    return range;
}

void read_list(const toml::array& list, StudyAxis& axis, Messages& messages) {
    if (list.empty())
        add_error(messages, place_of(list),
                  fmt::format("the list of values for {} is empty", reading::quoted(axis.name)));
    for (const toml::node& value : list) {
        value.visit([&axis](const auto& concrete) { axis.values.push_back(concrete); });
        axis.labels.push_back(written(value));
    }
}

std::optional<std::size_t> axis_of(const Study& study, std::string_view path) {
    const auto at =
        std::find_if(study.axes.begin(), study.axes.end(), [&](const StudyAxis& a) { return a.name == path; });
    if (at == study.axes.end()) return {};
    return static_cast<std::size_t>(at - study.axes.begin());
}

struct Following {
    Section section;
    std::string path;
};

/// { expression = "360 - 2 a", a = "segment.1.angle" }
void read_following(Following& node, Study& study, Messages& messages) {
    FollowingValue value{node.path, read_string(node.section, "expression", messages).value_or("0"), {}};
    mu::Parser parser;
    double probe = 1;
    for (const auto& [key, of] : *node.section.table) {
        if (key.str() == "expression") continue;
        const auto path = read_string(node.section, key.str(), messages);
        const auto axis = path ? axis_of(study, *path) : std::nullopt;
        if (path && (!axis || !study.axes[*axis].numeric()))
            add_error(messages, place_of(of),
                      fmt::format("{} is not the path of numbers that this study varies", reading::quoted(*path)));
        if (!axis) continue;
        value.variables.emplace_back(std::string(key.str()), *axis);
        try {
            parser.DefineVar(value.variables.back().first, &probe);
        } catch (const mu::Parser::exception_type&) {
            add_error(messages, place_of(of),
                      fmt::format("{} cannot be a variable of an expression: letters, then letters and digits",
                                  reading::quoted(value.variables.back().first)));
            return;
        }
    }
    try {
        parser.SetExpr(value.expression);
        parser.Eval();
        study.following.push_back(std::move(value));
    } catch (const mu::Parser::exception_type& wrong) {
        add_error(messages, place_of(node.section, "expression"),
                  fmt::format("the expression is not understood: {}", wrong.GetMsg()));
    }
}

struct AxisReader {
    Study& study;
    Messages& messages;
    std::vector<Following> following{};  ///< to be read when all axes are known

    void read(const std::string& path, const toml::node& node) {
        const toml::table* table = node.as_table();
        if (table != nullptr && !table->contains("from") && !table->contains("expression")) {
            for (const auto& [key, below] : *table)
                read(path + "." + std::string(key.str()), below);
            return;
        }
        if (const std::string first = path.substr(0, path.find('.')); first == "study" || first == "schema")
            return add_error(messages, place_of(node), fmt::format("'{}' cannot be varied", first));
        if (table != nullptr && table->contains("expression")) {
            following.push_back({Section{table, reading::quoted(path), place_of(node)}, path});
            return;
        }
        StudyAxis axis{path, {}, {}, {}};
        if (table != nullptr) {
            Section section{table, reading::quoted(path), place_of(node), keys::steps};
            axis.range = read_range(section, study, messages);
            if (!axis.range) return;
        } else if (const toml::array* list = node.as_array()) {
            read_list(*list, axis, messages);
        } else {
            return report_kind(node, fmt::format("the values of {}", reading::quoted(path)),
                               "a list, or steps like { from = 10, to = 20, count = 11 }", messages);
        }
        study.axes.push_back(std::move(axis));
    }
};

/// [[study.case]]: named sets of values that change together.
void read_cases(Section& section, Study& study, Messages& messages) {
    const toml::node* node = find(section, "case");
    if (node == nullptr) return;
    if (!node->is_array_of_tables())
        return report_kind(*node, "'case' in [study]", "a list of tables, each headed [[study.case]]", messages);
    StudyAxis axis{"case", {}, {}, {}};
    for (const toml::node& one : *node->as_array()) {
        toml::table values = *one.as_table();
        const auto name = values["name"].value_exact<std::string>();
        if (!name) add_error(messages, place_of(one), "a case needs a 'name', a string in quotes");
        if (name && std::find(axis.labels.begin(), axis.labels.end(), *name) != axis.labels.end())
            add_error(messages, place_of(one), fmt::format("there are two cases {}", reading::quoted(*name)));
        values.erase("name");
        axis.values.push_back(std::move(values));
        axis.labels.push_back(name.value_or(""));
    }
    study.axes.push_back(std::move(axis));
}

/// Axes in the order in which they stand in the file, of which the table knows nothing any more.
void read_axes(Section& section, Study& study, Messages& messages) {
    AxisReader reader{study, messages};
    read_cases(section, study, messages);
    std::vector<std::pair<FilePlace, std::string_view>> keys;
    for (const auto& [key, node] : *section.table)
        if (!is_own(key.str())) keys.emplace_back(key_place(section, key.str()), key.str());
    std::sort(keys.begin(), keys.end());
    for (const auto& [place, key] : keys)
        reader.read(std::string(key), *section.table->get(key));
    for (Following& following : reader.following)
        read_following(following, study, messages);
}

void check_size(const Section& section, const Study& study, Messages& messages) {
    double points = study.design == StudyDesign::grid ? 1 : 0;
    for (const StudyAxis& axis : study.axes) {
        const auto count = static_cast<double>(axis.count());
        points = study.design == StudyDesign::grid ? points * count : points + count;
    }
    if (study.random()) points = static_cast<double>(study.count);
    if (points > static_cast<double>(most_points_of_study))
        add_error(messages, section.place,
                  fmt::format("{:.3g} points are too many: a study has {} at most", points, most_points_of_study));
}

void read_count(Section& section, Study& study, Messages& messages) {
    const bool wanted = study.random() || samples_pieces(*section.table);
    const auto count = read_whole_number(section, "count", messages);
    if (!wanted && has(section, "count"))
        return add_error(messages, place_of(section, "count"),
                         "'count' in [study] is for random designs and tolerances: a grid has one for each range");
    if (wanted && !has(section, "count"))
        add_error(messages, section.place, "'count' in [study] is missing: how many points");
    if (count && *count < 1)
        add_error(messages, place_of(section, "count"),
                  fmt::format("'count' in [study] must be 1 or more, not {}", *count));
    if (count && *count > 0) study.count = static_cast<std::uint64_t>(*count);
}

void read_seed(Section& section, Study& study, Messages& messages) {
    const auto seed = read_whole_number(section, "seed", messages);
    if (seed && *seed < 0) add_error(messages, place_of(section, "seed"), "'seed' in [study] must be 0 or greater");
    if (seed) study.seed = static_cast<std::uint64_t>(*seed);
}

void read_quantities(Section& section, Study& study, const Problem& problem, Messages& messages) {
    const toml::node* node = find(section, "quantities");
    if (node == nullptr) return;
    if (!node->is_array()) return report_kind(*node, "'quantities' in [study]", "a list of names", messages);
    for (const toml::node& name : *node->as_array()) {
        // Where the mechanism varies, another one may know it.
        const auto word = name.value_exact<std::string>();
        if (!word)
            report_kind(name, "a quantity", "a string in quotes", messages);
        else if (axis_of(study, "case") || axis_of(study, "mechanism") || problem.mechanism == nullptr ||
                 find_quantity(whole_of(*problem.mechanism), *word) >= 0 ||
                 find_quantity(*problem.mechanism, *word) >= 0)
            study.quantities.push_back(*word);
        else
            to_quantity(name, "'quantities'", section, problem, messages);
    }
}

}  // namespace

void read_study(Section& file, Problem& problem, Messages& messages) {
    std::optional<Section> section = read_section(file, "study", messages);
    if (!section) return;
    auto study = std::make_shared<Study>();
    const bool failed_before = std::exchange(messages.failed, false);
    study->design = static_cast<StudyDesign>(read_choice(*section, "design", "design", messages).value_or(0));
    read_count(*section, *study, messages);
    read_seed(*section, *study, messages);
    read_axes(*section, *study, messages);
    read_quantities(*section, *study, problem, messages);
    read_tolerance(*section, *study, problem, messages);
    read_clearance(*section, *study, problem, messages);
    read_allocation(*section, *study, problem, messages);
    read_charts(*section, *study, messages);
    if (study->axes.empty() && !samples_pieces(*section->table) && !messages.failed)
        add_error(messages, section->place,
                  "[study] varies nothing: name a value by its path, as in \"dimensions.ground\" = [100, 120, 140], or "
                  "give the dimensions a [study.tolerance]");
    if (!study->axes.empty() && samples_pieces(*section->table))
        add_error(messages, place_of(*section, section->table->contains("tolerance") ? "tolerance" : "clearance"),
                  "a study varies values or samples tolerances, not both: use two files");
    check_size(*section, *study, messages);
    if (!messages.failed) problem.study = std::move(study);
    messages.failed |= failed_before;
}

}  // namespace reading

}  // namespace mechwright
