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

/// How far the coupler has turned at a displacement d: both dyads are linear in T and 1/T.
Number turn_at(const GuidanceValues& u, const Number& d) {
    const auto at = [&u](S::Unknown i) { return number(u[i]); };
    const Number dc = std::conj(d);
    const Number A = at(S::x) * (dc - at(S::a_conjugate)), Ac = at(S::x_conjugate) * (d - at(S::a));
    const Number B = at(S::y) * (dc - at(S::b_conjugate)), Bc = at(S::y_conjugate) * (d - at(S::b));
    const auto constant = [&](const Number& x, const Number& xc, const Number& a, const Number& ac) {
        return d * dc - d * ac - dc * a + x * ac + xc * a;
    };
    const Number C = constant(at(S::x), at(S::x_conjugate), at(S::a), at(S::a_conjugate));
    const Number D = constant(at(S::y), at(S::y_conjugate), at(S::b), at(S::b_conjugate));
    const Number turn = (Ac * D - Bc * C) / (A * Bc - Ac * B);
    return turn / std::abs(turn);
}

}  // namespace

std::vector<GuidanceValues> orbit_members(const GuidanceSystem& system, const GuidanceValues& u) {
    if (system.poses > 1) return {u, exchanged(u)};
    const GuidanceValues left = cognate(u), right = cognate(exchanged(u));
    return {u, exchanged(u), left, exchanged(left), right, exchanged(right)};
}

std::optional<GuidedLinkage> linkage_of(const GuidanceValues& u, const GuidanceTarget& target) {
    std::vector<Displacement> displacements;
    for (const auto& place : target.places) {
        if (!place) {
            displacements.push_back({0, 1});
            continue;
        }
        const Number d = number(target.parameters[*place]);
        const bool is_pose = *place + 1 < target.system.poses;
        displacements.push_back({d, is_pose ? number(target.parameters[S::first_turn + *place]) : turn_at(u, d)});
    }
    return mechwright::linkage_of(Dyad{number(u[S::a]), number(u[S::x])}, Dyad{number(u[S::b]), number(u[S::y])},
                                  displacements, {number(target.origin), target.size});
}

}  // namespace mechwright::homotopy
