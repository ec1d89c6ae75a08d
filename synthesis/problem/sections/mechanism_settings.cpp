#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/units.h"

namespace mechwright::reading {

namespace {

/// The sections of some settings, each once.
std::vector<std::string_view> sections_of(std::span<const Setting> settings) {
    std::vector<std::string_view> names;
    for (const Setting& setting : settings)
        if (std::find(names.begin(), names.end(), setting.section) == names.end()) names.push_back(setting.section);
    return names;
}

double read_setting(Section& section, const Setting& setting, const Units& units, Messages& messages) {
    const double number = read_number(section, setting.name, messages).value_or(setting.preset);
    if (setting.is_mass && has(section, setting.name) && units.mass.empty())
        add_warning(
            messages, place_of(section, setting.name),
            fmt::format("{} is taken in the unit that goes with force, length and second, tonnes with N and mm: "
                        "write mass = \"kg\" in [units] to have it converted, or mass = \"t\"",
                        name_of(section, setting.name)));
    if (!has(section, setting.name) || setting.allows(number)) return number * inner_per_file_unit(setting, units);
    add_error(messages, place_of(section, setting.name),
              fmt::format("{} must be {} {}{}, not {}", name_of(section, setting.name),
                          setting.or_above ? "at least" : "greater than", setting.above,
                          std::isfinite(setting.below) ? fmt::format(" and less than {}", setting.below) : "", number));
    return setting.preset;
}

/// Sections that only other mechanisms have.
void report_foreign_sections(Section& file, const Mechanism& mechanism, Messages& messages) {
    const auto own = sections_of(mechanism.settings);
    for (const auto& other : mechanisms())
        for (const std::string_view section : sections_of(other->settings)) {
            if (std::find(own.begin(), own.end(), section) != own.end() || !has(file, section)) continue;
            if (std::find(file.reported.begin(), file.reported.end(), section) != file.reported.end()) continue;
            file.reported.push_back(section);
            add_error(messages, key_place(file, section),
                      fmt::format("a {} has no section [{}]: leave it out", mechanism.name, section));
        }
}

}  // namespace

void read_settings(Section& file, Problem& problem, Messages& messages) {
    if (problem.mechanism == nullptr) {
        for (const auto& any : mechanisms())
            for (const std::string_view section : sections_of(any->settings))
                find(file, section);
        return;
    }
    const auto& settings = problem.mechanism->settings;
    for (std::size_t i = 0; i < settings.size(); ++i)
        problem.settings[i] = settings[i].preset;
    for (const std::string_view name : sections_of(settings)) {
        std::optional<Section> section = read_section(file, name, messages);
        if (!section) continue;
        for (std::size_t i = 0; i < settings.size(); ++i)
            if (settings[i].section == name)
                problem.settings[i] = read_setting(*section, settings[i], problem.units, messages);
        report_unknown_keys(*section, messages);
    }
    report_foreign_sections(file, *problem.mechanism, messages);
}

}  // namespace mechwright::reading
