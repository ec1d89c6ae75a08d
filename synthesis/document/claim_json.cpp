#include "synthesis/document/claim_json.h"

#include <fmt/format.h>

#include <cmath>

#include "synthesis/problem/text.h"

namespace mechwright::claims {

namespace {

constexpr double largest_angle = 1e6;

std::string place_in(const std::string& list, std::size_t index) { return fmt::format("{}[{}]", list, index); }

}  // namespace

const Json* member(const Json& object, const std::string& name) {
    const auto at = object.find(name);
    return at == object.end() ? nullptr : &*at;
}

std::string shown(const Json* value) {
    constexpr std::size_t longest = 60;
    return value ? reading::printable(value->dump(-1, ' ', false, Json::error_handler_t::replace), longest) : "nothing";
}

void Reader::fail(std::string why) {
    if (defect.empty()) defect = std::move(why);
}

const Json* Reader::object(const Json* json, const std::string& place) {
    if (json && json->is_object()) return json;
    fail(json ? fmt::format("{} is a {}, not an object", place, json->type_name()) : place + " is missing");
    return nullptr;
}

bool Reader::array(const Json* json, const std::string& place, std::size_t most) {
    if (!json)
        fail(place + " is missing");
    else if (!json->is_array())
        fail(fmt::format("{} is a {}, not a list", place, json->type_name()));
    else if (json->size() > most)
        fail(fmt::format("{} has {} entries; {} are the most that make sense", place, json->size(), most));
    return json && json->is_array() && json->size() <= most;
}

std::string Reader::text(const Json* json, const std::string& place) {
    if (json && json->is_string()) return json->get<std::string>();
    fail(json ? fmt::format("{} is a {}, not a string", place, json->type_name()) : place + " is missing");
    return {};
}

bool Reader::flag(const Json* json, const std::string& place) {
    if (json && json->is_boolean()) return json->get<bool>();
    fail(place + " is not true or false");
    return false;
}

double Reader::number(const Json* json, const std::string& place) {
    if (!json) {
        fail(place + " is missing");
    } else if (!json->is_number()) {
        fail(fmt::format("{} is a {}, not a number", place, json->type_name()));
    } else {
        const double value = json->get<double>();
        if (std::isfinite(value)) return value;
        fail(place + " is not a finite number");
    }
    return 0;
}

std::optional<double> Reader::optional_number(const Json* json, const std::string& place) {
    if (!json) return std::nullopt;
    return number(json, place);
}

double Reader::angle(const Json* json, const std::string& place) {
    const double value = number(json, place);
    if (std::abs(value) <= largest_angle) return value;
    fail(fmt::format("{} is {}, which makes no sense as an angle", place, value));
    return 0;
}

std::vector<double> Reader::numbers(const Json* json, const std::string& place, std::size_t most, bool angles) {
    std::vector<double> list;
    if (!array(json, place, most)) return list;
    for (std::size_t i = 0; i < json->size() && understood(); ++i)
        list.push_back(angles ? angle(&(*json)[i], place_in(place, i)) : number(&(*json)[i], place_in(place, i)));
    return list;
}

std::vector<Vector<double>> Reader::points(const Json* json, const std::string& place, std::size_t most) {
    std::vector<Vector<double>> list;
    if (!array(json, place, most)) return list;
    for (std::size_t i = 0; i < json->size() && understood(); ++i) {
        const auto pair = numbers(&(*json)[i], place_in(place, i), 2, false);
        if (pair.size() == 2)
            list.push_back({pair[0], pair[1]});
        else
            fail(place_in(place, i) + " is not a pair [x, y]");
    }
    return list;
}

}  // namespace mechwright::claims
