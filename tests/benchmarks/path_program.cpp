// What derivatives cost: a path problem of ten variables and twenty-four timed points, evaluated for its value, its
// value and gradient, and its Hessian. The ratio to the value alone is what counts; machines differ in the rest.

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "synthesis/problem/reader.h"
#include "synthesis/program/program.h"
#include "synthesis/search/starts.h"

namespace {

using namespace mechwright;

const Problem& problem() {
    static const Problem p = [] {
        std::string points;
        std::string angles;
        for (int i = 0; i < 24; ++i) {
            const double t = i * 0.26179938779914941;
            points += "[" + std::to_string(40 * std::cos(t)) + ", " + std::to_string(25 * std::sin(t)) + "], ";
            angles += std::to_string(15 * i) + ", ";
        }
        const std::string text = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 20, max = 200 }
crank = { min = 5, max = 60 }
coupler = { min = 20, max = 200 }
rocker = { min = 20, max = 200 }
point-along = { min = -100, max = 100 }
point-across = { min = -100, max = 100 }
origin-x = { min = -100, max = 100 }
origin-y = { min = -100, max = 100 }
tilt = { min = 0, max = 360 }
crank-start = { min = 0, max = 360 }
[path]
points = [)" + points + "]\ntiming = \"prescribed\"\ncrank_angles = [" +
                                 angles + "]\n[objective]\nminimize = \"path-sse\"\n";
        return parse_problem(text, "benchmark.toml").problem;
    }();
    return p;
}

const Program& program() {
    static const Program p = build_program(problem(), variants(problem()).front());
    return p;
}

void value(benchmark::State& state) {
    const Eigen::VectorXd x = start_point(program(), 1, 1, 50);
    ProgramValues out;
    for (auto _ : state) {
        evaluate(program(), x, false, out);
        benchmark::DoNotOptimize(out.objective);
    }
}
BENCHMARK(value)->Name("path program: value");

void value_and_gradient(benchmark::State& state) {
    const Eigen::VectorXd x = start_point(program(), 1, 1, 50);
    ProgramValues out;
    for (auto _ : state) {
        evaluate(program(), x, true, out);
        benchmark::DoNotOptimize(out.objective);
    }
}
BENCHMARK(value_and_gradient)->Name("path program: value and gradient");

void hessian(benchmark::State& state) {
    const Eigen::VectorXd x = start_point(program(), 1, 1, 50);
    const Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(program().rows.size()));
    LagrangianHessian out;
    for (auto _ : state) {
        lagrangian_hessian(program(), x, 1, multipliers, out);
        benchmark::DoNotOptimize(out.value.data());
    }
}
BENCHMARK(hessian)->Name("path program: Hessian");

}  // namespace
