#include "synthesis/mechanism/linkage/again/rooms_again.h"

#include <cmath>

#include "synthesis/mechanism/linkage/again/least_of_several.h"
#include "synthesis/mechanism/linkage/again/regions_again.h"
#include "synthesis/mechanism/linkage/again/self_distance.h"
#include "synthesis/mechanism/linkage/again/swept_again.h"
#include "synthesis/mechanism/linkage/again/turned_direction.h"

namespace mechwright::again {

namespace {

using Kind = LinkageMeasure::Kind;

/// How far the farthest pins of a room are apart along its width or its height, all over the motion.
Digits50 side_of(const Scan& scan, const LinkageRoom& room, bool across) {
    const auto farthest = [&](int sign) {
        return least_of_several(scan, room.pins.size(),
                                [&room, across, sign]<class T>(std::size_t k, const PoseSignals<T>& pose) {
                                    using std::cos, std::sin;
                                    Vector<T> way{T(cos(T(room.direction))), T(sin(T(room.direction)))};
                                    if (across) way = left_of(way);
                                    return T(T(sign) * dot(pose.in_drawing(room.pins[k]), way));
                                });
    };
    return -(farthest(1) + farthest(-1));
}

}  // namespace

bool is_of_place(const LinkageMeasure& measure) {
    return measure.kind == Kind::room_width || measure.kind == Kind::room_height || measure.kind == Kind::room_area ||
           measure.kind == Kind::turned_width || measure.kind == Kind::turned_area ||
           measure.kind == Kind::self_distance || measure.kind == Kind::swept_area || measure.kind == Kind::uncovered ||
           measure.kind == Kind::region_margin;
}

Digits50 of_place(const Scan& scan, const LinkageMeasure& measure) {
    if (measure.kind == Kind::region_margin) return margin_of_region(scan, scan.model.regions[measure.of_room]);
    LinkageRoom room = scan.model.rooms[measure.of_room];
    if (measure.kind == Kind::self_distance) return self_distance(scan, room.pins.front());
    if (measure.kind == Kind::swept_area) return swept_area(scan, room, {});
    if (measure.kind == Kind::uncovered) return uncovered(scan, room);
    if (room.turn != LinkageRoom::Turn::given) room.direction = turned_direction(scan, room);
    if (measure.kind == Kind::room_width || measure.kind == Kind::turned_width) return side_of(scan, room, false);
    if (measure.kind == Kind::room_height) return side_of(scan, room, true);
    return side_of(scan, room, false) * side_of(scan, room, true);
}

}  // namespace mechwright::again
