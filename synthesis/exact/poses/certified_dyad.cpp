#include "synthesis/exact/poses/certified_dyad.h"

#include "synthesis/exact/homotopy/certify.h"
#include "synthesis/exact/homotopy/dyad_system.h"
#include "synthesis/exact/poses/dyad_equation.h"

namespace mechwright {

namespace {

std::complex<double> rounded(const Vector<Digits50>& z) { return {z.x.convert_to<double>(), z.y.convert_to<double>()}; }

}  // namespace

ExactCondition exact_condition(const ExactDisplacement& displacement) {
    return dyad_factors(displacement.shift, displacement.turn);
}

ExactCondition exact_fixed_pivot_on_line(const Vector<Digits50>& point, const Vector<Digits50>& direction) {
    return line_factors(point, direction, 1);
}

ExactCondition exact_moving_pivot_on_line(const Vector<Digits50>& point, const Vector<Digits50>& direction) {
    return line_factors(point, direction, 3);
}

std::optional<CertifiedDyad> certified(const Dyad& approximation, std::span<const ExactCondition, 4> conditions) {
    using System = homotopy::DyadSystem;
    System::Parameters<Digits50> parameters;
    for (std::size_t i = 0; i < conditions.size(); ++i)
        for (std::size_t j = 0; j < System::terms; ++j)
            parameters[System::terms * i + j] = {conditions[i][j], Digits50(0)};
    const auto& [fixed, moving] = approximation;
    const auto proof = homotopy::certify(
        System{}, {{{fixed.real(), 0}, {fixed.imag(), 0}, {moving.real(), 0}, {moving.imag(), 0}}}, parameters);
    if (!proof || !proof->real) return {};
    const auto& s = proof->solution;
    CertifiedDyad found{{}, {s[0].re, s[1].re}, {s[2].re, s[3].re}};
    found.dyad = {rounded(found.fixed), rounded(found.moving)};
    return found;
}

}  // namespace mechwright
