#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

/// The link of a point that moves: the one that is named, else the first that has it.
std::optional<std::size_t> guiding_link(LinkageReading& reading, Section& target, std::size_t pin, bool link_needed) {
    const auto& points = reading.made.structure.pins[pin].points;
    const std::string& name = reading.made.pins[pin];
    if (has(target, "link") || link_needed) {
        const auto link = read_link(reading, target, "link", true);
        if (!link) return {};
        if (std::none_of(points.begin(), points.end(), [&](const auto& point) { return point.link == *link; })) {
            add_error(reading.messages, place_of(target, "link"),
                      fmt::format("'{}' is no point of the link '{}': name one of that link, or another link", name,
                                  reading.made.links[*link]));
            return {};
        }
        return *link;
    }
    return points.front().link;
}

void read_guided_point(LinkageReading& reading, Section& target, bool link_needed, const std::string& called) {
    const auto name = read_string(target, "point", reading.messages);
    if (!name) {
        if (!has(target, "point"))
            add_error(reading.messages, target.place,
                      fmt::format("{} is missing: name the point that is guided, like point = \"P\"",
                                  name_of(target, "point")));
        if (link_needed) read_link(reading, target, "link", true);
        return;
    }
    const auto pin = find_pin(reading, *name, place_of(target, "point"), name_of(target, "point"));
    if (!pin) return;
    const auto link = guiding_link(reading, target, *pin, link_needed);
    if (!link) return;
    const auto& points = reading.made.structure.pins[*pin].points;
    if (std::any_of(points.begin(), points.end(), [](const auto& point) { return point.link == 0; }))
        return add_error(reading.messages, place_of(target, "point"),
                         fmt::format("'{}' is a point of the frame, which does not move: name one that does", *name));
    reading.made.guided.push_back({*pin, *link, link_needed, called});
}

/// Whether an angle of a link goes into a signal.
bool has_angle(const Linkage& linkage, std::size_t signal) {
    const linkage::Signal& s = linkage.signals[signal].value;
    if (s.kind == linkage::Signal::Kind::angle) return true;
    return s.kind == linkage::Signal::Kind::sum && std::any_of(s.terms.begin(), s.terms.end(), [&](const auto& term) {
               return has_angle(linkage, term.signal);
           });
}

/// The signal that is to be a function of the input.
void read_output(LinkageReading& reading) {
    std::optional<Section> function = read_section(reading.file, "function", reading.messages);
    if (!function) return;
    const auto name = read_string(*function, "signal", reading.messages);
    if (!name) {
        if (!has(*function, "signal"))
            add_error(reading.messages, function->place,
                      "'signal' in [function] is missing: name the signal that is the output, like "
                      "signal = \"swing\" with [signals] swing = { angle = \"rocker\" }");
        return;
    }
    std::vector<std::string_view> known;
    for (std::size_t i = 0; i < reading.made.signals.size(); ++i) {
        known.push_back(reading.made.signals[i].name);
        if (known.back() == *name) reading.made.output = i;
    }
    if (!reading.made.output)
        return add_error(reading.messages, place_of(*function, "signal"),
                         fmt::format("there is no signal {}; {}", reading::quoted(*name),
                                     known.empty() ? "signals stand in [signals]" : remedy(*name, known)));
    if (reading.made.signals[*reading.made.output].unit == Unit::none)
        return add_error(
            reading.messages, place_of(*function, "signal"),
            fmt::format("'{}' is a ratio: the output of a function is an angle or a length; name a signal that is "
                        "one",
                        *name));
    std::vector<linkage::Signal> signals;
    for (const LinkageSignal& signal : reading.made.signals)
        signals.push_back(signal.value);
    if (has_angle(reading.made, *reading.made.output) && !linkage::turns_are_alike(signals, *reading.made.output))
        add_error(reading.messages, place_of(*function, "signal"),
                  fmt::format("'{}' is a sum of angles times factors that are no whole numbers, of which a pose alone "
                              "does not say the turns: name the angle of a link",
                              *name));
}

constexpr std::size_t most_targets = 16;

/// Why a target's name cannot be one beside those before it; empty if it can.
std::string why_no_name(const Linkage& made, const std::string& name, const std::vector<std::string>& before) {
    constexpr std::array<std::string_view, 5> words{"assembly", "scale", "tilt", "origin-x", "origin-y"};
    if (is_reserved_name(name) || std::find(words.begin(), words.end(), name) != words.end())
        return "is a word of its own in results";
    if (std::any_of(made.signals.begin(), made.signals.end(), [&](const auto& signal) { return signal.name == name; }))
        return "is a signal already";
    if (std::find(before.begin(), before.end(), name) != before.end()) return "is another target already";
    return {};
}

