#include "synthesis/problem/sections/kinds_with_sections.h"

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/mechanism/cam/read/cam.h"
#include "synthesis/problem/problem.h"

namespace mechwright::reading {

namespace {

void report_foreign(const KindWithSections& kind, Section& file, const Problem& problem, Messages& messages) {
    for (const std::string_view section : kind.sections) {
        if (!has(file, section)) continue;
        file.reported.push_back(section);
        if (problem.mechanism != nullptr)
            add_error(messages, key_place(file, section),
                      fmt::format("a {} has no '{}': leave it out", problem.mechanism->name, section));
    }
}

}  // namespace

std::span<const KindWithSections> kinds_with_sections() {
    static const std::array all{cam_sections()};
    return all;
}

const KindWithSections* sections_of(const Mechanism& mechanism) {
    const auto all = kinds_with_sections();
    const auto at = std::find_if(all.begin(), all.end(), [&](const auto& k) { return k.mechanism == mechanism.name; });
    return at == all.end() ? nullptr : &*at;
}

void read_kind(Section& file, Problem& problem, Messages& messages) {
    const KindWithSections* own = problem.mechanism == nullptr ? nullptr : sections_of(*problem.mechanism);
    for (const KindWithSections& kind : kinds_with_sections())
        if (&kind != own) report_foreign(kind, file, problem, messages);
    if (own == nullptr) return;
    own->read_kind(file, problem, messages);
    // Which one it is has been told to be wrong: how it moves is not looked at.
    if (problem.mechanism == nullptr)
        file.reported.insert(file.reported.end(), own->sections.begin(), own->sections.end());
}

void read_motion_of_kind(Section& file, Problem& problem, Messages& messages) {
    if (problem.mechanism == nullptr) return;
    if (const KindWithSections* own = sections_of(*problem.mechanism)) own->read_motion(file, problem, messages);
}

}  // namespace mechwright::reading
