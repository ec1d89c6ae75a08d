#include "synthesis/verify/asked.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "synthesis/document/cam_document.h"
#include "synthesis/document/document.h"
#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/problem/bytes.h"
#include "synthesis/problem/reader.h"
#include "synthesis/problem/text.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

/// Members that a document has where its problem asks for them, and not else, at any depth.
constexpr std::array<std::string_view, 33> only_where_asked{
    "crank_range", "settings",    "instant",    "cam",          "contour",    "objective",    "terms",
    "weight",      "reduce",      "equal",      "min",          "max",        "requirements", "poses",
    "path",        "weights",     "directions", "of",           "times",      "samples",      "prescribed_angles",
    "function",    "line",        "arc",        "range_of_use", "expression", "points",       "start",
    "end",         "body_length", "wishes",     "choices",      "step"};

bool same_number(double a, double b) {
    constexpr double same_within = 1e-14;
    return a == b || std::abs(a - b) <= same_within * std::max(std::abs(a), std::abs(b));
}

std::string json_text(const Json* value) {
    constexpr std::size_t longest = 60;
    return value ? reading::printable(value->dump(-1, ' ', false, Json::error_handler_t::replace), longest) : "nothing";
}

std::string unlike(const std::string& place, const Json* stated, const Json* asked) {
    return fmt::format("{} is stated as {}, asked for is {}", place, json_text(stated), json_text(asked));
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
        const bool is_asked_part =
            every_member || std::find(only_where_asked.begin(), only_where_asked.end(), name) != only_where_asked.end();
        if (is_asked_part && !asked.contains(name)) return unlike(before + name, &value, nullptr);
    }
    return {};
}

/// Why the rotation of a cam is none of those that the problem allows, or what is proven of it leaves one of its
/// rotations or choices of laws out.
std::string cam_defect(const Json& document, const Problem& problem) {
    const auto rotation = [&](std::size_t assembly) { return cam_rotation_names[assembly % 2]; };
    const Json::json_pointer of_design("/design/rotation");
    if (document.contains(of_design) && std::none_of(problem.assemblies.begin(), problem.assemblies.end(),
                                                     [&](std::size_t i) { return document[of_design] == rotation(i); }))
        return fmt::format("design.rotation is {}, which was not asked for", json_text(&document[of_design]));
    const Json::json_pointer of_proof("/search/certificate/parts");
    if (!document.contains(of_proof) || !document[of_proof].is_array()) return {};
    const Json& parts = document[of_proof];
    for (const std::size_t asked : problem.assemblies)
        if (std::none_of(parts.begin(), parts.end(),
                         [&](const Json& part) { return part.is_object() && part.value("assembly", Json()) == asked; }))
            return fmt::format("search.certificate has no part for cams {}", cam_choice_text(problem, asked));
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
    return is_cam(*problem.mechanism) ? cam_defect(document, problem) : assembly_defect(document, problem);
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
