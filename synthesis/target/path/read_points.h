#pragma once
/// \file
/// Lists of points, wherever they stand.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/geometry/vector.h"
#include "synthesis/problem/messages.h"

namespace mechwright::reading {

constexpr std::size_t most_points = 10000;

/// Points and where each of them stands.
struct PointList {
    std::vector<Vector<double>> points{};
    std::vector<FilePlace> places{};
    std::string file{};    ///< the file with the points, as messages show it; empty if they stand in the problem file
    FilePlace named_at{};  ///< the list, or the file's name, in the problem file
    bool whole = false;    ///< every point could be read, and there is one
};

/// A point that cannot be read keeps its place in the list, so that the numbers of the others stay right.
void add_point(PointList& list, const std::optional<Vector<double>>& point, FilePlace place);

/// The points of a table with two columns.
void read_point_table(std::string_view text, PointList& list, Messages& messages);

/// An error about a point, in whichever file it stands.
void add_point_error(const PointList& list, FilePlace place, std::string text, Messages& messages);

}  // namespace mechwright::reading
