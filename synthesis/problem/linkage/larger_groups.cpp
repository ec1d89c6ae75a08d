#include "synthesis/problem/linkage/larger_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "analysis/linkage/motion/configurations.h"
#include "analysis/linkage/motion/least_missing.h"
#include "synthesis/mechanism/linkage/branches.h"
#include "synthesis/problem/linkage/closing.h"
#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/linkage/sides.h"
#include "synthesis/problem/text.h"

namespace mechwright {

namespace {

/// The group of links that has this larger group.
const linkage::Group& links_of_larger(const Linkage& linkage, std::size_t larger) {
    return *std::find_if(linkage.order.groups.begin(), linkage.order.groups.end(),
                         [larger](const linkage::Group& group) { return group.larger == larger; });
}

/// Finds assemblies group by group, each hung on those before it.
class Assembler {
public:
    Assembler(const Linkage& linkage, std::span<const double> numbers, std::span<const std::int8_t> sides, double input,
              bool closed)
        : linkage_(linkage), numbers_(numbers), input_(input), closed_(closed), moving_(driven(linkage, numbers)) {
        moving_.sides.assign(sides.begin(), sides.end());
        now_.sides = moving_.sides;
        now_.assembled.input = input;
        add();
    }

    std::vector<LargerAssembly> found{};

private:
    void add() {
        const std::size_t g = now_.indices.size();
        if (g == moving_.groups.size()) {
            const std::size_t last = closed_ ? linkage::none : linkage::margin_of_larger(linkage_.order, g - 1);
            if (!moving_.place(input_, {}, last)) return;
            if (!closed_) moving_.place(input_);  // the pins of the last group, too, whatever comes after it
            now_.pose = moving_.pose;
            return found.push_back(now_);
        }
        const std::size_t margin = linkage::margin_of_larger(linkage_.order, g);
        constexpr double reached = -1;  // which the group says of itself
        moving_.groups[g].near.clear();
        moving_.pose.margins[margin] = {};
        moving_.place(input_, {}, margin);
        if (moving_.pose.margins[margin].outer != reached) return;
        const auto all = linkage::configurations(linkage_.structure, numbers_, moving_, g).all;
        for (std::size_t i = 0; i < all.size(); ++i) {
            moving_.groups[g].near = all[i];
            now_.indices.push_back(i + 1);
            now_.assembled.places.push_back(all[i]);
            add();
            now_.indices.pop_back();
            now_.assembled.places.pop_back();
        }
        moving_.groups[g].near.clear();
    }

