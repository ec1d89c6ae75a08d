#include "synthesis/exact/homotopy/guidance_linkages.h"

#include <complex>

namespace mechwright::homotopy {

namespace {

using Number = std::complex<double>;
using S = GuidanceSystem;

Number number(const Complex<double>& z) { return {z.re, z.im}; }
Complex<double> plain(const Number& z) { return {z.real(), z.imag()}; }

GuidanceValues exchanged(const GuidanceValues& u) {
    return {u[S::y], u[S::y_conjugate], u[S::b], u[S::b_conjugate],
            u[S::x], u[S::x_conjugate], u[S::a], u[S::a_conjugate]};
}

/// The cognate that keeps the pivot a. With the coupler point P in the origin and k = (P - x)/(y - x): completing the
/// parallelogram of a, x and P gives its pin a - x; its coupler constant is 1/k, and its other pivot a + k (b - a).
GuidanceValues cognate(const GuidanceValues& u) {
    GuidanceValues v;
    for (const std::size_t bar : {std::size_t{0}, std::size_t{1}}) {
        const Number x = number(u[S::x + bar]), a = number(u[S::a + bar]), y = number(u[S::y + bar]),
                     b = number(u[S::b + bar]);
        const Number k = x / (x - y);
        v[S::x + bar] = plain(a - x);
        v[S::a + bar] = plain(a);
        v[S::y + bar] = plain((a - x) * (1.0 - k));
        v[S::b + bar] = plain(a + k * (b - a));
    }
    return v;
}

/// The same for a ram, whose line's normal b is infinitely far from a: it is turned by the argument of k.
GuidanceValues cognate_with_ram(const GuidanceValues& u) {
    GuidanceValues v;
    std::array<Number, 2> k;
    for (const std::size_t bar : {std::size_t{0}, std::size_t{1}}) {
        const Number x = number(u[S::x + bar]), a = number(u[S::a + bar]), y = number(u[S::y + bar]);
        k[bar] = x / (x - y);
        v[S::x + bar] = plain(a - x);
        v[S::a + bar] = plain(a);
        v[S::y + bar] = plain((a - x) * (1.0 - k[bar]));
    }
    const Number length = std::sqrt(k[0] * k[1]);
    v[S::b] = plain(k[0] / length * number(u[S::b]));
    v[S::b_conjugate] = plain(k[1] / length * number(u[S::b_conjugate]));
    return v;
}

/// A dyad at a displacement d, A T + A'/T + C = 0 (guidance_system.h).
struct TurnEquation {
    Number A, Ac, C;
};

TurnEquation turn_equation(SecondDyad kind, const GuidanceValues& u, std::size_t first, const Number& d) {
    const Number x = number(u[first]), xc = number(u[first + 1]), a = number(u[first + 2]), ac = number(u[first + 3]);
    const Number by_turn = kind == SecondDyad::ram ? 0 : d, free = kind == SecondDyad::block ? 0 : d;
    const Number square = kind == SecondDyad::rocker ? d * std::conj(d) : 0;
    return {x * (std::conj(by_turn) - ac), xc * (by_turn - a),
            square - free * ac - std::conj(free) * a + x * ac + xc * a};
}

/// How far the coupler has turned at a displacement d: both dyads are linear in T and 1/T.
Number turn_at(const GuidanceSystem& system, const GuidanceValues& u, const Number& d) {
    const auto [A, Ac, C] = turn_equation(SecondDyad::rocker, u, S::x, d);
    const auto [B, Bc, D] = turn_equation(system.second, u, S::y, d);
    const Number turn = (Ac * D - Bc * C) / (A * Bc - Ac * B);
    return turn / std::abs(turn);
}

}  // namespace

std::vector<GuidanceValues> orbit_members(const GuidanceSystem& system, const GuidanceValues& u) {
    if (system.second == SecondDyad::block) return {u};
    if (system.second == SecondDyad::ram)
        return system.poses > 1 ? std::vector{u} : std::vector{u, cognate_with_ram(u)};
    if (system.poses > 1) return {u, exchanged(u)};
    const GuidanceValues left = cognate(u), right = cognate(exchanged(u));
    return {u, exchanged(u), left, exchanged(left), right, exchanged(right)};
}

std::vector<Displacement> displacements_of(const GuidanceValues& u, const GuidanceTarget& target) {
    std::vector<Displacement> displacements;
    for (const auto& place : target.places) {
        if (!place) {
            displacements.push_back({0, 1});
            continue;
        }
        const Number d = number(target.parameters[*place]);
        const bool is_pose = *place + 1 < target.system.poses;
        displacements.push_back(
            {d, is_pose ? number(target.parameters[S::first_turn + *place]) : turn_at(target.system, u, d)});
    }
    return displacements;
}

DrawingPlace place_of(const GuidanceTarget& target) { return {number(target.origin), target.size}; }

GuidedParts parts_of(const GuidanceValues& u, const GuidanceSystem& system) {
    return {{number(u[S::a]), number(u[S::x])}, system.second, {number(u[S::b]), number(u[S::y])}};
}

std::optional<GuidedLinkage> linkage_of(const GuidanceValues& u, const GuidanceTarget& target) {
    const GuidedParts parts = parts_of(u, target.system);
    return mechwright::linkage_of(parts.crank, parts.second, displacements_of(u, target), place_of(target));
}

}  // namespace mechwright::homotopy
