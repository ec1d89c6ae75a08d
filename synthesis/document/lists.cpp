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

Json angles(const std::vector<double>& radians, const Units& units) {
    Json list = Json::array();
    for (const double angle : radians)
        list.push_back(std::isfinite(angle) ? Json(in_file_unit(angle, Unit::angle, units)) : Json());
    return list;
}

}  // namespace mechwright
