#include "synthesis/report/structure/centres.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "synthesis/mechanism/linkage/drawing/centres.h"
#include "synthesis/problem/linkage/of_kinds/expand.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

using CentreKind = linkage::InstantCentre::Kind;
using Json = nlohmann::ordered_json;

/// In (-90, 90] degrees: either sense of a direction at infinity is the same.
double direction_of(const Vector<double>& at) {
    const double angle = std::atan2(at.y, at.x), right = std::atan2(1, 0);
    return angle > right ? angle - 2 * right : angle <= -right ? angle + 2 * right : angle;
}

}  // namespace

bool is_of_links(const Mechanism& mechanism) {
    return mechanism.as_linkage || mechanism.model.as<LinkageModel>() != nullptr;
}

namespace {

/// A design of a built-in kind as the linkage that it is.
struct LinkageOfDesign {
    std::shared_ptr<const Mechanism> mechanism{};
    std::vector<double> dimensions{};

    LinkageOfDesign(const Mechanism& kind, std::span<const double> given, std::size_t assembly) {
        const ReadProblem read = parse_problem(linkage_of_design(kind, given, assembly), "");
        if (!read.ok()) return;
        mechanism = read.problem.mechanism;
        for (const DimensionRange& range : read.problem.dimensions)
            dimensions.push_back(range.min);
    }
};

}  // namespace

std::optional<std::vector<NamedCentre>> centres_of(const DesignOfLinks& design, double master) {
    if (design.mechanism->as_linkage) {
        const LinkageOfDesign linkage(*design.mechanism, design.dimensions, design.assembly);
        if (!linkage.mechanism) return {};
        return centres_of({linkage.mechanism, linkage.dimensions, 0}, master);
    }
    const LinkageModel& model = linkage_of(design.mechanism->model.data());
    const auto centres = centres_in_drawing(model, design.dimensions, design.assembly, master);
    if (!centres) return {};
    std::vector<NamedCentre> named;
    for (const linkage::InstantCentre& centre : *centres)
        named.push_back({model.links[centre.first], model.links[centre.second], centre});
    return named;
}

std::string centres_text(const std::vector<NamedCentre>& centres, double input, const Units& units) {
    Table table{{Align::left, Align::left}, {}};
    for (const auto& [first, second, centre] : centres)
        table.rows.push_back({first + ", " + second,
                              centre.kind == CentreKind::place
                                  ? fmt::format("({}, {})", number_text(centre.at.x), number_text(centre.at.y))
                              : centre.kind == CentreKind::at_infinity
                                  ? fmt::format("at infinity in the direction {} {}",
                                                number_text(in_file_unit(direction_of(centre.at), Unit::angle, units)),
                                                unit_label(Unit::angle, units))
                                  : "everywhere: they move alike"});
    return fmt::format("Instant centres at {}: {}\n{}", number_text(input), centres.size(), to_text(table, 2));
}

Json centres_json(const std::vector<NamedCentre>& centres, double input, const Units& units) {
    Json all = Json::array();
    for (const auto& [first, second, centre] : centres) {
        Json one{{"links", {first, second}}};
        if (centre.kind == CentreKind::place)
            one["at"] = {centre.at.x, centre.at.y};
        else if (centre.kind == CentreKind::at_infinity)
            one["direction"] = in_file_unit(direction_of(centre.at), Unit::angle, units);
        else
            one["everywhere"] = true;
        all.push_back(std::move(one));
    }
    return {{"crank", input}, {"instant-centres", std::move(all)}};
}

}  // namespace mechwright
