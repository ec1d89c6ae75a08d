#include "synthesis/mechanism/slider_crank/again.h"

#include "synthesis/mechanism/quick_return/check_ram.h"
#include "synthesis/mechanism/quick_return/measure_ram_again.h"
#include "synthesis/mechanism/quick_return/ram_motion_again.h"
#include "synthesis/mechanism/quick_return/rod_reaches.h"

namespace mechwright::quick_return {

template struct again::RamAgain<again::SliderCrankGeometry>;

std::vector<Way> slider_crank_ways(bool full_turn) {
    if (full_turn) return {rod_reaches("crank", "offset")};
    const std::string_view why = "crank and rod together reach the slide line";
    return {{{why, {"rod", "crank"}, {"offset"}}, {why, {"rod", "crank", "offset"}, {}}}};
}

Vector<Digits50> rod_path_point(Form form, std::span<const Digits50> dimensions, const Digits50& crank_angle) {
    const again::Rebuilt<again::SliderCrankGeometry> m(form.assembly, dimensions);
    const auto s = m.at(crank_angle);
    if (!(s.right.c[0] >= 0 && s.left.c[0] >= 0))
        return {std::numeric_limits<Digits50>::quiet_NaN(), std::numeric_limits<Digits50>::quiet_NaN()};
    const Vector<Digits50> along{s.run.c[0] / m.rod.rod, s.height.c[0] / m.rod.rod};
    const Vector<Digits50> pin{dimensions[0] * cos(crank_angle), dimensions[0] * sin(crank_angle)};
    const Vector<Digits50> local = pin + turned(Vector<Digits50>{dimensions[3], dimensions[4]}, along);
    return Vector<Digits50>{dimensions[5], dimensions[6]} +
           turned(local, Vector<Digits50>{cos(dimensions[7]), sin(dimensions[7])});
}

}  // namespace mechwright::quick_return
