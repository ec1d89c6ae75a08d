#include "synthesis/report/structure/structure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numbers>

#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/problem/linkage/larger_groups.h"
#include "synthesis/problem/linkage/sides.h"
#include "synthesis/report/structure/assemblies.h"
#include "synthesis/report/structure/circuits.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;
using linkage::Group;
using Kind = Group::Kind;

constexpr std::array<std::string_view, 9> kind_names{"drive", "gear", "one position", "RRR",         "RRP",
                                                     "RPR",   "RPP",  "PRP",          "larger group"};

std::vector<std::string> names_of(const Linkage& l, const std::vector<std::size_t>& links) {
    std::vector<std::string> names;
    for (const std::size_t link : links)
        names.push_back(l.links[link]);
    return names;
}

std::vector<std::string> links_at(const Linkage& l, const linkage::Pin& pin) {
    std::vector<std::size_t> links;
    for (const linkage::Point& point : pin.points)
        links.push_back(point.link);
    std::sort(links.begin(), links.end());
    return names_of(l, links);
}

/// With these dimensions: redundant links fit, so that they hold nothing and the drives settle what moves.
int mobility_of(const Linkage& l) {
    return l.redundant.empty() ? l.mobility.mobility : static_cast<int>(l.structure.drives.size());
}

std::string slide_name(const Linkage& l, std::size_t slide) {
    return l.slides[slide].empty() ? fmt::format("slide {}", slide + 1) : l.slides[slide];
}

Json joints_of(const Linkage& l) {
    Json joints = Json::array();
    const linkage::Structure& s = l.structure;
    for (std::size_t i = 0; i < s.pins.size(); ++i) {
        std::vector<std::string> links = links_at(l, s.pins[i]);
        for (const linkage::Slot& slot : s.slots)  // the end of a redundant link that is let go
            if (slot.pin == i && is_redundant(l, slot.line.on)) links.push_back(l.links[slot.line.on]);
        if (links.size() > 1) joints.push_back({{"kind", "pin"}, {"name", l.pins[i]}, {"links", links}});
    }
    for (std::size_t i = 0; i < s.slides.size(); ++i)
        joints.push_back({{"kind", "slide"},
                          {"name", slide_name(l, i)},
                          {"links", {l.links[s.slides[i].link], l.links[s.slides[i].line.on]}}});
    for (const linkage::Slot& slot : s.slots)
        if (!is_redundant(l, slot.line.on)) {
            std::vector<std::string> links = links_at(l, s.pins[slot.pin]);
            links.push_back(l.links[slot.line.on]);
            joints.push_back({{"kind", "slot"}, {"name", l.pins[slot.pin]}, {"links", links}});
        }
    for (const linkage::Gear& g : s.gears)
        if (!g.parallel)
            joints.push_back({{"kind", "gear"},
                              {"name", fmt::format("{} {}", l.links[g.first], l.links[g.second])},
                              {"links", {l.links[g.first], l.links[g.second], l.links[g.carrier]}}});
    for (const linkage::Rack& r : s.racks)
        joints.push_back({{"kind", "rack"},
                          {"name", fmt::format("{} {}", l.links[s.slides[r.slide].link], l.links[r.wheel])},
                          {"links", {l.links[s.slides[r.slide].link], l.links[r.wheel], l.links[r.carrier]}}});
    return joints;
}

/// The links that are one joint too many; not those that only point to their pins in the parallelograms that these
/// keep.
Json redundant_names(const Linkage& l) {
    return names_of(l, std::vector(l.redundant.begin(),
                                   l.redundant.end() - static_cast<std::ptrdiff_t>(l.kept_by_redundant.size())));
}

/// The segments of a drive's motion.
Json segments_of(const Linkage& l, const linkage::DriveMotion<double>& motion, bool of_slide) {
    const double angle_unit = l.units.degrees ? 180 / std::numbers::pi : 1;
    Json segments = Json::array();
    for (const cam::Segment<double>& segment : motion.segments) {
        Json one{{"kind", segment_kind_names[static_cast<std::size_t>(segment.kind)]},
                 {"angle", segment.angle * angle_unit}};
        if (segment.kind != cam::SegmentKind::dwell) one["lift"] = segment.lift * (of_slide ? 1 : angle_unit);
        segments.push_back(std::move(one));
    }
    return segments;
}

