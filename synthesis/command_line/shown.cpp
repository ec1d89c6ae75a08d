#include "synthesis/command_line/shown.h"

#include <fmt/format.h>

#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/problem/bytes.h"
#include "synthesis/problem/text.h"
#include "synthesis/report/document.h"
#include "synthesis/search/solve.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t largest_document = std::size_t{1} << 30;
constexpr std::size_t longest_reason = 2000;

/// The parser's message without its own name in front.
std::string reason(const nlohmann::json::exception& exception) {
    const std::string what = exception.what();
    const std::size_t end = what.find("] ");
    return reading::printable(end == std::string::npos ? what : what.substr(end + 2), longest_reason);
}

std::string title_of(const Json& document) {
    const Json& problem = document["problem"];
    return problem.contains("title") && problem["title"].is_string() ? problem["title"].get<std::string>() : "";
}

int read_result(const std::string& file, std::size_t alternative, Console& console, ShownDesign& shown) {
    std::string fault;
    const int outcome = read_result_document(file, shown.document, fault);
    if (outcome != exit_code::solved) {
        complain(console, file + ": " + fault);
        return outcome;
    }
    Json& document = shown.document;
    if (document.is_array()) {
        complain(console, file + ": holds a list of results: solve with --out DIR writes each into a file of its own");
        return exit_code::invalid_file;
    }
    if (alternative > 0) {
        const std::size_t count = document.contains("alternatives") ? document["alternatives"].size() : 0;
        if (alternative > count || !document["alternatives"][alternative - 1].contains("design")) {
            complain(console, fmt::format("--alternative {}: {} has {}", alternative, file, count));
            return exit_code::wrong_usage;
        }
        document = with_other_design(document, document["alternatives"][alternative - 1]);
    }
    FinishedOrNot finished = finished_design(document);
    if (!finished.defect.empty()) {
        complain(console, file + ": not a result with a design: " + finished.defect);
        return exit_code::invalid_file;
    }
    shown.design = std::move(finished.design);
    shown.title = title_of(document);
    return exit_code::solved;
}

/// The mechanism of a problem file that leaves nothing open.
int read_given(const std::string& file, Console& console, ShownDesign& shown) {
    ReadProblem read;
    if (const int outcome = read_and_report(file, false, console, read)) return outcome;
    const Problem& problem = read.problem;
    const bool open = std::any_of(problem.dimensions.begin(), problem.dimensions.end(),
                                  [](const DimensionRange& range) { return !range.fixed(); });
    if (open || problem.assemblies.size() > 1) {
        complain(console, file +
                              ": this problem leaves something to be designed: solve it with --out DIR, and give the "
                              "result in DIR to this command");
        return exit_code::invalid_file;
    }
    const Solution given = evaluate_given(problem);
    shown = {finished_design(problem, given.design), analysis_document(problem, given), problem.title};
    return exit_code::solved;
}

}  // namespace

std::string why_not_a_result(const Json& json) {
    if (!json.is_object()) return "it is not an object";
    if (!json.contains("schema") || !json["schema"].is_number_integer()) return "it has no schema number";
    if (json["schema"] != 1)
        return "its schema " + json["schema"].dump() + " is not known to this version of mechwright, only 1 is";
    if (!json.contains("problem") || !json["problem"].is_object()) return "it does not say of which problem";
    return {};
}

int read_result_document(const std::string& file, Json& document, std::string& fault) {
    const reading::Bytes content = reading::read_bytes(file, largest_document, true);
    fault = content.failure;
    if (!fault.empty()) return exit_code::no_access;
    try {
        document = Json::parse(content.bytes);
    } catch (const nlohmann::json::exception& exception) {
        fault = "not a result document: " + reason(exception);
        return exit_code::invalid_file;
    }
    if (document.is_array()) return exit_code::solved;
    if (const std::string why = why_not_a_result(document); !why.empty()) {
        fault = "not a result document: " + why;
        return exit_code::invalid_file;
    }
    return exit_code::solved;
}

int read_shown(const std::string& file, std::size_t alternative, Console& console, ShownDesign& shown) {
    const int outcome =
        file.ends_with(".toml") ? read_given(file, console, shown) : read_result(file, alternative, console, shown);
    if (outcome != exit_code::solved || shown.design.assembles()) return outcome;
    complain(console, file + ": the mechanism does not assemble at any crank angle");
    return exit_code::infeasible;
}

}  // namespace mechwright
