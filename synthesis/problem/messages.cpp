#include "synthesis/problem/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace mechwright {

std::string to_string(const Message& message) {
    const std::string place = message.line > 0 ? fmt::format(":{}:{}", message.line, message.column) : "";
    return fmt::format("{}{}: {}{}", message.name.empty() ? message.file : message.name, place,
                       message.warning ? "warning: " : "", message.text);
}

bool ReadProblem::ok() const {
    return std::all_of(messages.begin(), messages.end(), [](const Message& message) { return message.warning; });
}

namespace reading {

namespace {

/// Messages about another file come where the problem names it, in the order of their places there.
auto key(const Entry& entry) { return std::tuple(entry.order, FilePlace{entry.message.line, entry.message.column}); }

void keep_first(Messages& messages) {
    auto& entries = messages.entries;
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return key(a) < key(b); });
    if (entries.size() <= Messages::most_shown) return;
    messages.left_out += entries.size() - Messages::most_shown;
    entries.resize(Messages::most_shown);
}

/// The number of the node at a place, or -1 where there is none.
int node_number(const NodeNames& nodes, FilePlace place) {
    const auto found = nodes.numbers.find(place.node);
    return found == nodes.numbers.end() ? -1 : found->second;
}

Message message_at(const Messages& messages, FilePlace place, std::string text, bool warning) {
    if (messages.nodes == nullptr) return {messages.file, place.line, place.column, std::move(text), warning};
    const int number = node_number(*messages.nodes, place);
    const auto name = number < 0 ? std::string() : messages.nodes->names[static_cast<std::size_t>(number)];
    return {messages.file, 0, 0, std::move(text), warning, name};
}

void add(Messages& messages, FilePlace order, Message message) {
    if (messages.nodes != nullptr) order = {node_number(*messages.nodes, order), 0};
    constexpr std::size_t most_kept = 10 * Messages::most_shown;  // bounds memory for files of nothing but errors
    messages.failed |= !message.warning;
    messages.entries.push_back({order, std::move(message)});
    if (messages.entries.size() >= most_kept) keep_first(messages);
}

}  // namespace

void add_error(Messages& messages, FilePlace place, std::string text) {
    add(messages, place, message_at(messages, place, std::move(text), false));
}

void add_warning(Messages& messages, FilePlace place, std::string text) {
    add(messages, place, message_at(messages, place, std::move(text), true));
}

bool has_error_at(const Messages& messages, FilePlace place) {
    return std::any_of(messages.entries.begin(), messages.entries.end(),
                       [&](const Entry& entry) { return entry.order == place && !entry.message.warning; });
}

std::string place_text(const Messages& messages, FilePlace place) {
    if (messages.nodes == nullptr) return fmt::format("in line {}", place.line);
    return message_at(messages, place, {}, false).name;
}

void add_error(Messages& messages, std::string text) { add_error(messages, FilePlace{0, 0}, std::move(text)); }

void add_error_elsewhere(Messages& messages, FilePlace named_at, const std::string& file, FilePlace place,
                         std::string text) {
    add(messages, named_at, {file, place.line, place.column, std::move(text)});
}

std::vector<Message> sorted(Messages&& messages) {
    keep_first(messages);
    std::vector<Message> all;
    for (Entry& entry : messages.entries)
        all.push_back(std::move(entry.message));
    // Not a warning: an error may be among those left out.
    if (messages.left_out > 0)
        all.push_back({messages.file, 0, 0, fmt::format("and {} more; correct these first", messages.left_out)});
    return all;
}

}  // namespace reading

}  // namespace mechwright
