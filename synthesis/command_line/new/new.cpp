// mechwright new: a few questions, and a commented problem file.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/interrupt.h"
#include "synthesis/command_line/new/task.h"
#include "synthesis/command_line/options.h"
#include "synthesis/problem/reader.h"
#include "synthesis/problem/text.h"
#include "synthesis/report/files/write_file.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

struct NewOptions {
    std::string file;
    std::string mechanism;
    std::string task;
    std::vector<std::string> set;
    bool list = false;
    bool force = false;

    bool to_file() const { return !file.empty() && file != "-"; }
    bool asks() const { return mechanism.empty() || task.empty(); }
};

/// Why there is no file: nothing is written.
struct Refusal {
    std::string why;
};

/// Where answers come from. On a terminal a wrong one is asked for again; a script cannot know that.
struct Source {
    std::ostream& prompts;
    bool terminal;
};

std::string trimmed(const std::string& text) {
    constexpr std::string_view blank = " \t\r";
    const std::size_t first = text.find_first_not_of(blank);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blank) + 1 - first);
}

std::string ask(const Question& question, std::string_view preset, const Source& source) {
    while (true) {
        if (source.terminal) source.prompts << question.text << " [" << preset << "]: " << std::flush;
        std::string answer;
        if (!std::getline(std::cin, answer)) {
            if (source.terminal) source.prompts << '\n';
            throw Refusal{fmt::format("the input ended before the question '{}'", question.text)};
        }
        answer = trimmed(answer);
        if (answer.empty()) return std::string(preset);
        const std::string fault = fault_of(question, answer);
        if (fault.empty()) return answer;
        if (!source.terminal) throw Refusal{fmt::format("{}: {}", question.text, fault)};
        source.prompts << folded("  ", fault);
    }
}

std::vector<std::string_view> known_mechanisms() {
    std::vector<std::string_view> names;
    for (const Task& task : tasks())
        if (names.empty() || names.back() != task.mechanism) names.push_back(task.mechanism);
    return names;
}

std::vector<std::string_view> known_tasks(std::string_view mechanism) {
    std::vector<std::string_view> names;
    for (const Task& task : tasks())
        if (task.mechanism == mechanism) names.push_back(task.name);
    return names;
}

/// The name that an option gives, or the answer.
std::string chosen(std::string_view what, const std::string& given, const std::vector<std::string_view>& known,
                   const Source& source) {
    const std::string text = fmt::format("{} ({})", what, reading::listed(known));
    const Question question{
        .name = what, .text = text, .preset = known.front(), .kind = Answer::choice, .choices = known};
    if (given.empty()) return ask(question, question.preset, source);
    if (const std::string fault = fault_of(question, given); !fault.empty())
        throw Refusal{fmt::format("{}: {}", what, fault)};
    return given;
}

Task task_of(const NewOptions& options, const Source& source) {
    const std::string mechanism = chosen("Mechanism", options.mechanism, known_mechanisms(), source);
    if (source.terminal && options.task.empty())
        for (const Task& task : tasks())
            if (task.mechanism == mechanism)
                source.prompts << folded(fmt::format("  {:<18}  ", task.name), task.meaning);
    const std::string name = chosen("Task", options.task, known_tasks(mechanism), source);
    const std::vector<Task> all = tasks();
    return *std::find_if(all.begin(), all.end(),
                         [&](const Task& task) { return task.mechanism == mechanism && task.name == name; });
}

/// The answers of a command line: what --set says, else presets.
Answers answers_given(const Task& task, const std::vector<std::string>& set) {
    Answers answers;
    std::vector<std::string_view> names;
    for (const Question& question : task.questions) {
        names.push_back(question.name);
        answers[question.name] = question.preset;
    }
    for (const std::string& assignment : set) {
        const std::size_t equals = assignment.find('=');
        if (equals == std::string::npos) throw Refusal{"--set " + reading::quoted(assignment) + ": write NAME=VALUE"};
        const std::string name = assignment.substr(0, equals), value = trimmed(assignment.substr(equals + 1));
        const auto question = std::find_if(task.questions.begin(), task.questions.end(),
                                           [&](const Question& q) { return q.name == name; });
        if (question == task.questions.end())
            throw Refusal{"--set: unknown " + reading::quoted(name) + "; " + reading::remedy(name, names)};
        if (const std::string fault = fault_of(*question, value); !fault.empty())
            throw Refusal{fmt::format("--set {}: {}", name, fault)};
        answers[question->name] = value;
    }
    return answers;
}

