#include "synthesis/bench/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "analysis/numbers/instruction_set.h"
#include "synthesis/document/versions.h"
#include "synthesis/report/files/write_file.h"

namespace mechwright::bench {

namespace {

std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(std::min(line.find(':') + 2, line.size()));
    return "unknown processor";
}

std::string_view name_of(InstructionSet set) {
    switch (set) {
        case InstructionSet::avx2: return "AVX2";
        case InstructionSet::avx512: return "AVX-512";
        default: return "baseline x86-64";
    }
}

constexpr const char* revision =
#include "revision.inc"
    ;

nlohmann::ordered_json json_of(const Surroundings& s) {
    return {{"program", s.program},     {"compiler", s.compiler},         {"libraries", s.libraries},
            {"processor", s.processor}, {"instructions", s.instructions}, {"effort", s.full ? "full" : "quick"}};
}

Surroundings surroundings_of(const nlohmann::ordered_json& json) {
    return {json.at("program"),   json.at("compiler"),     json.at("libraries"),
            json.at("processor"), json.at("instructions"), json.at("effort") == "full"};
}

}  // namespace

Surroundings surroundings(bool full) {
    return {fmt::format("mechwright {} ({})", program_version(), revision),
            "gcc " __VERSION__ " " MECHWRIGHT_BUILD_FLAGS,
            fmt::format("Ipopt {}, NLopt {}, Eigen {}", ipopt_version(), nlopt_version(), eigen_version()),
            fmt::format("{}, {} cores", processor_name(), std::thread::hardware_concurrency()),
            std::string(name_of(widest_instruction_set())),
            full};
}

bool Record::has(std::string_view section, std::string_view measurement) const {
    const auto found = sections.find(section);
    return found != sections.end() && std::any_of(found->second.begin(), found->second.end(),
                                                  [&](const auto& made) { return made.first == measurement; });
}

Sheet sheet_of(const Record& record, const Section& section, const std::vector<Measurement>& measurements) {
    Sheet sheet{{section.columns.begin(), section.columns.end()}, {}};
    const auto found = record.sections.find(section.name);
    if (found == record.sections.end()) return sheet;
    for (const Measurement& measurement : measurements)
        for (const auto& [name, rows] : found->second)
            if (name == measurement.name)
                for (const Row& row : rows) {
                    Row whole{name};
                    whole.insert(whole.end(), row.begin(), row.end());
                    sheet.rows.push_back(std::move(whole));
                }
    return sheet;
}

std::optional<Record> read_record(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) return std::nullopt;
    try {
        const auto json = nlohmann::ordered_json::parse(stream);
        Record record{surroundings_of(json.at("surroundings")), {}};
        for (const auto& [section, measurements] : json.at("sections").items())
            for (const auto& [name, rows] : measurements.items())
                record.sections[section].emplace_back(name, rows.get<std::vector<Row>>());
        return record;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
}

std::optional<std::string> write_record(const std::filesystem::path& file, const Record& record) {
    using Json = nlohmann::ordered_json;
    std::vector<std::string> sections;
    for (const auto& [section, measurements] : record.sections) {
        std::vector<std::string> lines;
        for (const auto& [name, rows] : measurements)
            lines.push_back(Json(name).dump() + ": " + Json(rows).dump());
        sections.push_back(fmt::format("{}: {{\n{}\n}}", Json(section).dump(), fmt::join(lines, ",\n")));
    }
    return write_atomically(file, fmt::format("{{\"surroundings\": {},\n\"sections\": {{\n{}\n}}}}\n",
                                              json_of(record.surroundings).dump(), fmt::join(sections, ",\n")));
}

}  // namespace mechwright::bench
