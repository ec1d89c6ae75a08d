#include "synthesis/report/page/results_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/report/page/tables.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_designs = 100, most_alternatives = 12, most_lines = 1000;

std::string title_of(const Json& document) {
    const Json& problem = document["problem"];
    if (problem.contains("title") && problem["title"].is_string()) return problem["title"].get<std::string>();
    return "";
}

/// Adds a design if it can be shown.
bool add(ResultToShow& result, std::string name, Json document) {
    FinishedOrNot finished = finished_design(document);
    if (!finished.defect.empty() || !finished.design.assembles()) return false;
    result.designs.push_back({std::move(name), std::move(finished.design), std::move(document)});
    return true;
}

void add_others(ResultToShow& result, const char* member, const char* name, std::size_t room) {
    if (!result.document.contains(member) || !result.document[member].is_array()) return;
    std::size_t number = 0;
    for (const Json& other : result.document[member]) {
        ++number;
        const bool shown = result.designs.size() < room && other.is_object() && other.contains("design") &&
                           add(result, fmt::format("{} {}", name, number), with_other_design(result.document, other));
        if (!shown) ++result.not_shown;
    }
}

}  // namespace

ResultToShow result_to_show(const std::string& file, const Json& document, std::size_t room) {
    ResultToShow result{title_of(document), file, document, {}, 0};
    const bool is_solved = document.contains("status") && document["status"] == "solved";
    if (document.contains("design"))
        add(result, is_solved || !document.contains("status") ? "best" : "best so far", document);
    add_others(result, "front", "front", room);
    add_others(result, "alternatives", "alternative", room);
    return result;
}

ResultLine result_line(const std::string& file, const Json& document) {
    std::string standing = document.contains("status") ? cell_text(document["status"]) : "evaluated";
    if (document.contains("objective") && document["objective"].is_object()) {
        const Json& objective = document["objective"];
        if (objective.contains("quantity")) standing += ", " + cell_text(objective["quantity"]);
        if (objective.contains("value")) standing += " " + cell_text(objective["value"]);
    }
    return {file, title_of(document), standing};
}

Page page_on_results(const NamedDocuments& results) {
    Page page;
    if (results.size() == 1) page.title = title_of(results[0].second);
    if (page.title.empty())
        page.title = results.size() == 1 ? results[0].first : fmt::format("{} results", results.size());
    std::size_t room = most_designs - std::min(most_designs, results.size());
    std::size_t left_out = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const auto& [file, document] = results[i];
        if (i < most_designs) {
            page.results.push_back(result_to_show(file, document, 1 + std::min(room, most_alternatives)));
            room -= std::min(room, page.results.back().designs.size());
        } else if (page.lines.size() < most_lines) {
            page.lines.push_back(result_line(file, document));
        } else {
            ++left_out;
        }
    }
    if (left_out > 0) page.lines.push_back({fmt::format("and {} more", left_out), "", ""});
    return page;
}

}  // namespace mechwright
