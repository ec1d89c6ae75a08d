#include "synthesis/exact/homotopy/nine_point_linkages.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace mechwright::homotopy {

namespace {

using Number = std::complex<double>;
using S = NinePointSystem;

Number number(const Complex<double>& z) { return {z.re, z.im}; }
Complex<double> plain(const Number& z) { return {z.real(), z.imag()}; }

NinePointValues exchanged(const NinePointValues& u) {
    return {u[S::y], u[S::y_conjugate], u[S::b], u[S::b_conjugate],
            u[S::x], u[S::x_conjugate], u[S::a], u[S::a_conjugate]};
}

/// The cognate that keeps the pivot a. With the coupler point P in the origin and k = (P - x)/(y - x): completing the
/// parallelogram of a, x and P gives its pin a - x; its coupler constant is 1/k, and its other pivot a + k (b - a).
NinePointValues cognate(const NinePointValues& u) {
    NinePointValues v;
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
Number turn_at(const NinePointValues& u, const Number& d) {
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

double cross(const Number& a, const Number& b) { return a.real() * b.imag() - a.imag() * b.real(); }

}  // namespace

std::array<NinePointValues, 6> orbit_members(const NinePointValues& u) {
    const NinePointValues left = cognate(u), right = cognate(exchanged(u));
    return {u, exchanged(u), left, exchanged(left), right, exchanged(right)};
}

std::optional<LinkageThroughPoints> linkage_of(const NinePointValues& u, const NinePointTarget& target) {
    const Number x = number(u[S::x]), a = number(u[S::a]), y = number(u[S::y]), b = number(u[S::b]);
    const double size = target.size;
    const FourBar<double> links{size * std::abs(b - a), size * std::abs(x - a), size * std::abs(y - x),
                                size * std::abs(y - b)};
    const double least = 1e-9 * (links.ground + links.crank + links.coupler + links.rocker);
    if (!(std::min({links.ground, links.crank, links.coupler, links.rocker}) > least)) return {};
    LinkageThroughPoints found;
    const Number k = -x / (y - x);
    const Number origin = number(target.origin) + size * a;
    const double tilt = std::arg(b - a);
    found.one_assembly = true;
    for (std::size_t j = 0; j < found.crank_angles.size(); ++j) {
        const Number d = j == 0 ? Number() : number(target.parameters[j - 1]);
        const Number turn = j == 0 ? Number(1) : turn_at(u, d);
        const Number crank_pin = d + x * turn, rocker_pin = d + y * turn;
        found.crank_angles[j] = std::arg((crank_pin - a) / (b - a));
        // Open: the rocker pin lies to the left of the line from crank pin to rocker pivot.
        const Assembly here = cross(b - crank_pin, rocker_pin - crank_pin) > 0 ? Assembly::open : Assembly::crossed;
        if (j == 0)
            found.linkage = {links,
                             {k.real() * links.coupler, k.imag() * links.coupler},
                             {{origin.real(), origin.imag()}, tilt},
                             here};
        found.one_assembly = found.one_assembly && here == found.linkage.assembly;
    }
    return found;
}

std::optional<std::vector<double>> in_order(const std::array<double, 9>& crank_angles) {
    constexpr double turn = 2 * std::numbers::pi;
    for (const double direction : {1.0, -1.0}) {
        std::vector<double> angles{crank_angles[0]};
        for (std::size_t j = 1; j < crank_angles.size(); ++j) {
            double step = std::fmod(direction * (crank_angles[j] - angles.back()), turn);
            if (step <= 0) step += turn;
            angles.push_back(angles.back() + direction * step);
        }
        if (std::abs(angles.back() - angles.front()) < turn) return angles;
    }
    return {};
}

}  // namespace mechwright::homotopy
