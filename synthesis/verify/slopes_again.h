#pragma once
/// \file
/// How something changes with the dimensions that a document leaves open, by differences in fifty digits, and what of
/// it is independent.

#include <cstddef>
#include <functional>
#include <vector>

#include "synthesis/verify/rebuilt.h"

namespace mechwright {

using RowAgain = std::vector<Digits50>;

/// Several values of a design, at dimensions close to those that it has.
using ValuesAgain = std::function<std::vector<Digits50>(const std::vector<Digits50>& dimensions)>;

/// By each dimension that is open, with all that are tied to it: [value][open dimension], by central differences. Where
/// `sides` is given, it gets by how much the differences to either side are apart, at most, over the greatest slope.
std::vector<RowAgain> slopes_again(const Rebuilt& design, const ValuesAgain& values, Digits50* sides = nullptr);

/// The dimensions that are open, in the order of their columns.
std::vector<std::size_t> open_dimensions(const Claim& claim);

/// Columns of unit length, or none: what is that much smaller than the greatest is rounding of the differences, where
/// nothing depends on a dimension.
void scale_columns(std::vector<RowAgain>& rows);

/// The columns that are independent beyond this part of the first pivot, the greatest first.
std::vector<std::size_t> independent_columns(std::vector<RowAgain> rows, double independent_beyond);

/// The rows in these columns alone.
std::vector<RowAgain> in_columns(const std::vector<RowAgain>& rows, const std::vector<std::size_t>& columns);

/// Of n + 1 rows in n columns: whether they balance with weights above 0, or of either sign where they are of
/// equalities. Weights are the determinants of the other rows, with alternating signs. The first is of no equality.
bool balances(const std::vector<RowAgain>& rows, const std::vector<bool>& equality);

}  // namespace mechwright
