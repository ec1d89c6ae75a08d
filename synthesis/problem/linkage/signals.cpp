#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

using Word = std::string_view;

/// A key that says what a signal is, with the keys that may stand beside it.
struct SignalKind {
    Word key;
    std::array<Word, 2> beside;
    Word unit;  ///< "" where it follows from other signals
    linkage::Signal::Kind is;
};

constexpr std::array<SignalKind, 13> kinds{
    {{"angle", {"to", "near"}, "angle", linkage::Signal::Kind::angle},
     {"x", {"on", ""}, "length", linkage::Signal::Kind::x},
     {"y", {"on", ""}, "length", linkage::Signal::Kind::y},
     {"along", {"point", "on"}, "length", linkage::Signal::Kind::along},
     {"distance", {"", ""}, "length", linkage::Signal::Kind::distance},
     {"from-line", {"point", ""}, "length", linkage::Signal::Kind::from_line},
     {"slide", {"", ""}, "length", linkage::Signal::Kind::slide},
     {"speed-of", {"", ""}, "speed", linkage::Signal::Kind::speed},
     {"acceleration-of", {"", ""}, "acceleration", linkage::Signal::Kind::acceleration},
     {"curvature-of", {"", ""}, "curvature", linkage::Signal::Kind::curvature},
     {"transmission-angle", {"", ""}, "angle", linkage::Signal::Kind::transmission_angle},
     {"sum", {"", ""}, "", linkage::Signal::Kind::sum},
     {"ratio", {"", ""}, "", linkage::Signal::Kind::ratio}}};

constexpr std::array<Word, 11> of_targets{"path-sse",    "path-rms",      "path-max",     "pose-rms",
                                          "pose-max",    "function-max",  "function-rms", "line-deviation",
                                          "line-length", "arc-deviation", "arc-angle"};

/// What is said of the targets of a section: words that its quantities end in, by their place in `of_targets`.
struct TargetWords {
    Word section;
    std::size_t first;
    std::size_t count;

    std::span<const Word> words() const { return std::span(of_targets).subspan(first, count); }
};

constexpr std::array<TargetWords, 5> words_of_targets{
    {{"path", 0, 3}, {"poses", 3, 2}, {"function", 5, 2}, {"line", 7, 2}, {"arc", 9, 2}}};

/// A target that has a name in a file.
struct NamedTarget {
    std::string name;
    const TargetWords* of;
};

std::vector<NamedTarget> named_targets(const Section& file) {
    std::vector<NamedTarget> all;
    const auto add = [&](const toml::node& node, const TargetWords& of) {
        const toml::table* table = node.as_table();
        if (table == nullptr) return;
        if (const auto name = (*table)["name"].value_exact<std::string>()) all.push_back({*name, &of});
    };
    for (const TargetWords& of : words_of_targets) {
        const toml::node* node = file.table->get(of.section);
        if (node == nullptr) continue;
        add(*node, of);
        if (const toml::array* list = node->as_array())
            for (const toml::node& one : *list)
                add(one, of);
    }
    return all;
}

struct SignalReading {
    LinkageReading& reading;
    std::vector<const toml::table*> tables{};  ///< null of those that a built-in kind has as a linkage
    std::vector<FilePlace> places{};
    std::vector<Word> units{};  ///< found so far; "circle" while one is being found

