#pragma once
/// \file
/// Texts of problems with something else in a place of theirs.

#include <gtest/gtest.h>

#include <string>

namespace mechwright::testing {

/// The text with `by` where it first says `what`, which it has to.
inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

}  // namespace mechwright::testing
