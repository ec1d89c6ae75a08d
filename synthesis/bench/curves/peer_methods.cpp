#include "synthesis/bench/curves/peer_methods.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include "analysis/numbers/low_discrepancy.h"
#include "analysis/numbers/scalar.h"
#include "synthesis/bench/curves/descriptors.h"
#include "synthesis/bench/curves/whole_curve_error.h"
#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"

namespace mechwright::bench {

namespace {

/// What a design counts for that does not assemble: more than any that does.
constexpr double worthless = 1e6;
/// Differential evolution: individuals per variable (R. Storn and K. Price, "Differential evolution", 1997) and the
/// generations after which it begins again.
constexpr unsigned individuals_per_variable = 10;
constexpr unsigned generations_of_evolution = 400;
/// CMA-ES begins again with twice the individuals (A. Auger and N. Hansen, "A restart CMA evolution strategy with
/// increasing population size", 2005).
constexpr unsigned first_individuals = 12;
constexpr unsigned generations_of_strategy = 2000;
constexpr double converged_within = 1e-12;
/// four-bar-rs: 200 individuals, 50 generations, curves of 180 points, lengths up to ten cranks.
constexpr unsigned individuals_of_descriptors = 200;
constexpr unsigned generations_of_descriptors = 50;
constexpr std::size_t points_of_curve = 180;
constexpr double least_of_crank = 1e-2;
constexpr double most_of_crank = 10;
constexpr int most_harmonics = 40;
constexpr double power_left_out = 1e-5;

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The error of the whole curve as pagmo wants a problem: a function of the unit box.
struct WholeCurveBox {
    WholeCurveError error{};
    std::shared_ptr<CurveWork> work = std::make_shared<CurveWork>();

    pagmo::vector_double fitness(const pagmo::vector_double& part) const {
        return {std::min(error.at(part, *work), worthless)};
    }
    std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
        return {pagmo::vector_double(unit_box_size, 0), pagmo::vector_double(unit_box_size, 1)};
    }
};

/// Restarts until so many evaluations are used up: evolve(restart, population size, seed) gives the algorithm.
template <class Size, class Evolve>
PeerRun evolved(const Shape& shape, std::uint64_t seed, long evaluations, const Size& size, const Evolve& evolve) {
    const auto begin = std::chrono::steady_clock::now();
    const pagmo::problem problem{WholeCurveBox{whole_curve_error(shape)}};
    PeerRun run{std::numeric_limits<double>::infinity(), 0, 0};
    for (unsigned restart = 0; run.evaluations < static_cast<double>(evaluations); ++restart) {
        const auto own_seed = static_cast<unsigned>(mixed(seed + 1000 * restart));
        pagmo::population individuals(problem, size(restart), own_seed);
        const auto left = static_cast<unsigned>((static_cast<double>(evaluations) - run.evaluations) / size(restart));
        individuals = evolve(left + 1, own_seed).evolve(individuals);
        run.rms = std::min(run.rms, individuals.champion_f().front());
        run.evaluations += static_cast<double>(individuals.get_problem().get_fevals());
    }
    if (run.rms >= worthless) run.rms = std::numeric_limits<double>::infinity();
    run.seconds = seconds_since(begin);
    return run;
}

PeerRun differential_evolution(const Shape& shape, std::uint64_t seed, long evaluations) {
    const unsigned size = individuals_per_variable * unit_box_size;
    return evolved(
        shape, seed, evaluations, [&](unsigned) { return size; },
        [](unsigned generations, unsigned own_seed) {
            return pagmo::algorithm{pagmo::de{std::min(generations, generations_of_evolution), 0.8, 0.9, 2,
                                              converged_within, converged_within, own_seed}};
        });
}

PeerRun covariance_strategy(const Shape& shape, std::uint64_t seed, long evaluations) {
    return evolved(
        shape, seed, evaluations, [](unsigned restart) { return first_individuals << std::min(restart, 8u); },
        [](unsigned generations, unsigned own_seed) {
            return pagmo::algorithm{pagmo::cmaes{std::min(generations, generations_of_strategy), -1, -1, -1, -1, 0.3,
                                                 converged_within, converged_within, false, true, own_seed}};
        });
}

/// Five numbers of a linkage with a crank of 1: ground, coupler, rocker, place of the point on the coupler; then the
/// assembly. Lengths evenly over their logarithm.
struct DescriptorsBox {
    WholeCurveError error{};
    Descriptors wanted{};
    std::shared_ptr<CurveWork> work = std::make_shared<CurveWork>();

