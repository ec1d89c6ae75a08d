#include <fmt/format.h>

#include <algorithm>

#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string lower(std::string_view text) {
    std::string made(text);
    for (char& c : made)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return made;
}

std::vector<std::string_view> views(const std::vector<std::string>& names) { return {names.begin(), names.end()}; }

std::optional<std::size_t> find_in(LinkageReading& reading, const std::vector<std::string>& names,
                                   std::string_view name, FilePlace place, std::string_view what,
                                   std::string_view noun) {
    const auto at = std::find(names.begin(), names.end(), name);
    if (at != names.end()) return static_cast<std::size_t>(at - names.begin());
    add_error(reading.messages, place,
              fmt::format("{}: there is no {} {}; {}", what, noun, reading::quoted(name), remedy(name, views(names))));
    return {};
}

}  // namespace

bool is_name(LinkageReading& reading, std::string_view name, FilePlace place, std::string_view what) {
    const bool good = !name.empty() && is_letter(name.front()) && std::all_of(name.begin(), name.end(), [](char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
    if (!good)
        add_error(reading.messages, place,
                  fmt::format("{} {} is no name: names start with a letter and go on with letters, digits, '_' and '-'",
                              what, reading::quoted(name)));
    return good;
}

void report_case_twins(LinkageReading& reading, const std::vector<std::string>& names,
                       const std::vector<FilePlace>& places, std::string_view what) {
    std::vector<std::pair<std::string, std::size_t>> by_letters;
    for (std::size_t i = 0; i < names.size() && i < places.size(); ++i)
        by_letters.emplace_back(lower(names[i]), i);
    std::sort(by_letters.begin(), by_letters.end());
    for (std::size_t i = 1; i < by_letters.size(); ++i)
        if (by_letters[i].first == by_letters[i - 1].first)
            add_error(reading.messages, places[by_letters[i].second],
                      fmt::format("the {}s '{}' and '{}' differ by case only: give one another name", what,
                                  names[by_letters[i - 1].second], names[by_letters[i].second]));
}

void use(LinkageReading& reading, std::size_t dimension, Measure measure, FilePlace place) {
    LinkageDimension& d = reading.made.dimensions[dimension];
    if (d.measure == Measure::unknown) {
        d.measure = measure;
        reading.uses[dimension] = place;
    } else if (d.measure != measure) {
        add_error(
            reading.messages, place,
            fmt::format("'{}' is used as {} here and as {} {}: give each a dimension of its own", d.name,
                        name_of(measure), name_of(d.measure), place_text(reading.messages, reading.uses[dimension])));
    }
}

std::optional<LinkageNumber> to_linkage_number(LinkageReading& reading, const toml::node& node, std::string_view what,
                                               Measure measure) {
    if (node.is_number()) {
        const auto number = to_number(node, what, reading.messages);
        if (!number) return {};
        return LinkageNumber{{*number, {}}, measure};
    }
    const auto text = node.value_exact<std::string>();
    if (!text) {
        report_kind(node, what, "a number, or a sum of dimensions like \"ground - 0.5 crank\"", reading.messages);
        return {};
    }
    std::vector<std::string> names;
    for (const LinkageDimension& dimension : reading.made.dimensions)
        names.push_back(dimension.name);
    std::vector<std::size_t> used;
    const ParsedAffine parsed = parse_affine(*text, [&](std::string_view name, std::string& fault) {
        const auto at = std::find(names.begin(), names.end(), name);
        if (at == names.end()) {
            fault = fmt::format("there is no dimension {}; {}", reading::quoted(name),
                                names.empty() ? "give it in [dimensions]" : remedy(name, views(names)));
            return std::optional<std::size_t>();
        }
        used.push_back(static_cast<std::size_t>(at - names.begin()));
        return std::optional(used.back());
    });
    if (!parsed.fault.empty()) {
        add_error(reading.messages, place_of(node),
                  fmt::format("{} {}: {}", what, reading::quoted(*text), parsed.fault));
        return {};
    }
    if (measure != Measure::unknown)
        for (const std::size_t dimension : used)
            use(reading, dimension, measure, place_of(node));
    LinkageNumber number{{}, measure};
    number.value.constant = parsed.value.constant;
    for (const auto& [dimension, factor] : parsed.value.terms)
        if (dimension < reading.expanded.size())
            add(number.value, reading.expanded[dimension], factor);
        else
            add(number.value, {0, {{dimension, 1}}}, factor);
    return number;
}

linkage::Number add_number(LinkageReading& reading, LinkageNumber number) {
    reading.made.numbers.push_back(std::move(number));
    return reading.made.numbers.size() - 1;
}

linkage::Number add_constant(LinkageReading& reading, double value, Measure measure) {
    return add_number(reading, {{value, {}}, measure});
}

linkage::Number read_structure_number(LinkageReading& reading, Section& section, std::string_view key, Measure measure,
                                      double preset) {
    const toml::node* node = find(section, key);
    const auto number =
        node == nullptr ? std::nullopt : to_linkage_number(reading, *node, name_of(section, key), measure);
    return number ? add_number(reading, *number) : add_constant(reading, preset, measure);
}

std::optional<linkage::Coordinates> to_coordinates(LinkageReading& reading, const toml::node& node,
                                                   std::string_view what) {
    const auto pair = [&](const toml::node& a, const toml::node& b, Measure second, bool polar) {
        const auto x = to_linkage_number(reading, a, what, Measure::length);
        const auto y = to_linkage_number(reading, b, what, second);
        if (!x || !y) return std::optional<linkage::Coordinates>();
        const linkage::Number first = add_number(reading, *x);
        return std::optional(linkage::Coordinates{first, add_number(reading, *y), polar});
    };
    if (const toml::array* list = node.as_array(); list != nullptr && list->size() == 2)
        return pair(*list->get(0), *list->get(1), Measure::length, false);
    if (const toml::table* table = node.as_table();
        table != nullptr && table->size() == 2 && table->contains("length") && table->contains("angle"))
        return pair(*table->get("length"), *table->get("angle"), Measure::angle, true);
    add_error(reading.messages, place_of(node),
              fmt::format("{} must be a place on its link: [x, y] or {{ length = ..., angle = ... }}", what));
    return {};
}

std::optional<std::size_t> find_link(LinkageReading& reading, std::string_view name, FilePlace place,
                                     std::string_view what) {
    return find_in(reading, reading.made.links, name, place, what, "link");
}

std::optional<std::size_t> find_pin(LinkageReading& reading, std::string_view name, FilePlace place,
                                    std::string_view what) {
    return find_in(reading, reading.made.pins, name, place, what, "point");
}

std::optional<std::size_t> read_link(LinkageReading& reading, Section& section, std::string_view key, bool required) {
    const auto name = read_string(section, key, reading.messages);
    if (!name) {
        if (has(section, key)) return {};
        if (!required) return 0;
        add_error(reading.messages, section.place,
                  fmt::format("{} is missing: it names a link", name_of(section, key)));
        return {};
    }
    return find_link(reading, *name, place_of(section, key), name_of(section, key));
}

std::optional<std::size_t> find_slide(LinkageReading& reading, const toml::node& node, std::string_view what) {
    const Linkage& made = reading.made;
    if (const auto number = node.value_exact<std::int64_t>()) {
        if (*number >= 1 && static_cast<std::size_t>(*number) <= made.slides.size())
            return static_cast<std::size_t>(*number - 1);
        add_error(reading.messages, place_of(node),
                  made.slides.empty()
                      ? fmt::format("{}: there is no [[slide]]", what)
                      : fmt::format("{} must be a number from 1 to {}, not {}", what, made.slides.size(), *number));
        return {};
    }
    const auto name = node.value_exact<std::string>();
    if (!name) {
        report_kind(node, what, "the name or the number of a slide", reading.messages);
        return {};
    }
    if (const auto at = std::find(made.slides.begin(), made.slides.end(), *name);
        at != made.slides.end() && !name->empty())
        return static_cast<std::size_t>(at - made.slides.begin());
    std::vector<std::string_view> known;
    for (const std::string& slide : made.slides)
        if (!slide.empty()) known.push_back(slide);
    add_error(reading.messages, place_of(node),
              fmt::format("{}: there is no slide {}; {}", what, reading::quoted(*name),
                          made.slides.empty() ? "the mechanism has none"
                          : known.empty()     ? "give a [[slide]] this name"
                                              : remedy(*name, known)));
    return {};
}

std::vector<Section> sections_in(LinkageReading& reading, std::string_view name, std::span<const Key> keys) {
    std::vector<Section> sections;
    const toml::node* node = find(reading.file, name);
    if (node == nullptr) return sections;
    const toml::array* list = node->as_array();
    if (list == nullptr) {
        add_error(reading.messages, place_of(*node),
                  fmt::format("'{0}' must be a list of tables: write [[{0}]]", name));
        return sections;
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
        const toml::node& entry = *list->get(i);
        if (!entry.is_table())
            report_kind(entry, fmt::format("entry {} of '{}'", i + 1, name), "a table", reading.messages);
        else if (sections.size() == LinkageReading::most_joints)
            return add_error(reading.messages, place_of(entry),
                             fmt::format("more than {} of [[{}]]", LinkageReading::most_joints, name)),
                   sections;
        else
            sections.push_back({entry.as_table(), fmt::format("[[{}]] number {}", name, i + 1), place_of(entry), keys});
    }
    return sections;
}

}  // namespace mechwright::reading
