#include "synthesis/exact/poses/guided_linkage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mechwright {

namespace {

using Complex = std::complex<double>;

double cross(const Complex& a, const Complex& b) { return a.real() * b.imag() - a.imag() * b.real(); }

}  // namespace

std::optional<GuidedLinkage> linkage_of(const Dyad& crank, const Dyad& rocker,
                                        std::span<const Displacement> displacements, const DrawingPlace& place) {
    const auto& [a, x] = crank;
    const auto& [b, y] = rocker;
    const double size = place.size;
    const FourBar<double> links{size * std::abs(b - a), size * std::abs(x - a), size * std::abs(y - x),
                                size * std::abs(y - b)};
    const double least = 1e-9 * (links.ground + links.crank + links.coupler + links.rocker);
    if (!(std::min({links.ground, links.crank, links.coupler, links.rocker}) > least)) return {};
    GuidedLinkage found;
    const Complex k = -x / (y - x);
    const Complex origin = place.origin + size * a;
    const double tilt = std::arg(b - a);
    found.coupler_direction = std::arg(y - x);
    found.one_assembly = true;
    for (const auto& [shift, turn] : displacements) {
        const Complex crank_pin = shift + x * turn, rocker_pin = shift + y * turn;
        found.crank_angles.push_back(std::arg((crank_pin - a) / (b - a)));
        // Open: the rocker pin lies to the left of the line from crank pin to rocker pivot.
        const Assembly here = cross(b - crank_pin, rocker_pin - crank_pin) > 0 ? Assembly::open : Assembly::crossed;
        if (found.crank_angles.size() == 1)
            found.linkage = {links,
                             {k.real() * links.coupler, k.imag() * links.coupler},
                             {{origin.real(), origin.imag()}, tilt},
                             here};
        found.one_assembly = found.one_assembly && here == found.linkage.assembly;
    }
    return found;
}

std::vector<std::vector<double>> in_order(const std::vector<double>& crank_angles) {
    constexpr double turn = 2 * std::numbers::pi;
    std::vector<std::vector<double>> possible;
    for (const double direction : {1.0, -1.0}) {
        std::vector<double> angles{crank_angles.front()};
        for (std::size_t j = 1; j < crank_angles.size(); ++j) {
            double step = std::fmod(direction * (crank_angles[j] - angles.back()), turn);
            if (step <= 0) step += turn;
            angles.push_back(angles.back() + direction * step);
        }
        if (std::abs(angles.back() - angles.front()) < turn) possible.push_back(std::move(angles));
    }
    return possible;
}

}  // namespace mechwright
