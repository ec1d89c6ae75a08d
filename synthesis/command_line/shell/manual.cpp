#include "synthesis/command_line/shell/manual.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "synthesis/command_line/exit_code.h"
#include "synthesis/report/versions.h"

namespace mechwright {

namespace {

/// Text in which roff finds nothing of its own.
std::string plain(std::string_view text) {
    std::string result = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else
            result += c;
    }
    return result;
}

std::string bold(std::string_view text) { return "\\fB" + plain(text) + "\\fR"; }
std::string slanted(std::string_view text) { return "\\fI" + plain(text) + "\\fR"; }

std::string item(std::string_view term, std::string_view text) {
    return fmt::format(".TP\n{}\n{}\n", term, plain(text));
}

std::string argument_of(const ArgumentNode& argument) {
    const std::string name = slanted(argument.name) + (argument.repeated ? "..." : "");
    return argument.required ? name : "[" + name + "]";
}

std::string term_of(const OptionNode& option) {
    const std::string names = (option.short_name.empty() ? "" : bold(option.short_name) + ", ") + bold(option.name);
    return option.value.empty() ? names : names + " " + slanted(option.value);
}

/// The same option stands in every command: once is enough.
bool is_help(const OptionNode& option) { return option.name == "--help"; }

std::string command_section(const CommandNode& node) {
    std::string usage = bold(fmt::format("mechwright {}", fmt::join(node.path, " ")));
    for (const ArgumentNode& argument : node.arguments)
        usage += " " + argument_of(argument);
    std::string text = fmt::format(".SS {}\n{}.\n", usage, plain(node.help));
    for (const ArgumentNode& argument : node.arguments)
        text += item(slanted(argument.name), argument.help);
    for (const OptionNode& option : node.options)
        if (!is_help(option)) text += item(term_of(option), option.help);
    return text;
}

struct Entry {
    std::string_view term;
    std::string_view text;
};

constexpr std::array<Entry, 3> environment{
    {{"MECHWRIGHT_INSTRUCTIONS",
      "baseline, avx2 or avx512: the widest instructions that are used, of those the processor has. The results are "
      "the same, digit for digit."},
     {"NO_COLOR", "If it is set and not empty, nothing is coloured."},
     {"TERM", "On a terminal of the kind dumb, or of none, there are neither colours nor a progress line."}}};

constexpr std::array<Entry, 4> kinds_of_files{
    {{"*.toml",
      "Problem files: mechanism, dimensions, requirements, objective. mechwright new writes one to begin with."},
     {"*.json", "Result documents, as solve writes them: the design, what it reaches, and how that was verified."},
     {"study.sqlite", "The data of a study, in its folder."},
     {"*.csv", "Tables: points of a path that a problem file names, motions, designs."}}};

constexpr std::array<Entry, 5> examples{
    {{"mechwright new problem.toml", "Asks a few questions and writes a problem file."},
     {"mechwright solve problem.toml --out results", "Designs the mechanism and writes the result to a folder."},
     {"mechwright verify results/problem.json", "Checks a result again."},
     {"mechwright explain transmission-angle-worst", "Says what a quantity is."},
     {"mechwright study problem.toml --out study", "Solves a problem for many values of what it says."}}};

template <class Entries>
std::string section(std::string_view title, const Entries& entries) {
    std::string text = fmt::format(".SH {}\n", title);
    for (const Entry& entry : entries)
        text += item(bold(entry.term), entry.text);
    return text;
}

std::string exit_status() {
    std::string text = ".SH EXIT STATUS\n";
    for (const exit_code::Meaning& meaning : exit_code::meanings())
        text += item(bold(std::to_string(meaning.code)), meaning.text);
    return text + ".PP\n" + plain(exit_code::of_several()) + "\n";
}

}  // namespace

std::string manual_page(const CommandNode& program) {
    std::string text = fmt::format(
        ".TH MECHWRIGHT 1 \"\" \"mechwright {}\" \"User Commands\"\n"
        ".SH NAME\nmechwright \\- {}\n"
        ".SH SYNOPSIS\n{} {} [{}] ...\n"
        ".SH DESCRIPTION\n{}\n",
        program_version(), plain("synthesis and optimisation of planar mechanisms"), bold("mechwright"),
        slanted("COMMAND"), slanted("OPTIONS"),
        plain("mechwright designs four-bar linkages, quick-return drives and disc cams. A problem file says which "
              "dimensions are free, what the mechanism must do and what should be as good as possible; mechwright "
              "finds the dimensions and checks them independently. Results go to standard output, messages and "
              "progress to standard error."));
    text += ".SH OPTIONS\n";
    for (const OptionNode& option : program.options)
        text += item(term_of(option), option.help);
    text += ".SH COMMANDS\n" + plain("Every command has --help.") + "\n";
    for (const CommandNode* node : all_nodes(program))
        if (!node->path.empty()) text += command_section(*node);
    return text + exit_status() + section("ENVIRONMENT", environment) + section("FILES", kinds_of_files) +
           section("EXAMPLES", examples);
}

}  // namespace mechwright
