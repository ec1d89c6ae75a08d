#include <algorithm>
#include <numbers>
#include <utility>

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

namespace {

/// Steps of reading as if nothing had failed before; whether they pass.
template <class... Steps>
bool passes(LinkageReading& reading, const Steps&... steps) {
    const bool failed_before = std::exchange(reading.messages.failed, false);
    (steps(reading), ...);
    const bool passed = !reading.messages.failed;
    reading.messages.failed |= failed_before;
    return passed;
}

void read_head(LinkageReading& reading) {
    Section& file = reading.file;
    Messages& messages = reading.messages;
    if (!has(file, "schema")) add_error(messages, file.place, "'schema' is missing: write schema = 1");
    if (const auto schema = read_whole_number(file, "schema", messages); schema && *schema != 1)
        add_error(messages, place_of(file, "schema"), "this schema is not known to this version: write schema = 1");
    find(file, "mechanism");
    reading.made.title = read_string(file, "title", messages).value_or("");
    Problem settings;
    read_units(file, settings, messages);
    read_solver(file, settings, messages);
    find(file, "study");
    reading.made.units = settings.units;
}

}  // namespace

LinkageParts read_linkage_table(const toml::table& table, Linkage& made, Messages& messages) {
    Section file{&table, "", {1, 1}, keys::of_file()};
    LinkageReading reading{file, made, messages};
    if (const auto name = table["mechanism"].value_exact<std::string>(); name != "linkage") {
        add_error(messages, place_of(file, "mechanism"),
                  "this is no linkage: its structure is that of its kind; write mechanism = \"linkage\" for links "
                  "and joints of your own");
        return {};
    }
    read_head(reading);
    const bool joined = passes(reading, read_linkage_dimensions, read_links, read_slides, read_slots, read_gears,
                               read_racks, read_drives);
    LinkageParts parts;
    parts.motion = passes(reading, read_linkage_motion);
    const bool placed = passes(reading, read_sketch, read_placement);
    const bool rooms = passes(reading, read_rooms);
    parts.signals = passes(reading, read_signal_section) && rooms;
    read_asked(reading);
    parts.targets = passes(reading, read_linkage_targets);
    // A name that is misspelt elsewhere may be that of a dimension that nothing seems to use.
    conclude_dimensions(reading, joined && placed && parts.motion && rooms && parts.signals && parts.targets);
    const bool settled = joined && passes(reading, settle);
    const bool closed = settled && passes(reading, read_assembly);
    if (!settled) find(file, "assembly");  // of dyads that are not known
    const bool assembled = closed && placed && passes(reading, assemble_larger);
    parts.structure = settled && placed && (assembled || made.order.closed());
    report_unknown_keys(file, messages);
    return parts;
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
