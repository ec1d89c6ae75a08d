#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/text.h"
#include "synthesis/target/names.h"

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

/// False where there is none.
bool read_guided_point(LinkageReading& reading, Section& target, bool link_needed, const std::string& called) {
    const auto name = read_string(target, "point", reading.messages);
    if (!name) {
        if (!has(target, "point"))
            add_error(reading.messages, target.place,
                      fmt::format("{} is missing: name the point that is guided, like point = \"P\"",
                                  name_of(target, "point")));
        if (link_needed) read_link(reading, target, "link", true);
        return false;
    }
    const auto pin = find_pin(reading, *name, place_of(target, "point"), name_of(target, "point"));
    if (!pin) return false;
    const auto link = guiding_link(reading, target, *pin, link_needed);
    if (!link) return false;
    const auto& points = reading.made.structure.pins[*pin].points;
    if (std::any_of(points.begin(), points.end(), [](const auto& point) { return point.link == 0; })) {
        add_error(reading.messages, place_of(target, "point"),
                  fmt::format("'{}' is a point of the frame, which does not move: name one that does", *name));
        return false;
    }
    reading.made.guided.push_back({*pin, *link, link_needed, called});
    return true;
}

/// Whether an angle of a link goes into a signal.
bool has_angle(const Linkage& linkage, std::size_t signal) {
    const linkage::Signal& s = linkage.signals[signal].value;
    if (s.kind == linkage::Signal::Kind::angle) return true;
    return s.kind == linkage::Signal::Kind::sum && std::any_of(s.terms.begin(), s.terms.end(), [&](const auto& term) {
               return has_angle(linkage, term.signal);
           });
}

/// Why a signal cannot be the output of a function; empty if it can.
std::string why_no_output(const Linkage& made, std::size_t output) {
    if (made.signals[output].unit == Unit::curvature)
        return "is a curvature: the output of a function is an angle or a length; name a signal that is one";
    if (made.signals[output].unit == Unit::none)
        return "is a ratio: the output of a function is an angle or a length; name a signal that is one";
    std::vector<linkage::Signal> signals;
    for (const LinkageSignal& signal : made.signals)
        signals.push_back(signal.value);
    if (has_angle(made, output) && !linkage::turns_are_alike(signals, output))
        return "is a sum of angles times factors that are no whole numbers, of which a pose alone does not say the "
               "turns: name the angle of a link";
    return {};
}

/// The signal that is to be a function of the input.
void read_output(LinkageReading& reading, Section& function, const std::string& called) {
    const auto name = read_string(function, "signal", reading.messages);
    if (!name) {
        if (!has(function, "signal"))
            add_error(reading.messages, function.place,
                      fmt::format("{} is missing: name the signal that is the output, like signal = \"swing\" with "
                                  "[signals] swing = {{ angle = \"rocker\" }}",
                                  name_of(function, "signal")));
        return;
    }
    std::vector<std::string_view> known;
    for (const LinkageSignal& signal : reading.made.signals)
        known.push_back(signal.name);
    const auto output = static_cast<std::size_t>(std::find(known.begin(), known.end(), *name) - known.begin());
    if (output == known.size())
        return add_error(reading.messages, place_of(function, "signal"),
                         fmt::format("there is no signal {}; {}", reading::quoted(*name),
                                     known.empty() ? "signals stand in [signals]" : remedy(*name, known)));
    if (const std::string why = why_no_output(reading.made, output); !why.empty())
        return add_error(reading.messages, place_of(function, "signal"), fmt::format("'{}' {}", *name, why));
    reading.made.over_input.push_back({called, Followed::nothing, output});
}

/// Why a target's name cannot be one beside those before it; empty if it can.
std::string why_no_name(const Linkage& made, const std::string& name, const std::vector<std::string>& before) {
    constexpr std::array<std::string_view, 5> words{"assembly", "scale", "tilt", "origin-x", "origin-y"};
    if (is_reserved_name(name) || std::find(words.begin(), words.end(), name) != words.end())
        return "is a word of its own in results";
    if (std::any_of(made.signals.begin(), made.signals.end(), [&](const auto& signal) { return signal.name == name; }))
        return "is a signal already";
    if (is_name_of_room(made, name)) return "is the name of a room or a region already";
    if (std::find(before.begin(), before.end(), name) != before.end()) return "is another target already";
    return {};
}

