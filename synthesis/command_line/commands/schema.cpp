// mechwright schema: what editors and other programs check problem files and result documents with.

#include <CLI/CLI.hpp>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/document/result_schema.h"
#include "synthesis/problem/schema/problem_schema.h"
#include "synthesis/problem/text.h"
#include "synthesis/report/json_text.h"
#include "synthesis/report/section_words.h"
#include "synthesis/solve/solve.h"

namespace mechwright {

namespace {

nlohmann::ordered_json schema_of_problems() {
    std::vector<std::string_view> methods;
    for (const MethodDescription& method : all_methods())
        methods.push_back(method.name);
    return problem_schema(methods);
}

struct SchemaOptions {
    std::string of;
    bool markdown = false;
};

int print_schema(const SchemaOptions& options, Console& console) {
    const std::string& of = options.of;
    if (of != "problem" && of != "result") {
        complain(console, "there is no schema of " + reading::quoted(of) + "; there are those of problem and result");
        return exit_code::wrong_usage;
    }
    if (options.markdown && of == "result") {
        complain(console, "--markdown lists the keys of problem files: leave it out, or ask for 'problem'");
        return exit_code::wrong_usage;
    }
    print(console, options.markdown  ? sections_as_markdown()
                   : of == "problem" ? json_text(schema_of_problems())
                                     : json_text(result_schema()));
    return exit_code::solved;
}

}  // namespace

Command add_schema(CLI::App& program) {
    const auto options = std::make_shared<SchemaOptions>();
    CLI::App* command = program.add_subcommand("schema", "Print the JSON Schema of problems or of results");
    command->add_option("DOCUMENT", options->of, "problem or result")->required()->option_text(" ");
    command->add_flag("--markdown", options->markdown, "The sections and keys of problem files as tables, for people");
    return {command, [options](Console& console) { return print_schema(*options, console); }};
}

}  // namespace mechwright
