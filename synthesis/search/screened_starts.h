#pragma once
/// \file
/// Starts for the search of a path, picked from very many candidates by what is left of the targets once placement,
/// size and guided point are fitted (synthesis/mechanism/path_screening.h).

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "synthesis/search/drawn_starts.h"

namespace mechwright {

class ScreenedStarts {
public:
    /// Draws the proportions of lengths that candidates have. `program` must outlive this.
    ScreenedStarts(const Program& program, std::uint64_t seed);

    /// The best starts of a round: one from each of `groups` groups of eight candidates that share their crank angles,
    /// the best `keep` of them, best first. Where a mechanism cannot be screened so, they are drawn one by one
    /// (drawn_starts.h). A function of (program, seed, round) alone; `counts` are added to.
    std::vector<Eigen::VectorXd> of_round(int round, int groups, int keep, DrawCounts& counts) const;

private:
    static constexpr std::size_t most_lengths = 8;
    using Lengths = std::array<double, most_lengths>;

    struct Candidate;

    bool meets_conditions(const Lengths& x) const;
    int random_variables() const;
    std::vector<Eigen::VectorXd> one_by_one(int round, int groups, int keep, DrawCounts& counts) const;
    void draw_shapes();
    std::optional<Eigen::MatrixXd> lengths_of_margins() const;
    double beyond_range(const Lengths& x, double size) const;
    std::vector<ScreenedPoint> points() const;
    bool stays_assembled(const Eigen::VectorXd& x) const;

    const Program& program_;
    std::uint64_t seed_;
    std::uint64_t stream_;
    bool can_screen_;          ///< else starts are evaluated one by one
    std::size_t lengths_ = 0;  ///< the mechanism's first dimensions
    PathFreedom free_{};
    Lengths lower_{};
    Lengths upper_{};
    std::vector<Lengths> shapes_;
};

}  // namespace mechwright
