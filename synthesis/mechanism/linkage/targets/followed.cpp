#include "synthesis/mechanism/linkage/targets/followed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "synthesis/mechanism/linkage/mechanism.h"
#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/mechanism/linkage/targets/found_places.h"
#include "synthesis/mechanism/linkage/targets/guidance.h"

namespace mechwright {

namespace {

using Kind = LinkageMeasure::Kind;

/// Of one of the targets over input ranges.
LinkageMeasure measure_of(Kind kind, std::size_t over_input) { return {kind, {}, {}, {}, 0, over_input}; }

/// The extremes of the distance over the input range, in order along it.
std::vector<ErrorExtreme> extremes_of_distance(Form form, std::span<const double> arguments) {
    const LinkageMeasure measure = measure_of(Kind::distance_greatest, form.over_input);
    Motion motion;
    motion.assembly = form.assembly;
    motion.model = form.model;
    motion.of = &measure;
    motion.full_turn = false;
    const measuring::Over sized(motion, true);
    const std::size_t own = sized.dimensions_of(arguments).size();
    const double start = arguments[own], range = arguments[own + 1];
    const LinkageModel& model = linkage_of(form.model);
    const double unit = model.unit_of_input(), input = model.input_per_argument();
    motion.from = unit * std::min(start, start + range);
    motion.to = unit * std::max(start, start + range);
    const measuring::Over over(motion, true);
    const auto dimensions = over.dimensions_of(arguments), shape = over.shape_of(arguments);
    const auto signals = measuring::own_signals(over.model, measure);
    auto plain = measuring::measured<double, 2>(over, arguments, signals);
    if (!measuring::closes_at_samples(over, dimensions)) return {};
    const measuring::Course course = measuring::course_of(over, dimensions, plain, signals);
    if (course.travel.from > course.travel.to) return {};
    const double radius = shape.size() == ArcShape::parameters ? shape.back() : 0;
    std::vector<ErrorExtreme> all;
    for (const linkage::Extreme& place :
         linkage::extremes(plain, {0, 0}, course, course.travel.from, course.travel.to)) {
        if (std::isnan(place.value)) return {};
        const double share = (place.at - input * start) / (input * range);
        all.push_back({share, share, place.value - radius, place.stationary});
    }
    if (range < 0) std::reverse(all.begin(), all.end());
    return all;
}

template <class Shape>
void fit_shape(Form form, std::span<const double> arguments, std::span<double> numbers,
               const std::array<bool, 3>& free) {
    const std::size_t own = arguments.size() - 2 - Shape::parameters;
    form.guided = linkage_of(form.model).over_input[form.over_input].of;
    StretchPoints points;
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = guided_point_of_linkage(
            form, arguments.first(own),
            arguments[own] + arguments[own + 1] * static_cast<double>(i) / static_cast<double>(points.size() - 1));
    std::array<bool, Shape::parameters> own_free;
    std::copy_n(free.begin(), own_free.size(), own_free.begin());
    std::array<double, Shape::parameters> fitted;
    std::copy_n(numbers.begin(), fitted.size(), fitted.begin());
    Shape::fit(points, own_free, fitted);
    std::copy(fitted.begin(), fitted.end(), numbers.begin());
}

template <class Shape>
FollowedShape shape_of_linkage(std::size_t over_input, std::size_t dimensions) {
    const ShapeTexts texts = Shape::texts();
    FollowedShape entry;
    entry.name = Shape::name;
    entry.numbers = Shape::numbers();
    const auto add = [&](const std::string& name, Unit unit, std::string meaning, Kind kind) {
        Quantity quantity = mechwright::over_input(
            linkage_quantity(name, unit, std::move(meaning), measure_of(kind, over_input), dimensions));
        quantity.defined = Shape::is_followed;
        quantity.measure_again = measure_linkage_again;
        quantity.section = std::string(Shape::name);
        quantity.of_motion = false;
        entry.quantities.push_back(std::move(quantity));
    };
    add(texts.deviation, Unit::length, "greatest distance of a stretch of the guided point's path from what it follows",
        Kind::distance_greatest);
    add(texts.extent, texts.unit_of_extent, texts.meaning_of_extent, Kind::extent);
    entry.extremes = extremes_of_distance;
    entry.fit = fit_shape<Shape>;
    return entry;
}

}  // namespace

FollowedShape linkage_shape(const LinkageModel& model, std::size_t over_input, std::size_t dimensions) {
    const LinkageInputTarget& target = model.over_input[over_input];
    FollowedShape made = target.followed == Followed::line ? shape_of_linkage<LineShape>(over_input, dimensions)
                                                           : shape_of_linkage<ArcShape>(over_input, dimensions);
    made.guided = target.of;
    return made;
}

}  // namespace mechwright
