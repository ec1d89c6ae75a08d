#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "synthesis/problem/sections/sections.h"

namespace mechwright::reading {

namespace {

/// Angular velocities or accelerations of the links, those that are named.
struct LinkRates {
    std::optional<double> crank;
    std::optional<double> coupler;
    std::optional<double> rocker;
};

LinkRates read_rates(Section& instant, std::string_view key, Messages& messages) {
    LinkRates rates;
    auto section = has(instant, key) ? read_section(instant, key, messages) : std::nullopt;
    if (!section) return rates;
    section->title = name_of(instant, key);
    rates.crank = read_number(*section, "crank", messages);
    rates.coupler = read_number(*section, "coupler", messages);
    rates.rocker = read_number(*section, "rocker", messages);
    report_unknown_keys(*section, messages);
    return rates;
}

/// Whether the ratios are numbers.
bool are_finite(const LinkRates& velocity, const LinkRates& acceleration) {
    const double crank = *velocity.crank;
    double sum = std::abs(acceleration.crank.value_or(0) / (crank * crank));
    for (const auto& v : {velocity.coupler, velocity.rocker})
        sum += std::abs(v.value_or(0) / crank) * (1 + std::abs(acceleration.crank.value_or(0) / (crank * crank)));
    for (const auto& a : {acceleration.coupler, acceleration.rocker})
        sum += std::abs(a.value_or(0) / (crank * crank));
    return std::isfinite(sum);
}

void require_equal(Problem& problem, std::string_view quantity, double value) {
    const auto index = static_cast<std::size_t>(find_quantity(*problem.mechanism, quantity));
    problem.requirements.push_back({index, value, std::nullopt, std::nullopt});
}

/// For unit angular velocity of the crank: the ratio of velocities, and its change with the crank angle, which the
/// accelerations follow from: a = ratio' v^2 + ratio a_crank, with v and a_crank those of the crank.
void require_rates(const LinkRates& velocity, const LinkRates& acceleration, Problem& problem) {
    const double crank = *velocity.crank, crank_acceleration = acceleration.crank.value_or(0);
    const auto add = [&](const std::optional<double>& v, const std::optional<double>& a, std::string_view of_velocity,
                         std::string_view of_acceleration) {
        if (!v) return;
        const double ratio = *v / crank;
        require_equal(problem, of_velocity, ratio);
        if (a) require_equal(problem, of_acceleration, (*a - ratio * crank_acceleration) / (crank * crank));
    };
    add(velocity.coupler, acceleration.coupler, "instant-coupler-velocity", "instant-coupler-acceleration");
    add(velocity.rocker, acceleration.rocker, "instant-rocker-velocity", "instant-rocker-acceleration");
}

}  // namespace

void read_instant(Section& file, Problem& problem, Messages& messages) {
    std::optional<Section> instant = read_section(file, "instant", messages);
    if (!instant || problem.mechanism == nullptr) return;
    if (find_quantity(*problem.mechanism, "instant-rocker-velocity") < 0)
        return add_error(messages, instant->place,
                         fmt::format("a {} has no [instant]: leave it out", problem.mechanism->name));
    const std::size_t before = messages.entries.size();
    const LinkRates velocity = read_rates(*instant, "velocity", messages);
    const LinkRates acceleration = read_rates(*instant, "acceleration", messages);
    for (const char* key : {"velocity", "acceleration"})
        find(*instant, key);
    report_unknown_keys(*instant, messages);
    if (messages.entries.size() != before) return;
    if (!velocity.crank || *velocity.crank == 0)
        return add_error(messages, instant->place,
                         "[instant] needs velocity = { crank = ..., coupler = ..., rocker = ... }, that of the crank "
                         "not 0");
    if (!velocity.coupler && !velocity.rocker)
        return add_error(messages, place_of(*instant, "velocity"),
                         "[instant] needs the angular velocity of the coupler or of the rocker");
    if ((acceleration.coupler && !velocity.coupler) || (acceleration.rocker && !velocity.rocker))
        return add_error(messages, place_of(*instant, "acceleration"),
                         "an angular acceleration needs the angular velocity of the same link");
    if (!are_finite(velocity, acceleration))
        return add_error(
            messages, instant->place,
            "[instant]: for unit angular velocity of the crank the numbers are beyond all bounds; use another "
            "unit of time");
    problem.has_instant = true;
    DimensionRange& start = problem.dimensions[problem.mechanism->point->roles.start];
    if (!start.named) start = {.min = 0, .max = 2 * std::numbers::pi, .start = {}, .named = true};
    require_rates(velocity, acceleration, problem);
}

}  // namespace mechwright::reading
