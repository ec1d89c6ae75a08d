#pragma once
/// \file
/// Kinds of mechanism of which problem files say more than dimensions, in sections that no others have. A kind's folder
/// in `synthesis/mechanism` reads them.

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "synthesis/problem/toml/section.h"

namespace mechwright::reading {

struct KindWithSections {
    std::string_view mechanism;  ///< its name in files, which several mechanisms can share
    std::span<const std::string_view> sections;
    /// Which mechanism of that name it is: before the dimensions. Leaves none where the file does not say.
    void (*read_kind)(Section& file, Problem& problem, Messages& messages);
    /// How it moves: after the dimensions.
    void (*read_motion)(Section& file, Problem& problem, Messages& messages);
    /// Says in the schema of problem files what the lists of keys do not say of these sections.
    void (*complete_schema)(nlohmann::ordered_json& properties);
    /// The schema of the files that mean one mechanism of that name, and what else these need and cannot have.
    nlohmann::ordered_json (*is_meant)(const Mechanism& mechanism);
    void (*limit_files)(const Mechanism& mechanism, nlohmann::ordered_json& schema);
};

std::span<const KindWithSections> kinds_with_sections();

/// That of a mechanism, or null.
const KindWithSections* sections_of(const Mechanism& mechanism);

/// Calls read_kind of the mechanism's kind, and reports sections of other kinds.
void read_kind(Section& file, Problem& problem, Messages& messages);
void read_motion_of_kind(Section& file, Problem& problem, Messages& messages);

}  // namespace mechwright::reading
