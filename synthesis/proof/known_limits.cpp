#include "synthesis/proof/known_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "analysis/four_bar/best_crank_rocker.h"
#include "analysis/slider_crank/best_slider_crank.h"
#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/four_bar/four_bar.h"
#include "synthesis/mechanism/possible_values.h"
#include "synthesis/mechanism/slider_crank/slider_crank.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/variant.h"

namespace mechwright {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double any = std::numeric_limits<double>::infinity();

/// Room for what the tolerance lets pass.
double slack(const Problem& problem, double value) {
    return 2 * problem.solver.tolerance * std::max(1.0, std::abs(value));
}

/// Whether the motion is a full turn of the crank: quantities over a turn are meant.
bool turns_fully(const Problem& problem) {
    return !problem.crank_range && !problem.path && !has_input_range(problem) && !problem.has_instant;
}

std::size_t index_of(const Problem& problem, std::string_view quantity) {
    return static_cast<std::size_t>(find_quantity(*problem.mechanism, quantity));
}

std::string value_text(const Problem& problem, std::size_t quantity, double value) {
    const Unit unit = problem.mechanism->quantities[quantity].unit;
    const std::string label = unit_label(unit, problem.units);
    return fmt::format("{:.6g}{}{}", in_file_unit(value, unit, problem.units), label.empty() ? "" : " ", label);
}

void add_possible_values(const Problem& problem, std::vector<KnownLimit>& limits) {
    for (const Requirement& r : problem.requirements) {
        const Quantity& quantity = problem.mechanism->quantities[r.quantity];
        const PossibleValues possible = possible_values(quantity.name);
        limits.push_back({"possible-values", r.quantity, possible.least, possible.greatest,
                          fmt::format("'{}' is the {}", quantity.name, quantity.meaning)});
    }
}

void add_of_crank_rockers(const Problem& problem, std::vector<KnownLimit>& limits) {
    const Asked swing = asked_of(problem, "swing"), ratio = asked_of(problem, "time-ratio");
    const std::size_t transmission = index_of(problem, "transmission-angle-worst");
    const double least_swing = swing.least - slack(problem, swing.least);
    if (least_swing > 0 && least_swing < pi)
        limits.push_back({"swing", transmission, 0, 0.5 * (pi - least_swing),
                          "the worst transmission angle of a crank-rocker is at most (180 deg - swing) / 2"});
    const double greatest_swing = swing.greatest + slack(problem, swing.greatest);
    if (greatest_swing > 0 && greatest_swing < pi)
        limits.push_back({"swing-time-ratio", index_of(problem, "time-ratio"), 1,
                          (3 * pi + greatest_swing) / (pi - greatest_swing),
                          "the time ratio of a crank-rocker is less than (540 deg + swing) / (180 deg - swing)"});
    if (!(swing.least == swing.greatest && ratio.least == ratio.greatest)) return;
    if (!(swing.least > 0 && swing.least < pi && ratio.least > 1)) return;
    const double slow = 2 * pi * ratio.least / (1 + ratio.least);
    const double best = std::max(transmission_bound_of_crank_rockers(swing.least, slow),
                                 transmission_bound_of_crank_rockers(swing.least, 2 * pi - slow));
    constexpr double of_equalities = 1e3;  // by how much their tolerance may raise the bound, and far more
    limits.push_back({"family", transmission, 0, best + of_equalities * slack(problem, best),
                      "crank-rockers of this swing and time ratio form one one-parameter family for each direction of "
                      "the crank, whose best members are known"});
}

void limit_transmission(const Problem& problem, std::string_view name, double greatest, const std::string& why,
                        std::vector<KnownLimit>& limits) {
    for (const char* quantity : {"transmission-angle-worst", "transmission-angle-min"})
        limits.push_back({name, index_of(problem, quantity), 0, greatest, why});
}

void add_of_slider_cranks(const Problem& problem, std::vector<KnownLimit>& limits) {
    limits.push_back({"time-ratio", index_of(problem, "time-ratio"), 1, 3,
                      "the time ratio of a slider-crank whose crank turns fully is less than 3: its limits are seen "
                      "from the crank pivot under less than a right angle"});
    const Asked ratio = asked_of(problem, "time-ratio");
    const double least = ratio.least - slack(problem, ratio.least);
    if (const auto best = least > 1 ? best_transmission_slider_crank(1, least) : std::nullopt)
        limit_transmission(
            problem, "ratio-family", std::acos(std::min(1.0, (best->crank + std::abs(best->offset)) / best->rod)),
            "slider-cranks of one time ratio form one one-parameter family, whose best member is known", limits);
}

void add_of_rod(const Problem& problem, const DimensionRange& rod, std::vector<KnownLimit>& limits) {
    const Asked stroke = asked_of(problem, "stroke");
    const double sine = 0.5 * (stroke.least - slack(problem, stroke.least) * stroke.least) / rod.max;
    if (!rod.tied() && sine > 0)
        limit_transmission(problem, "stroke", std::acos(std::min(1.0, sine)),
                           "the sine of the rod's greatest slope is at least half of the stroke over the rod", limits);
}

}  // namespace

Asked asked_of(const Problem& problem, std::string_view quantity) {
    Asked asked;
    for (const Requirement& r : problem.requirements) {
        if (problem.mechanism->quantities[r.quantity].name != quantity) continue;
        asked.least = std::max(asked.least, r.equal.value_or(r.min.value_or(-any)));
        asked.greatest = std::min(asked.greatest, r.equal.value_or(r.max.value_or(any)));
    }
    return asked;
}

std::vector<KnownLimit> known_limits(const Problem& problem) {
    std::vector<KnownLimit> limits;
    add_possible_values(problem, limits);
    if (!turns_fully(problem)) return limits;
    if (is_four_bar(*problem.mechanism)) add_of_crank_rockers(problem, limits);
    if (is_slider_crank(*problem.mechanism)) add_of_slider_cranks(problem, limits);
    const std::size_t rod = problem.mechanism->rod_sloped_by_stroke;
    if (rod != no_dimension) add_of_rod(problem, problem.dimensions[rod], limits);
    return limits;
}

std::shared_ptr<const Proof> proof_by_limits(const Problem& problem) {
    for (const KnownLimit& limit : known_limits(problem)) {
        const std::string_view name = problem.mechanism->quantities[limit.quantity].name;
        const Asked asked = asked_of(problem, name);
        const bool above = asked.least > limit.greatest + slack(problem, limit.greatest);
        const bool below = asked.greatest < limit.least - slack(problem, limit.least);
        if (!above && !below) continue;
        const double value = above ? limit.greatest : limit.least;
        return proof_by(fmt::format("{}; so '{}' never is {} than {}, and {} is asked for", limit.why, name,
                                    above ? "greater" : "less", value_text(problem, limit.quantity, value),
                                    value_text(problem, limit.quantity, above ? asked.least : asked.greatest)),
                        LimitCertificate{std::string(limit.name), limit.quantity, value});
    }
    return nullptr;
}

}  // namespace mechwright
