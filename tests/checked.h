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

inline bool is_refused(const nlohmann::ordered_json& document) {
    const std::vector<Check> checks = verify(document);
    return std::any_of(checks.begin(), checks.end(), [](const Check& check) { return !check.passed; });
}

}  // namespace mechwright::testing