    const std::vector<LinkageSignal>& signals() const { return reading.made.signals; }
    std::optional<std::size_t> find_signal(const toml::node& node, const std::string& what) const {
        const auto name = node.value_exact<std::string>();
        if (!name) return report_kind(node, what, "the name of a signal", reading.messages), std::nullopt;
        return find_signal(*name, place_of(node), what);
    }
    std::optional<std::size_t> find_signal(Word name, FilePlace place, const std::string& what) const {
        std::vector<Word> known;
        for (std::size_t i = 0; i < signals().size(); ++i) {
            if (signals()[i].name == name) return i;
            known.push_back(signals()[i].name);
        }
        add_error(reading.messages, place,
                  fmt::format("{}: there is no signal {}; {}", what, reading::quoted(name),
                              known.empty() ? "signals stand in [signals]" : remedy(name, known)));
        return {};
    }
    std::size_t pin(const toml::node& node, const std::string& what) const {
        if (const auto name = node.value_exact<std::string>())
            return find_pin(reading, *name, place_of(node), what).value_or(0);
        report_kind(node, what, "the name of a point", reading.messages);
        return 0;
    }
    std::size_t link(const toml::node& node, const std::string& what) const {
        if (const auto name = node.value_exact<std::string>())
            return find_link(reading, *name, place_of(node), what).value_or(0);
        report_kind(node, what, "the name of a link", reading.messages);
        return 0;
    }
    void two(const toml::node& node, const std::string& what, std::size_t& first, std::size_t& second) const {
        const toml::array* list = node.as_array();
        if (list == nullptr || list->size() != 2)
            return add_error(reading.messages, place_of(node),
                             fmt::format("{} must be two names, like [\"P\", \"Q\"]", what));
        const bool signals = what.starts_with("'ratio'");
        for (std::size_t i = 0; i < 2; ++i)
            (i == 0 ? first : second) =
                signals ? find_signal(*list->get(i), what).value_or(0) : pin(*list->get(i), what);
    }
    void sum(const toml::node& node, const std::string& what, linkage::Signal& made) const {
        const toml::table* terms = node.as_table();
        if (terms == nullptr || terms->empty())
            return add_error(
                reading.messages, place_of(node),
                fmt::format("{} must be signals with their factors, like {{ swing = 1, other = -0.5 }}", what));
        const Section section{terms, what, place_of(node)};
        for (const auto& [name, factor] : in_order(*terms)) {
            const auto signal = find_signal(name, key_place(section, name), what);
            const auto number = to_number(*factor, fmt::format("the factor of '{}'", name), reading.messages);
            if (signal && number) made.terms.push_back({*signal, *number});
        }
    }
    /// What stands behind a key of a signal.
    void take(Word key, const toml::node& node, const std::string& what, Word kind, linkage::Signal& made) const {
        if (key == "near" || (key == "along" && kind == "along"))
            made.number = to_radians(reading.made.units, to_number(node, what, reading.messages).value_or(0));
        else if (key == "angle" || key == "to" || key == "on")
            (key == "angle" ? made.of : key == "to" ? made.to : made.on) = link(node, what);
        else if (key == "distance" || key == "ratio")
            two(node, what, made.of, made.to);
        else if (key == "from-line")
            two(node, what, made.to, made.end);
        else if (key == "slide")
            made.of = find_slide(reading, node, what).value_or(0);
        else if (key == "sum")
            sum(node, what, made);
        else
            made.of = pin(node, what);
    }
    const SignalKind* kind_of_table(std::size_t i) const {
        const SignalKind* found = nullptr;
        for (const SignalKind& kind : kinds)
            if (tables[i]->contains(kind.key)) {
                if (found != nullptr) return nullptr;
                found = &kind;
            }
        return found;
    }
    void read(std::size_t i) {
        LinkageSignal& signal = reading.made.signals[i];
        const std::string title = fmt::format("the signal '{}'", signal.name);
        const SignalKind* kind = kind_of_table(i);
        if (kind == nullptr) {
            std::vector<Word> words;
            for (const SignalKind& one : kinds)
                words.push_back(one.key);
            return add_error(reading.messages, places[i],
                             fmt::format("{} needs exactly one of {}", title, listed(words)));
        }
        signal.kind = kind->key;
        signal.value.kind = kind->is;
        Section section{tables[i], title, places[i]};
        for (const Word key : {kind->key, kind->beside[0], kind->beside[1]}) {
            if (key.empty()) continue;
            const toml::node* node = find(section, key);
            const bool needed = key == "point";
            if (node != nullptr)
                take(key, *node, name_of(section, key), kind->key, signal.value);
            else if (needed)
                add_error(reading.messages, section.place, fmt::format("{} is missing", name_of(section, key)));
        }
        report_unknown_keys(section, reading.messages);
    }
    /// The unit of a signal: "mixed" where a sum adds different ones, "circle" where it is made of itself.
    Word unit_of(std::size_t i) {
        if (!units[i].empty()) return units[i];
        for (const SignalKind& kind : kinds)
            if (kind.key == signals()[i].kind && !kind.unit.empty()) return units[i] = kind.unit;
        units[i] = "circle";
        Word unit;
        const auto take = [&](Word name) {
            for (std::size_t k = 0; k < signals().size(); ++k)
                if (signals()[k].name == name) {
                    const Word more = unit_of(k);
                    unit = unit.empty() || unit == more || more == "circle" ? more : unit == "circle" ? unit : "mixed";
                }
        };
        if (tables[i] == nullptr) return units[i] = signals()[i].unit == Unit::angle ? "angle" : "length";
        if (const toml::table* terms = (*tables[i])["sum"].as_table())
            for (const auto& [name, factor] : *terms)
                take(name.str());
        if (const toml::array* list = (*tables[i])["ratio"].as_array())
            for (const toml::node& entry : *list)
                if (const auto name = entry.value_exact<std::string>()) take(*name);
        if (unit != "circle" && signals()[i].kind == "ratio") unit = unit == "mixed" ? "quotient" : "ratio";
        return units[i] = unit.empty() ? Word("ratio") : unit;
    }
};

