#include "synthesis/target/function/function_target.h"

#include <fmt/format.h>
#include <muParser.h>

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

std::string complete_samples(FunctionTarget& target) {
    const auto& samples = target.samples;
    const double x0 = samples.front().x, y0 = samples.front().y;
    const double width = samples.back().x - x0, height = samples.back().y - y0;
    if (height == 0) return "the function has the same value at both ends of its range: nothing then scales the output";
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
    for (int i = 0; i <= probes; ++i) {
        const double x = target.from + (target.to - target.from) * i / probes;
        if (!std::isfinite(y(x))) return fmt::format("the expression has no value at x = {}, inside its range", x);
    }
    const double y0 = y(target.from), height = y(target.to) - y0;
    if (height == 0) return "the function has the same value at both ends of its range: nothing then scales the output";
    const double middle = 0.5 * (target.from + target.to), half = 0.5 * (target.to - target.from);
    auto series = chebyshev_series([&](double s) { return (y(middle + half * s) - y0) / height; });
    if (!series) return "the expression is not smooth inside its range: give samples = [[x, y], ...] instead";
    target.series = *std::move(series);
    return {};
}

}  // namespace mechwright
