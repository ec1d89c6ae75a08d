#pragma once
/// \file
/// All assemblies of a linkage at an input.

#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/linkage/placing/place.h"
#include "synthesis/problem/linkage/linkage.h"

namespace mechwright {

struct LinkageAssembly {
    std::vector<std::int8_t> sides;  ///< of each choice of the order, 1 or -1
    linkage::Pose<double> pose;
    bool as_in_file = false;            ///< what the file asks for, or one of these where it says "either"
    std::vector<std::size_t> larger{};  ///< of each larger group which of its assemblies at this input, from 1
};

/// The input at which assemblies are shown where none is asked for: at which indices of larger groups count, or one of
/// the motion.
double usual_input(const Linkage& linkage);

/// The dyads of which a file chooses the side, in the order in which they are placed.
std::vector<const linkage::Group*> chosen_dyads(const Linkage& linkage);

/// Those that close at an input of the master (radians, or a displacement); of more than ten dyads the last ones are
/// left at their first side. Ranges of dimensions stand at their usual values. Of larger groups that are no triads
/// those that are found.
std::vector<LinkageAssembly> assemblies_at(const Linkage& linkage, double master);

/// An input at which the linkage closes (radians, or a displacement), with all assemblies there.
struct AssembledAt {
    double master = 0;
    std::vector<LinkageAssembly> assemblies;
};

/// At the input that is asked for, or else the one that the file names, or else the one of a round of inputs at which
/// most assemblies close; none where it does not close there. Precondition: the linkage has a drive.
AssembledAt assembled_at(const Linkage& linkage, std::optional<double> at);

}  // namespace mechwright
