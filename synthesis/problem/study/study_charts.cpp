#include <fmt/format.h>

#include <algorithm>

#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/study/study_sections.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

/// The columns of a chart are looked for in the data, which alone know all of their names.
std::string column(Section& section, std::string_view key, bool needed, Messages& messages) {
    const auto name = read_string(section, key, messages);
    if (needed && !has(section, key))
        add_error(messages, section.place, fmt::format("{} is missing: the name of a column", name_of(section, key)));
    return name.value_or("");
}

bool can_be_file_name(std::string_view name) {
    return !name.empty() &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_") ==
               std::string_view::npos;
}

/// Of a front: which of its columns are better the greater they are.
void read_maximized(Section& section, StudyChart& chart, Messages& messages) {
    const toml::node* node = find(section, "maximize");
    if (node == nullptr) return;
    const toml::array* list = node->as_array();
    if (list == nullptr) return report_kind(*node, "'maximize' in [[study.chart]]", "a list of columns", messages);
    for (const toml::node& name : *list) {
        const auto word = name.value_exact<std::string>();
        if (word && (*word == chart.x || *word == chart.y))
            chart.maximized.push_back(*word);
        else
            add_error(messages, place_of(name), "'maximize' in [[study.chart]] names the columns of x or y");
    }
}

StudyChart read_chart(const toml::node& node, std::size_t number, Messages& messages) {
    Section section{node.as_table(), "[[study.chart]]", place_of(node), keys::chart};
    StudyChart chart;
    if (!has(section, "kind")) add_error(messages, section.place, "a chart needs a 'kind': " + listed(keys::charts));
    chart.kind = static_cast<ChartKind>(read_choice(section, "kind", "kind of chart", messages).value_or(0));
    chart.name = read_string(section, "name", messages).value_or(fmt::format("chart-{}", number));
    if (!can_be_file_name(chart.name))
        add_error(messages, place_of(section, "name"), "the name of a chart has letters, digits, - and _ only");
    chart.title = read_string(section, "title", messages).value_or("");
    chart.x = column(section, "x", true, messages);
    chart.y = column(section, "y", chart.kind != ChartKind::curves, messages);
    chart.value = column(section, "value", chart.kind != ChartKind::front, messages);
    chart.family = column(section, "family", false, messages);
    chart.each = column(section, "each", false, messages);
    chart.where = read_string(section, "where", messages).value_or("");
    chart.logarithmic = read_bool(section, "log", messages).value_or(false);
    chart.levels = read_numbers(section, "levels", messages).value_or(std::vector<double>{});
    read_maximized(section, chart, messages);
    report_unknown_keys(section, messages);
    return chart;
}

}  // namespace

void read_charts(Section& study_section, Study& study, Messages& messages) {
    const toml::node* node = find(study_section, "chart");
    if (node == nullptr) return;
    if (!node->is_array_of_tables())
        return report_kind(*node, "'chart' in [study]", "a list of tables, each headed [[study.chart]]", messages);
    const toml::array& list = *node->as_array();
    for (std::size_t i = 0; i < list.size(); ++i) {
        StudyChart chart = read_chart(list[i], i + 1, messages);
        const auto same = [&](const StudyChart& other) { return other.name == chart.name; };
        if (std::any_of(study.charts.begin(), study.charts.end(), same))
            add_error(messages, place_of(list[i]), fmt::format("there are two charts {}", reading::quoted(chart.name)));
        study.charts.push_back(std::move(chart));
    }
}

}  // namespace mechwright::reading
