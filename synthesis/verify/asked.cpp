#include "synthesis/verify/asked.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "synthesis/document/document.h"
#include "synthesis/document/kinds_in_documents.h"
#include "synthesis/problem/bytes.h"
#include "synthesis/problem/reader.h"
#include "synthesis/problem/text.h"
#include "synthesis/target/names.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

/// Members that a document has where its problem asks for them, and not else, at any depth.
constexpr std::array<std::string_view, 27> only_where_asked{
    "crank_range",  "settings",   "instant", "contour", "objective", "terms",
    "weight",       "reduce",     "equal",   "min",     "max",       "requirements",
    "weights",      "directions", "of",      "times",   "samples",   "prescribed_angles",
    "range_of_use", "expression", "points",  "start",   "end",       "body_length",
    "wishes",       "choices",    "step"};

bool same_number(double a, double b) {
    constexpr double same_within = 1e-14;
    return a == b || std::abs(a - b) <= same_within * std::max(std::abs(a), std::abs(b));
}

std::string unlike(const std::string& place, const Json* stated, const Json* asked) {
    return fmt::format("{} is stated as {}, asked for is {}", place, claims::shown(stated), claims::shown(asked));
}

bool is_only_where_asked(std::string_view name) {
    const auto kinds = kinds_in_documents();
    const auto is_among = [&](const auto& names) { return std::find(names.begin(), names.end(), name) != names.end(); };
    return is_among(only_where_asked) || is_among(repeated_sections) ||
           std::any_of(kinds.begin(), kinds.end(), [&](const KindInDocuments& kind) { return kind.given == name; });
}

/// Where what is stated lacks something that is asked for, or has something that is not.
std::string difference(const Json& stated, const Json& asked, const std::string& place, bool every_member) {
    if (asked.is_number() && stated.is_number())
        return same_number(stated.get<double>(), asked.get<double>()) ? "" : unlike(place, &stated, &asked);
    if (asked.type() != stated.type() || (asked.is_array() && asked.size() != stated.size()))
        return unlike(place, &stated, &asked);
    if (asked.is_array()) {
        for (std::size_t i = 0; i < asked.size(); ++i)
            if (std::string d = difference(stated[i], asked[i], fmt::format("{}[{}]", place, i), false); !d.empty())
                return d;
        return {};
    }
    if (!asked.is_object()) return stated == asked ? "" : unlike(place, &stated, &asked);
    const std::string before = place.empty() ? "" : place + ".";
    for (const auto& [name, value] : asked.items()) {
        const auto there = stated.find(name);
        if (there == stated.end() && name == "accuracy_points") continue;  // of the method exact alone
        if (there == stated.end()) return unlike(before + name, nullptr, &value);
        if (std::string d = difference(*there, value, before + name, name == "dimensions"); !d.empty()) return d;
    }
    for (const auto& [name, value] : stated.items()) {
        if ((every_member || is_only_where_asked(name)) && !asked.contains(name))
            return unlike(before + name, &value, nullptr);
    }
    return {};
}

/// Why the assembly of the design is none of those that the problem allows.
std::string assembly_defect(const Json& document, const Problem& problem) {
    if (!document.contains("design") || !document["design"].is_object()) return {};
    const Json& design = document["design"];
    if (!design.contains("assembly") || !design["assembly"].is_string()) return {};
    const auto name = design["assembly"].get<std::string>();
    const auto& names = problem.mechanism->assemblies;
    const bool allowed = std::any_of(problem.assemblies.begin(), problem.assemblies.end(),
                                     [&](std::size_t i) { return i < names.size() && names[i] == name; });
    return allowed ? "" : fmt::format("design.assembly is {}, which was not asked for", reading::quoted(name));
}

}  // namespace

std::string asked_otherwise(const Json& document, const Problem& problem) {
    if (!document.is_object()) return "it is not an object";
    std::string defect = difference(document, asked_document(problem), "", false);
    if (!defect.empty()) return defect;
    const KindInDocuments* own = kind_in_documents(*problem.mechanism);
    return own ? own->choices_defect(document, problem) : assembly_defect(document, problem);
}

std::vector<Check> check_asked(const Json& document) {
    const auto problem = document.find("problem");
    if (problem == document.end() || !problem->is_object() || !problem->contains("text")) return {};
    Check check{"asks for what its problem does", false, "the text of the problem is not a text"};
    if (!(*problem)["text"].is_string()) return {check};
    const auto text = (*problem)["text"].get<std::string>();
    if (problem->value("sha256", Json()) != reading::sha256(text)) {
        check.detail = "the text of the problem does not have the checksum that is stated";
        return {check};
    }
    const ReadProblem read = parse_problem(text, "problem.text");
    if (!read.ok() || read.problem.text.empty()) {
        check.detail =
            read.messages.empty() ? "the text of the problem names other files" : to_string(read.messages[0]);
        return {check};
    }
    check.detail = asked_otherwise(document, read.problem);
    check.passed = check.detail.empty();
    if (check.passed) check.detail = "targets, requirements, objective, ranges and tolerance are those of the problem";
    return {check};
}

}  // namespace mechwright
