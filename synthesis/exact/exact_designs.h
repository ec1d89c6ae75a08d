#pragma once
/// \file
/// What an exact method finds: designs that meet their targets exactly, and those with a defect.

#include <optional>
#include <string>
#include <vector>

#include "synthesis/exact/poses/guided_linkage.h"
#include "synthesis/program/proof.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// Of solutions that rounding does not part, or that belong to families: nothing is proven of the others either.
inline constexpr std::string_view some_are_singular =
    "the targets are special: some solutions coincide as far as doubles tell, and a better one may be among them";

struct ExactDesigns {
    std::vector<Solution> designs;         ///< without a defect that shows at the targets, best first
    std::vector<ExcludedDesign> excluded;  ///< with one
    std::optional<SolutionCounts> counts;  ///< of solutions that are isolated; none where they form families
    std::shared_ptr<const Proof> proof{};  ///< that every solution is accounted for
    long evaluations = 0;                  ///< paths that were followed, or members of families that were examined
    std::string note;                      ///< for the user, where there is no design
    int starts = 0;                        ///< local searches in a family
    int local_optima = 0;                  ///< that they came to
    bool stopped = false;
};

/// A linkage with the defect that excludes it, if there is one that shows at the targets; defects between them are for
/// verification.
struct ExactDesign {
    Solution solution;
    std::string defect;
};

/// A four-bar that passes the points or poses of a problem, as a design of it.
ExactDesign exact_design(const Problem& problem, const GuidedLinkage& found);

/// A design with the crank angles at which it meets the targets, up to whole turns: in the direction in which it does
/// so in their order, the better one where both will do.
ExactDesign exact_design(const Problem& problem, Design design, const std::vector<double>& crank_angles);

/// A design whose crank angles are known, or that has no path. What excludes it: the assembly, a dimension outside
/// its range, a requirement, a target that is missed.
ExactDesign exact_design(const Problem& problem, Design design);

/// Angles of a full turn come into their ranges where whole turns can do that.
void move_angles_into_ranges(const Problem& problem, Design& design);

/// A design that is of no use, whatever it is worth.
ExactDesign excluded_design(Design design, std::string defect);

/// Puts a design where it belongs.
void add_design(ExactDesigns& out, ExactDesign design);

/// Keeps the better of two: without a defect before with one, then as the problem prefers. Whether it was the new one.
bool keep_better(const Problem& problem, std::optional<ExactDesign>& best, ExactDesign design);

/// Best first.
void rank(const Problem& problem, ExactDesigns& out);

}  // namespace mechwright
