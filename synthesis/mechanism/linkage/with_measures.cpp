#include "synthesis/mechanism/linkage/with_measures.h"

#include <utility>

#include "synthesis/mechanism/linkage/drawing/drawn_rooms.h"
#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/mechanism/linkage/rooms/room_quantities.h"

namespace mechwright {

namespace {

/// How many dimensions are its own: those that targets bring follow them.
std::size_t own_dimensions(const Mechanism& kind) {
    return kind.plain ? kind.plain->dimensions.size() : kind.dimensions.size();
}

/// Where ends of the motion follow from the design, it is not measured before these are known.
bool is_of_known_motion(const Motion& motion) { return motion.full_turn || motion.from <= motion.to; }

/// A quantity as it is over an input range.
Quantity over_range_of(const InputRange& input, const Quantity& quantity) {
    Quantity moving = over_input(quantity);
    if (input.start != no_dimension) moving.reads = moving.reads.and_then(input.start, 2);
    return moving;
}

/// What is measured, and the sections that say it.
struct Measures {
    Model model;
    std::vector<Quantity> quantities;
    std::string sections;
};

Mechanism with_model(const Mechanism& kind, const Measures& measures) {
    Mechanism made = kind;
    const LinkageModel& linkage = linkage_of(measures.model.data());
    for (Quantity quantity : measures.quantities) {
        if (made.input) made.input->quantities.push_back(over_range_of(*made.input, quantity));
        quantity.defined = is_of_known_motion;
        made.quantities.push_back(std::move(quantity));
    }
    made.model = measures.model;
    if (!linkage.regions.empty()) made.model_over = linkage_over_unit;
    if (made.drawing) made.drawing->rooms = draw_rooms;
    made.made_from = measures.sections;
    return made;
}

}  // namespace

std::shared_ptr<const Mechanism> with_measures(const std::shared_ptr<const Mechanism>& kind, LinkageModel model,
                                               std::size_t own_signals, std::span<const NamedMeasure> asked,
                                               std::string sections) {
    const std::size_t dimensions = own_dimensions(*kind);
    std::vector<Quantity> quantities = quantities_of_rooms(model, dimensions);
    for (Quantity& quantity : quantities_of_signals(model, dimensions, own_signals, asked))
        quantities.push_back(std::move(quantity));
    const Measures measures{Model(std::move(model)), std::move(quantities), std::move(sections)};
    Mechanism made = with_model(*kind, measures);
    if (kind->whole) made.whole = std::make_shared<const Mechanism>(with_model(*kind->whole, measures));
    return std::make_shared<const Mechanism>(std::move(made));
}

}  // namespace mechwright
