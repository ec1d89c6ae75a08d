#include "synthesis/mechanism/linkage/model.h"

#include <cmath>

namespace mechwright {

PlacedLinkage::PlacedLinkage(const LinkageModel& model, std::span<const double> dimensions, std::size_t assembly)
    : model_(model),
      numbers_(numbers_of(model, dimensions)),
      sizes_(linkage::sizes_of(model.structure, model.order, std::span<const double>(numbers_))),
      sides_(model.sides[assembly]),
      inputs_(model.drives.size()),
      pose_(linkage::empty_pose<double>(model.structure, model.order)) {}

bool PlacedLinkage::place(double master) {
    set_inputs(model_, master, std::span(inputs_));
    return linkage::place<double>(model_.order, sizes_, {inputs_, sides_}, pose_);
}

LinkagePlacement placement_of(const LinkageModel& model, std::span<const double> dimensions) {
    const double tilt = model.placement[2].at(dimensions);
    return {{{model.placement[0].at(dimensions), model.placement[1].at(dimensions)}, {std::cos(tilt), std::sin(tilt)}},
            model.scale.at(dimensions)};
}

}  // namespace mechwright
