#include "synthesis/document/proof_document.h"

#include "synthesis/document/fields.h"
#include "synthesis/problem/units.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

using namespace names;

Json place_of(const CamPlace& place) {
    return {{of_part("segment"), place.segment + 1}, {of_part("piece"), place.piece}, {of_part("at"), place.u}};
}

Json document_of(const Problem& problem, const HalfPlaneCertificate& certificate) {
    Json parts = Json::array();
    for (const HalfPlaneCertificate::Part& part : certificate.parts) {
        Json rows = Json::array();
        for (const WeightedHalfPlane& row : part.rows) {
            Json one{{of_half_plane("of"), fields::half_planes[static_cast<std::size_t>(row.origin)]}};
            if (row.origin == WeightedHalfPlane::Origin::pressure_angle) {
                one.update(place_of(row.place));
                one[of_half_plane("limit")] = in_file_unit(row.limit, Unit::angle, problem.units);
                one[of_half_plane("side")] = row.side;
            }
            one[of_half_plane("weight")] = row.weight;
            rows.push_back(std::move(one));
        }
        parts.push_back({{of_part("assembly"), part.assembly}, {of_part("half_planes"), std::move(rows)}});
    }
    return {{of_certificate("kind"), "half-planes"},
            {of_certificate("dimension"), problem.mechanism->dimensions[certificate.dimension].name},
            {of_certificate("parts"), std::move(parts)}};
}

Json document_of(const Problem& problem, const CurvatureCertificate& certificate) {
    Json parts = Json::array();
    for (const CurvatureCertificate::Part& part : certificate.parts) {
        Json one{{of_part("assembly"), part.assembly}};
        one.update(place_of(part.place));
        parts.push_back(std::move(one));
    }
    return {{of_certificate("kind"), "curvature"},
            {of_certificate("dimension"), problem.mechanism->dimensions[certificate.dimension].name},
            {of_certificate("parts"), std::move(parts)}};
}

Json document_of(const Problem& problem, const LimitCertificate& certificate) {
    const Quantity& quantity = problem.mechanism->quantities[certificate.quantity];
    return {{of_certificate("kind"), "limit"},
            {of_certificate("limit"), certificate.name},
            {of_certificate("quantity"), quantity.name},
            {of_certificate("value"), in_file_unit(certificate.value, quantity.unit, problem.units)}};
}

Json document_of(const Problem&, const BoundCertificate&) { return {{of_certificate("kind"), "bound"}}; }
Json document_of(const Problem&, const CountCertificate&) { return {{of_certificate("kind"), "count"}}; }
Json document_of(const Problem&, const ZeroCertificate&) { return {{of_certificate("kind"), "zero"}}; }
Json document_of(const Problem&, const GivenCertificate&) { return {{of_certificate("kind"), "given"}}; }
Json document_of(const Problem&, const RangesCertificate&) { return {{of_certificate("kind"), "ranges"}}; }

}  // namespace

Json certificate_document(const Problem& problem, const Certificate& certificate) {
    return std::visit([&](const auto& one) { return document_of(problem, one); }, certificate);
}

}  // namespace mechwright
