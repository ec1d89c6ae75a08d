#include "synthesis/mechanism/linkage/model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "synthesis/mechanism/input.h"

namespace mechwright {

LinkageModel over_unit(LinkageModel model, double unit) {
    for (std::size_t i = 0; i < model.numbers.size(); ++i)
        if (model.lengths[i]) model.numbers[i].constant /= unit;
    for (std::size_t i = 0; i < 2; ++i)
        model.placement[i].constant /= unit;
    model.unit *= unit;
    model.identity = std::make_shared<const char>();
    for (std::size_t i = 0; i < model.sketched.size(); ++i)
        if (model.sketched_lengths[i]) model.sketched[i] /= unit;
    for (linkage::Assembled& start : model.starts) {
        for (std::size_t g = 0; g < start.places.size(); ++g)
            for (std::size_t i = 0; i < start.places[g].size(); ++i)
                if (model.order.larger[g].unknowns[i].part != 2) start.places[g][i] /= unit;
    }
    return model;
}

Model linkage_over_unit(const Model& model, double unit) { return Model(over_unit(*model.as<LinkageModel>(), unit)); }

namespace {

template <class R>
linkage::DriveLawIn<R> law_in(const LinkageDrive& drive, bool master) {
    if (master) return {};
    linkage::DriveLawIn<R> law{R(drive.ratio), R(drive.phase)};
    if constexpr (std::is_same_v<R, double>)
        law.motion = drive.motion;
    else
        law.motion = drive.motion_again;
    if (law.motion) law.ratio = law.motion->net / (R(2) * pi<R>());
    return law;
}

/// The same for inputs of the analysis.
template <class R>
linkage::DriveLawIn<R> law_in_model(const LinkageModel& model, std::size_t drive) {
    linkage::DriveLawIn<R> law = law_in<R>(model.drives[drive], drive == 0);
    const R unit(model.structure.drives[drive].of_slide ? model.unit : 1);
    law.ratio *= R(model.input_length) / unit;
    law.phase /= unit;
    law.scale /= unit;
    return law;
}

template <class R>
std::vector<linkage::DriveLawIn<R>> laws_in_model(const LinkageModel& model) {
    std::vector<linkage::DriveLawIn<R>> laws;
    for (std::size_t i = 0; i < model.drives.size(); ++i)
        laws.push_back(law_in_model<R>(model, i));
    return laws;
}

}  // namespace

template <class R>
std::vector<linkage::DriveLawIn<R>> laws_in(std::span<const LinkageDrive> drives) {
    std::vector<linkage::DriveLawIn<R>> laws;
    for (const LinkageDrive& drive : drives)
        laws.push_back(law_in<R>(drive, laws.empty()));
    return laws;
}
template std::vector<linkage::DriveLawIn<double>> laws_in<double>(std::span<const LinkageDrive> drives);
template std::vector<linkage::DriveLawIn<Digits50>> laws_in<Digits50>(std::span<const LinkageDrive> drives);

linkage::DriveLaw law_of(const LinkageModel& model, std::size_t drive) { return law_in_model<double>(model, drive); }
std::vector<linkage::DriveLaw> laws_of(const LinkageModel& model) { return laws_in_model<double>(model); }
std::vector<linkage::DriveLawIn<Digits50>> laws_again_of(const LinkageModel& model) {
    return laws_in_model<Digits50>(model);
}

namespace {

Ways followed_ways(const LinkageModel& model, std::span<const double> dimensions, std::size_t assembly) {
    constexpr double farthest_turns = 8;  // of what never closes
    const auto laws = laws_of(model);
    const auto& sides = model.sides[assembly];
    const std::vector<double> numbers = numbers_of(model, dimensions);
    linkage::Assembled start = model.starts[assembly];
    if (!std::equal(dimensions.begin(), dimensions.end(), model.sketched.begin(), model.sketched.end())) {
        const std::vector<double> sketched = numbers_of(model, std::span<const double>(model.sketched));
        const auto moved = linkage::assembled_with(model.structure, model.order, sketched, numbers, sides, laws, start);
        if (!moved) return {};
        start = *moved;
    }
    constexpr double turn = 2 * std::numbers::pi;
    linkage::Reach reach{start.input - farthest_turns * turn, start.input + farthest_turns * turn, turn * model.turns,
                         1};
    if (model.driven_by_slide()) {
        const linkage::Driven<double> placed(model.structure, model.order, std::span<const double>(numbers), sides,
                                             laws);
        const linkage::Inputs inputs = inputs_of(model, dimensions, placed);
        reach = {std::min(inputs.from, start.input), std::max(inputs.to, start.input), 0, 1};
    }
    return linkage::follow_ways(model.structure, model.order, numbers, sides, laws, start, reach);
}

/// What was asked for last: tables, drawings and targets ask for the same ways at every input. It keeps the identity
/// alive, so that no other model can have it.
struct LastWays {
    std::shared_ptr<const char> of{};
    std::vector<double> dimensions{};
    std::size_t assembly = 0;
    Ways ways{};
};

}  // namespace

Ways ways_of(const LinkageModel& model, std::span<const double> dimensions, std::size_t assembly) {
    if (assembly >= model.starts.size() || !model.starts[assembly].exists()) return {};
    thread_local LastWays last;
    if (last.of != model.identity || last.assembly != assembly ||
        !std::equal(dimensions.begin(), dimensions.end(), last.dimensions.begin(), last.dimensions.end()))
        last = {model.identity,
                {dimensions.begin(), dimensions.end()},
                assembly,
                followed_ways(model, dimensions, assembly)};
    return last.ways;
}

linkage::Driven<double> driven(const LinkageModel& model, std::span<const double> dimensions, std::size_t assembly) {
    const std::vector<double> numbers = numbers_of(model, dimensions);
    linkage::Driven<double> made(model.structure, model.order, std::span<const double>(numbers), model.sides[assembly],
                                 laws_of(model));
    made.set_ways(ways_of(model, dimensions, assembly));
    return made;
}

linkage::Inputs inputs_of(const LinkageModel& model, std::span<const double> dimensions,
                          const linkage::Driven<double>& driven) {
    const std::vector<double> numbers = numbers_of(model, dimensions);
    // Steps say nothing of the lengths in larger groups.
    const double size = model.order.closed()
                            ? size_of(driven)
                            : std::max(size_of(driven), linkage::farthest_point(model.structure, numbers));
    linkage::Inputs inputs = linkage::inputs_of(model.structure, numbers, size, std::max(model.turns, 1));
    if (!model.driven_by_slide()) return inputs;
    inputs.from = model.input_of(inputs.from * model.unit);
    inputs.to = model.input_of(inputs.to * model.unit);
    return inputs;
}

std::optional<std::array<double, 2>> reach_of_input(const Mechanism& mechanism) {
    const LinkageModel* model = mechanism.model.as<LinkageModel>();
    return model == nullptr ? std::nullopt : model->reach;
}

LinkagePlacement placement_of(const LinkageModel& model, std::span<const double> dimensions) {
    const double tilt = model.placement[2].at(dimensions);
    return {{{model.placement[0].at(dimensions), model.placement[1].at(dimensions)}, {std::cos(tilt), std::sin(tilt)}},
            model.scale.at(dimensions)};
}

}  // namespace mechwright
