#include "tests/verify/documents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/mechanism/mechanism.h"
#include "tests/degree.h"
#include "tests/long_form.h"

namespace mechwright::test {

namespace {

const Mechanism& four_bar() { return *find_mechanism("four-bar"); }

std::vector<double> dimensions_of(const Json& document) {
    std::vector<double> dimensions;
    for (const Dimension& d : four_bar().dimensions) {
        const double number = document["design"].value(std::string(d.name), 0.0);
        dimensions.push_back(d.kind == DimensionKind::angle ? number * degree : number);
    }
    return dimensions;
}

/// The value of a quantity in degrees or lengths, from the components that the optimisers use.
double value_of_quantity(const Quantity& quantity, const Motion& motion, const std::vector<double>& dimensions) {
    std::array<double, Quantity::most_components> components{};
    const std::size_t count = quantity.components(motion);
    Measurement out;
    out.value = components;
    measure(quantity, motion, dimensions, out);
    const auto end = components.begin() + static_cast<std::ptrdiff_t>(count);
    double value = components[0];
    if (quantity.reduce == Reduce::least) value = *std::min_element(components.begin(), end);
    if (quantity.reduce == Reduce::greatest) value = *std::max_element(components.begin(), end);
    return quantity.unit == Unit::angle ? value / degree : value;
}

}  // namespace

/// With t = tan(stroke/2) and v = tan((stroke - swing)/2) the square Q of coupler over crank is the root above 1 of
/// (1 + t^2) Q^3 + t^2 v^2 (Q^2 - 2 Q - t^2) = 0. Then crank^2 = sin^2(swing/2) / D and rocker^2 = (Q cos^2(stroke/2) +
/// sin^2(stroke/2)) / D with D = Q cos^2 k + sin^2 k, k = (stroke - swing)/2.
FourBar<double> classical_optimum(double stroke, double swing) {
    const double t = std::tan(stroke / 2), v = std::tan((stroke - swing) / 2);
    const auto cubic = [&](double q) { return (1 + t * t) * q * q * q + t * t * v * v * (q * q - 2 * q - t * t); };
    double low = 1, high = 1e3;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (cubic(middle) < 0 ? low : high) = middle;
    }
    const double q = low, k = (stroke - swing) / 2;
    const double d = q * std::pow(std::cos(k), 2) + std::pow(std::sin(k), 2);
    const double crank = std::sin(swing / 2) / std::sqrt(d);
    const double rocker = std::sqrt((q * std::pow(std::cos(stroke / 2), 2) + std::pow(std::sin(stroke / 2), 2)) / d);
    return {1, crank, std::sqrt(q) * crank, rocker};
}

Json document(const DocumentOf& parts) {
    Json json;
    json["schema"] = 1;
    json["problem"] = {{"file", "test.toml"}, {"mechanism", "four-bar"}};
    json["units"] = {{"angle", "deg"}, {"length", "mm"}};
    json["status"] = "solved";
    json["tolerance"] = 1e-9;
    json["dimensions"] = {{"ground", parts.links.ground},
                          {"crank", {{"min", parts.links.crank / 2}, {"max", parts.links.crank * 2}}},
                          {"coupler", {{"min", parts.links.coupler / 2}, {"max", parts.links.coupler * 2}}},
                          {"rocker", {{"min", parts.links.rocker / 2}, {"max", parts.links.rocker * 2}}}};
    if (!parts.crank_range.empty()) json["crank_range"] = parts.crank_range;
    Json& design = json["design"];
    design = {{"ground", parts.links.ground},
              {"crank", parts.links.crank},
              {"coupler", parts.links.coupler},
              {"rocker", parts.links.rocker}};
    for (std::size_t i = 0; i < parts.placement.size(); ++i) {
        const std::string name(four_bar().dimensions[4 + i].name);
        design[name] = parts.placement[i];
        json["dimensions"][name] = {{"min", parts.placement[i] - 1}, {"max", parts.placement[i] + 1}};
    }
    const auto dimensions = dimensions_of(json);
    design["assembly"] = parts.assembly;
    design["kind"] = four_bar().describe({}, dimensions);

    const std::array<double, 2> range = parts.crank_range.empty()
                                            ? std::array<double, 2>{}
                                            : std::array{parts.crank_range[0] * degree, parts.crank_range[1] * degree};
    const Motion motion = motion_of(four_bar(), dimensions, parts.assembly == "open" ? 0 : 1,
                                    parts.crank_range.empty() ? nullptr : range.data());
    const auto value = [&](const std::string& name) {
        const auto index = static_cast<std::size_t>(find_quantity(four_bar(), name));
        return value_of_quantity(four_bar().quantities[index], motion, dimensions);
    };
    if (!parts.maximized.empty())
        json["objective"] = {{"quantity", parts.maximized}, {"sense", "maximize"}, {"value", value(parts.maximized)}};
    for (const std::string& name : parts.required)
        json["requirements"].push_back(
            {{"quantity", name}, {"value", value(name)}, {"equal", value(name)}, {"violation", 0.0}, {"active", true}});
    for (const Quantity& q : four_bar().quantities)
        if (q.path == PathMeasure::none && q.defined(motion) && std::isfinite(value(std::string(q.name))))
            json["quantities"][std::string(q.name)] = value(std::string(q.name));
    return json;
}

void add_path(Json& document, const std::vector<double>& crank_angles, double miss, bool prescribed) {
    const auto dimensions = dimensions_of(document);
    const std::size_t assembly = document["design"]["assembly"] == "open" ? 0 : 1;
    Json path{{"points", Json::array()}, {"timing", prescribed ? "prescribed" : "free"}, {"closed", false}};
    Json reached = Json::array(), distances = Json::array(), due = Json::array();
    for (const double angle : crank_angles) {
        PathMiss there{};
        four_bar().point->miss(four_bar().form(assembly), dimensions, angle * degree, {0, 0}, there);
        const double x = -there.miss.x, y = -there.miss.y;
        path["points"].push_back({x + miss, y});
        reached.push_back({x, y});
        distances.push_back(std::abs((x + miss) - x));
        due.push_back(angle - document["design"].value("crank-start", 0.0));
    }
    if (prescribed) path["prescribed_angles"] = due;
    path["reached"] = reached;
    path["crank_angles"] = crank_angles;
    path["distances"] = distances;
    document["path"] = path;
}

std::vector<std::string> failures(const Json& document) {
    std::vector<std::string> names;
    for (const Check& c : verify(document))
        if (!c.passed) names.push_back(c.name);
    return names;
}

int verified_with_members_replaced(Json& document, Json& at) {
    static const std::vector<Json> others{Json(),        Json("1"),      Json(true),
                                          Json::array(), Json::object(), Json(-1),
                                          Json(0),       Json(1e308),    Json(18446744073709551615u),
                                          Json(-1e-320)};
    int replaced = 0;
    if (at.is_structured())
        for (auto& child : at)
            replaced += verified_with_members_replaced(document, child);
    const Json kept = at;
    static std::size_t turn = 0;
    for (int i = 0; i < cases_to_try(3, static_cast<int>(others.size())); ++i) {
        at = others[turn++ % others.size()];
        EXPECT_FALSE(verify(document).empty());
        ++replaced;
    }
    at = kept;
    return replaced;
}

int verified_with_members_replaced(Json& document) { return verified_with_members_replaced(document, document); }

std::string told(const std::vector<Check>& checks) {
    std::string text;
    for (const Check& c : checks)
        text += (c.passed ? "passed: " : "FAILED: ") + c.name + ": " + c.detail + "\n";
    return text;
}

}  // namespace mechwright::test
