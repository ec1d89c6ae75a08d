#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/report/json_text.h"
#include "synthesis/report/names.h"
#include "synthesis/report/signal_words.h"
#include "synthesis/report/text/sections.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

struct Options {
    std::string name;  ///< of a mechanism or a file; empty: of all mechanisms
    std::string word;  ///< that names or meanings have; empty: any
    bool json = false;
};

/// The quantities of a mechanism that have the word.
std::vector<const Quantity*> quantities_with(const Mechanism& mechanism, const std::string& word) {
    std::vector<const Quantity*> found;
    for (const Quantity& quantity : mechanism.quantities)
        if (quantity.name.find(word) != std::string::npos || quantity.meaning.find(word) != std::string::npos)
            found.push_back(&quantity);
    return found;
}

std::string list_of(const Mechanism& mechanism, const std::string& word, bool colour) {
    const auto found = quantities_with(mechanism, word);
    if (found.empty()) return {};
    std::string text =
        folded(emphasised(mechanism.name, Emphasis::strong, colour) + ": ", std::string(mechanism.meaning));
    std::size_t width = name_of(Unit::length).size();
    for (const Quantity* quantity : found)
        width = std::max(width, name_of(quantity->unit).size());
    for (const Quantity* quantity : found)
        text += folded(fmt::format("  {:<24}  {:<{}}  ", quantity->name, name_of(quantity->unit), width),
                       quantity->meaning);
    return text;
}

nlohmann::ordered_json json_of(const Mechanism& mechanism, const std::string& word) {
    auto list = nlohmann::ordered_json::array();
    for (const Quantity* quantity : quantities_with(mechanism, word))
        list.push_back({{"name", quantity->name}, {"unit", name_of(quantity->unit)}, {"meaning", quantity->meaning}});
    return {{"mechanism", mechanism.name}, {"meaning", mechanism.meaning}, {"quantities", std::move(list)}};
}

/// Prints what these have; `more` is said below their lists.
int show(const std::vector<std::shared_ptr<const Mechanism>>& all, const Options& options, const std::string& more,
         Console& console) {
    std::string text;
    auto json = nlohmann::ordered_json::array();
    for (const auto& mechanism : all) {
        const std::string list = list_of(*mechanism, options.word, colour_wanted(console));
        if (list.empty()) continue;
        text += (text.empty() ? "" : "\n") + list;
        json.push_back(json_of(*mechanism, options.word));
    }
    if (text.empty()) {
        complain(console, fmt::format("no quantity has the word '{}' in its name or meaning", options.word));
        return exit_code::wrong_usage;
    }
    print(console, options.json ? json_text(json) : text + more);
    return exit_code::solved;
}

/// Whether a linkage has signals, or a built-in kind is measured by some.
bool has_signals(const Mechanism& mechanism) {
    const auto* model = mechanism.model.as<LinkageModel>();
    return model != nullptr && !model->signals.empty();
}

/// What is asked of rooms and regions, where a mechanism can have them.
std::string words_of_rooms(const Mechanism& mechanism) {
    return mechanism.as_linkage ? "\nMore is asked of [[room]] and [[region]]: mechwright explain room\n" : "";
}

/// What a file can ask for.
int show_those_of_file(const Options& options, Console& console) {
    ReadProblem read;
    if (const int code = read_and_report(options.name, true, console, read); code != exit_code::solved) return code;
    std::string more;
    if (read.problem.use) more = "\n" + folded("Range of use: ", words_of_use(read.problem));
    more += words_of_rooms(*read.problem.mechanism);
    if (is_described(*read.problem.mechanism) || read.problem.mechanism->as_linkage)
        more += !has_signals(*read.problem.mechanism)
                    ? "\nMore is asked of signals, in [signals]: mechwright explain signals\n"
                    : "\n" + words_of_signals();
    return show({read.problem.mechanism}, options, more, console);
}

bool is_file(const std::string& name) {
    std::error_code none;
    return name == "-" || name.ends_with(".toml") || std::filesystem::is_regular_file(name, none);
}

int list_quantities(const Options& options, Console& console) {
    if (is_file(options.name)) return show_those_of_file(options, console);
    if (options.name == "linkage") {
        complain(console, "the quantities of a linkage are those of its file: mechwright quantities FILE");
        return exit_code::wrong_usage;
    }
    if (options.name.empty()) {
        const auto all = mechanisms();
        return show({all.begin(), all.end()}, options, "", console);
    }
    const auto named = mechanisms_named(options.name);
    if (!named.empty()) return show(named, options, "", console);
    complain(console, unknown_mechanism(options.name));
    return exit_code::wrong_usage;
}

}  // namespace

Command add_quantities(CLI::App& program) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("quantities", "List what can be required or optimised");
    command->add_option("MECHANISM", options->name, "Only those of this mechanism, or of a problem file")
        ->option_text(" ");
    command->add_option("--about", options->word, "Only those whose name or meaning has this word")->type_name("WORD");
    command->add_flag("--json", options->json, "For programs");
    return {command, [options](Console& console) { return list_quantities(*options, console); }};
}

}  // namespace mechwright
