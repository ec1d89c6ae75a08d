#pragma once
/// \file
/// Instant centres of a design, for people and for programs.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/linkage/measuring/instant_centres.h"
#include "synthesis/mechanism/mechanism.h"
#include "synthesis/problem/problem.h"

namespace mechwright {

struct NamedCentre {
    std::string first, second;  ///< the two links
    linkage::InstantCentre centre;
};

/// The design of a linkage, or of a built-in kind that is one.
struct DesignOfLinks {
    std::shared_ptr<const Mechanism> mechanism;
    std::span<const double> dimensions;
    std::size_t assembly = 0;
};

/// Whether a mechanism is made of links and joints.
bool is_of_links(const Mechanism& mechanism);

/// The centres of all pairs of links in the drawing, at an input of the master (radians, or a
/// displacement). Absent where it does not close there, or stands at a dead position. Precondition: is_of_links.
std::optional<std::vector<NamedCentre>> centres_of(const DesignOfLinks& design, double master);

/// "A, B" and where; angles in the file's unit, as the input at which they are so.
std::string centres_text(const std::vector<NamedCentre>& centres, double input, const Units& units);
nlohmann::ordered_json centres_json(const std::vector<NamedCentre>& centres, double input, const Units& units);

}  // namespace mechwright
