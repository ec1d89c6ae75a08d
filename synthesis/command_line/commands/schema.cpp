// mechwright schema: what editors and other programs check problem files and result documents with.

#include <CLI/CLI.hpp>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/document/result_schema.h"
#include "synthesis/problem/schema/problem_schema.h"
#include "synthesis/problem/text.h"
#include "synthesis/report/json_text.h"
#include "synthesis/solve/solve.h"

namespace mechwright {

namespace {

nlohmann::ordered_json schema_of_problems() {
    std::vector<std::string_view> methods;
    for (const MethodDescription& method : all_methods())
        methods.push_back(method.name);
    return problem_schema(methods);
}

int print_schema(const std::string& of, Console& console) {
    if (of != "problem" && of != "result") {
        complain(console, "there is no schema of " + reading::quoted(of) + "; there are those of problem and result");
        return exit_code::wrong_usage;
    }
    print(console, json_text(of == "problem" ? schema_of_problems() : result_schema()));
    return exit_code::solved;
}

}  // namespace

Command add_schema(CLI::App& program) {
    const auto of = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("schema", "Print the JSON Schema of problems or of results");
    command->add_option("DOCUMENT", *of, "problem or result")->required()->option_text(" ");
    return {command, [of](Console& console) { return print_schema(*of, console); }};
}

}  // namespace mechwright