/// What a path or poses are called; empty where they stand alone and have no name.
std::string read_target_name(LinkageReading& reading, Section& target, bool alone, std::vector<std::string>& names,
                             std::vector<FilePlace>& places) {
    if (const auto weight = read_number(target, "weight", reading.messages); weight && !(*weight > 0))
        add_error(reading.messages, place_of(target, "weight"),
                  fmt::format("{} must be greater than 0, not {}", name_of(target, "weight"), *weight));
    const auto name = read_string(target, "name", reading.messages);
    if (!name && !has(target, "name") && !alone)
        add_error(reading.messages, target.place,
                  fmt::format("{} is missing: where there are several paths and poses each has a name, like name = "
                              "\"foot\", by which its quantities are called, foot.path-rms",
                              name_of(target, "name")));
    if (!name) return {};
    if (!is_name(reading, *name, place_of(target, "name"), name_of(target, "name"))) return {};
    if (const std::string why = why_no_name(reading.made, *name, names); !why.empty())
        add_error(reading.messages, place_of(target, "name"),
                  fmt::format("{}: {} {}: give the target another name", name_of(target, "name"),
                              reading::quoted(*name), why));
    else {
        names.push_back(*name);
        places.push_back(place_of(target, "name"));
    }
    return *name;
}

/// The points and bodies of paths and poses, in the order in which read_path and read_poses come to them.
void read_guided(LinkageReading& reading) {
    std::vector<Section> paths = read_sections(reading.file, "path", reading.messages),
                         poses = read_sections(reading.file, "poses", reading.messages);
    const std::size_t count = paths.size() + poses.size();
    if (count > most_targets)
        return add_error(reading.messages, (paths.empty() ? poses : paths).back().place,
                         fmt::format("{} paths and poses are too many: a problem has {} at most", count, most_targets));
    std::vector<std::string> names;
    std::vector<FilePlace> places;
    for (const bool of_body : {false, true})
        for (Section& target : of_body ? poses : paths)
            read_guided_point(reading, target, of_body, read_target_name(reading, target, count == 1, names, places));
    for (std::size_t i = 0; i < reading.made.signals.size(); ++i) {
        names.push_back(reading.made.signals[i].name);
        places.push_back(reading.signal_places[i]);
    }
    report_case_twins(reading, names, places, "name");
}

/// A section that a linkage can have once only, in this version.
bool is_repeated(LinkageReading& reading, std::string_view section) {
    const toml::node* node = reading.file.table->get(section);
    if (node == nullptr || !node->is_array()) return false;
    find(reading.file, section);
    add_error(reading.messages, place_of(*node),
              fmt::format("a linkage has one [{0}] in this version, headed in single brackets; several can be had of "
                          "[[path]] and [[poses]]",
                          section));
    return true;
}

}  // namespace

void read_linkage_targets(LinkageReading& reading) {
    std::string_view first = has(reading.file, "path") ? "path" : has(reading.file, "poses") ? "poses" : "";
    if (!first.empty()) read_guided(reading);
    for (const auto& [section, followed] : {std::pair<std::string_view, Followed>("function", Followed::nothing),
                                            {"line", Followed::line},
                                            {"arc", Followed::arc}}) {
        if (!has(reading.file, section) || is_repeated(reading, section)) continue;
        if (!first.empty()) {
            find(reading.file, section);
            add_error(reading.messages, key_place(reading.file, section),
                      fmt::format("[{1}] does not go with [{0}] in this version: several targets of a problem are "
                                  "paths and poses; leave one of the two out",
                                  first, section));
            continue;
        }
        first = section;
        if (section == "function") {
            read_output(reading);
            continue;
        }
        if (auto target = read_section(reading.file, section, reading.messages))
            read_guided_point(reading, *target, false, {});
        reading.made.followed = followed;
    }
    if (find(reading.file, "instant") != nullptr)
        add_error(reading.messages, key_place(reading.file, "instant"),
                  "[instant] is no target of a linkage: what its signals do at one crank angle is a quantity; write "
                  "[[require]] quantity = \"NAME.speed.at(60)\", equal = ...");
}

}  // namespace mechwright::reading
