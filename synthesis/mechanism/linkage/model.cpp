#include "synthesis/mechanism/linkage/model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

std::vector<linkage::DriveLaw> laws_of(std::span<const LinkageDrive> drives) {
    std::vector<linkage::DriveLaw> laws;
    for (const LinkageDrive& drive : drives)
        laws.push_back(laws.empty() ? linkage::DriveLaw{} : linkage::DriveLaw{drive.ratio, drive.phase});
    return laws;
}

linkage::DriveLaw law_of(const LinkageModel& model, std::size_t drive) {
    const LinkageDrive& own = model.drives[drive];
    linkage::DriveLaw law = drive == 0 ? linkage::DriveLaw{} : linkage::DriveLaw{own.ratio, own.phase};
    const double unit = model.structure.drives[drive].of_slide ? model.unit : 1;
    law.ratio *= model.input_length / unit;
    law.phase /= unit;
    return law;
}

std::vector<linkage::DriveLaw> laws_of(const LinkageModel& model) {
    std::vector<linkage::DriveLaw> laws;
    for (std::size_t i = 0; i < model.drives.size(); ++i)
        laws.push_back(law_of(model, i));
    return laws;
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
    const linkage::Reach reach{start.input - farthest_turns * turn, start.input + farthest_turns * turn,
                               turn * model.turns, 1};
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
