#pragma once
/// \file
/// Reading of JSON values that may be anything. The first defect is kept; after it, reading goes on with defaults.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/geometry/vector.h"

namespace mechwright::claims {

using Json = nlohmann::ordered_json;

inline constexpr std::size_t most_points = 10000;  ///< of a target

/// The member of an object, or null where there is none.
const Json* member(const Json& object, const std::string& name);

/// A value as messages show it, cut where it is long; "nothing" for null.
std::string shown(const Json* value);

/// Each function takes a value, or null where there is none, and its place in the document for the message.
struct Reader {
    std::string defect;

    bool understood() const { return defect.empty(); }
    void fail(std::string why);

    /// The value if it is an object, else null.
    const Json* object(const Json* json, const std::string& place);
    /// Whether it is an array of at most so many entries.
    bool array(const Json* json, const std::string& place, std::size_t most);
    std::string text(const Json* json, const std::string& place);
    bool flag(const Json* json, const std::string& place);
    /// A finite number.
    double number(const Json* json, const std::string& place);
    std::optional<double> optional_number(const Json* json, const std::string& place);
    /// A number in either unit of angles, small enough for it to have digits left after the point.
    double angle(const Json* json, const std::string& place);
    std::vector<double> numbers(const Json* json, const std::string& place, std::size_t most, bool angles);
    std::vector<Vector<double>> points(const Json* json, const std::string& place, std::size_t most);
};

}  // namespace mechwright::claims
