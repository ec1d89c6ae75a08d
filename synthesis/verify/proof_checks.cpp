#include "synthesis/verify/proof_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "synthesis/document/claim_json.h"
#include "synthesis/document/claimed_problem.h"
#include "synthesis/document/proof_document.h"
#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/mechanism/possible_values.h"
#include "synthesis/proof/empty_ranges.h"
#include "synthesis/proof/known_limits.h"
#include "synthesis/verify/cam_bound.h"
#include "synthesis/verify/rebuilt.h"

namespace mechwright {

namespace {

using claims::Json;
using claims::member;
using claims::Reader;

constexpr double pi = std::numbers::pi;

/// What a certificate was found to show: nothing wrong, or why it does not hold.
struct Finding {
    std::string defect;
    std::string shown;
};

Finding holds(std::string shown) { return {{}, std::move(shown)}; }
Finding fails(std::string why) { return {std::move(why), {}}; }

struct Context {
    const Json& document;
    const Json& search;
    const Json& certificate;
    const Rebuilt& design;
    const Problem& problem;  ///< as the document has it
    bool infeasible;         ///< is what is said to be proven, else the best
};

const Quantity* single_objective(const Context& c, bool maximize) {
    const auto& objective = c.problem.objective;
    if (!objective || objective->terms.size() != 1 || objective->terms.front().maximize != maximize) return nullptr;
    return &c.problem.mechanism->quantities[objective->terms.front().quantity];
}

bool all_given(const Problem& problem) {
    return std::all_of(problem.dimensions.begin(), problem.dimensions.end(),
                       [](const DimensionRange& range) { return range.fixed() || range.tied(); });
}

Finding check_given(const Context& c) {
    if (all_given(c.problem)) return holds("every dimension is given");
    if (!c.infeasible && !c.problem.objective) return holds("nothing is to be made greatest or least");
    return fails("dimensions are free, and there may be a better design");
}

Finding check_zero(const Context& c) {
    constexpr double rounding = 1e-12;
    const Quantity* quantity = single_objective(c, false);
    if (c.infeasible || !quantity) return fails("one quantity is to be least for this");
    if (possible_values(quantity->name).least != 0) return fails(fmt::format("{} can be negative", quantity->name));
    Measurements measurements(c.design);
    const auto& again = measurements.of(c.problem.objective->terms.front().quantity);
    if (!again) return fails("it has no value for this design");
    Digits50 size = 1;
    if (quantity->unit == Unit::length || quantity->unit == Unit::area) {
        size = std::max(c.design.longest, c.design.path ? c.design.path->size : Digits50(0));
        if (quantity->unit == Unit::area) size *= size;
    }
    if (!(again->value <= rounding * size)) return fails("it is " + shown_small(again->value) + ", not zero");
    return holds(fmt::format("{} cannot be negative, and is {}", quantity->name, shown_small(again->value)));
}

Finding check_count(const Context& c) {
    const Json* counts = member(c.search, "solutions");
    if (!counts || !counts->is_object()) return fails("there are no counts of solutions");
    Reader in;
    const auto number = [&](const char* name) { return in.number(member(*counts, name), name); };
    const double tracked = number("tracked"), distinct = number("distinct"), at_infinity = number("at_infinity");
    const double singular = number("singular"), real = number("real"), certified = number("certified");
    const double defect_free = number("defect_free");
    if (!in.understood()) return fails(in.defect);
    const double known = distinct + at_infinity + singular;
    if (tracked != known) return fails(fmt::format("of {} solutions {} are known", tracked, known));
    if (c.infeasible && singular != 0) return fails("singular solutions are counted, and not examined");
    if (certified > real) return fails("more solutions are certified than are real");
    if (c.infeasible != (defect_free == 0)) return fails("the number of designs without a defect does not go with it");
    return holds(fmt::format("{} solutions are {} distinct ones, {} at infinity and {} singular", tracked, distinct,
                             at_infinity, singular));
}

Finding check_bound(const Context& c) {
    constexpr double closed_within = 1.1e-6, rounding = 1e-9;
    const Json* bound = member(c.search, "bound");
    const Json* objective = member(c.document, "objective");
    const Json* value = objective && objective->is_object() ? member(*objective, "value") : nullptr;
    if (c.infeasible || !bound || !bound->is_number() || !value || !value->is_number())
        return fails("there is no bound of an objective");
    const double least = bound->get<double>(), reached = value->get<double>();
    if (!(least >= (1 - closed_within) * reached && least <= (1 + rounding) * reached))
        return fails(fmt::format("the bound {} does not meet the objective {}", least, reached));
    return holds(fmt::format("the bound {:.12g} meets the objective; the boxes are not covered again", least));
}

Finding check_ranges(const Context& c) {
    if (!c.infeasible) return fails("it says nothing of the best design");
    if (const auto proof = proof_by_ranges(c.problem)) return holds(proof->argument);
    return fails("there are dimensions in the ranges that meet the conditions of a kind of motion");
}

/// The greatest value of a function of one number that lies between two, on a fine grid that is dense towards both.
double greatest_on_grid(double from, double to, const std::function<double(double)>& f) {
    constexpr int steps = 20000;
    double best = -std::numeric_limits<double>::infinity();
    for (int i = 1; i < steps; ++i) {
        const double part = 0.5 - 0.5 * std::cos(pi * i / steps);
        const double value = f(from + part * (to - from));
        if (value > best) best = value;
    }
    return best;
}

/// The worst transmission angle of a crank-rocker with coupler over crank `ratio` in the family of its swing and
/// stroke, by the triangles of its limits; negative where it is none.
double member_of_family(double swing, double stroke, double ratio) {
    // Crank 1: the rocker pin's limits, and the rocker pivot over them.
    const double alpha = pi - stroke;
    const Vector<double> outer{ratio + 1, 0}, inner{(ratio - 1) * std::cos(alpha), (ratio - 1) * std::sin(alpha)};
    const Vector<double> chord = inner - outer;
    const double half = 0.5 * std::hypot(chord.x, chord.y), rocker = half / std::sin(0.5 * swing);
    double best = -1;
    for (const double side : {1.0, -1.0}) {
        const double height = side * half / std::tan(0.5 * swing) / (2 * half);
        const Vector<double> pivot = 0.5 * (outer + inner) + height * left_of(chord);
        const double ground = std::hypot(pivot.x, pivot.y);
        const double longest = std::max({ground, ratio, rocker});
        if (!(ratio > 1 && ground > 1 && rocker > 1 && 1 + 2 * longest <= ground + ratio + rocker)) continue;
        // Both limits have the pivot on the same side of the coupler, or they are those of two assemblies.
        if ((cross(outer, pivot) > 0) != (cross(inner, pivot) > 0)) continue;
        const auto angle = [&](double diagonal) {
            const double cosine = (ratio * ratio + rocker * rocker - diagonal * diagonal) / (2 * ratio * rocker);
            return std::acos(std::clamp(cosine, -1.0, 1.0));
        };
        best = std::max(best, std::min(angle(ground - 1), pi - angle(ground + 1)));
    }
    return best;
}

double best_of_family(double swing, double time_ratio) {
    const double slow = 2 * pi * time_ratio / (1 + time_ratio);
    double best = 0;
    for (const double stroke : {slow, 2 * pi - slow})
        best = std::max(best, greatest_on_grid(0, 1, [&](double part) {
                            return member_of_family(swing, stroke, (1 + part) / (1 - part));
                        }));
    return best;
}

/// The ram's limits subtend the angle of the time ratio at the crank pivot, which lies on a circle through them: every
/// place on it before the foot of the pivot comes between the limits, where the rod would stand square to the slide, is
/// a slider-crank.
double best_slider_crank(double time_ratio) {
    const double seen = pi * (time_ratio - 1) / (time_ratio + 1);
    if (!(seen < 0.5 * pi)) return 0;
    return greatest_on_grid(0.5 * seen, 0.5 * (pi - seen), [&](double m) {
        const double far = std::sin(m + 0.5 * seen), near = std::sin(m - 0.5 * seen);
        const double crank = 0.5 * (far - near), rod = 0.5 * (far + near), offset = far * near;
        // The distances of the pivot from the limits over the circle's diameter, and its height over their line.
        return std::acos(std::min(1.0, (crank + offset) / rod));
    });
}

/// Levers and ram lines of a crank shaper on a grid.
double best_shaper(const Problem& problem, double time_ratio, double stroke) {
    constexpr std::size_t lever = 2, rod = 3, line = 4;
    constexpr int steps = 200;
    const double ratio = std::cos(pi / (1 + time_ratio));
    const DimensionRange &levers = problem.dimensions[lever], &lines = problem.dimensions[line];
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
            const double l = stroke > 0 ? stroke / (2 * ratio) : levers.min + (levers.max - levers.min) * i / steps;
            const double h = lines.min + (lines.max - lines.min) * j / steps;
            least = std::min(least, std::max(l - h, h - l * std::sqrt(1 - ratio * ratio)));
        }
    return std::acos(std::clamp(least / problem.dimensions[rod].max, -1.0, 1.0));
}

double best_whitworth(const Problem& problem, double stroke) {
    constexpr std::size_t arm = 2, rod = 3;
    const double least = stroke > 0 ? 0.5 * stroke : problem.dimensions[arm].min;
    return std::acos(std::min(1.0, least / problem.dimensions[rod].max));
}

/// No design that meets the other requirements has a value of the limited quantity above what is returned (below it,
/// where that is asked for), as far as this place knows; NaN where it does not know the limit.
double limit_again(const Context& c, const std::string& name, const Quantity& quantity, bool above) {
    const Asked swing = asked_of(c.problem, "swing"), ratio = asked_of(c.problem, "time-ratio");
    const Asked stroke = asked_of(c.problem, "stroke");
    const double asked_stroke = stroke.least > 0 && std::isfinite(stroke.least) ? stroke.least : 0;
    if (name == "possible-values") {
        const PossibleValues possible = possible_values(quantity.name);
        return above ? possible.greatest : possible.least;
    }
    if (!above) return std::nan("");
    const bool transmission = quantity.name == "transmission-angle-worst" || quantity.name == "transmission-angle-min";
    const std::string_view mechanism = c.problem.mechanism->name;
    if (mechanism == "four-bar" && name == "swing" && quantity.name == "transmission-angle-worst")
        return 0.5 * (pi - swing.least);
    if (mechanism == "four-bar" && name == "swing-time-ratio" && quantity.name == "time-ratio")
        return (3 * pi + swing.greatest) / (pi - swing.greatest);
    if (mechanism == "four-bar" && name == "family" && quantity.name == "transmission-angle-worst")
        return best_of_family(swing.least, ratio.least);
    if (mechanism == "slider-crank" && name == "time-ratio" && quantity.name == "time-ratio") return 3;
    if (mechanism == "slider-crank" && name == "ratio-family" && transmission) return best_slider_crank(ratio.least);
    if (mechanism == "crank-shaper" && name == "lever" && transmission)
        return best_shaper(c.problem, ratio.least, asked_stroke);
    if (mechanism == "whitworth" && name == "arm" && transmission) return best_whitworth(c.problem, asked_stroke);
    const std::size_t rod = mechanism == "whitworth" ? 3 : 1;
    if ((mechanism == "slider-crank" || mechanism == "whitworth") && name == "stroke" && transmission)
        return std::acos(std::min(1.0, 0.5 * asked_stroke / c.problem.dimensions[rod].max));
    return std::nan("");
}

Finding check_limit(const Context& c) {
    constexpr double rounding = 1e-9;
    Reader in;
    const std::string name = in.text(member(c.certificate, "limit"), "search.certificate.limit");
    const std::string quantity_name = in.text(member(c.certificate, "quantity"), "search.certificate.quantity");
    const double stated = in.number(member(c.certificate, "value"), "search.certificate.value");
    if (!in.understood()) return fails(in.defect);
    const int index = find_quantity(*c.problem.mechanism, quantity_name);
    if (index < 0) return fails("there is no such quantity");
    const Quantity& quantity = c.problem.mechanism->quantities[static_cast<std::size_t>(index)];
    const double value = from_document(stated, quantity.unit, c.problem.units).convert_to<double>();
    const Asked asked = asked_of(c.problem, quantity.name);
    const bool above = !c.infeasible || asked.least > value;
    const double again = limit_again(c, name, quantity, above);
    const double room = rounding * std::max(1.0, std::abs(value));
    if (!(above ? again <= value + room : again >= value - room))
        return fails(fmt::format("the limit '{}' is {}, and {} is stated", name, again, value));
    if (c.infeasible) {
        if (!(above ? asked.least > value : asked.greatest < value))
            return fails("what is asked for is within the limit");
        return holds(fmt::format("'{}' never is {} than {}", quantity.name, above ? "greater" : "less",
                                 shown(Digits50(value), quantity.unit, c.problem.units)));
    }
    if (single_objective(c, true) != &quantity) return fails("the limit is not one of what is to be greatest");
    Measurements measurements(c.design);
    const auto& reached = measurements.of(static_cast<std::size_t>(index));
    if (!reached || !(reached->value >= value - room)) return fails("the design does not come up to the limit");
    return holds("the design comes up to the limit, and nothing on a fine grid is beyond it");
}

/// The program of the cam with all the laws that its segments may have, which the claim of a design leaves out.
MotionProgram whole_program(const Context& c) {
    MotionProgram program = *c.problem.program;
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
Digits50 loosened(const Context& c, double limit) {
    return c.infeasible ? 2 * c.problem.solver.tolerance * std::abs(limit) : 0;
}

/// Whether a limit on the pressure angle in a segment is one that the problem has, loosened or not.
bool is_asked(const Context& c, std::size_t segment, double limit) {
    constexpr double rounding = 1e-14;
    if (segment >= c.problem.program->segments.size()) return false;
    const cam::SegmentKind kind = c.problem.program->segments[segment].kind;
    const double slack = c.infeasible ? c.problem.solver.tolerance : 0;
    return std::any_of(c.problem.requirements.begin(), c.problem.requirements.end(), [&](const Requirement& r) {
        const std::string_view name = c.problem.mechanism->quantities[r.quantity].name;
        const bool covers = name == "pressure-angle-max" ||
                            (name == "pressure-angle-rise" && kind == cam::SegmentKind::rise) ||
                            (name == "pressure-angle-return" && kind == cam::SegmentKind::fall);
        const double most = r.max.value_or(r.equal.value_or(10));
        return covers && limit < 0.5 * pi && limit >= most + slack * std::max(most, 1.0) - rounding;
    });
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

WeightedHalfPlane read_row(Reader& in, const Json& json, const Context& c) {
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

HalfPlaneCertificate::Part read_part(Reader& in, const Json& json, const Context& c, const HalfPlaneCertificate*) {
    HalfPlaneCertificate::Part part;
    const Json* rows = member(json, "half_planes");
    if (!rows || !rows->is_array()) in.fail("there are no half-planes");
    for (std::size_t i = 0; in.understood() && i < rows->size(); ++i)
        part.rows.push_back(read_row(in, (*rows)[i], c));
    return part;
}

CurvatureCertificate::Part read_part(Reader& in, const Json& json, const Context&, const CurvatureCertificate*) {
    return {0, read_place(in, json)};
}

/// The greatest least radius of curvature that is asked for, and the angle that a face starts at.
CamLimits cam_limits(const Context& c) {
    CamLimits limits{0, 0, 0, 0, 0};
    const auto index = static_cast<std::size_t>(std::max(find_dimension(*c.problem.mechanism, "offset"), 0));
    const DimensionRange& offset = c.problem.dimensions[index];
    const double size = std::max(std::abs(offset.min), std::abs(offset.max));
    const Digits50 room = offset.fixed() ? Digits50(0) : loosened(c, size);
    limits.least_offset = offset.min - room;
    limits.greatest_offset = offset.max + room;
    const Asked radius = asked_of(c.problem, "profile-radius-min"), start = asked_of(c.problem, "start-angle");
    if (radius.least > 0) limits.radius = radius.least - loosened(c, radius.least);
    if (std::isfinite(start.least)) limits.start_angle = start.least;
    const int distance = find_dimension(*c.problem.mechanism, "pivot-distance");
    if (distance >= 0) limits.least_distance = c.problem.dimensions[static_cast<std::size_t>(distance)].min;
    return limits;
}

/// The least that all parts leave of the dimension: nothing below it, whatever the assembly.
template <class CertificateKind>
Finding check_cam(const Context& c) {
    constexpr double rounding = 1e-9;
    if (!is_cam(*c.problem.mechanism) || !c.problem.program) return fails("it is about cams");
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
    Digits50 least = std::numeric_limits<Digits50>::infinity();
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
    }
    std::sort(assemblies.begin(), assemblies.end());
    assemblies.erase(std::unique(assemblies.begin(), assemblies.end()), assemblies.end());
    if (assemblies.size() % law_choices(program) != 0) return fails("it does not cover every choice of laws");
    const std::string_view name = c.problem.mechanism->dimensions[dimension].name;
    const DimensionRange& range = c.problem.dimensions[dimension];
    if (c.infeasible) {
        const Asked asked = asked_of(c.problem, name);
        const double most = std::min(range.max, asked.greatest);
        if (!(least > most + loosened(c, most) / 2))
            return fails(fmt::format("a {} of {:.12g} is not excluded, and {} is allowed", name,
                                     least.convert_to<double>(), most));
        return holds(isfinite(least) && least < 1e6 * range.max
                         ? fmt::format("{} is at least {:.12g}", name, least.convert_to<double>())
                         : std::string("the limits on the pressure angle exclude each other"));
    }
    const Quantity* objective = single_objective(c, false);
    if (!objective || objective->name != name) return fails(fmt::format("{} is not what is to be least", name));
    const Digits50 reached = c.design.dimensions[dimension];
    if (!(std::max<Digits50>(least, range.min) >= reached * (1 - rounding)))
        return fails(fmt::format("{} is {:.12g}, and only less than {:.12g} is excluded", name,
                                 reached.convert_to<double>(), least.convert_to<double>()));
    return holds(fmt::format("{} is at least {:.12g}", name, least.convert_to<double>()));
}

struct Kind {
    std::string_view name;
    Finding (*check)(const Context&);
};

constexpr std::array<Kind, 8> kinds{{{"half-planes", check_cam<HalfPlaneCertificate>},
                                     {"curvature", check_cam<CurvatureCertificate>},
                                     {"limit", check_limit},
                                     {"bound", check_bound},
                                     {"count", check_count},
                                     {"zero", check_zero},
                                     {"given", check_given},
                                     {"ranges", check_ranges}}};

}  // namespace

bool says_infeasible(const Json& document) {
    const Json* status = member(document, "status");
    return status && status->is_string() && status->get<std::string>() == "infeasible";
}

Json with_some_design(Json document) {
    if (!document.is_object() || !says_infeasible(document) || member(document, "design")) return document;
    Json design = Json::object();
    const Json* given = member(document, "dimensions");
    if (given && given->is_object())
        for (const auto& [name, value] : given->items())
            design[name] = value.is_object() ? value.value("min", Json(1)) : value;
    if (const Json* cam = member(document, "cam"); cam && cam->is_object()) {
        design["rotation"] = cam_rotation_names[0];
        design["laws"] = Json::array();
        const Json* segments = member(*cam, "segments");
        for (std::size_t i = 0; segments && segments->is_array() && i < segments->size(); ++i) {
            const Json* laws = (*segments)[i].is_object() ? member((*segments)[i], "laws") : nullptr;
            design["laws"].push_back(laws && laws->is_array() && !laws->empty() ? (*laws)[0] : Json(""));
        }
    }
    document["design"] = std::move(design);
    return document;
}

std::vector<Check> check_proof(const Json& document) {
    const Json* search = member(document, "search");
    if (!search || !search->is_object()) return {};
    const Json* complete = member(*search, "complete");
    const Json* certificate = member(*search, "certificate");
    const bool said = complete && complete->is_boolean() && complete->get<bool>();
    if (!said && !certificate) return {};
    Check check{says_infeasible(document) ? "that no design meets the requirements is shown"
                                          : "that no design is better is shown",
                false, "there is no certificate"};
    if (!said) check.detail = "it has a certificate, and is not said to be complete";
    if (!said || !certificate || !certificate->is_object()) return {check};
    const Json* name = member(*certificate, "kind");
    const auto* kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) {
        return name && name->is_string() && name->get<std::string>() == k.name;
    });
    check.detail = "there is no such certificate";
    if (kind == kinds.end()) return {check};
    const auto [claim, defect] = read_claim(with_some_design(document));
    check.detail = defect;
    if (!defect.empty()) return {check};
    const Rebuilt design = rebuilt(claim);
    const ClaimedDesign claimed = claimed_design(claim);
    const Finding finding =
        kind->check({document, *search, *certificate, design, claimed.problem, says_infeasible(document)});
    check.passed = finding.defect.empty();
    check.detail = fmt::format("{}: {}", kind->name, check.passed ? finding.shown : finding.defect);
    return {check};
}

}  // namespace mechwright
