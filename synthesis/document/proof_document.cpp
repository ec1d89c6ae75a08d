#include "synthesis/document/proof_document.h"

#include "synthesis/problem/units.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

Json place_of(const CamPlace& place) {
    return {{"segment", place.segment + 1}, {"piece", place.piece}, {"at", place.u}};
}

Json document_of(const Problem& problem, const HalfPlaneCertificate& certificate) {
    Json parts = Json::array();
    for (const HalfPlaneCertificate::Part& part : certificate.parts) {
        Json rows = Json::array();
        for (const WeightedHalfPlane& row : part.rows) {
            Json one{{"of", half_plane_names[static_cast<std::size_t>(row.origin)]}};
            if (row.origin == WeightedHalfPlane::Origin::pressure_angle) {
                one.update(place_of(row.place));
                one["limit"] = in_file_unit(row.limit, Unit::angle, problem.units);
                one["side"] = row.side;
            }
            one["weight"] = row.weight;
            rows.push_back(std::move(one));
        }
        parts.push_back({{"assembly", part.assembly}, {"half_planes", std::move(rows)}});
    }
    return {{"kind", "half-planes"},
            {"dimension", problem.mechanism->dimensions[certificate.dimension].name},
            {"parts", std::move(parts)}};
}

Json document_of(const Problem& problem, const CurvatureCertificate& certificate) {
    Json parts = Json::array();
    for (const CurvatureCertificate::Part& part : certificate.parts) {
        Json one{{"assembly", part.assembly}};
        one.update(place_of(part.place));
        parts.push_back(std::move(one));
    }
    return {{"kind", "curvature"},
            {"dimension", problem.mechanism->dimensions[certificate.dimension].name},
            {"parts", std::move(parts)}};
}

Json document_of(const Problem& problem, const LimitCertificate& certificate) {
    const Quantity& quantity = problem.mechanism->quantities[certificate.quantity];
    return {{"kind", "limit"},
            {"limit", certificate.name},
            {"quantity", quantity.name},
            {"value", in_file_unit(certificate.value, quantity.unit, problem.units)}};
}

Json document_of(const Problem&, const BoundCertificate&) { return {{"kind", "bound"}}; }
Json document_of(const Problem&, const CountCertificate&) { return {{"kind", "count"}}; }
Json document_of(const Problem&, const ZeroCertificate&) { return {{"kind", "zero"}}; }
Json document_of(const Problem&, const GivenCertificate&) { return {{"kind", "given"}}; }
Json document_of(const Problem&, const RangesCertificate&) { return {{"kind", "ranges"}}; }

}  // namespace

Json certificate_document(const Problem& problem, const Certificate& certificate) {
    return std::visit([&](const auto& one) { return document_of(problem, one); }, certificate);
}

}  // namespace mechwright
