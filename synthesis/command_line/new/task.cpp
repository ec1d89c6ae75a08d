#include "synthesis/command_line/new/task.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "synthesis/mechanism/drawing/figure.h"
#include "synthesis/mechanism/linkage/tasks.h"
#include "synthesis/mechanism/mechanism.h"
#include "synthesis/problem/text.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

std::optional<double> number_of(std::string_view text) {
    double number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || stop != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
    return number;
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, at);)
        parts.push_back(part);
    return parts;
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;)
        words.push_back(word);
    return words;
}

std::string number_fault(const Question& question, std::string_view answer) {
    const auto number = number_of(answer);
    if (!number) return reading::quoted(answer) + " is not a number";
    if (*number < question.least) return fmt::format("it must be {} at least", question.least);
    if (*number > question.most) return fmt::format("it must be {} at most", question.most);
    return {};
}

std::string choice_fault(const Question& question, std::string_view answer) {
    if (std::find(question.choices.begin(), question.choices.end(), answer) != question.choices.end()) return {};
    return "unknown " + reading::quoted(answer) + "; " + reading::remedy(answer, question.choices);
}

std::string points_fault(const Question& question, const std::string& answer) {
    const auto points = split(answer, ';');
    if (points.size() < 2) return "give two or more, with semicolons between";
    for (const std::string& point : points) {
        const auto words = words_of(point);
        if (words.size() != question.numbers)
            return fmt::format("{} is not {} numbers with spaces between", reading::quoted(point), question.numbers);
        for (const std::string& word : words)
            if (!number_of(word)) return reading::quoted(word) + " is not a number";
    }
    return {};
}

std::string segments_fault(const std::string& answer) {
    constexpr std::array<std::string_view, 3> kinds{"rise", "dwell", "return"};
    double turn = 0;
    bool up = false;
    for (const std::string& segment : split(answer, ',')) {
        const auto words = words_of(segment);
        const auto angle = words.size() == 2 ? number_of(words[1]) : std::nullopt;
        if (!angle || *angle <= 0)
            return reading::quoted(segment) + " is not a segment: give its kind and its angle, as in 'rise 120'";
        if (std::find(kinds.begin(), kinds.end(), words[0]) == kinds.end())
            return "unknown " + reading::quoted(words[0]) + "; " + reading::remedy(words[0], kinds);
        if (words[0] == (up ? "rise" : "return")) return "rises and returns must take turns, a rise first";
        if (words[0] != "dwell") up = !up;
        turn += *angle;
    }
    if (up) return "the follower must come back: a return is missing";
    if (std::abs(turn - 360) > 1e-9) return fmt::format("the angles must add up to 360 deg, not to {}", turn);
    return {};
}

/// A number as TOML has it: ".5" is none there.
std::string number_as_toml(const std::string& answer) { return fmt::format("{}", number_of(answer).value_or(0)); }

/// [[20, 20], [20, 25]]
std::string points_as_toml(const std::string& answer) {
    std::vector<std::string> points;
    for (const std::string& point : split(answer, ';')) {
        std::vector<std::string> numbers;
        for (const std::string& word : words_of(point))
            numbers.push_back(number_as_toml(word));
        points.push_back(fmt::format("[{}]", fmt::join(numbers, ", ")));
    }
    return fmt::format("[{}]", fmt::join(points, ", "));
}

std::string segments_as_toml(const std::string& answer) {
    std::string text;
    for (const std::string& segment : split(answer, ',')) {
        const auto words = words_of(segment);
        text +=
            fmt::format("{}[[segment]]\nkind  = \"{}\"\nangle = {}\n", text.empty() ? "" : "\n", words[0], words[1]);
        if (words[0] != "dwell") text += "lift  = @lift@\nlaw   = \"@law@\"\n";
    }
    return text;
}

std::string as_toml(const Question& question, const std::string& answer) {
    switch (question.kind) {
        case Answer::points: return points_as_toml(answer);
        case Answer::segments: return segments_as_toml(answer);
        case Answer::number: return number_as_toml(answer);
        default: return answer;
    }
}

/// Puts a value where "@name@" stands, and its multiples where "@name*3@" does.
void put(std::string& text, const std::string& name, const std::string& value) {
    for (std::size_t at = 0; (at = text.find("@" + name, at)) != std::string::npos;) {
        const std::size_t rest = at + 1 + name.size(), end = text.find('@', rest);
        if (text[rest] != '@' && text[rest] != '*') {  // a longer name
            ++at;
            continue;
        }
        const auto factor = number_of(std::string_view(text).substr(rest + 1, end - std::min(end, rest + 1)));
        text.replace(at, end + 1 - at, factor ? number_text(*factor * number_of(value).value_or(0)) : value);
    }
}

/// Comments beside what they explain, below each other where there is room.
std::string with_comments_aligned(const std::string& text) {
    constexpr std::size_t column = 40;
    std::string aligned;
    for (const std::string& line : split(text, '\n')) {
        const std::size_t comment = line.find(" # ");
        if (comment == std::string::npos || line.front() == '#') {
            aligned += line + "\n";
            continue;
        }
        const std::string code = line.substr(0, line.find_last_not_of(' ', comment) + 1);
        aligned += fmt::format("{:<{}}{}\n", code, std::max(column, code.size() + 1), line.substr(comment + 1));
    }
    return aligned;
}

/// A comment after those at the beginning: how to see where the dimensions are.
std::string with_figure_named(const std::string& text, const Task& task) {
    const bool has_figure = !figure_of(task.mechanism).empty();
    const std::string comment =
        has_figure ? fmt::format("# mechwright draw --figure {} draws where its dimensions are.\n", task.mechanism)
                   : "# mechwright draw --figure FILE draws its links, points and dimensions.\n";
    std::size_t at = 0;
    while (at < text.size() && text[at] == '#')
        at = text.find('\n', at) + 1;
    return text.substr(0, at) + comment + text.substr(at);
}

}  // namespace

std::vector<Task> tasks() {
    std::vector<Task> all;
    for (const auto& mechanism : mechanisms())
        all.insert(all.end(), mechanism->tasks.begin(), mechanism->tasks.end());
    // A linkage is none of the list: its file makes it.
    const std::vector<Task> linkages = linkage_tasks();
    all.insert(all.end(), linkages.begin(), linkages.end());
    return all;
}

std::string fault_of(const Question& question, const std::string& answer) {
    switch (question.kind) {
        case Answer::number: return number_fault(question, answer);
        case Answer::choice: return choice_fault(question, answer);
        case Answer::points: return points_fault(question, answer);
        case Answer::segments: return segments_fault(answer);
        case Answer::expression: break;
    }
    const bool plain = std::all_of(answer.begin(), answer.end(),
                                   [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\' && c != '@'; });
    return plain ? "" : "give an expression in x, such as x^1.5 or log10(x)";
}

std::string problem_file(const Task& task, const Answers& answers) {
    std::string text(task.text);
    // Segments hold answers of other questions: they come first.
    for (const bool segments : {true, false})
        for (const Question& question : task.questions)
            if ((question.kind == Answer::segments) == segments)
                put(text, std::string(question.name), as_toml(question, answers.at(question.name)));
    return with_comments_aligned(with_figure_named(text, task));
}

}  // namespace mechwright