/// What the reader of problem files finds wrong with a text; empty if nothing.
std::string fault_of_file(const std::string& text) {
    std::string faults;
    for (const Message& message : parse_problem(text, "").messages)
        if (!message.warning) faults += (faults.empty() ? "" : "\n") + message.text;
    return faults;
}

std::string asked_for(const Task& task, const Source& source) {
    Answers answers = answers_given(task, {});
    while (true) {
        for (const Question& question : task.questions)
            answers[question.name] = ask(question, std::string(answers[question.name]), source);
        std::string text = problem_file(task, answers);
        const std::string fault = fault_of_file(text);
        if (fault.empty()) return text;
        if (!source.terminal) throw Refusal{fault};
        source.prompts << "That does not go together:\n" << folded("  ", fault) << "Once more:\n";
    }
}

std::string composed(const NewOptions& options, const Source& source) {
    const Task task = task_of(options, source);
    if (options.asks()) return asked_for(task, source);
    std::string text = problem_file(task, answers_given(task, options.set));
    if (const std::string fault = fault_of_file(text); !fault.empty()) throw Refusal{fault};
    return text;
}

std::string list_of_tasks() {
    std::string text;
    for (const Task& task : tasks()) {
        text += (text.empty() ? "" : "\n") + folded(fmt::format("{} {}: ", task.mechanism, task.name), task.meaning);
        for (const Question& question : task.questions)
            text +=
                folded(fmt::format("  {:<16}", question.name), fmt::format("{} [{}]", question.text, question.preset));
    }
    return text;
}

bool in_the_way(const NewOptions& options, Console& console) {
    std::error_code ignored;
    if (!options.to_file() || options.force || !std::filesystem::exists(options.file, ignored)) return false;
    complain(console, fmt::format("'{}' exists; --force replaces it", options.file));
    return true;
}

int write(const NewOptions& options, const std::string& text, Console& console) {
    if (!options.to_file()) {
        print(console, text);
        return exit_code::solved;
    }
    // It may have come while the questions were asked.
    if (in_the_way(options, console)) return exit_code::no_access;
    const Interrupt held(false);
    if (const auto fault = write_atomically(options.file, text)) {
        complain(console, *fault);
        return exit_code::no_access;
    }
    console.err << fmt::format("{} is written; mechwright solve {} designs it", options.file, options.file)
                << std::endl;
    return exit_code::solved;
}

int begin(const NewOptions& options, Console& console) {
    if (options.list) {
        print(console, list_of_tasks());
        return exit_code::solved;
    }
    if (!options.set.empty() && options.asks()) {
        complain(console, "--set needs --mechanism and --task: 'mechwright new --list' lists them");
        return exit_code::wrong_usage;
    }
    if (in_the_way(options, console)) return exit_code::no_access;
    try {
        return write(options, composed(options, {console.err, ::isatty(STDIN_FILENO) == 1}), console);
    } catch (const Refusal& refusal) {
        complain(console, refusal.why + "\nNothing is written.");
        return exit_code::wrong_usage;
    }
}

}  // namespace

Command add_new(CLI::App& program) {
    const auto options = std::make_shared<NewOptions>();
    CLI::App* command = program.add_subcommand("new", "Ask a few questions and write a commented problem file");
    command->add_option("FILE", options->file, "File to write (standard output)")->option_text(" ");
    command->add_option("--mechanism", options->mechanism, "Do not ask for the mechanism")
        ->type_name("NAME")
        ->check(not_empty);
    command->add_option("--task", options->task, "Nor for the task; with both, for nothing")
        ->type_name("NAME")
        ->check(not_empty);
    command->add_option("--set", options->set, "An answer, beside both; else the preset")
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
    command->add_flag("--list", options->list, "List mechanisms, tasks and answers with their presets");
    command->add_flag("--force", options->force, "Replace a file that exists");
    return {command, [options](Console& console) { return begin(*options, console); }};
}

}  // namespace mechwright
