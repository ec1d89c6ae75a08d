#include "synthesis/bench/linkages/swarm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/bench/profiles/random_number.h"

namespace mechwright::bench {

namespace {

/// pylinkage's particle_swarm_optimization, which hands them to LocalBestPSO of pyswarms.
constexpr std::size_t particles = 100, neighbours = 17;
constexpr double to_own_best = 3, to_best_of_neighbours = 0.1, inertia = 0.6;
/// It ends after so many steps; with more evaluations it begins again.
constexpr long most_steps = 200;

class Swarm {
public:
    Swarm(const BoxedError& error, std::uint64_t seed) : error_(error), seed_(seed) {
        const std::size_t n = error.lower.size();
        all_.resize(particles);
        for (Particle& p : all_) {
            p.at.resize(n);
            p.velocity.resize(n);
            for (std::size_t i = 0; i < n; ++i) {
                p.at[i] = error.lower[i] + (error.upper[i] - error.lower[i]) * random();
                p.velocity[i] = random();
            }
            p.best_at = p.at;
        }
    }

    /// All particles evaluated, then moved.
    void step() {
        for (Particle& p : all_) {
            const double value = error_.at(p.at);
            least_ = std::min(least_, value);
            if (!(value < p.best)) continue;
            p.best = value;
            p.best_at = p.at;
        }
        std::vector<const Particle*> leaders;
        for (const Particle& p : all_)
            leaders.push_back(&best_near(p));
        std::vector<std::vector<double>> led;
        for (const Particle* leader : leaders)
            led.push_back(leader->best_at);
        for (std::size_t k = 0; k < all_.size(); ++k)
            move(all_[k], led[k]);
    }
    double least() const { return least_; }

private:
    struct Particle {
        std::vector<double> at{}, velocity{}, best_at{};
        double best = std::numeric_limits<double>::infinity();
    };

    double random() { return random_number(seed_, ++drawn_); }

    /// The best of those that are nearest by the sum of differences, itself among them.
    const Particle& best_near(const Particle& p) const {
        std::array<std::pair<double, std::size_t>, particles> by_distance;
        for (std::size_t k = 0; k < particles; ++k) {
            double sum = 0;
            for (std::size_t i = 0; i < p.at.size(); ++i)
                sum += std::abs(all_[k].at[i] - p.at[i]);
            by_distance[k] = {sum, k};
        }
        std::partial_sort(by_distance.begin(), by_distance.begin() + neighbours, by_distance.end());
        const auto best =
            std::min_element(by_distance.begin(), by_distance.begin() + neighbours,
                             [&](const auto& a, const auto& b) { return all_[a.second].best < all_[b.second].best; });
        return all_[best->second];
    }

    /// What leaves the box comes in at its other side.
    void move(Particle& p, const std::vector<double>& leader) {
        for (std::size_t i = 0; i < p.at.size(); ++i) {
            p.velocity[i] = inertia * p.velocity[i] + to_own_best * random() * (p.best_at[i] - p.at[i]) +
                            to_best_of_neighbours * random() * (leader[i] - p.at[i]);
            const double width = error_.upper[i] - error_.lower[i], from = p.at[i] + p.velocity[i] - error_.lower[i];
            p.at[i] = error_.lower[i] + from - width * std::floor(from / width);
        }
    }

    const BoxedError& error_;
    std::uint64_t seed_, drawn_ = 0;
    std::vector<Particle> all_{};
    double least_ = std::numeric_limits<double>::infinity();
};

double by_swarms(const BoxedError& error, std::uint64_t seed, long evaluations) {
    double least = std::numeric_limits<double>::infinity();
    for (long used = 0; used < evaluations;) {
        Swarm swarm(error, mixed(seed + static_cast<std::uint64_t>(used)));
        for (long step = 0; step < most_steps && used < evaluations; ++step) {
            swarm.step();
            used += static_cast<long>(particles);
        }
        least = std::min(least, swarm.least());
    }
    return least;
}

struct ErrorForPagmo {
    const BoxedError* error = nullptr;

    pagmo::vector_double fitness(const pagmo::vector_double& x) const { return {error->at(x)}; }
    std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
        if (error == nullptr) return {{0}, {1}};
        return {error->lower, error->upper};
    }
};

double by_evolution(const BoxedError& error, std::uint64_t seed, long evaluations) {
    constexpr unsigned for_each_variable = 10;
    constexpr double converged_at = 1e-12;
    const auto size = static_cast<unsigned>(for_each_variable * error.lower.size());
    const pagmo::problem problem{ErrorForPagmo{&error}};
    double least = std::numeric_limits<double>::infinity();
    for (long used = 0; used < evaluations;) {
        const auto own_seed = static_cast<unsigned>(mixed(seed + static_cast<std::uint64_t>(used)));
        pagmo::population individuals(problem, size, own_seed);
        const auto generations = static_cast<unsigned>((evaluations - used) / size + 1);
        individuals =
            pagmo::algorithm{pagmo::de{generations, 0.8, 0.9, 2, converged_at, converged_at, own_seed}}.evolve(
                individuals);
        least = std::min(least, individuals.champion_f().front());
        used += static_cast<long>(individuals.get_problem().get_fevals());
    }
    return least;
}

}  // namespace

std::span<const PeerOfLinkages> peers_of_linkages() {
    static constexpr std::array all{PeerOfLinkages{"particle swarm", by_swarms},
                                    PeerOfLinkages{"differential evolution", by_evolution}};
    return all;
}

}  // namespace mechwright::bench