/// The targets of one sort: those of paths and poses, or of what is asked over an input range.
struct TargetSections {
    std::vector<Section> sections{};
    std::vector<std::string_view> of{};  ///< the section that each is, without brackets
    std::string_view example;            ///< what a quantity of one with a name is called

    void add(LinkageReading& reading, std::string_view section) {
        for (Section& one : read_sections(reading.file, section, reading.messages)) {
            sections.push_back(std::move(one));
            of.push_back(section);
        }
    }
};

/// Names of signals and of targets that were read, which nothing else can have.
struct KnownNames {
    std::vector<std::string> names{};
    std::vector<FilePlace> places{};
};

/// What a target is called; empty where it is the only one of its sort and has no name.
std::string read_target_name(LinkageReading& reading, Section& target, const TargetSections& all, KnownNames& known) {
    if (const auto weight = read_number(target, "weight", reading.messages); weight && !(*weight > 0))
        add_error(reading.messages, place_of(target, "weight"),
                  fmt::format("{} must be greater than 0, not {}", name_of(target, "weight"), *weight));
    const auto name = read_string(target, "name", reading.messages);
    if (!name && !has(target, "name") && all.sections.size() > 1)
        add_error(
            reading.messages, target.place,
            fmt::format("{} is missing: where there are several {} each has a name, like name = \"foot\", by "
                        "which its quantities are called, foot.{}",
                        name_of(target, "name"),
                        all.example == "path-rms" ? "paths and poses" : "functions, lines and arcs", all.example));
    if (!name) return {};
    if (!is_name(reading, *name, place_of(target, "name"), name_of(target, "name"))) return {};
    if (const std::string why = why_no_name(reading.made, *name, known.names); !why.empty())
        add_error(reading.messages, place_of(target, "name"),
                  fmt::format("{}: {} {}: give the target another name", name_of(target, "name"),
                              reading::quoted(*name), why));
    else {
        known.names.push_back(*name);
        known.places.push_back(place_of(target, "name"));
    }
    return *name;
}

/// What a function, a line or an arc is of.
void read_over_input(LinkageReading& reading, Section& target, std::string_view section, const std::string& called) {
    if (section == "function") return read_output(reading, target, called);
    if (!read_guided_point(reading, target, false, {})) return;
    std::vector<GuidedPoint>& guided = reading.made.guided;
    guided.back().follows = true;
    reading.made.over_input.push_back({called, section == "line" ? Followed::line : Followed::arc, guided.size() - 1});
}

}  // namespace

void read_linkage_targets(LinkageReading& reading) {
    TargetSections paths{{}, {}, "path-rms"}, over_input{{}, {}, "function-max"};
    // In the order in which the readers of these sections come to them.
    for (const std::string_view section : sections_of_places)
        paths.add(reading, section);
    for (const std::string_view section : sections_over_input)
        over_input.add(reading, section);
    const std::size_t count = paths.sections.size() + over_input.sections.size();
    if (count > most_targets)
        return add_error(reading.messages, (over_input.sections.empty() ? paths : over_input).sections.back().place,
                         fmt::format("{} targets are too many: a problem has {} at most", count, most_targets));
    KnownNames known;
    for (std::size_t i = 0; i < paths.sections.size(); ++i) {
        Section& target = paths.sections[i];
        read_guided_point(reading, target, paths.of[i] == "poses", read_target_name(reading, target, paths, known));
    }
    for (std::size_t i = 0; i < over_input.sections.size(); ++i) {
        Section& target = over_input.sections[i];
        read_over_input(reading, target, over_input.of[i], read_target_name(reading, target, over_input, known));
    }
    for (std::size_t i = 0; i < reading.made.signals.size(); ++i) {
        known.names.push_back(reading.made.signals[i].name);
        known.places.push_back(reading.signal_places[i]);
    }
    report_case_twins(reading, known.names, known.places, "name");
    if (find(reading.file, "instant") != nullptr)
        add_error(reading.messages, key_place(reading.file, "instant"),
                  "[instant] is no target of a linkage: what its signals do at one crank angle is a quantity; write "
                  "[[require]] quantity = \"NAME.speed.at(60)\", equal = ...");
}

}  // namespace mechwright::reading