bool is_one_of(std::span<const Word> words, Word word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Where targets have names: why a quantity is neither of one of them nor of a signal; empty if it is of one.
std::string unknown_owner(const SignalReading& signals, const std::string& name, std::string_view quantity) {
    const std::vector<NamedTarget> targets = named_targets(signals.reading.file);
    if (targets.empty() || name.size() == quantity.size()) return {};
    std::vector<Word> known;
    for (const NamedTarget& target : targets)
        known.push_back(target.name);
    for (const LinkageSignal& signal : signals.signals())
        known.push_back(signal.name);
    if (is_one_of(known, name) || is_name_of_room(signals.reading.made, name)) return {};
    return fmt::format("there is no target and no signal {}; {}", reading::quoted(name), remedy(name, known));
}

void check_quantity(const SignalReading& signals, const toml::node& node, const std::string& what) {
    const auto text = node.value_exact<std::string>();
    if (!text) return report_kind(node, what, "the name of a quantity", signals.reading.messages);
    const std::string quantity(without_whole(*text));
    if (is_one_of(of_targets, quantity)) return;
    const std::string name = quantity.substr(0, quantity.find('.'));
    for (const NamedTarget& target : named_targets(signals.reading.file)) {
        if (target.name != name) continue;
        const std::span<const Word> words = target.of->words();
        if (name.size() < quantity.size() && is_one_of(words, Word(quantity).substr(name.size() + 1))) return;
        std::string known;
        for (std::size_t i = 0; i < words.size(); ++i)
            known += fmt::format("{}{}.{}", i == 0 ? "" : i + 1 == words.size() ? " and " : ", ", name, words[i]);
        return add_error(
            signals.reading.messages, place_of(node),
            fmt::format("{}: {} is no quantity of '{}': it has {}", what, reading::quoted(*text), name, known));
    }
    if (const std::string fault = unknown_owner(signals, name, quantity); !fault.empty())
        return add_error(signals.reading.messages, place_of(node), fmt::format("{}: {}", what, fault));
    std::string fault;
    if (!to_linkage_quantity(signals.reading.made, quantity, fault))
        add_error(signals.reading.messages, place_of(node), fmt::format("{}: {}", what, fault));
}

void check_quantities(const SignalReading& signals, const toml::node& node, const std::string& what) {
    const toml::array* list = node.as_array();
    if (list == nullptr) return check_quantity(signals, node, what);
    for (const toml::node& entry : *list)
        check_quantity(signals, entry, what);
}

}  // namespace

bool is_reserved_name(std::string_view name) {
    return is_one_of(ready_made_quantities, name) || is_one_of(of_targets, name);
}

