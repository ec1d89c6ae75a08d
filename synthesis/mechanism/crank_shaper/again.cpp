#include "synthesis/mechanism/crank_shaper/again.h"

#include "synthesis/mechanism/quick_return/check_ram.h"
#include "synthesis/mechanism/quick_return/measure_ram_again.h"
#include "synthesis/mechanism/quick_return/ram_motion_again.h"

namespace mechwright::quick_return {

template struct again::RamAgain<again::CrankShaperGeometry>;

std::vector<Way> crank_shaper_ways(bool full_turn) {
    Way way{{"the crank is shorter than the centre distance", {"centre-distance"}, {"crank"}}};
    if (full_turn)
        way.push_back({"the rod reaches the ram line from the upright lever", {"rod", "ram-distance"}, {"lever"}});
    return {way};
}

}  // namespace mechwright::quick_return
