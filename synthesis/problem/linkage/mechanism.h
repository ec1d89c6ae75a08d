#pragma once
/// \file
/// A linkage's file as a problem: its mechanism, made from its sections, and what is asked of it.

#include <toml++/toml.h>

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "synthesis/problem/linkage/linkage.h"

namespace mechwright {

/// The mechanism of a linkage with the quantities of these names beside those that every linkage has. `sections` are
/// those of its file, JSON (Mechanism::made_from).
std::shared_ptr<const Mechanism> mechanism_of(const Linkage& linkage, std::string sections,
                                              std::span<const std::string> quantities);

/// Why no mechanism can be made of a linkage yet; empty if one can.
std::string why_no_mechanism(const Linkage& linkage);

struct MadeAgain {
    std::shared_ptr<const Mechanism> mechanism{};  ///< null if there is a defect
    std::string defect{};                          ///< of what any JSON value says
};

/// Whether tables of a problem can hold what a document says: no null, and nothing that is too deep.
bool is_plain(const nlohmann::ordered_json& json, int depth = 0);

/// The mechanism of the sections that a document repeats.
MadeAgain mechanism_of_sections(const nlohmann::ordered_json& sections, std::span<const std::string> quantities);

}  // namespace mechwright

namespace mechwright::reading {

/// Whether a file describes a linkage.
bool names_linkage(const toml::table& table);

/// Those sections of a file that it has, of these.
nlohmann::ordered_json sections_named(const toml::table& table, std::span<const std::string_view> names);

/// The sections of a file that describe the linkage, without what is asked of it.
nlohmann::ordered_json sections_of_linkage(const toml::table& table);

/// That parts keep in the regions of the problem's mechanism, or out of them, as far as asked.
void require_regions(Problem& problem);

/// All sections of such a file as a problem.
void read_linkage_problem(const toml::table& table, Problem& problem, Messages& messages);

}  // namespace mechwright::reading
