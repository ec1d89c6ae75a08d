#include "synthesis/mechanism/linkage/model.h"

#include <cmath>

namespace mechwright {

LinkageModel over_unit(LinkageModel model, double unit) {
    for (std::size_t i = 0; i < model.numbers.size(); ++i)
        if (model.lengths[i]) model.numbers[i].constant /= unit;
    for (std::size_t i = 0; i < 2; ++i)
        model.placement[i].constant /= unit;
    return model;
}

std::vector<linkage::DriveLaw> laws_of(std::span<const LinkageDrive> drives) {
    std::vector<linkage::DriveLaw> laws;
    for (const LinkageDrive& drive : drives)
        laws.push_back(laws.empty() ? linkage::DriveLaw{} : linkage::DriveLaw{drive.ratio, drive.phase});
    return laws;
}

linkage::Driven<double> driven(const LinkageModel& model, std::span<const double> dimensions, std::size_t assembly) {
    const std::vector<double> numbers = numbers_of(model, dimensions);
    return {model.structure, model.order, std::span<const double>(numbers), model.sides[assembly],
            laws_of(model.drives)};
}

LinkagePlacement placement_of(const LinkageModel& model, std::span<const double> dimensions) {
    const double tilt = model.placement[2].at(dimensions);
    return {{{model.placement[0].at(dimensions), model.placement[1].at(dimensions)}, {std::cos(tilt), std::sin(tilt)}},
            model.scale.at(dimensions)};
}

}  // namespace mechwright
