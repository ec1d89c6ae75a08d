#pragma once
/// \file
/// Pictures of a linkage as its file describes it, before it is a design: all its assemblies, and its links apart.

#include <span>
#include <string>

#include "synthesis/report/structure/assemblies.h"

namespace mechwright {

/// What [assembly] says of an assembly: a heading as a comment, and a line for each dyad that has two.
std::vector<std::string> assembly_block(const Linkage& linkage, const LinkageAssembly& assembly, std::size_t number);

/// The assemblies side by side in one scale, each with the names of its points and what [assembly] says of it (SVG);
/// of more than 64 the first ones.
std::string assemblies_picture(const Linkage& linkage, std::span<const LinkageAssembly> assemblies, double master,
                               double width);

/// Whether enough of a file could be read to draw its links.
bool has_skeleton(const Linkage& linkage);

/// Every link by itself in its own frame, whose axes are drawn, in one scale, with the names of its points and their
/// places (SVG). Of a linkage that was read with errors, what was read. Precondition: has_skeleton.
std::string skeleton_picture(const Linkage& linkage, double width);

}  // namespace mechwright
