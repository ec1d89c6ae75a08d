#include "synthesis/mechanism/linkage/rooms/with_rooms.h"

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

Mechanism with_model(const Mechanism& kind, const Model& model, const std::string& sections) {
    Mechanism made = kind;
    const LinkageModel& linkage = linkage_of(model.data());
    for (Quantity& quantity : quantities_of_rooms(linkage, own_dimensions(kind))) {
        if (made.input) made.input->quantities.push_back(over_range_of(*made.input, quantity));
        quantity.defined = is_of_known_motion;
        made.quantities.push_back(std::move(quantity));
    }
    made.model = model;
    if (!linkage.regions.empty()) made.model_over = linkage_over_unit;
    if (made.drawing) made.drawing->rooms = draw_rooms;
    made.made_from = sections;
    return made;
}

}  // namespace

std::shared_ptr<const Mechanism> with_rooms(const std::shared_ptr<const Mechanism>& kind, LinkageModel model,
                                            const std::string& sections) {
    const Model shared(std::move(model));
    Mechanism made = with_model(*kind, shared, sections);
    if (kind->whole) made.whole = std::make_shared<const Mechanism>(with_model(*kind->whole, shared, sections));
    return std::make_shared<const Mechanism>(std::move(made));
}

}  // namespace mechwright
