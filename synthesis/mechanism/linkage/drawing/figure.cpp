#include "synthesis/mechanism/linkage/drawing/figure.h"

#include <algorithm>
#include <cmath>

#include "synthesis/mechanism/linkage/model.h"

namespace mechwright {

namespace {

using namespace figure;

/// The panel while its places and dimensions are put in.
struct LinkageFigure {
    FigurePanel panel;
    const LinkageModel& model;
    LinkagePlacement placement;

    /// A place of a link: where it has a name already, or a hidden one.
    std::string add_place(std::size_t link, const Vector<double>& own, std::string name, bool shown) {
        FigurePlace place = link == 0 ? fixed(std::move(name), placement.in_drawing(own))
                                      : fixed(std::move(name), placement.scale * own, model.links[link]);
        place.is_shown = shown;
        panel.places.push_back(std::move(place));
        return panel.places.back().name;
    }

    /// The dimension that a number of the structure is; null where it is a constant, a sum or a multiple.
    const Dimension* dimension_of(linkage::Number number) const {
        const Affine& sum = model.numbers[number];
        if (sum.constant != 0 || sum.terms.size() != 1 || sum.terms[0].second != 1) return nullptr;
        return &panel.design.mechanism->dimensions[sum.terms[0].first];
    }
    bool is_new(const Dimension* dimension) const {
        return dimension != nullptr && panel.design[dimension->name] != 0 &&
               std::none_of(panel.dimensions.begin(), panel.dimensions.end(),
                            [&](const FigureDimension& d) { return d.name == dimension->name; });
    }

    void add_coordinate(const Dimension& dimension, const std::string& origin, const std::string& point,
                        const FigureSide& along, double away) {
        const bool length = dimension.kind == DimensionKind::length;
        panel.dimensions.push_back(by(point, length ? length_along(dimension.name, origin, point, along, away)
                                                    : coordinate(dimension.name, origin, point, along, away)));
    }

    void add_point(std::size_t link, const std::string& point, const linkage::Coordinates& at,
                   const Vector<double>& own) {
        const Dimension *first = dimension_of(at.first), *second = dimension_of(at.second);
        if (!is_new(first) && !is_new(second)) return;
        constexpr double beside = 20;
        const std::string hidden = model.links[link] + " " + point;
        const std::string origin = add_place(link, {0, 0}, "origin of " + hidden, false);
        const std::string ahead = add_place(link, {1, 0}, "axis of " + hidden, false);
        const FigureSide x = side(origin, ahead), y = side(origin, ahead, 90);
        if (at.polar) {
            if (is_new(first)) add_coordinate(*first, origin, point, side(origin, point), beside);
            if (is_new(second)) panel.dimensions.push_back(angle(second->name, origin, x, side(origin, point), 40));
            return;
        }
        if (is_new(first)) add_coordinate(*first, origin, point, x, own.y < 0 ? -beside : beside);
        if (is_new(second)) add_coordinate(*second, origin, point, y, own.x > 0 ? -beside : beside);
    }
};

/// The dimensions that are drawn nowhere, in a sentence.
std::string remark_on(const FigurePanel& panel) {
    std::string names;
    for (const Dimension& dimension : panel.design.mechanism->dimensions) {
        const bool drawn = std::any_of(panel.dimensions.begin(), panel.dimensions.end(),
                                       [&](const FigureDimension& d) { return d.name == dimension.name; });
        if (!drawn && !dimension.name.empty()) names += (names.empty() ? "" : ", ") + dimension.name;
    }
    return names.empty() ? "" : "Not drawn, as they are 0, or of joints, sums or targets: " + names + ".";
}

}  // namespace

FigurePanel linkage_panel(const MovingDesign& design) {
    const LinkageModel& model = linkage_of(design.motion.model);
    const Motion& motion = design.motion;
    LinkageFigure made{{.title = "The links, their points and dimensions",
                        .design = design,
                        .input = model.at.value_or(motion.from + 0.125 * (motion.to - motion.from))},
                       model,
                       placement_of(model, design.dimensions)};
    const std::vector<double> numbers = numbers_of(model, std::span<const double>(design.dimensions));
    for (std::size_t i = 0; i < model.pins.size(); ++i)
        for (const linkage::Point& point : model.structure.pins[i].points) {
            const Vector<double> own = linkage::place_of(point.at, std::span<const double>(numbers));
            const bool first = &point == &model.structure.pins[i].points.front();
            const std::string name = first ? model.pins[i] : model.pins[i] + " on " + model.links[point.link];
            made.add_point(point.link, made.add_place(point.link, own, name, first), point.at, own);
        }
    made.panel.remark = remark_on(made.panel);
    return made.panel;
}

}  // namespace mechwright