Json drives_of(const Linkage& l) {
    Json drives = Json::array();
    for (std::size_t i = 0; i < l.structure.drives.size(); ++i) {
        const linkage::Drive& drive = l.structure.drives[i];
        Json one = drive.of_slide ? Json{{"slide", slide_name(l, drive.slide)}}
                                  : Json{{"link", l.links[drive.link]}, {"on", l.links[drive.on]}};
        if (i > 0) {
            if (l.drives[i].motion)
                one["segments"] = segments_of(l, *l.drives[i].motion, drive.of_slide);
            else
                one["ratio"] = l.drives[i].ratio;
            one["phase"] = l.drives[i].phase * (drive.of_slide || !l.units.degrees ? 1 : 180 / std::numbers::pi);
        }
        if (l.drives[i].speed) one["speed"] = *l.drives[i].speed;
        drives.push_back(std::move(one));
    }
    return drives;
}

/// The numbers that a group reads: those of the joints that it has with itself and with what is placed before it.
std::vector<linkage::Number> numbers_read(const Linkage& l, std::size_t group) {
    std::vector<bool> own(l.structure.links, false), there(l.structure.links, false);
    there[0] = true;
    for (std::size_t i = 0; i <= group; ++i)
        for (const std::size_t link : l.order.groups[i].links)
            there[link] = true, own[link] = own[link] || i == group;
    std::vector<linkage::Number> read;
    const auto coordinates = [&read](const linkage::Coordinates& c) { read.insert(read.end(), {c.first, c.second}); };
    const auto joined = [&](std::vector<std::size_t> links) {
        return std::all_of(links.begin(), links.end(), [&](std::size_t i) { return there[i]; }) &&
               std::any_of(links.begin(), links.end(), [&](std::size_t i) { return own[i]; });
    };
    const auto pin = [&](const linkage::Pin& at) {
        for (const linkage::Point& point : at.points)
            if (there[point.link]) coordinates(point.at);
    };
    const auto line = [&](const linkage::Line& of) {
        coordinates(of.through);
        if (of.by_angle)
            read.push_back(of.angle);
        else
            coordinates(of.towards);
    };
    const linkage::Structure& s = l.structure;
    for (const linkage::Pin& at : s.pins) {
        std::size_t known = 0;
        bool mine = false;
        for (const linkage::Point& point : at.points)
            known += there[point.link], mine = mine || own[point.link];
        if (mine && known > 1) pin(at);
    }
    for (const linkage::Slide& slide : s.slides)
        if (joined({slide.link, slide.line.on})) {
            line(slide.line);
            read.insert(read.end(), {slide.angle, slide.offset});
        }
    for (const linkage::Slot& slot : s.slots) {
        const auto& points = s.pins[slot.pin].points;
        if (std::any_of(points.begin(), points.end(), [&](const auto& p) { return joined({p.link, slot.line.on}); })) {
            line(slot.line);
            pin(s.pins[slot.pin]);
        }
    }
    for (const linkage::Gear& gear : s.gears)
        if (joined({gear.first, gear.second, gear.carrier})) read.insert(read.end(), {gear.ratio, gear.phase});
    for (const linkage::Rack& rack : s.racks)
        if (joined({s.slides[rack.slide].link, rack.wheel, rack.carrier}))
            read.insert(read.end(), {rack.radius, rack.phase});
    return read;
}

std::vector<std::string> dimensions_read(const Linkage& l, std::size_t group) {
    std::vector<bool> in(l.dimensions.size(), false);
    for (const linkage::Number number : numbers_read(l, group))
        for (const auto& [dimension, factor] : l.numbers[number].value.terms)
            in[dimension] = true;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < in.size(); ++i)
        if (in[i]) names.push_back(l.dimensions[i].name);
    return names;
}

/// A side as a file says it whatever the order of its links.
Json side_of(const Linkage& l, const Group& group, int side) {
    if (group.kind != Kind::rrr) return word_of(group, side);
    return side_document(l, group, side);
}

Json groups_of(const Linkage& l) {
    Json groups = Json::array();
    for (std::size_t i = 0; i < l.order.groups.size(); ++i) {
        const Group& group = l.order.groups[i];
        Json one{{"kind", kind_names[static_cast<std::size_t>(group.kind)]}, {"links", names_of(l, group.links)}};
        if (group.links.size() == 1 && is_redundant(l, group.links[0])) one["redundant"] = true;
        for (const linkage::Gear& gear : l.structure.gears)
            if (gear.parallel && group.links[0] == gear.second) {
                one["kind"] = "parallel";
                one["parallel-to"] = l.links[gear.carrier];
            }
        if (group.choice != linkage::none && !one.contains("redundant")) {
            one["closed-at"] = l.pins[group.pin];
            one["side"] = side_of(l, group, l.sides[group.choice]);
        }
        if (group.kind == Kind::larger) {
            one["name"] = name_of_larger(l, group.larger);
            if (l.given() && !l.larger_counts.empty()) one["assemblies"] = l.larger_counts[group.larger];
        } else
            one["assemblies"] = one.contains("redundant") ? 1 : group.assemblies();
        one["dimensions"] = dimensions_read(l, i);
        groups.push_back(std::move(one));
    }
    return groups;
}