void read_signal_section(LinkageReading& reading) {
    SignalReading signals{reading};
    const std::size_t before = reading.made.signals.size();
    signals.tables.resize(before, nullptr);
    signals.places.resize(before);
    if (std::optional<Section> section = read_section(reading.file, "signals", reading.messages)) {
        for (const auto& [name, node] : in_order(*section->table)) {
            const FilePlace place = key_place(*section, name);
            if (is_reserved_name(name)) {
                add_error(reading.messages, place,
                          fmt::format("'{}' cannot be the name of a signal: it is a quantity already", name));
                continue;
            }
            if (is_name_of_room(reading.made, name)) {
                add_error(reading.messages, place,
                          fmt::format("'{}' cannot be the name of a signal: a room or a region has it", name));
                continue;
            }
            const auto all = std::span(reading.made.signals).first(before);
            if (std::any_of(all.begin(), all.end(), [&](const LinkageSignal& one) { return one.name == name; })) {
                add_error(reading.messages, place,
                          fmt::format("'{}' is a signal of this mechanism already, which can be asked for as it is: "
                                      "leave it out, or give another one another name",
                                      name));
                continue;
            }
            if (!is_name(reading, name, place, "signal")) continue;
            const toml::table* table = node->as_table();
            if (table == nullptr) {
                report_kind(*node, fmt::format("the signal '{}'", name), "a table, like { angle = \"rocker\" }",
                            reading.messages);
                continue;
            }
            reading.made.signals.emplace_back().name = name;
            signals.tables.push_back(table);
            signals.places.push_back(place);
            reading.signal_places.push_back(place);
        }
        std::vector<std::string> names;
        for (const LinkageSignal& signal : reading.made.signals)
            names.push_back(signal.name);
        report_case_twins(reading, names, signals.places, "signal");
    }
    for (std::size_t i = before; i < signals.tables.size(); ++i)
        signals.read(i);
    signals.units.resize(signals.tables.size());
    for (std::size_t i = before; i < signals.tables.size(); ++i) {
        const Word unit = signals.unit_of(i);
        // By a displacement a point has as much speed as there are lengths in one.
        const auto& drives = reading.made.structure.drives;
        const bool by_length = !drives.empty() && drives.front().of_slide;
        const bool by_time = unit == "speed" || unit == "acceleration";
        reading.made.signals[i].unit = unit == "angle"                               ? Unit::angle
                                       : unit == "length" || (by_time && !by_length) ? Unit::length
                                       : unit == "curvature"                         ? Unit::curvature
                                                                                     : Unit::none;
        if (unit == "circle")
            add_error(reading.messages, signals.places[i],
                      fmt::format("the signal '{}' is made of itself", reading.made.signals[i].name));
        else if (unit == "mixed")
            add_error(reading.messages, signals.places[i],
                      fmt::format("the signal '{}' adds what has different units: add angles to angles and lengths to "
                                  "lengths",
                                  reading.made.signals[i].name));
    }
}

void read_asked(LinkageReading& reading) {
    const SignalReading signals{reading};
    for (Section& section : sections_in(reading, "require", keys::requirement)) {
        if (const toml::node* node = find(section, "quantity"))
            check_quantity(signals, *node, name_of(section, "quantity"));
        else
            add_error(reading.messages, section.place, fmt::format("'quantity' in {} is missing", section.title));
        const auto equal = read_number(section, "equal", reading.messages),
                   min = read_number(section, "min", reading.messages),
                   max = read_number(section, "max", reading.messages);
        if (!has(section, "equal") && !has(section, "min") && !has(section, "max"))
            add_error(reading.messages, section.place,
                      fmt::format("{} asks for nothing: write 'equal', 'min' or 'max'", section.title));
        if ((equal && (min || max)) || (min && max && *min > *max))
            add_error(reading.messages, section.place,
                      fmt::format("{} can be met by no value: write 'equal', or 'min' not above 'max'", section.title));
        report_unknown_keys(section, reading.messages);
    }
    const toml::node* objective = find(reading.file, "objective");
    if (objective == nullptr) return;
    std::vector<const toml::table*> tables;
    if (const toml::array* list = objective->as_array()) {
        for (const toml::node& entry : *list)
            if (entry.is_table()) tables.push_back(entry.as_table());
    } else if (objective->is_table()) {
        tables.push_back(objective->as_table());
    }
    if (tables.empty()) report_kind(*objective, "'objective'", "a table", reading.messages);
    for (const toml::table* table : tables) {
        Section section{table, "[objective]", place_of(*table), keys::objective};
        for (const char* key : {"minimize", "maximize"})
            if (const toml::node* node = find(section, key)) check_quantities(signals, *node, name_of(section, key));
        read_number(section, "weight", reading.messages);
        read_choice(section, "reduce", "reduction", reading.messages);
        for (const char* key : {"rank", "within"})  // which are read once the quantities are known
            find(section, key);
        if (has(section, "minimize") == has(section, "maximize"))
            add_error(reading.messages, section.place, "[objective] needs either 'minimize' or 'maximize'");
        report_unknown_keys(section, reading.messages);
    }
}

}  // namespace mechwright::reading
