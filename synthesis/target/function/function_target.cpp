#include "synthesis/target/function/function_target.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mechwright {

struct ExpressionValues::Parser {
    mu::Parser parser;
    double x = 0;
};

namespace {

constexpr std::size_t longest_expression = 1000;

void prepare(mu::Parser& parser, double* x, const std::string& expression) {
    parser.DefineVar("x", x);
    parser.DefineConst("pi", 3.14159265358979323846);
    parser.DefineConst("e", 2.71828182845904523536);
    parser.SetExpr(expression);
}

/// The output's range stands for how much the function grows from one end to the other. A function that swings farther
/// than this part of its greatest change allows would have the output turn a million times its range.
constexpr double least_growth = 1e-6;

std::string why_not_scaled(double growth, double greatest_change) {
    if (std::abs(growth) > least_growth * greatest_change) return {};
    return "the function has the same value at both ends of its range: nothing then scales the output, whose 'range' "
           "stands for how much y grows from the first x to the last; end where y is another";
}

std::string complete_samples(FunctionTarget& target) {
    const auto& samples = target.samples;
    const double x0 = samples.front().x, y0 = samples.front().y;
    const double width = samples.back().x - x0, height = samples.back().y - y0;
    double greatest_change = 0;
    for (const Vector<double>& s : samples)
        greatest_change = std::max(greatest_change, std::abs(s.y - y0));
    if (std::string why = why_not_scaled(height, greatest_change); !why.empty()) return why;
    target.parts.clear();
    for (const Vector<double>& s : samples)
        target.parts.push_back({(s.x - x0) / width, (s.y - y0) / height});
    target.from = x0;
    target.to = samples.back().x;
    return {};
}

}  // namespace

ExpressionValues::ExpressionValues(const std::string& expression) : parser_(std::make_unique<Parser>()) {
    prepare(parser_->parser, &parser_->x, expression);
}

ExpressionValues::~ExpressionValues() = default;

double ExpressionValues::operator()(double x) {
    parser_->x = x;
    try {
        return parser_->parser.Eval();
    } catch (const mu::Parser::exception_type&) {
        return std::numeric_limits<double>::quiet_NaN();
    }
}

std::string why_not_understood(const std::string& expression) {
    if (expression.size() > longest_expression) return "the expression is longer than 1000 characters";
    try {
        mu::Parser parser;
        double x = 1;
        prepare(parser, &x, expression);
        parser.Eval();
    } catch (const mu::Parser::exception_type& wrong) {
        return fmt::format("the expression is not understood: {}", wrong.GetMsg());
    }
    return {};
}

FunctionTarget at_accuracy_points(const FunctionTarget& target) {
    FunctionTarget points;
    points.parts = target.parts;
    if (target.expression.empty()) return points;
    ExpressionValues y(target.expression);
    const double y0 = y(target.from), height = y(target.to) - y0;
    for (const double x : target.accuracy_points)
        points.parts.push_back({(x - target.from) / (target.to - target.from), (y(x) - y0) / height});
    return points;
}

std::string complete(FunctionTarget& target) {
    if (!target.samples.empty()) return complete_samples(target);
    if (std::string why = why_not_understood(target.expression); !why.empty()) return why;
    ExpressionValues y(target.expression);
    constexpr int probes = 1000;
    const double y0 = y(target.from), height = y(target.to) - y0;
    double greatest_change = 0;
    for (int i = 0; i <= probes; ++i) {
        const double x = target.from + (target.to - target.from) * i / probes, change = y(x) - y0;
        if (!std::isfinite(change)) return fmt::format("the expression has no value at x = {}, inside its range", x);
        greatest_change = std::max(greatest_change, std::abs(change));
    }
    if (std::string why = why_not_scaled(height, greatest_change); !why.empty()) return why;
    const double middle = 0.5 * (target.from + target.to), half = 0.5 * (target.to - target.from);
    auto series = chebyshev_series([&](double s) { return (y(middle + half * s) - y0) / height; });
    if (!series) return "the expression is not smooth inside its range: give samples = [[x, y], ...] instead";
    target.series = *std::move(series);
    return {};
}

}  // namespace mechwright
