#pragma once
/// \file
/// Certificates of proofs as they stand in a result document.

#include <nlohmann/json.hpp>

#include "synthesis/document/fields.h"
#include "synthesis/problem/problem.h"
#include "synthesis/program/proof.h"

namespace mechwright {

/// {"kind": ...} with what verification needs. Segments count from 1; angles in the file's unit.
nlohmann::ordered_json certificate_document(const Problem& problem, const Certificate& certificate);

/// The names of WeightedHalfPlane::Origin, in its order.
inline constexpr auto half_plane_names = fields::half_planes;

}  // namespace mechwright
