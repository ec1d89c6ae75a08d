#include "synthesis/exact/instant.h"

#include <fmt/format.h>

#include <complex>

#include "synthesis/exact/sized_linkage.h"
#include "synthesis/mechanism/four_bar/four_bar.h"
#include "synthesis/mechanism/four_bar/instant.h"

namespace mechwright {

namespace {

using Complex = std::complex<double>;
using four_bar::InstantRate, four_bar::OfLink, four_bar::Rate;

/// What is asked for, all for unit angular velocity of the crank.
struct Rates {
    std::optional<double> coupler;
    std::optional<double> rocker;
    std::optional<double> coupler_acceleration;
    std::optional<double> rocker_acceleration;

    bool all() const { return coupler && rocker && coupler_acceleration && rocker_acceleration; }
};

Rates rates_of(const Problem& problem) {
    Rates rates;
    for (const Requirement& r : problem.requirements) {
        const Quantity& q = problem.mechanism->quantities[r.quantity];
        if (!r.equal) continue;
        if (is_measured_by<InstantRate<OfLink::coupler, Rate::velocity>>(q)) rates.coupler = r.equal;
        if (is_measured_by<InstantRate<OfLink::rocker, Rate::velocity>>(q)) rates.rocker = r.equal;
        if (is_measured_by<InstantRate<OfLink::coupler, Rate::acceleration>>(q)) rates.coupler_acceleration = r.equal;
        if (is_measured_by<InstantRate<OfLink::rocker, Rate::acceleration>>(q)) rates.rocker_acceleration = r.equal;
    }
    return rates;
}

/// Crank, coupler and rocker as vectors. The loop crank + coupler - rocker = ground and its two derivatives are linear
/// in them; of the last two, with k and r the velocities of coupler and rocker and k', r' their accelerations,
///     crank + k coupler = r rocker,  -crank + (i k' - k^2) coupler = (i r' - r^2) rocker
/// (Theory of Machines, section 9-3).
struct LoopVectors {
    Complex crank, coupler, rocker;
};

LoopVectors rosenauer(const Rates& rates) {
    const double k = *rates.coupler, r = *rates.rocker;
    const double dk = *rates.coupler_acceleration, dr = *rates.rocker_acceleration;
    return {{k * r * (r - k), r * dk - k * dr}, {r * (1 - r), dr}, {k * (1 - k), dk}};
}

}  // namespace

std::string why_no_instant(const Problem& problem) {
    if (!is_four_bar(*problem.mechanism)) return "it knows four-bars alone";
    if (has_ties(problem)) return "dimensions are tied to others";
    if (!rates_of(problem).all())
        return "it needs the angular velocities and accelerations of coupler and rocker in [instant]; with fewer, "
               "slsqp finds members of the family";
    return {};
}

ExactDesigns instant_designs(const Problem& problem, const RunOptions&, const RunEnd&) {
    const LoopVectors v = rosenauer(rates_of(problem));
    const Complex ground = v.crank + v.coupler - v.rocker;
    ExactDesigns out;
    SolutionCounts counts;
    counts.tracked = 1;
    const SizedLinkage loop{std::abs(ground), std::abs(v.crank), std::abs(v.coupler), std::abs(v.rocker)};
    if (loop.has_lengths()) {
        counts.distinct = counts.real = counts.certified = 1;
        Design design = design_of(problem, loop);
        // Open: the rocker pin lies to the left of the line from crank pin to rocker pivot.
        design.assembly = (std::conj(ground - v.crank) * v.coupler).imag() > 0 ? 0 : 1;
        design.dimensions[problem.mechanism->point->roles.start] = std::arg(v.crank / ground);
        add_design(out, exact_design(problem, std::move(design)));
    } else {
        counts.singular = 1;
        out.note = "the links of the one four-bar with these velocities and accelerations have no length";
    }
    out.counts = counts;
    out.evaluations = 1;
    out.proof = proof_by(
        "Rosenauer: the loop and its two derivatives are linear in the links, which they determine but for size",
        CountCertificate{});
    return out;
}

}  // namespace mechwright
