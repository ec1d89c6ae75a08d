#include "synthesis/bench/program_times.h"

#include <cmath>

#include "synthesis/bench/instructions.h"
#include "synthesis/search/starts.h"

namespace mechwright::bench {

namespace {

/// The program evaluated over and over into the same place.
struct Evaluation {
    const ProgramPoint* at;
    ProgramValues values{};

    double operator()(bool derivatives) { return operator()(at->x, derivatives); }
    double operator()(const Eigen::VectorXd& x, bool derivatives) {
        evaluate(at->program, x, derivatives, values);
        return values.objective;
    }
};

Eigen::VectorXd ones(const ProgramPoint& at) {
    return Eigen::VectorXd::Ones(static_cast<Eigen::Index>(at.program.rows.size()));
}

bool is_regular(const ProgramPoint& at) {
    Evaluation evaluation{&at};
    evaluation(true);
    LagrangianHessian hessian;
    lagrangian_hessian(at.program, at.x, 1, ones(at), hessian);
    return evaluation.values.assembled && hessian.value.allFinite();
}

}  // namespace

std::optional<ProgramPoint> program_point(const Problem& problem) {
    constexpr int starts = 20, candidates = 50;
    for (const Variant& variant : variants(problem)) {
        ProgramPoint at{build_program(problem, variant), {}};
        if (at.program.size() == 0) return std::nullopt;
        for (int start = 1; start <= starts; ++start) {
            at.x = start_point(at.program, problem.solver.seed, start, candidates);
            if (is_regular(at)) return at;
        }
    }
    return std::nullopt;
}

Piece values(const ProgramPoint& at) {
    return piece([evaluation = Evaluation{&at}](std::size_t) mutable { return evaluation(false); });
}

Piece values_and_gradients(const ProgramPoint& at) {
    return piece([evaluation = Evaluation{&at}](std::size_t) mutable { return evaluation(true); });
}

Piece differences(const ProgramPoint& at) {
    return piece([evaluation = Evaluation{&at}, moved = at.x](std::size_t) mutable {
        const double step = std::ldexp(1.0, -26);
        double sum = evaluation(false);
        for (double& variable : moved) {
            const double here = variable;
            variable += step;
            sum += evaluation(moved, false);
            variable = here;
        }
        return sum;
    });
}

Piece hessians(const ProgramPoint& at) {
    return piece([&at, multipliers = ones(at), hessian = LagrangianHessian{}](std::size_t) mutable {
        lagrangian_hessian(at.program, at.x, 1, multipliers, hessian);
        return hessian.value.sum();
    });
}

std::optional<long> instructions_of_values(const ProgramPoint& at, long most) {
    Evaluation evaluation{&at};
    return instructions_of([&] { benchmark::DoNotOptimize(evaluation(false)); }, most);
}

}  // namespace mechwright::bench
