#pragma once
/// \file
/// What the parts of `expand_problem` share.

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>

#include "synthesis/problem/linkage/of_kinds/expand.h"
#include "synthesis/problem/toml/in_order.h"
#include "synthesis/problem/toml/section.h"

namespace mechwright::reading {

struct Expanding {
    const toml::table& table;  ///< of the file
    const Problem& problem;    ///< the same, read
    const AsLinkage& as;
    const DesignPutIn& put_in;
    Messages& messages;
    std::string text{};  ///< of the linkage, so far

    /// Whether a dimension is a number that targets bring, after those of the kind.
    bool is_of_target(std::size_t dimension) const;
    /// The number of a dimension in the design that is put in, in the file's units.
    std::optional<double> number_of_design(std::string_view name) const;
    /// The assembly of that design.
    std::optional<std::size_t> assembly_of_design() const;
};

/// Reports the targets that a linkage of this kind cannot have.
void refuse_targets(Expanding& e);

/// Their sections, with what they speak of and the numbers that else stand in [dimensions].
void write_targets(Expanding& e);

/// Objectives and requirements, by the quantities of the linkage.
void write_asked(Expanding& e);

}  // namespace mechwright::reading
