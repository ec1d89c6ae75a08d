#include "synthesis/mechanism/linkage/model.h"

#include <algorithm>
#include <cmath>

namespace mechwright {

LinkageModel over_unit(LinkageModel model, double unit) {
    for (std::size_t i = 0; i < model.numbers.size(); ++i)
        if (model.lengths[i]) model.numbers[i].constant /= unit;
    for (std::size_t i = 0; i < 2; ++i)
        model.placement[i].constant /= unit;
    model.unit *= unit;
    return model;
}

std::vector<linkage::DriveLaw> laws_of(std::span<const LinkageDrive> drives) {
    std::vector<linkage::DriveLaw> laws;
    for (const LinkageDrive& drive : drives)
        laws.push_back(laws.empty() ? linkage::DriveLaw{} : linkage::DriveLaw{drive.ratio, drive.phase});
    return laws;
}

std::vector<linkage::DriveLaw> laws_of(const LinkageModel& model) {
    std::vector<linkage::DriveLaw> laws = laws_of(model.drives);
    for (std::size_t i = 0; i < laws.size(); ++i) {
        const double unit = model.structure.drives[i].of_slide ? model.unit : 1;
        laws[i].ratio *= model.input_length / unit;
        laws[i].phase /= unit;
    }
    return laws;
}

linkage::Driven<double> driven(const LinkageModel& model, std::span<const double> dimensions, std::size_t assembly) {
    const std::vector<double> numbers = numbers_of(model, dimensions);
    return {model.structure, model.order, std::span<const double>(numbers), model.sides[assembly], laws_of(model)};
}

linkage::Inputs inputs_of(const LinkageModel& model, std::span<const double> dimensions,
                          const linkage::Driven<double>& driven) {
    linkage::Inputs inputs =
        linkage::inputs_of(model.structure, numbers_of(model, dimensions), size_of(driven), std::max(model.turns, 1));
    if (!model.driven_by_slide()) return inputs;
    inputs.from = model.input_of(inputs.from * model.unit);
    inputs.to = model.input_of(inputs.to * model.unit);
    return inputs;
}

LinkagePlacement placement_of(const LinkageModel& model, std::span<const double> dimensions) {
    const double tilt = model.placement[2].at(dimensions);
    return {{{model.placement[0].at(dimensions), model.placement[1].at(dimensions)}, {std::cos(tilt), std::sin(tilt)}},
            model.scale.at(dimensions)};
}

}  // namespace mechwright
