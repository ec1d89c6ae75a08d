#include <algorithm>
#include <numbers>

#include "synthesis/problem/bytes.h"
#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/toml/toml_text.h"

namespace mechwright {

std::string_view name_of(Measure measure) {
    switch (measure) {
        case Measure::length: return "a length";
        case Measure::angle: return "an angle";
        case Measure::ratio: return "a ratio";
        case Measure::unknown: break;
    }
    return "nothing";
}

bool Linkage::given() const {
    return std::all_of(dimensions.begin(), dimensions.end(),
                       [](const LinkageDimension& d) { return d.tied || d.given(); });
}

std::vector<double> numbers_of(const Linkage& linkage, const std::vector<double>& dimensions) {
    const double angle = linkage.units.degrees ? std::numbers::pi / 180 : 1;
    std::vector<double> numbers;
    for (const LinkageNumber& number : linkage.numbers)
        numbers.push_back(number.value.at(std::span<const double>(dimensions)) *
                          (number.measure == Measure::angle ? angle : 1));
    return numbers;
}

bool is_redundant(const Linkage& linkage, std::size_t link) {
    return std::find(linkage.redundant.begin(), linkage.redundant.end(), link) != linkage.redundant.end();
}

std::vector<double> usual_dimensions(const Linkage& linkage) {
    std::vector<double> dimensions;
    for (const LinkageDimension& d : linkage.dimensions)
        dimensions.push_back(d.start.value_or(d.min + (d.max - d.min) / 2));
    return dimensions;
}

bool ReadLinkage::ok() const {
    return !unreadable && std::all_of(messages.begin(), messages.end(), [](const Message& m) { return m.warning; });
}

namespace reading {

void read_linkage_table(const toml::table& table, Linkage& made, Messages& messages) {
    Section file{&table, "", {1, 1}, keys::of_file()};
    LinkageReading reading{file, made, messages};
    if (const auto name = table["mechanism"].value_exact<std::string>(); name != "linkage")
        return add_error(
            messages, place_of(file, "mechanism"),
            "this is no linkage: its structure is that of its kind; write mechanism = \"linkage\" for links "
            "and joints of your own");
    if (!has(file, "schema")) add_error(messages, file.place, "'schema' is missing: write schema = 1");
    if (const auto schema = read_whole_number(file, "schema", messages); schema && *schema != 1)
        add_error(messages, place_of(file, "schema"), "this schema is not known to this version: write schema = 1");
    find(file, "mechanism");
    made.title = read_string(file, "title", messages).value_or("");
    Problem settings;
    read_units(file, settings, messages);
    read_solver(file, settings, messages);
    find(file, "study");
    made.units = settings.units;
    read_linkage_dimensions(reading);
    read_links(reading);
    read_slides(reading);
    read_slots(reading);
    read_gears(reading);
    read_racks(reading);
    read_drives(reading);
    read_linkage_motion(reading);
    read_sketch(reading);
    read_placement(reading);
    read_rooms(reading);
    read_signals(reading);
    read_linkage_targets(reading);
    conclude_dimensions(reading);
    if (!messages.failed) settle(reading);
    read_assembly(reading);
    if (!messages.failed) assemble_larger(reading);
    report_unknown_keys(file, messages);
}

}  // namespace reading

ReadLinkage parse_linkage(std::string_view text, const std::string& file) {
    ReadLinkage read;
    read.linkage.file = file;
    reading::Messages messages{.file = file};
    if (const auto table = reading::parse_toml(text, messages))
        reading::read_linkage_table(*table, read.linkage, messages);
    read.messages = sorted(std::move(messages));
    return read;
}

ReadLinkage read_linkage(const std::string& file) {
    const reading::Bytes read = reading::read_bytes(file, 64 << 20, true);
    if (read.failure.empty()) return parse_linkage(read.bytes, file);
    ReadLinkage failed;
    failed.messages.push_back({file, 0, 0, read.failure});
    failed.unreadable = read.unreadable;
    return failed;
}

}  // namespace mechwright
