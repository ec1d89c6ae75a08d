#pragma once
/// \file
/// All assemblies of a linkage at an input, and how a file asks for one of them.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/linkage/place.h"
#include "synthesis/problem/linkage/linkage.h"

namespace mechwright {

struct LinkageAssembly {
    std::vector<std::int8_t> sides;  ///< of each choice of the order, 1 or -1
    linkage::Pose<double> pose;
    bool as_in_file = false;  ///< what the file asks for, or one of these where it says "either"
};

/// Whether a link is left out of the order: its side follows from the others.
bool is_redundant(const Linkage& linkage, std::size_t link);

/// The dyads of which a file chooses the side, in the order in which they are placed.
std::vector<const linkage::Group*> chosen_dyads(const Linkage& linkage);

/// Those that close at an input of the master (radians, or a displacement); of more than ten dyads the last ones are
/// left at their first side. Ranges of dimensions stand at their usual values. Precondition: the order is closed.
std::vector<LinkageAssembly> assemblies_at(const Linkage& linkage, double master);

/// "left", "right", "ahead", "behind"; "either" for 0.
std::string_view word_of(const linkage::Group& group, int side);

/// A line of [assembly]: `C = { side = "left", from = "B", to = "D" }`, whatever the order of the links, or
/// `C = "ahead"`.
std::string assembly_line(const Linkage& linkage, const linkage::Group& group, int side);

}  // namespace mechwright
