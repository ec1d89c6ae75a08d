#include "synthesis/command_line/shell/manual.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "synthesis/command_line/exit_code.h"
#include "synthesis/document/versions.h"

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

/// What verify does about each claim of a result document.
constexpr std::array<Entry, 14> verified_claims{
    {{"what was asked for",
      "The document holds the text of its problem file under its checksum, unless that names other files. The text is "
      "read again, and mechanism, units, ranges and ties, range of crank angles, segments and laws, targets, "
      "requirements, objective, tolerance and settings have to be those of the text. With --problem FILE the same is "
      "done with that file."},
     {"dimensions",
      "Given ones are as given, the others within their ranges by the tolerance; the kind of mechanism "
      "is derived again, and the assembly is one that was allowed."},
     {"assembly, circuit, branch",
      "In fifty digits over the whole continuous motion, by circle intersections and brackets of every extreme; none "
      "of the formulas that designs are made with."},
     {"range of motion",
      "Whether the crank turns fully, where a motion that ends by itself begins and ends, and the family of the "
      "design: "
      "derived in fifty digits from the geometry, by other formulas than those that designs are made with."},
     {"quantities, requirements, objective",
      "Measured again in fifty digits over the motion; stated values have to agree to 1e-9, angles to 1e-9 rad. "
      "Requirements have to be met by the tolerance; violation and active are derived. At a toggle that ends the "
      "motion "
      "a value may be off by what the rounding of the end makes."},
     {"points of a path, poses",
      "Where the mechanism is at the stated crank angles, its distances, order and timing; that it stays assembled on "
      "one branch between them; of points without an order that no place of the curve is nearer."},
     {"extremes, alternating, free",
      "Of functions, lines and arcs: the extremes are found again in fifty digits by sampling and golden sections (y "
      "of x "
      "in double), those that are as great as the greatest to a millionth counted with their signs, and the free "
      "dimensions by differences of these errors. Where more alternate than are free, weights above 0 with which their "
      "slopes balance are computed: no small change of the dimensions makes all of them smaller."},
     {"warnings", "Margins below the rule's limit are derived again."},
     {"front", "Every design as that of the result; none may be as good as another in both objectives."},
     {"alternatives",
      "Every one that is not stated with a defect: it meets the requirements with its stated objective, "
      "is not better than the design, and is the cognate that it is stated to be."},
     {"complete, certificate",
      "What is said to be proven stands there with a certificate, which is evaluated again in fifty digits: weights of "
      "half-planes that keep the centre of a cam away; places where a flat face asks for the largest cam; a limit, by "
      "a "
      "closed form or an extreme of its own, and that what is asked for lies beyond it by more than the tolerance; "
      "ranges that leave no room for the loop to close or the crank to turn, ties and tolerance among them; counts of "
      "solutions that leave none out (their numbers alone: the solutions are not tracked again); a zero of what cannot "
      "be negative."},
     {"complete by branch and bound",
      "The bound has to meet the objective. Of a function whose scales are given it is proven again: every linkage "
      "errs "
      "by so much at one of four places, by convex hulls in fifty digits. With free scales the same is done at two "
      "hundred places of the scales, evenly spread and around the design; of a timed path some ten thousand other "
      "linkages, placed by least squares, and descents from the best of them must not come below the bound. What lies "
      "between such places is not covered again: there the claim rests on the search alone."},
     {"status, verification",
      "Solved and passed only where all other checks pass; unverified only where one does not."},
     {"not checked", "Texts in words (note, defect, details), versions, times and counts of the search."}}};

constexpr std::array<Entry, 6> examples{
    {{"mechwright new problem.toml", "Asks a few questions and writes a problem file."},
     {"mechwright solve problem.toml --out results", "Designs the mechanism and writes the result to a folder."},
     {"mechwright verify results/problem.json", "Checks a result again."},
     {"mechwright explain transmission-angle-worst", "Says what a quantity is."},
     {"mechwright schema problem > problem.schema.json", "Writes what editors complete and check problem files with."},
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
    text += section("WHAT VERIFY CHECKS", verified_claims);
    return text + exit_status() + section("ENVIRONMENT", environment) + section("FILES", kinds_of_files) +
           section("EXAMPLES", examples);
}

}  // namespace mechwright
