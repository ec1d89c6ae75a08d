#pragma once
/// \file
/// A problem of a built-in kind that is a linkage, said as the linkage that it is.

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/problem/reader.h"

namespace mechwright {

/// A design that takes the place of what is open: the member `design` of a result document.
struct DesignPutIn {
    const nlohmann::ordered_json* design = nullptr;  ///< null: the problem stays as it is
    bool as_starts = false;  ///< its numbers are the starts of ranges, which stay; else they are given
};

struct ExpandedProblem {
    std::string text;               ///< of the problem file; empty where it cannot be said
    std::vector<Message> messages;  ///< what is wrong with the file, and what a linkage cannot carry, by its places

    bool ok() const { return !text.empty(); }
};

/// `file` is the name of the text in messages, and for the files that it names.
ExpandedProblem expand_problem(std::string_view text, const std::string& file, const DesignPutIn& put_in = {});

/// A design of a kind that is a linkage (Mechanism::as_linkage) as a problem file that asks for nothing; angles are
/// radians there. The dimensions are in mechanism order, radians and lengths.
std::string linkage_of_design(const Mechanism& kind, std::span<const double> dimensions, std::size_t assembly);

/// The same of any design: each dimension has a range.
std::string linkage_of_kind(const Mechanism& kind, std::size_t assembly);

}  // namespace mechwright
