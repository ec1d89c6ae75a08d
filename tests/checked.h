#pragma once
/// \file
/// Documents as verification finds them.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "synthesis/verify/verify.h"

namespace mechwright::testing {

inline void expect_verified(const nlohmann::ordered_json& document) {
    for (const Check& check : verify(document))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

/// How many of a document's numbers are found again as they are stated, whether it meets its requirements or not.
inline std::size_t count_of_stated(const nlohmann::ordered_json& document) {
    std::size_t stated = 0;
    for (const Check& check : verify(document))
        if (check.name.ends_with("stated")) {
            EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
            ++stated;
        }
    return stated;
}

inline bool is_refused(const nlohmann::ordered_json& document) {
    const std::vector<Check> checks = verify(document);
    return std::any_of(checks.begin(), checks.end(), [](const Check& check) { return !check.passed; });
}

}  // namespace mechwright::testing
