#include "synthesis/report/names.h"

#include <algorithm>

#include "synthesis/problem/text.h"

namespace mechwright {

namespace {

void add_once(std::vector<std::string_view>& names, std::string_view name) {
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace

std::string_view name_of(Unit unit) {
    switch (unit) {
        case Unit::none: return "number";
        case Unit::length: return "length";
        case Unit::area: return "area";
        case Unit::curvature: return "curvature";
        case Unit::angle: return "angle";
        case Unit::force: return "force";
        case Unit::torque: return "torque";
        case Unit::rate: return "rate";
    }
    return "";
}

std::vector<std::string_view> mechanism_names() {
    std::vector<std::string_view> names;
    for (const auto& mechanism : mechanisms())
        add_once(names, mechanism->name);
    return names;
}

std::vector<std::shared_ptr<const Mechanism>> mechanisms_named(std::string_view name) {
    std::vector<std::shared_ptr<const Mechanism>> found;
    for (const auto& mechanism : mechanisms())
        if (mechanism->name == name) found.push_back(mechanism);
    return found;
}

std::string unknown_mechanism(const std::string& name) {
    return "unknown mechanism " + reading::quoted(name) + "; " + reading::remedy(name, mechanism_names());
}

std::vector<std::string_view> explained_names() {
    std::vector<std::string_view> names;
    for (const auto& mechanism : mechanisms())
        for (const Quantity& quantity : mechanism->quantities)
            add_once(names, quantity.name);
    for (const auto& mechanism : mechanisms()) {
        for (const Dimension& dimension : mechanism->dimensions)
            add_once(names, dimension.name);
        for (const Setting& setting : mechanism->settings)
            add_once(names, setting.name);
    }
    for (const auto& mechanism : mechanisms())
        add_once(names, mechanism->name);
    return names;
}

}  // namespace mechwright
