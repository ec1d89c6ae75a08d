#pragma once
/// \file
/// Starts for the search of a path by mechanisms of which few random designs close, linkages among them: very many
/// points are drawn, left at the first target at which they do not assemble (assembled_draws.h), and of the others
/// those are kept that come close to the targets once placement, size and guided points are fitted (target/path/fit.h).

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "synthesis/search/assembled_draws.h"
#include "synthesis/search/draws.h"

namespace mechwright {

/// A point of a program of which some variables are known to be good, whatever the others are.
struct KnownPart {
    Eigen::VectorXd x;
    std::vector<Eigen::Index> known;  ///< variables
};

class DrawnStarts {
public:
    /// Where parts are known each candidate takes one of them in turn, and the rest is drawn; as many then come as
    /// close to the targets, it is all that is asked for that ranks them. `program` must outlive this.
    DrawnStarts(const Program& program, std::uint64_t seed, std::vector<KnownPart> parts = {})
        : program_(program), draws_(program, seed), parts_(std::move(parts)) {}

    /// The best `keep` starts of a round, best first: draws until `enough` times as many assemble, no more than `most`
    /// times as many. The preferred values are among the candidates of round 0 where no parts are known. A function of
    /// (program, seed, round) alone; `counts` are added to.
    std::vector<Eigen::VectorXd> of_round(int round, int keep, int enough, int most, DrawCounts& counts) const;

private:
    Eigen::VectorXd draw(std::uint64_t k) const;
    std::vector<NumberedDraw> draws_that_assemble(std::uint64_t first, std::uint64_t end) const;

    const Program& program_;
    Draws draws_;
    std::vector<KnownPart> parts_;
};

}  // namespace mechwright
