#include "synthesis/document/lists.h"

#include <cmath>

#include "synthesis/problem/units.h"

namespace mechwright {

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