    static double length(double part) { return least_of_crank * std::pow(most_of_crank / least_of_crank, part); }
    static CurveArguments arguments(const pagmo::vector_double& part) {
        const double angle = 2 * pi<double>() * part[4], distance = length(part[3]);
        return {length(part[0]),
                1,
                length(part[1]),
                length(part[2]),
                distance * std::cos(angle),
                distance * std::sin(angle),
                0,
                0,
                0};
    }
    static std::size_t assembly(const pagmo::vector_double& part) { return part[5] < 0.5 ? 0 : 1; }

    /// How the curve of a linkage differs from what is wanted.
    Difference differs(const pagmo::vector_double& part) const {
        constexpr Difference none{worthless, 0, 1};
        const CurveProblem& p = error.curve;
        const CurveArguments a = arguments(part);
        SampledCurve& curve = work->curve;
        if (!p.fit->sample(p.set, assembly(part), std::span(a).first(p.arguments), points_of_curve, curve)) return none;
        if (!curve.closed) return none;
        std::vector<Vector<double>> points;
        for (std::size_t k = 0; k + 1 < curve.count; ++k)
            points.push_back({curve.x[k], curve.y[k]});
        const auto own = descriptors_of(points, static_cast<int>(wanted.forward.size()));
        return own.forward.empty() ? none : difference(wanted, own);
    }
    pagmo::vector_double fitness(const pagmo::vector_double& part) const {
        return {std::min(differs(part).distance, worthless)};
    }
    std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
        return {pagmo::vector_double(6, 0), pagmo::vector_double(6, 1)};
    }
    /// What the linkage misses the shape by, laid over it, in mm; whatever size it comes out at.
    double rms(const pagmo::vector_double& part) const {
        const Difference laid = differs(part);
        if (laid.distance >= worthless) return std::numeric_limits<double>::infinity();
        CurveArguments a = arguments(part);
        for (std::size_t i = 0; i < 6; ++i)
            a[i] *= std::abs(laid.factor) / error.unit();
        a[6] = laid.shift.real() / error.unit();
        a[7] = laid.shift.imag() / error.unit();
        a[8] = std::arg(laid.factor);
        return error.at(a, assembly(part), *work);
    }
};

PeerRun evolution_on_descriptors(const Shape& shape, std::uint64_t seed, long) {
    const auto begin = std::chrono::steady_clock::now();
    const int harmonics = harmonics_of(shape.points, most_harmonics, power_left_out);
    const DescriptorsBox box{whole_curve_error(shape), descriptors_of(shape.points, harmonics)};
    const auto own_seed = static_cast<unsigned>(mixed(seed));
    const pagmo::problem problem{box};
    pagmo::population individuals(problem, individuals_of_descriptors, own_seed);
    individuals =
        pagmo::algorithm{pagmo::de{generations_of_descriptors, 0.8, 0.9, 2, 0, 0, own_seed}}.evolve(individuals);
    return {box.rms(individuals.champion_x()), static_cast<double>(individuals.get_problem().get_fevals()),
            seconds_since(begin)};
}

PeerRun solved(const Shape& shape, std::uint64_t seed, std::string_view method) {
    Problem problem = parse_problem(problem_text(shape, static_cast<int>(seed)), "shape.toml").problem;
    problem.solver.method = method;
    RunOptions options;
    options.jobs = 1;
    const Result result = solve(problem, options);
    const bool good = result.status == Status::solved;
    return {good ? result.best->objective : std::numeric_limits<double>::infinity(),
            static_cast<double>(result.search.evaluations), result.search.seconds};
}

PeerRun by_default(const Shape& shape, std::uint64_t seed, long) { return solved(shape, seed, "auto"); }
PeerRun by_slsqp(const Shape& shape, std::uint64_t seed, long) { return solved(shape, seed, "slsqp"); }

}  // namespace

std::span<const PeerMethod> peer_methods() {
    static constexpr std::array all{
        PeerMethod{"default", false, by_default},
        PeerMethod{"SLSQP, multistart", false, by_slsqp},
        PeerMethod{"CMA-ES, restarts", false, covariance_strategy},
        PeerMethod{"differential evolution, restarts", false, differential_evolution},
        PeerMethod{"differential evolution on descriptors", true, evolution_on_descriptors},
    };
    return all;
}

}  // namespace mechwright::bench
