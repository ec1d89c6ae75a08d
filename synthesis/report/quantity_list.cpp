#include "synthesis/report/quantity_list.h"

#include "synthesis/problem/text.h"

namespace mechwright {

std::string_view name_of(Unit unit) {
    switch (unit) {
        case Unit::none: return "number";
        case Unit::length: return "length";
        case Unit::area: return "area";
        case Unit::angle: return "angle";
        case Unit::force: return "force";
        case Unit::torque: return "torque";
    }
    return "";
}

std::vector<const Mechanism*> mechanisms_named(std::string_view name) {
    std::vector<const Mechanism*> found;
    for (const Mechanism* mechanism : mechanisms())
        if (mechanism->name == name) found.push_back(mechanism);
    return found;
}

std::string unknown_mechanism(const std::string& name) {
    std::vector<std::string_view> known;
    for (const Mechanism* mechanism : mechanisms())
        known.push_back(mechanism->name);
    return "unknown mechanism " + reading::quoted(name) + "; " + reading::remedy(name, known);
}

}  // namespace mechwright
