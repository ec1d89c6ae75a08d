#include "synthesis/command_line/shown.h"

#include <fmt/format.h>

#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/document/document.h"
#include "synthesis/document/result_file.h"
#include "synthesis/problem/text.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/left_open.h"
#include "synthesis/report/files/write_file.h"
#include "synthesis/solve/solve.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

std::string title_of(const Json& document) {
    const Json& problem = document["problem"];
    return problem.contains("title") && problem["title"].is_string() ? problem["title"].get<std::string>() : "";
}

int read_result(const std::string& file, std::size_t alternative, Console& console, ShownDesign& shown) {
    auto [document, fault, unreadable] = read_result_file(file);
    if (fault.empty() && document.is_array())
        fault = "holds a list of results: solve with --out DIR writes each into a file of its own";
    if (const std::string why = fault.empty() ? why_not_a_result(document) : ""; !why.empty())
        fault = "not a result document: " + why;
    if (!fault.empty()) {
        complain(console, file + ": " + fault);
        return unreadable ? exit_code::no_access : exit_code::invalid_file;
    }
    if (alternative > 0) {
        const std::size_t count = document.contains("alternatives") ? document["alternatives"].size() : 0;
        if (alternative > count || !document["alternatives"][alternative - 1].contains("design")) {
            complain(console, fmt::format("--alternative {}: {} has {}", alternative, file, count));
            return exit_code::wrong_usage;
        }
        document = with_other_design(document, document["alternatives"][alternative - 1]);
        if (document.contains("defect") && document["defect"].is_string())
            complain(console, fmt::format("{}: alternative {} is no use: {}", file, alternative,
                                          reading::printable(document["defect"].get<std::string>(), 2000)));
    }
    FinishedOrNot finished = finished_design(document);
    if (!finished.defect.empty()) {
        complain(console, file + ": not a result with a design: " + finished.defect);
        return exit_code::invalid_file;
    }
    shown = {std::move(finished.design), document, title_of(document)};
    return exit_code::solved;
}

/// The mechanism of a problem file that leaves nothing open.
int read_given(const std::string& file, Console& console, ShownDesign& shown) {
    ReadProblem read;
    if (const int outcome = read_and_report(file, false, console, read)) return outcome;
    const Problem& problem = read.problem;
    if (!why_not_analysable(problem).empty()) {
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

int read_shown(const std::string& file, std::size_t alternative, Console& console, ShownDesign& shown) {
    const int outcome =
        file.ends_with(".toml") ? read_given(file, console, shown) : read_result(file, alternative, console, shown);
    if (outcome != exit_code::solved || shown.design.assembles()) return outcome;
    complain(console, file + ": the mechanism does not assemble at any crank angle");
    return exit_code::infeasible;
}

int hand_over(const std::string& file, std::string_view text, Console& console) {
    if (file.empty()) {
        print(console, text);
        return exit_code::solved;
    }
    const auto fault = write_atomically(file, text);
    if (!fault) return exit_code::solved;
    complain(console, *fault);
    return exit_code::no_access;
}

}  // namespace mechwright
