#include "synthesis/problem/linkage/model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace mechwright {

namespace {

/// Numbers of a file in the program's units, as sums of the mechanism's dimensions.
class Conversion {
public:
    explicit Conversion(const Linkage& linkage) : linkage_(linkage), index_of_(linkage.dimensions.size(), 0) {
        for (std::size_t i = 0; i < linkage.dimensions.size(); ++i)
            if (!linkage.dimensions[i].tied) index_of_[i] = count_++;
    }
    double value(double in_file, Measure measure) const {
        return measure == Measure::angle && linkage_.units.degrees ? in_file * std::numbers::pi / 180 : in_file;
    }
    Affine sum(const Affine& in_file, Measure measure) const {
        Affine made{value(in_file.constant, measure), {}};
        for (const auto& [dimension, factor] : in_file.terms)
            made.terms.emplace_back(index_of_[dimension], factor);
        return made;
    }
    DimensionRange range(const LinkageDimension& d) const {
        DimensionRange range{value(d.min, d.measure), value(d.max, d.measure), {}, true, {}};
        if (d.start) range.start = value(*d.start, d.measure);
        for (const double choice : d.choices)
            range.choices.push_back(value(choice, d.measure));
        range.step = value(d.step, d.measure);
        return range;
    }
    std::size_t count() const { return count_; }

private:
    const Linkage& linkage_;
    std::vector<std::size_t> index_of_;
    std::size_t count_ = 0;
};

DimensionKind kind_of(Measure measure) {
    return measure == Measure::angle   ? DimensionKind::angle
           : measure == Measure::ratio ? DimensionKind::number
                                       : DimensionKind::coordinate;
}

/// What can only be positive is a length.
DimensionKind kind_of(const LinkageDimension& d) {
    const bool positive = d.min >= 0 && d.max > 0;
    return d.measure == Measure::length && positive ? DimensionKind::length : kind_of(d.measure);
}

constexpr std::array<Measure, 4> anchored{Measure::length, Measure::length, Measure::angle, Measure::ratio};
constexpr std::array<std::string_view, 4> meanings{"frame's origin in the drawing", "frame's origin in the drawing",
                                                   "direction of the frame's x axis in the drawing",
                                                   "by which every length is multiplied"};

/// Whether a number of the placement is a dimension of its own.
bool is_own(const Linkage& linkage, std::size_t anchor) {
    return !linkage.placement[anchor].sum && (anchor < 3 || linkage.scaled);
}

}  // namespace

std::vector<Dimension> dimensions_of(const Linkage& linkage) {
    std::vector<Dimension> dimensions;
    for (const LinkageDimension& d : linkage.dimensions)
        if (!d.tied)
            dimensions.push_back(
                {d.name, kind_of(d), true, fmt::format("{} of the links", name_of(d.measure).substr(2))});
    for (std::size_t i = 0; i < linkage.placement.size(); ++i)
        if (is_own(linkage, i))
            dimensions.push_back(
                {linkage.placement[i].range.name, kind_of(anchored[i]), i == 3, std::string(meanings[i])});
    return dimensions;
}

std::vector<DimensionRange> ranges_of(const Linkage& linkage) {
    const Conversion convert(linkage);
    std::vector<DimensionRange> ranges;
    for (const LinkageDimension& d : linkage.dimensions)
        if (!d.tied) ranges.push_back(convert.range(d));
    for (std::size_t i = 0; i < linkage.placement.size(); ++i) {
        if (!is_own(linkage, i)) continue;
        LinkageDimension own = linkage.placement[i].range;
        own.measure = anchored[i];
        ranges.push_back(convert.range(own));
        ranges.back().named = i == 3 || own.min != 0 || own.max != 0;
    }
    return ranges;
}

std::size_t margin_at(const Linkage& linkage, std::size_t pin) {
    for (const linkage::Group& group : linkage.order.groups)
        if (group.pin == pin) return linkage::margin_of(linkage.order, group);
    return linkage::none;
}

LinkageModel model_of(const Linkage& linkage) {
    const Conversion convert(linkage);
    LinkageModel model;
    model.links = linkage.links;
    model.pins = linkage.pins;
    model.slides = linkage.slides;
    model.structure = linkage.structure;
    model.order = linkage.order;
    model.redundant = linkage.redundant;
    for (const LinkageNumber& number : linkage.numbers) {
        model.numbers.push_back(convert.sum(number.value, number.measure));
        model.lengths.push_back(number.measure == Measure::length);
    }
    model.drives = linkage.drives;
    if (model.driven_by_slide()) {
        const std::vector<double> numbers = numbers_of(linkage, usual_dimensions(linkage));
        double size = linkage::farthest_point(model.structure, numbers);
        // Inputs that stops or a range allow are of order one, however far these are.
        const linkage::Stops& stops = model.structure.drives.front().stops;
        for (const auto& stop : {stops.min, stops.max})
            if (stop) size = std::max(size, std::abs(numbers[*stop]));
        if (linkage.crank_range)
            size = std::max({size, std::abs(linkage.crank_range->x), std::abs(linkage.crank_range->y)});
        if (size > 0) model.input_length = std::exp2(std::round(std::log2(size)));
    }
    model.guided = linkage.guided;
    model.over_input = linkage.over_input;
    model.rooms = linkage.rooms;
    model.regions = linkage.regions;
    model.at = linkage.at;
    for (const LinkageSignal& signal : linkage.signals) {
        model.signal_names.push_back({signal.name, signal.unit});
        model.signals.push_back(signal.value);
        if (signal.value.kind == linkage::Signal::Kind::transmission_angle)
            model.signals.back().of = margin_at(linkage, signal.value.of);
    }
    std::size_t own = convert.count();
    const auto anchor = [&](std::size_t i) {
        if (is_own(linkage, i)) return Affine{0, {{own++, 1}}};
        const LinkageAnchor& one = linkage.placement[i];
        return one.sum ? convert.sum(*one.sum, anchored[i]) : Affine{one.range.min, {}};
    };
    for (std::size_t i = 0; i < 3; ++i)
        model.placement[i] = anchor(i);
    model.scale = anchor(3);
    return model;
}

}  // namespace mechwright
