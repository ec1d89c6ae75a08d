#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "synthesis/problem/linkage/reading.h"

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

}  // namespace

void read_linkage_targets(LinkageReading& reading) {
    struct Target {
        std::string_view section;
        bool of_body;
        Followed followed;
    };
    constexpr std::array<Target, 4> targets{{{"path", false, Followed::nothing},
                                             {"poses", true, Followed::nothing},
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
        read_guided_point(reading, target.section, target.of_body);
        reading.made.followed = target.followed;
    }
    for (const char* name : {"function", "instant"}) {
        if (find(reading.file, name) == nullptr) continue;
        add_error(reading.messages, key_place(reading.file, name),
                  fmt::format("a linkage cannot be designed for [{}] by this version: its targets are [path], [poses], "
                              "[line] and [arc]; requirements on signals stand in [[require]]",
                              name));
    }
}

}  // namespace mechwright::reading
