#include "synthesis/exact/poses/certified_dyad.h"

#include <algorithm>
#include <cmath>

#include "synthesis/exact/homotopy/certify.h"
#include "synthesis/exact/homotopy/dyad_system.h"
#include "synthesis/exact/poses/dyad_equation.h"

namespace mechwright {

namespace {

using System = homotopy::DyadSystem;
using Certificate = homotopy::Certificate<System>;
using Parameters = System::Parameters<Digits50>;
using Point = System::Point<Digits50>;
using Equations = homotopy::Augmented<Digits50, System::size>;

std::complex<double> rounded(const Vector<Digits50>& z) { return {z.x.convert_to<double>(), z.y.convert_to<double>()}; }

Parameters parameters_of(std::span<const ExactCondition, 4> conditions) {
    Parameters parameters;
    for (std::size_t i = 0; i < conditions.size(); ++i)
        for (std::size_t j = 0; j < System::terms; ++j)
            parameters[System::terms * i + j] = {conditions[i][j], Digits50(0)};
    return parameters;
}

Equations equations_at(const Point& point, const Parameters& parameters) {
    Equations equations;
    System{}.linearise(point, parameters, static_cast<const Parameters*>(nullptr), equations);
    return equations;
}

/// The solution of equations with other right-hand sides, all 1.
Point solved_for_ones(Equations equations) {
    for (auto& row : equations)
        row[System::size] = {Digits50(1), Digits50(0)};
    homotopy::solve(equations);
    Point x;
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = equations[i][System::size];
    return x;
}

Equations transposed(const Equations& equations) {
    Equations other = equations;
    for (std::size_t i = 0; i < System::size; ++i)
        for (std::size_t j = 0; j < System::size; ++j)
            other[i][j] = equations[j][i];
    return other;
}

homotopy::Complex<Digits50> sum_of(const Point& x) { return x[0] + x[1] + x[2] + x[3]; }

/// About where the solution lies that is next to one with nearly dependent slopes J. The equations are quadratic, so
/// that other solutions are off by d with J d + B(d, d) = 0, B being their quadratic part. Next to this one d is nearly
/// a multiple of n = J^-1 1, and with w = J^-T 1 the multiple is -sum(n) / dot(w, B(n, n)). Derivation.
Point next_to(const Point& solution, const Parameters& parameters) {
    const Equations slopes = equations_at(solution, parameters);
    const Point n = solved_for_ones(slopes), w = solved_for_ones(transposed(slopes));
    const Equations at_n = equations_at(n, parameters);
    const Equations at_zero = equations_at(Point{}, parameters);
    Point quadratic;  // dot(w, B(n, n)), term by term
    for (std::size_t i = 0; i < System::size; ++i) {
        auto part = at_zero[i][System::size] - at_n[i][System::size];
        for (std::size_t j = 0; j < System::size; ++j)
            part = part - at_zero[i][j] * n[j];
        quadratic[i] = w[i] * part;
    }
    const auto multiple = -sum_of(n) / sum_of(quadratic);
    Point next;
    for (std::size_t i = 0; i < next.size(); ++i)
        next[i] = solution[i] + multiple * n[i];
    return next;
}

bool are_apart(const Certificate& a, const Certificate& b) {
    double apart = 0;
    for (std::size_t i = 0; i < a.solution.size(); ++i)
        apart = std::max(apart, std::sqrt(norm(homotopy::detail::rounded(a.solution[i] - b.solution[i]))));
    return apart > 2 * (a.radius + b.radius);
}

Point fine(const ComplexDyad& dyad) {
    const auto one = [](const std::complex<double>& z) {
        return homotopy::Complex<Digits50>{Digits50(z.real()), Digits50(z.imag())};
    };
    return {one(dyad.fixed[0]), one(dyad.fixed[1]), one(dyad.moving[0]), one(dyad.moving[1])};
}

CertifiedDyad real_part(const Certificate& proof) {
    const auto& s = proof.solution;
    CertifiedDyad found{{}, {s[0].re, s[1].re}, {s[2].re, s[3].re}};
    found.dyad = {rounded(found.fixed), rounded(found.moving)};
    return found;
}

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

PartedDyads parted(const DyadSolutions& found, std::span<const ExactCondition, 4> conditions) {
    const Parameters parameters = parameters_of(conditions);
    std::vector<Certificate> proofs;
    const auto add = [&](const Point& approximation) {
        const auto proof = certify(System{}, approximation, parameters);
        if (proof && std::all_of(proofs.begin(), proofs.end(),
                                 [&](const Certificate& other) { return are_apart(*proof, other); }))
            proofs.push_back(*proof);
    };
    for (const auto* dyads : {&found.dyads, &found.unsettled})
        for (const ComplexDyad& dyad : *dyads)
            add(fine(dyad));
    const std::vector<Certificate> known = proofs;
    for (const Certificate& proof : known)
        add(next_to(proof.solution, parameters));
    PartedDyads all;
    for (const Certificate& proof : proofs) {
        if (proof.real)
            all.real.push_back(real_part(proof));
        else
            ++all.others;
    }
    return all;
}

std::optional<CertifiedDyad> certified(const Dyad& approximation, std::span<const ExactCondition, 4> conditions) {
    const auto& [fixed, moving] = approximation;
    const auto proof = certify(System{}, fine({{fixed.real(), fixed.imag()}, {moving.real(), moving.imag()}}),
                               parameters_of(conditions));
    if (!proof || !proof->real) return {};
    return real_part(*proof);
}

}  // namespace mechwright
