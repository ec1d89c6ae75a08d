#include "synthesis/mechanism/linkage/rooms/box.h"

#include <vector>

#include "synthesis/mechanism/linkage/rooms/found_room.h"
#include "synthesis/mechanism/linkage/rooms/turned_box.h"

namespace mechwright {

std::optional<Box> box_of(const Motion& motion, std::span<const double> dimensions, const LinkageRoom& room) {
    using namespace measuring;
    const bool turns = room.turn != LinkageRoom::Turn::given;
    const LinkageMeasure measure{.kind = turns ? Kind::turned_area : Kind::room_area};
    Motion of_room = motion;
    of_room.of = &measure;
    const Over over(of_room);
    if (!closes_at_samples(over, dimensions)) return {};
    const std::vector<Signal> signals = signals_of_room(room, measure.kind);
    auto plain = measured<double, 2>(over, dimensions, std::span<const Signal>(signals));
    const Course course = course_of(over, dimensions, plain, signals);
    if (needs_turns(over, signals) && (course.turns.empty() || course.turns.to() < course.travel.to)) return {};
    if (turns) {
        TurnedBoxSearch<2> search(over, room, plain, course, dimensions);
        const TurnedBox turned = search.found();
        if (!turned.possible) return {};
        const linkage::MovingEnds<double> ends;
        ContactsAlong<double, 2> along(plain, course, ends);
        const auto far = [&](std::size_t side) {
            return along.of(turned.contacts[side], turned.direction + turn_of_side(side)).out;
        };
        return Box{{-far(1), far(0)}, {-far(3), far(2)}, turned.direction};
    }
    const Found found = found_of_room(over, plain, course, dimensions);
    if (!found.possible) return {};
    return Box{{found.minus.front().value(), found.plus.front().value()},
               {found.minus_across.front().value(), found.plus_across.front().value()},
               room.direction};
}

}  // namespace mechwright
