#pragma once
/// \file
/// Starts for the search of a path by mechanisms of which few random designs close, linkages among them: very many
/// points are drawn, left at the first target at which they do not assemble (assembled_draws.h), and of the others
/// those are kept that come close to the targets once placement, size and guided points are fitted (target/path/fit.h).

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "synthesis/search/assembled_draws.h"
#include "synthesis/search/draws.h"

namespace mechwright {

class DrawnStarts {
public:
    /// `program` must outlive this.
    DrawnStarts(const Program& program, std::uint64_t seed) : program_(program), draws_(program, seed) {}

    /// The best `keep` starts of a round, best first: draws until `enough` times as many assemble, no more than `most`
    /// times as many. The preferred values are among the candidates of round 0. A function of (program, seed, round)
    /// alone; `counts` are added to.
    std::vector<Eigen::VectorXd> of_round(int round, int keep, int enough, int most, DrawCounts& counts) const;

private:
    std::vector<NumberedDraw> draws_that_assemble(std::uint64_t first, std::uint64_t end) const;

    const Program& program_;
    Draws draws_;
};

}  // namespace mechwright
