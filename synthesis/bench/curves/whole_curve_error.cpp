#include "synthesis/bench/curves/whole_curve_error.h"

#include <cmath>

#include "synthesis/problem/reader.h"

namespace mechwright::bench {

double WholeCurveError::at(const CurveArguments& arguments, std::size_t assembly, CurveWork& work) const {
    if (!curve.allows(assembly, arguments)) return unlimited;
    FittedCurve design{arguments, assembly};
    if (!descend(curve, design, 1, 0, work)) return unlimited;
    return std::sqrt(design.sum / curve.weight) * unit();
}

double WholeCurveError::at(std::span<const double> part, CurveWork& work) const {
    CurveArguments a{};
    for (std::size_t i = 0; i < curve.arguments; ++i)
        a[i] = curve.lower[i] + part[i] * (curve.upper[i] - curve.lower[i]);
    return at(a, part[curve.arguments] < 0.5 ? 0 : 1, work);
}

WholeCurveError whole_curve_error(const Shape& shape) {
    auto problem = std::make_shared<const Problem>(parse_problem(problem_text(shape, 1), "shape.toml").problem);
    std::vector<Program> programs;
    for (const Variant& variant : variants(*problem))
        programs.push_back(build_program(*problem, variant));
    auto kept = std::make_shared<const std::vector<Program>>(std::move(programs));
    return {problem, kept, curve_problem(*kept).value()};
}

}  // namespace mechwright::bench
