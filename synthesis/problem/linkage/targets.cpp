#include <fmt/format.h>

#include <algorithm>
#include <array>

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

void read_guided_point(LinkageReading& reading, std::string_view section, bool link_needed) {
    std::optional<Section> target = read_section(reading.file, section, reading.messages);
    if (!target) return;
    const auto name = read_string(*target, "point", reading.messages);
    if (!name) {
        if (!has(*target, "point"))
            add_error(reading.messages, target->place,
                      fmt::format("{} is missing: name the point that is guided, like point = \"P\"",
                                  name_of(*target, "point")));
        if (link_needed) read_link(reading, *target, "link", true);
        return;
    }
    const auto pin = find_pin(reading, *name, place_of(*target, "point"), name_of(*target, "point"));
    if (!pin) return;
    const auto link = guiding_link(reading, *target, *pin, link_needed);
    if (!link) return;
    const auto& points = reading.made.structure.pins[*pin].points;
    if (std::any_of(points.begin(), points.end(), [](const auto& point) { return point.link == 0; }))
        return add_error(reading.messages, place_of(*target, "point"),
                         fmt::format("'{}' is a point of the frame, which does not move: name one that does", *name));
    reading.made.guided = GuidedPoint{*pin, *link};
    reading.made.guides_body = link_needed;
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

}  // namespace

void read_linkage_targets(LinkageReading& reading) {
    struct Target {
        std::string_view section;
        bool of_body;
        Followed followed;
    };
    constexpr std::array<Target, 5> targets{{{"path", false, Followed::nothing},
                                             {"poses", true, Followed::nothing},
                                             {"function", false, Followed::nothing},
                                             {"line", false, Followed::line},
                                             {"arc", false, Followed::arc}}};
    std::string_view first;
    for (const Target& target : targets) {
        if (!has(reading.file, target.section)) continue;
        if (!first.empty()) {
            find(reading.file, target.section);
            add_error(reading.messages, key_place(reading.file, target.section),
                      fmt::format("a problem has one target, [{}] or [{}]: not both", first, target.section));
            continue;
        }
        first = target.section;
        if (first == "function") {
            read_output(reading);
            continue;
        }
        read_guided_point(reading, target.section, target.of_body);
        reading.made.followed = target.followed;
    }
    if (find(reading.file, "instant") != nullptr)
        add_error(reading.messages, key_place(reading.file, "instant"),
                  "[instant] is no target of a linkage: what its signals do at one crank angle is a quantity; write "
                  "[[require]] quantity = \"NAME.speed.at(60)\", equal = ...");
}

}  // namespace mechwright::reading
