#include <fmt/format.h>

#include <algorithm>

#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/schema/keys.h"

namespace mechwright::reading {

namespace {

/// Turn of the second over that of the first by their teeth; absent if there are none that make sense.
std::optional<double> by_teeth(LinkageReading& reading, Section& section) {
    const auto teeth = read_numbers(section, "teeth", reading.messages);
    if (!teeth) return {};
    if (teeth->size() == 2 && (*teeth)[0] > 0 && (*teeth)[1] > 0) return (*teeth)[0] / (*teeth)[1];
    add_error(reading.messages, place_of(section, "teeth"),
              fmt::format("{} must be two numbers greater than 0, like [40, 80]", name_of(section, "teeth")));
    return {};
}

void read_gear(LinkageReading& reading, Section& section, bool belt) {
    Linkage& made = reading.made;
    linkage::Gear gear;
    bool whole = true;
    const toml::node* links = find(section, "links");
    const toml::array* list = links == nullptr ? nullptr : links->as_array();
    if (list == nullptr || list->size() != 2 || !list->get(0)->is_string() || !list->get(1)->is_string()) {
        add_error(reading.messages, place_of(section, "links"),
                  fmt::format("{} must be the names of two links", name_of(section, "links")));
        whole = false;
    } else {
        for (std::size_t i = 0; i < 2; ++i) {
            const auto link = find_link(reading, *list->get(i)->value<std::string>(), place_of(*list->get(i)),
                                        name_of(section, "links"));
            (i == 0 ? gear.first : gear.second) = link.value_or(0);
            whole = whole && link;
        }
    }
    const auto carrier = read_link(reading, section, "carrier", false);
    gear.carrier = carrier.value_or(0);
    const auto teeth = by_teeth(reading, section);
    const char* sense = belt ? "crossed" : "internal";
    const bool flag = read_bool(section, sense, reading.messages).value_or(false);
    if (has(section, "teeth") == has(section, "ratio"))
        add_error(reading.messages, section.place, fmt::format("{} needs either 'ratio' or 'teeth'", section.title));
    if (!belt && has(section, "internal") && !has(section, "teeth"))
        add_error(reading.messages, place_of(section, "internal"),
                  "'internal' belongs to 'teeth': a ratio has its own sign");
    if (teeth) {
        gear.ratio = add_constant(reading, flag != belt ? *teeth : -*teeth, Measure::ratio);
        find(section, "ratio");
    } else {
        gear.ratio = read_structure_number(reading, section, "ratio", Measure::ratio, 1);
        LinkageNumber& ratio = made.numbers[gear.ratio];
        if (ratio.value.terms.empty() && (belt ? !(ratio.value.constant > 0) : ratio.value.constant == 0) &&
            has(section, "ratio"))
            add_error(reading.messages, place_of(section, "ratio"),
                      belt ? "the ratio of a belt must be greater than 0: 'crossed' makes it turn the other way"
                           : "the ratio of a gear must be other than 0");
        if (belt && flag) {
            Affine turned;
            add(turned, ratio.value, -1);
            ratio.value = turned;
        }
    }
    gear.belt = belt;
    gear.phase = read_structure_number(reading, section, "phase", Measure::angle);
    report_unknown_keys(section, reading.messages);
    if (!whole || !carrier) return;
    if (gear.first == gear.second || gear.first == gear.carrier || gear.second == gear.carrier)
        return add_error(reading.messages, section.place,
                         fmt::format("{} needs two links that differ from each other and from their carrier '{}'",
                                     section.title, made.links[gear.carrier]));
    made.structure.gears.push_back(gear);
}

}  // namespace

void read_gears(LinkageReading& reading) {
    for (Section& section : sections_in(reading, "gear", keys::gear))
        read_gear(reading, section, false);
    for (Section& section : sections_in(reading, "belt", keys::belt))
        read_gear(reading, section, true);
}

void read_racks(LinkageReading& reading) {
    Linkage& made = reading.made;
    for (Section& section : sections_in(reading, "rack", keys::rack)) {
        const auto link = read_link(reading, section, "link", true), wheel = read_link(reading, section, "wheel", true);
        const auto carrier = read_link(reading, section, "carrier", false);
        if (!has(section, "radius"))
            add_error(reading.messages, section.place, fmt::format("{} is missing", name_of(section, "radius")));
        linkage::Rack rack;
        rack.radius = read_structure_number(reading, section, "radius", Measure::length, 1);
        rack.phase = read_structure_number(reading, section, "phase", Measure::length);
        report_unknown_keys(section, reading.messages);
        if (const LinkageNumber& radius = made.numbers[rack.radius];
            radius.value.terms.empty() && radius.value.constant == 0)
            add_error(reading.messages, place_of(section, "radius"), "the radius of a rack's wheel must not be 0");
        if (!link || !wheel || !carrier) continue;
        const auto& slides = made.structure.slides;
        const auto slide = std::find_if(slides.begin(), slides.end(), [&](const auto& s) { return s.link == *link; });
        if (slide == slides.end()) {
            add_error(
                reading.messages, place_of(section, "link"),
                fmt::format("'{0}' does not slide: a rack needs a [[slide]] with link = \"{0}\"", made.links[*link]));
            continue;
        }
        if (*wheel == *carrier || *wheel == *link) {
            add_error(reading.messages, place_of(section, "wheel"),
                      fmt::format("the wheel of {} must be another link than its carrier and its rack", section.title));
            continue;
        }
        rack.slide = static_cast<std::size_t>(slide - slides.begin());
        rack.wheel = *wheel;
        rack.carrier = *carrier;
        made.structure.racks.push_back(rack);
    }
}

}  // namespace mechwright::reading