double shown_input(const Linkage& l, double at) {
    return l.units.degrees && !l.structure.drives.front().of_slide ? at * 180 / std::numbers::pi : at;
}

/// All assemblies at an input: of each the sides and where its moving points are.
Json assemblies_of(const Linkage& l, double at) {
    Json list = Json::array();
    for (const LinkageAssembly& assembly : assemblies_at(l, at)) {
        Json one{{"sides", Json::object()}};
        if (!assembly.larger.empty()) one["indices"] = Json::object();
        one["points"] = Json::object();
        one["as-in-file"] = assembly.as_in_file;
        for (const Group* group : chosen_dyads(l))
            one["sides"][l.pins[group->pin]] = word_of(*group, assembly.sides[group->choice]);
        for (std::size_t i = 0; i < assembly.larger.size(); ++i)
            one["indices"][name_of_larger(l, i)] = assembly.larger[i];
        for (std::size_t i = 0; i < l.pins.size(); ++i)
            if (!linkage::is_on(l.structure.pins[i], 0))
                one["points"][l.pins[i]] = {assembly.pose.pins[i].x, assembly.pose.pins[i].y};
        list.push_back(std::move(one));
    }
    return {{"crank", shown_input(l, at)}, {"assemblies", std::move(list)}};
}

/// Where it is shown if nothing says where: 0, or in the middle of the first branch where slides or stops limit it.
double usual_input(const Linkage& l, const Json& circuits) {
    const linkage::Drive& master = l.structure.drives.front();
    if ((!master.of_slide && !master.stops.any()) || circuits.is_null() || circuits.empty()) return 0;
    const Json& branch = circuits[0]["branches"][0];
    const double middle = 0.5 * (branch["from"].get<double>() + branch["to"].get<double>());
    return master.of_slide || !l.units.degrees ? middle : middle * std::numbers::pi / 180;
}

std::string list_text(const Json& names) {
    std::vector<std::string> words;
    for (const Json& name : names)
        words.push_back(name.get<std::string>());
    return fmt::format("{}", fmt::join(words, ", "));
}

std::string side_text(const Json& group) {
    if (group.contains("redundant")) return "redundant: it fits between its pins";
    if (group.contains("parallel-to"))
        return fmt::format("kept parallel to {} by redundant links", group["parallel-to"].get<std::string>());
    if (!group.contains("side")) return "";
    const Json& side = group["side"];
    const std::string at = fmt::format("closed at {}", group["closed-at"].get<std::string>());
    if (side.is_string()) return at + ", " + side.get<std::string>();
    return at + fmt::format(", {} of {} to {}", side["side"].get<std::string>(), side["from"].get<std::string>(),
                            side["to"].get<std::string>());
}

std::string groups_text(const Json& groups) {
    Table table{{Align::right, Align::left, Align::left, Align::left, Align::left}, {}};
    std::string larger, reads;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const Json& group = groups[i];
        const bool counted = group.contains("assemblies") && group["assemblies"] != 1;
        table.rows.push_back({std::to_string(i + 1), group["kind"].get<std::string>(), list_text(group["links"]),
                              side_text(group),
                              counted ? fmt::format("{} assemblies", group["assemblies"].get<std::size_t>()) : ""});
        if (!group["dimensions"].empty())
            reads += folded(fmt::format("  {:>2}  ", i + 1), "reads " + list_text(group["dimensions"]));
        if (group.contains("name"))
            larger += folded("", fmt::format("{} is a larger group: its links are placed together. A [sketch], or "
                                             "[assembly] with its index among the assemblies below, says how.",
                                             group["name"].get<std::string>()));
    }
    return to_text(table, 2) + (reads.empty() ? "" : "\nDimensions\n" + reads) + (larger.empty() ? "" : "\n" + larger);
}

