#pragma once
/// \file
/// The result document: everything there is to say about a run, as JSON. All angles are in the file's unit.
///
/// Members, in this order (those in brackets only where they apply):
///   schema         1
///   problem        file, sha256, [text] (of the file, unless it names other files), title, mechanism
///   program        version, libraries (ipopt, nlopt, eigen)
///   units          angle ("deg" | "rad"), length
///   status         "solved" | "infeasible" | "limit" | "unverified" | "interrupted"
///   [note]         one sentence
///   tolerance      relative, on every requirement
///   dimensions     what was given: name -> number (fixed) or {min, max}; only those named in the file
///   [crank_range]  [from, to] if the file limits the motion
///   [settings]     name -> number, where the mechanism has any (working-share)
///   [design]       every dimension by name (optional ones only if named in the file or not 0), assembly, then
///                  kind ("crank-rocker", ...)
///   [objective]    quantity, sense, value; for several: terms [{quantity, sense, weight, value}], reduce, value
///   [requirements] [{quantity, value, equal | min and/or max, violation (relative), active}]
///   [quantities]   name -> value, every quantity of the mechanism that is defined for the design
///   [poses]        as path, with directions, body_length, reached_directions
///   [path]         points, timing, closed, [weights], [prescribed_angles], reached, crank_angles, distances
///   [warnings]     [{name, margin (length), relative (to the longest length), warned_below}]: margins of a design
///   close
///                  to a singular position
///   [verification] passed, checks [{name, passed, detail}]
///   alternatives   [{design, objective, [path_angles, distances], [cognate_of], verification | defect}]: those that
///   passed
///                  verification, best first, then those that did not, with the check that they fail (of exact
///                  problems only where all were asked for); cognate_of: 0 the design, else the alternative of that
///                  number, whose curve it draws
///   search         method, complete, [argument], starts, local_optima, hits, missed_chance, [solutions], evaluations,
///                  seed, seconds
///                  solutions: tracked, distinct, at_infinity, singular, real, defect_free
///
/// A number that is not finite is never written: its member is left out.

#include <nlohmann/json.hpp>
#include <string>

#include "synthesis/program/result.h"

namespace mechwright {

/// The document of a result. Verification is included as far as the result has it.
nlohmann::ordered_json document(const Problem& problem, const Result& result);

/// The document of a design that was given: as above, without what only a search has (status, verification,
/// alternatives, search).
nlohmann::ordered_json analysis_document(const Problem& problem, const Solution& solution);

/// What a problem asks for as the document states it: everything that does not follow from the design.
nlohmann::ordered_json asked_document(const Problem& problem);

/// The member verification: passed, checks.
nlohmann::ordered_json verification_document(const std::vector<Check>& done);

/// The status as the document writes it.
std::string_view name_of(Status status);

}  // namespace mechwright
