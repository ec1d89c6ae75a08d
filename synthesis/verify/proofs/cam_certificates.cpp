#include "synthesis/verify/proofs/cam_certificates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "synthesis/document/proof_document.h"
#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/program/proof.h"
#include "synthesis/verify/proofs/cam_bound.h"

namespace mechwright {

namespace {

using claims::Json;
using claims::member;
using claims::Reader;

constexpr double pi = std::numbers::pi;

/// The program of the cam with all the laws that its segments may have, which the claim of a design leaves out.
MotionProgram whole_program(const ProofContext& c) {
    MotionProgram program = *program_of(*c.problem.mechanism);
    const Json* cam = member(c.document, "cam");
    const Json* segments = cam && cam->is_object() ? member(*cam, "segments") : nullptr;
    for (std::size_t i = 0; segments && segments->is_array() && i < segments->size(); ++i) {
        const Json* laws = (*segments)[i].is_object() ? member((*segments)[i], "laws") : nullptr;
        if (!laws || !laws->is_array() || i >= program.segments.size()) continue;
        std::vector<std::size_t> all;
        for (const Json& law : *laws)
            for (std::size_t k = 0; k < cam_laws().size(); ++k)
                if (law.is_string() && cam_laws()[k].name == law.get<std::string>()) all.push_back(k);
        if (!all.empty()) program.segments[i].laws = all;
    }
    return program;
}

/// Room for what the tolerance lets pass where that there is no design is to be shown.
Digits50 loosened(const ProofContext& c, const Digits50& limit) {
    return c.infeasible ? Digits50(2 * c.problem.solver.tolerance * abs(limit)) : Digits50(0);
}

/// The least limit on the pressure angle in a segment that the problem has; infinite where it has none.
double asked_limit(const ProofContext& c, std::size_t segment) {
    double least = std::numeric_limits<double>::infinity();
    if (segment >= program_of(*c.problem.mechanism)->segments.size()) return least;
    const cam::SegmentKind kind = program_of(*c.problem.mechanism)->segments[segment].kind;
    for (const Requirement& r : c.problem.requirements) {
        const std::string_view name = c.problem.mechanism->quantities[r.quantity].name;
        const bool covers = name == "pressure-angle-max" ||
                            (name == "pressure-angle-rise" && kind == cam::SegmentKind::rise) ||
                            (name == "pressure-angle-return" && kind == cam::SegmentKind::fall);
        if (covers) least = std::min(least, r.max.value_or(r.equal.value_or(least)));
    }
    return least;
}

/// Whether a limit on the pressure angle in a segment is one that the problem has, loosened or not.
bool is_asked(const ProofContext& c, std::size_t segment, double limit) {
    constexpr double same_within = 1e-14;
    const double least = asked_limit(c, segment), slack = c.infeasible ? c.problem.solver.tolerance : 0;
    return limit < 0.5 * pi && limit >= least + slack * std::max(least, 1.0) - same_within;
}

CamPlace read_place(Reader& in, const Json& json) {
    constexpr double most = 1e6;
    const auto whole = [&](const char* name, double least) {
        const double number = in.number(member(json, name), name);
        if (!(number >= least && number < most && number == std::floor(number)))
            in.fail(std::string(name) + " is absurd");
        return in.understood() ? static_cast<std::size_t>(number) : std::size_t{1};
    };
    const std::size_t segment = whole("segment", 1) - 1, piece = whole("piece", 0);
    return {segment, piece, in.number(member(json, "at"), "at")};
}

WeightedHalfPlane read_row(Reader& in, const Json& json, const ProofContext& c) {
    WeightedHalfPlane row;
    const std::string of = in.text(member(json, "of"), "of");
    const auto* name = std::find(half_plane_names.begin(), half_plane_names.end(), of);
    if (name == half_plane_names.end()) in.fail("there is no such half-plane");
    row.weight = in.number(member(json, "weight"), "weight");
    if (!in.understood()) return row;
    row.origin = static_cast<WeightedHalfPlane::Origin>(name - half_plane_names.begin());
    if (row.origin != WeightedHalfPlane::Origin::pressure_angle) return row;
    row.place = read_place(in, json);
    row.side = in.number(member(json, "side"), "side") > 0 ? 1 : -1;
    row.limit =
        from_document(in.number(member(json, "limit"), "limit"), Unit::angle, c.problem.units).convert_to<double>();
    if (in.understood() && !is_asked(c, row.place.segment, row.limit)) in.fail("a limit is not one that is asked for");
    return row;
}

HalfPlaneCertificate::Part read_part(Reader& in, const Json& json, const ProofContext& c, const HalfPlaneCertificate*) {
    HalfPlaneCertificate::Part part;
    const Json* rows = member(json, "half_planes");
    if (!rows || !rows->is_array()) in.fail("there are no half-planes");
    for (std::size_t i = 0; in.understood() && i < rows->size(); ++i)
        part.rows.push_back(read_row(in, (*rows)[i], c));
    return part;
}

CurvatureCertificate::Part read_part(Reader& in, const Json& json, const ProofContext&, const CurvatureCertificate*) {
    return {0, read_place(in, json)};
}

/// The greatest least radius of curvature that is asked for, and the angle that a face starts at.
CamLimits cam_limits(const ProofContext& c) {
    CamLimits limits{0, 0, 0, 0, 0};
    const auto index = static_cast<std::size_t>(std::max(find_dimension(*c.problem.mechanism, "offset"), 0));
    const DimensionRange& offset = c.problem.dimensions[index];
    const double size = std::max(std::abs(offset.min), std::abs(offset.max));
    const Digits50 room = offset.fixed() ? Digits50(0) : loosened(c, size);
    limits.least_offset = offset.min - room;
    limits.greatest_offset = offset.max + room;
    const DigitsRange radius = asked_again(c, "profile-radius-min", Strictness::exact);
    const DigitsRange start = asked_again(c, "start-angle", Strictness::exact);
    if (radius.least > 0) limits.radius = radius.least - loosened(c, radius.least);
    if (isfinite(start.least)) limits.start_angle = start.least;
    const int distance = find_dimension(*c.problem.mechanism, "pivot-distance");
    if (distance >= 0) limits.least_distance = c.problem.dimensions[static_cast<std::size_t>(distance)].min;
    return limits;
}

/// The same part with limits as they stand.
HalfPlaneCertificate::Part as_asked(HalfPlaneCertificate::Part part, const ProofContext& c) {
    for (WeightedHalfPlane& row : part.rows)
        if (row.origin == WeightedHalfPlane::Origin::pressure_angle) row.limit = asked_limit(c, row.place.segment);
    return part;
}

CurvatureCertificate::Part as_asked(const CurvatureCertificate::Part& part, const ProofContext&) { return part; }

/// The number after "; the least NAME is" in the argument in words; nothing where it names none.
std::optional<double> least_in_words(const ProofContext& c) {
    const Json* argument = member(c.search, "argument");
    if (!argument || !argument->is_string()) return std::nullopt;
    const auto text = argument->get<std::string>();
    const std::size_t at = text.find("; the least ");
    const std::size_t is = at == std::string::npos ? at : text.find(" is ", at);
    if (is == std::string::npos) return std::nullopt;
    return std::strtod(text.c_str() + is + 4, nullptr);
}

/// Whether a number in words is the least size, of which a proof shows one that counts what the tolerance lets pass,
/// and by the same weights one for limits as they stand. The true one is not below the first; where both are all but
/// equal it is the second, for what the weights are off by counts with its square.
bool is_least(double named, const Digits50& with_tolerance, const Digits50& as_asked) {
    constexpr double digits = 1e-8, all_but_equal = 1e-4, same_within = 1e-3;
    if (!(named >= with_tolerance * (1 - digits))) return false;
    return as_asked > with_tolerance * (1 + all_but_equal) || named <= as_asked * (1 + same_within);
}

/// Whether in each sense of rotation that there is among some assemblies all choices of laws are.
bool covers_all_laws(const std::vector<std::size_t>& assemblies, std::size_t choices) {
    const auto has = [&](std::size_t assembly) {
        return std::find(assemblies.begin(), assemblies.end(), assembly) != assemblies.end();
    };
    return std::all_of(assemblies.begin(), assemblies.end(), [&](std::size_t assembly) {
        for (std::size_t choice = 0; choice < choices; ++choice)
            if (!has(2 * choice + assembly % 2)) return false;
        return true;
    });
}

/// The least that all parts leave of the dimension: nothing below it, whatever the assembly.
template <class CertificateKind>
Finding check_cam(const ProofContext& c) {
    constexpr double same_within = 1e-9;
    if (!is_cam(*c.problem.mechanism) || !program_of(*c.problem.mechanism)) return fails("it is about cams");
    const MotionProgram program = whole_program(c);
    Reader in;
    const int index = find_dimension(*c.problem.mechanism,
                                     in.text(member(c.certificate, "dimension"), "search.certificate.dimension"));
    const Json* parts = member(c.certificate, "parts");
    if (index < 0 || !parts || !parts->is_array() || parts->empty()) return fails("it has no parts");
    const auto dimension = static_cast<std::size_t>(index);
    std::vector<Digits50> dimensions = c.design.dimensions;
    const DimensionRange& arm = c.problem.dimensions[2];
    if (!arm.fixed()) dimensions[2] = arm.min - loosened(c, arm.max);
    const std::size_t first = cam_angle_dimension(*c.problem.mechanism, 0);
    for (std::size_t i = first; i < dimensions.size(); ++i)
        if (!c.problem.dimensions[i].fixed()) return fails("the motion is not given");
    // With what the tolerance lets pass, and as it is asked for: what is named in words lies between them.
    ProofContext strict = c;
    strict.infeasible = false;
    std::vector<Digits50> asked_dimensions = dimensions;
    if (!arm.fixed()) asked_dimensions[2] = arm.min;
    Digits50 least = std::numeric_limits<Digits50>::infinity(), least_asked = least;
    std::vector<std::size_t> assemblies;
    for (const Json& json : *parts) {
        auto part = read_part(in, json, c, static_cast<const CertificateKind*>(nullptr));
        const double assembly = in.number(member(json, "assembly"), "assembly");
        if (!in.understood()) return fails(in.defect);
        if (!(assembly >= 0 && assembly < 2.0 * static_cast<double>(law_choices(program))))
            return fails("there is no such assembly");
        part.assembly = static_cast<std::size_t>(assembly);
        assemblies.push_back(part.assembly);
        least = std::min(least, cam_bound(*c.problem.mechanism, program, dimensions, cam_limits(c), dimension, part));
        least_asked = std::min(least_asked, cam_bound(*c.problem.mechanism, program, asked_dimensions,
                                                      cam_limits(strict), dimension, as_asked(part, c)));
    }
    if (!covers_all_laws(assemblies, law_choices(program))) return fails("it does not cover every choice of laws");
    const std::string_view name = c.problem.mechanism->dimensions[dimension].name;
    const DimensionRange& range = c.problem.dimensions[dimension];
    if (c.infeasible) {
        const Digits50 most = std::min<Digits50>(range.max, asked_again(c, name, Strictness::exact).greatest);
        if (!(least > most + loosened(c, most) / 2))
            return fails(fmt::format("a {} of {:.12g} is not excluded, and {:.12g} is allowed", name,
                                     least.convert_to<double>(), most.convert_to<double>()));
        if (const auto named = least_in_words(c); named && !is_least(*named, least, least_asked))
            return fails(fmt::format("the least {} is said to be {:.9g}, and it is {:.9g}", name, *named,
                                     least_asked.convert_to<double>()));
        return holds(isfinite(least) && least < 1e6 * range.max
                         ? fmt::format("{} is at least {:.12g}", name, least.convert_to<double>())
                         : std::string("the limits on the pressure angle exclude each other"));
    }
    const Quantity* objective = single_objective(c, false);
    if (!objective || objective->name != name) return fails(fmt::format("{} is not what is to be least", name));
    const Digits50 reached = c.design.dimensions[dimension];
    if (!(std::max<Digits50>(least, range.min) >= reached * (1 - same_within)))
        return fails(fmt::format("{} is {:.12g}, and only less than {:.12g} is excluded", name,
                                 reached.convert_to<double>(), least.convert_to<double>()));
    return holds(fmt::format("{} is at least {:.12g}", name, least.convert_to<double>()));
}

}  // namespace

Finding check_half_planes(const ProofContext& c) { return check_cam<HalfPlaneCertificate>(c); }
Finding check_curvature(const ProofContext& c) { return check_cam<CurvatureCertificate>(c); }

}  // namespace mechwright