std::string assemblies_text(const Json& all, const Linkage& l) {
    const bool slide = l.structure.drives.front().of_slide;
    std::string text = fmt::format("\nAssemblies at the {} {}: {}\n", slide ? "displacement" : "crank angle",
                                   number_text(all["crank"].get<double>()), all["assemblies"].size());
    std::size_t shown = 0;
    for (const Json& one : all["assemblies"]) {
        if (++shown > 64) return text + "  ...\n";
        std::string sides, points;
        for (const auto& [pin, side] : one["sides"].items())
            sides += fmt::format("{}{}{}{}", sides.empty() ? "" : ", ", pin, tied_space, side.get<std::string>());
        const Json indices = one.contains("indices") ? one["indices"] : Json::object();
        for (const auto& [group, index] : indices.items())
            sides += fmt::format("{}{}{}{}", sides.empty() ? "" : ", ", group, tied_space, index.get<std::size_t>());
        for (const auto& [pin, at] : one["points"].items())
            points += fmt::format("{}{}{}({},{}{})", points.empty() ? "" : ", ", pin, tied_space,
                                  number_text(at[0].get<double>(), 6), tied_space, number_text(at[1].get<double>(), 6));
        text += folded("  ", (sides.empty() ? "one position" : sides) + (one["as-in-file"] ? ", as in the file" : ""));
        text += folded("    ", points);
    }
    return text;
}

bool is_placed(const Linkage& l) { return l.given() && !l.structure.drives.empty(); }

}  // namespace

Json structure_of(const Linkage& l, std::optional<double> at) {
    Json json{{"title", l.title}, {"links", Json::array()}};
    for (std::size_t link = 0; link < l.links.size(); ++link) {
        std::vector<std::string> points;
        for (std::size_t i = 0; i < l.pins.size(); ++i)
            if (linkage::is_on(l.structure.pins[i], link)) points.push_back(l.pins[i]);
        for (const linkage::Slot& slot : l.structure.slots)
            if (slot.line.on == link && is_redundant(l, link)) points.push_back(l.pins[slot.pin]);
        json["links"].push_back({{"name", l.links[link]}, {"points", points}});
    }
    json["joints"] = joints_of(l);
    json["mobility"] = {{"mobility", mobility_of(l)},
                        {"for_almost_all_dimensions", l.mobility.mobility},
                        {"counted", l.mobility.counted},
                        {"drives", l.structure.drives.size()},
                        {"redundant", redundant_names(l)}};
    json["drives"] = drives_of(l);
    json["groups"] = groups_of(l);
    if (is_placed(l)) {
        Json circuits = l.order.closed() ? circuits_of(l) : Json();
        const double usual = l.order.closed() ? l.at.value_or(usual_input(l, circuits)) : usual_input(l);
        json.update(assemblies_of(l, at.value_or(usual)));
        if (!circuits.is_null()) json["circuits"] = std::move(circuits);
    }
    return json;
}

std::string structure_text(const Linkage& l, std::optional<double> at, bool colour) {
    const Json json = structure_of(l, at);
    std::string text = l.title.empty() ? "" : emphasised(l.title, Emphasis::strong, colour) + "\n\n";
    Json links = Json::array();
    for (const Json& link : json["links"])
        links.push_back(link["name"]);
    text += folded("links      ", fmt::format("{}: {}", links.size(), list_text(links)));
    std::string joints;
    for (const Json& joint : json["joints"])
        joints += fmt::format("{}{}{}{} ({})", joints.empty() ? "" : "; ", joint["kind"].get<std::string>(), tied_space,
                              joint["name"].get<std::string>(), list_text(joint["links"]));
    text += folded("joints     ", joints);
    text += folded("mobility   ",
                   l.redundant.empty()
                       ? fmt::format("{} by rank, {} by count", l.mobility.mobility, l.mobility.counted)
                       : fmt::format("{} with these dimensions, {} for almost all others, {} by count; redundant: {}",
                                     mobility_of(l), l.mobility.mobility, l.mobility.counted,
                                     list_text(json["mobility"]["redundant"])));
    std::string drives;
    for (const Json& drive : json["drives"])
        drives +=
            (drives.empty() ? "" : "; ") +
            (drive.contains("slide") ? "displacement of " + drive["slide"].get<std::string>()
                                     : fmt::format("angle of {} against {}", drive["link"].get<std::string>(),
                                                   drive["on"].get<std::string>())) +
            (!drive.contains("segments") ? "" : fmt::format(" by a motion of {} segments", drive["segments"].size()));
    text += folded("drives     ", drives) + "\nOrder of solution\n" + groups_text(json["groups"]);
    if (json.contains("assemblies")) text += assemblies_text(json, l);
    if (json.contains("circuits")) text += circuits_text(l, json["circuits"]);
    return text;
}

}  // namespace mechwright
