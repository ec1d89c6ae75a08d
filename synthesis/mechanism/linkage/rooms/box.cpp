#include "synthesis/mechanism/linkage/rooms/box.h"

#include <vector>

#include "synthesis/mechanism/linkage/rooms/found_room.h"

namespace mechwright {

std::optional<Box> box_of(const Motion& motion, std::span<const double> dimensions, const LinkageRoom& room) {
    using namespace measuring;
    const LinkageMeasure measure{.kind = Kind::room_area};
    Motion of_room = motion;
    of_room.of = &measure;
    const Over over(of_room);
    if (!closes_at_samples(over, dimensions)) return {};
    const std::vector<Signal> signals = signals_of_room(room, measure.kind);
    auto plain = measured<double, 2>(over, dimensions, std::span<const Signal>(signals));
    const Course course = course_of(over, dimensions, plain, signals);
    if (needs_turns(over, signals) && (course.turns.empty() || course.turns.to() < course.travel.to)) return {};
    const Found found = found_of_room(over, plain, course, dimensions);
    if (!found.possible) return {};
    return Box{{found.minus.front().value(), found.plus.front().value()},
               {found.minus_across.front().value(), found.plus_across.front().value()}};
}

}  // namespace mechwright
