#include <fmt/format.h>

#include <numbers>

#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/schema/keys.h"

namespace mechwright::reading {

namespace {

/// A length where a slide is driven, else an angle in radians.
double in_program_units(const Linkage& made, double value, bool of_slide) {
    return of_slide || !made.units.degrees ? value : value * std::numbers::pi / 180;
}

void read_drive(LinkageReading& reading, Section& section, bool master) {
    Linkage& made = reading.made;
    linkage::Drive drive;
    drive.of_slide = has(section, "slide");
    bool whole = true;
    if (const toml::node* node = find(section, "slide")) {
        const auto slide = find_slide(reading, *node, name_of(section, "slide"));
        drive.slide = slide.value_or(0);
        whole = slide.has_value();
        for (const char* key : {"link", "on"})
            if (find(section, key) != nullptr)
                add_error(reading.messages, place_of(section, key),
                          fmt::format("{} drives a slide: leave '{}' out", section.title, key));
    } else {
        const auto link = read_link(reading, section, "link", true), on = read_link(reading, section, "on", false);
        whole = link && on;
        drive.link = link.value_or(0);
        drive.on = on.value_or(0);
        if (whole && drive.link == drive.on) {
            add_error(
                reading.messages, place_of(section, "link"),
                fmt::format("'{}' cannot turn against itself: name the link that the drive turns, and in 'on' the "
                            "one against which",
                            made.links[drive.link]));
            whole = false;
        }
    }
    LinkageDrive more;
    for (const char* key : {"ratio", "phase"})
        if (master && find(section, key) != nullptr)
            add_error(reading.messages, place_of(section, key),
                      fmt::format("'{}' is of further drives: the first is what they follow", key));
    more.ratio = read_number(section, "ratio", reading.messages).value_or(1);
    more.phase = in_program_units(made, read_number(section, "phase", reading.messages).value_or(0), drive.of_slide);
    more.speed = read_number(section, "speed", reading.messages);
    if (more.speed && drive.of_slide)
        add_error(
            reading.messages, place_of(section, "speed"),
            fmt::format("{} drives a slide, and 'speed' is turns per minute: leave it out; velocities are then per "
                        "unit of the displacement",
                        section.title));
    drive.stops = read_stops(reading, section, drive.of_slide ? Measure::length : Measure::angle);
    if (!drive.of_slide && drive.stops.min.has_value() != drive.stops.max.has_value())
        add_error(reading.messages, place_of(section, drive.stops.min ? "min" : "max"),
                  fmt::format("one stop does not end the turning of {}: give both 'min' and 'max'", section.title));
    if (const toml::node* node = find(section, "segment")) {
        const auto fail = [&](std::string_view text) {
            add_error(reading.messages, place_of(*node), fmt::format("{} {}", name_of(section, "segment"), text));
        };
        if (master)
            fail("is of further drives: the first is what they follow");
        else if (find(section, "ratio") != nullptr)
            fail("stands in place of 'ratio': leave one of them out");
        else if (!made.structure.drives.empty() && made.structure.drives.front().of_slide)
            fail(
                "is a motion over a turn of the first drive, which has to turn a link: let another drive be the first");
        else
            read_drive_motion(reading, section, *node, drive.of_slide, more);
    }
    report_unknown_keys(section, reading.messages);
    if (!whole) return;
    made.structure.drives.push_back(drive);
    made.drives.push_back(more);
    reading.drive_places.push_back(section.place);
}

}  // namespace

void read_drives(LinkageReading& reading) {
    const toml::node* node = find(reading.file, "drive");
    if (node == nullptr)
        return add_error(reading.messages, reading.file.place,
                         "the section [drive] is missing: it says what moves the linkage, like link = \"crank\"");
    if (const toml::table* table = node->as_table()) {
        Section section{table, "[drive]", place_of(*node), keys::drive};
        return read_drive(reading, section, true);
    }
    bool first = true;
    for (Section& section : sections_in(reading, "drive", keys::drive)) {
        read_drive(reading, section, first);
        first = false;
    }
}

}  // namespace mechwright::reading
