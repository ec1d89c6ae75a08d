#include "synthesis/document/lists.h"

#include <cmath>

#include "synthesis/problem/units.h"

namespace mechwright {

void put_number(nlohmann::ordered_json& object, std::string_view name, double number) {
    if (std::isfinite(number)) object[std::string(name)] = number;
}

using Json = nlohmann::ordered_json;

Json pairs(const std::vector<Vector<double>>& points) {
    Json list = Json::array();
    for (const Vector<double>& p : points)
        list.push_back({p.x, p.y});
    return list;
}

Json in_file_units(const std::vector<double>& values, Unit unit, const Units& units) {
    Json list = Json::array();
    for (const double value : values)
        list.push_back(std::isfinite(value) ? Json(in_file_unit(value, unit, units)) : Json());
    return list;
}

Json angles(const std::vector<double>& radians, const Units& units) {
    return in_file_units(radians, Unit::angle, units);
}

}  // namespace mechwright