    const Linkage& linkage_;
    std::span<const double> numbers_;
    double input_;
    bool closed_;
    linkage::Driven<double> moving_;
    LargerAssembly now_{};
};

}  // namespace

std::string name_of_larger(const Linkage& linkage, std::size_t larger) {
    std::string name;
    for (const std::size_t link : links_of_larger(linkage, larger).links)
        name += (name.empty() ? "" : "+") + linkage.links[link];
    return name;
}

nlohmann::ordered_json larger_document(const Linkage& linkage, std::size_t larger, std::size_t index) {
    return {{"group", name_of_larger(linkage, larger)}, {"index", index}};
}

std::string larger_line(const Linkage& linkage, std::size_t larger, std::size_t index) {
    const std::string name = name_of_larger(linkage, larger);
    return fmt::format("{} = {{ group = \"{}\", index = {} }}",
                       linkage.links[links_of_larger(linkage, larger).links[0]], name, index);
}

std::vector<LargerAssembly> larger_assemblies(const Linkage& linkage, std::span<const double> numbers,
                                              std::span<const std::int8_t> sides, double input, bool closed) {
    return Assembler(linkage, numbers, sides, input, closed).found;
}

double larger_missing(const Linkage& linkage, std::span<const double> numbers, std::span<const std::int8_t> sides,
                      double input) {
    linkage::Driven<double> moving = driven(linkage, numbers);
    moving.sides.assign(sides.begin(), sides.end());
    constexpr double reached = -1;  // which the group says of itself
    for (std::size_t g = 0; g < moving.groups.size(); ++g) {
        const std::size_t margin = linkage::margin_of_larger(linkage.order, g);
        moving.pose.margins[margin] = {};
        if (moving.place(input, {}, margin) || moving.pose.margins[margin].outer != reached) break;
        const auto all = linkage::configurations(linkage.structure, numbers, moving, g).all;
        if (all.empty()) return linkage::least_missing(moving, g);
        moving.groups[g].near = all.front();
    }
    return std::numeric_limits<double>::infinity();
}

namespace reading {

bool read_larger_assembly(LinkageReading& reading, std::string_view key, const toml::node& node) {
    Linkage& made = reading.made;
    const toml::table* table = node.as_table();
    std::size_t larger = 0;
    for (; larger < made.order.larger.size(); ++larger) {
        const auto& links = links_of_larger(made, larger).links;
        if (name_of_larger(made, larger) == key ||
            std::any_of(links.begin(), links.end(), [&](std::size_t link) { return made.links[link] == key; }))
            break;
    }
    if (larger == made.order.larger.size()) return false;
    const std::string what = fmt::format("'{}' in [assembly]", key), name = name_of_larger(made, larger);
    const std::string remedy = fmt::format("write {{ group = \"{}\", index = 1 }}, or \"either\" to try all", name);
    reading.larger_places[larger] = place_of(node);
    if (table == nullptr) {
        if (node.value_exact<std::string>() == "either")
            made.larger[larger] = 0;
        else
            add_error(reading.messages, place_of(node), fmt::format("{} is of a group of links: {}", what, remedy));
        return true;
    }
    Section section{table, what, place_of(*table)};
    const auto group = read_string(section, "group", reading.messages);
    const auto index = read_whole_number(section, "index", reading.messages);
    report_unknown_keys(section, reading.messages);
    if (group && *group != name)
        add_error(reading.messages, section.place,
                  fmt::format("{}: the group of this link is \"{}\", not {}", what, name, reading::quoted(*group)));
    else if (!index || *index < 1 || *index > 10000)
        add_error(reading.messages, section.place, fmt::format("{}: {}", what, remedy));
    else
        made.larger[larger] = static_cast<int>(*index);
    return true;
}

namespace {

double shown_master(const Linkage& made, double input) {
    return made.units.degrees && !made.structure.drives.front().of_slide ? input * 180 / std::numbers::pi : input;
}

std::string larger_input_text(const Linkage& made, double input) {
    return fmt::format("{} {:.6g}", made.structure.drives.front().of_slide ? "displacement" : "crank angle",
                       shown_master(made, input));
}

/// The inputs at which assemblies are looked for: the one that the file says, else many.
std::vector<double> inputs_to_try(const Linkage& made, std::span<const double> numbers) {
    if (made.sketch) return {made.sketch->input};
    if (made.motion_at) return {*made.motion_at};
    constexpr int count = 72;
    const bool slide = made.structure.drives.front().of_slide;
    const double reach = slide ? 4 * linkage::farthest_point(made.structure, numbers) : std::numbers::pi;
    std::vector<double> inputs{0};
    for (int i = 1; i < count; ++i)
        inputs.push_back(slide ? (i % 2 == 0 ? 1 : -1) * reach * (i + 1) / count : 2 * reach * i / count);
    return inputs;
}

/// How far the points of a sketch are from where they are in a pose.
double apart_from(const LinkageSketch& sketch, const linkage::Pose<double>& pose) {
    double square = 0;
    for (const auto& [pin, at] : sketch.points) {
        const Vector<double> way = pose.pins[pin] - at;
        square += dot(way, way);
    }
    return square;
}

/// Those that the file allows. Where several are left to a group of which it says nothing, `unsaid` is that group.
std::vector<LargerAssembly> allowed(const Linkage& made, std::vector<LargerAssembly> all, std::size_t& unsaid) {
    std::erase_if(all, [&](const LargerAssembly& one) {
        for (std::size_t g = 0; g < one.indices.size(); ++g)
            if (const int index = made.larger[g].value_or(0); index != 0 && static_cast<int>(one.indices[g]) != index)
                return true;
        return false;
    });
    if (all.empty()) return all;
    const bool open = std::any_of(made.larger.begin(), made.larger.end(), [](const auto& index) { return !index; });
    if (open && made.sketch && !made.sketch->points.empty())
        return {*std::min_element(all.begin(), all.end(), [&](const LargerAssembly& a, const LargerAssembly& b) {
            return apart_from(*made.sketch, a.pose) < apart_from(*made.sketch, b.pose);
        })};
    for (std::size_t g = 0; g < made.larger.size(); ++g)
        if (!made.larger[g] && std::any_of(all.begin(), all.end(), [&](const LargerAssembly& one) {
                return one.indices[g] != all.front().indices[g];
            }))
            unsaid = std::min(unsaid, g);
    return all;
}

/// That a larger group closes at no input that was tried, and by how much it does not at some of them.
void report_open_larger(LinkageReading& reading, std::span<const double> numbers, const std::string& name) {
    const Linkage& made = reading.made;
    const std::vector<double> tried = inputs_to_try(made, numbers);
    double least = std::numeric_limits<double>::infinity(), nearest = tried.front();
    for (std::size_t i = 0; i < tried.size(); i += 6)
        for_each_assembly(made.sides, 2, [&](const std::vector<std::int8_t>& sides) {
            const double missing = larger_missing(made, numbers, sides, tried[i]);
            if (!(missing < least)) return;
            least = missing;
            nearest = tried[i];
        });
    const std::string by = std::isfinite(least) ? fmt::format(": {:.3g} {} are missing at the {}", least,
                                                              made.units.length, larger_input_text(made, nearest))
                                                : ", or what they hang on does not";
    add_error(reading.messages, place_of(reading.file, "links"),
              fmt::format("with these dimensions the links {} do not close at {}{}. Change a length{}", name,
                          tried.size() == 1 ? "the " + larger_input_text(made, nearest) : std::string("any input"), by,
                          tried.size() == 1 ? ", or say another input" : ""));
}

}  // namespace

void assemble_larger(LinkageReading& reading) {
    Linkage& made = reading.made;
    if (made.order.closed() || made.structure.drives.empty()) return;
    const std::vector<double> numbers = numbers_of(made, usual_dimensions(made));
    constexpr std::size_t most_assemblies = 64;
    std::size_t unsaid = linkage::none, most = 0;
    made.larger_counts.assign(made.order.larger.size(), 0);
    double at = 0;
    for (const double input : inputs_to_try(made, numbers)) {
        at = input;
        for_each_assembly(made.sides, most_open_sides, [&](const std::vector<std::int8_t>& sides) {
            std::vector<LargerAssembly> all = larger_assemblies(made, numbers, sides, input, false);
            most = std::max(most, all.size());
            for (const LargerAssembly& one : all)
                for (std::size_t g = 0; g < one.indices.size(); ++g)
                    made.larger_counts[g] = std::max(made.larger_counts[g], one.indices[g]);
            for (LargerAssembly& one : allowed(made, std::move(all), unsaid))
                made.assembled.push_back(std::move(one));
        });
        if (most > 0) break;
    }
    const std::string name = name_of_larger(made, unsaid == linkage::none ? 0 : unsaid);
    if (most == 0) {
        report_open_larger(reading, numbers, name);
    } else if (made.assembled.empty()) {
        add_error(reading.messages, reading.larger_places[0],
                  fmt::format("at the {} the links {} close in {} ways: the index must be one of them",
                              larger_input_text(made, at), name, most));
    } else if (unsaid != linkage::none) {
        made.unassembled = fmt::format(
            "the links {} close in {} ways at the {}: say which, by a [sketch], or by [assembly] {}, or "
            "\"either\" to try all",
            name, most, larger_input_text(made, at), larger_line(made, unsaid, 1));
    } else if (made.assembled.size() > most_assemblies) {
        made.unassembled = fmt::format(
            "{} assemblies are to be tried, {} at most can be: say the sides or indices of "
            "some groups",
            made.assembled.size(), most_assemblies);
    }
}

}  // namespace reading

}  // namespace mechwright
