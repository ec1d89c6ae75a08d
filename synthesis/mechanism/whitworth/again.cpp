#include "synthesis/mechanism/whitworth/again.h"

#include "synthesis/mechanism/quick_return/check_ram.h"
#include "synthesis/mechanism/quick_return/measure_ram_again.h"
#include "synthesis/mechanism/quick_return/ram_motion_again.h"

namespace mechwright::quick_return {

template struct again::RamAgain<again::WhitworthGeometry>;

std::vector<Way> whitworth_ways(bool full_turn) {
    Way way{{"the crank is longer than the centre distance", {"crank"}, {"centre-distance"}}};
    if (full_turn) way.push_back({"the arm turns past the rod", {"rod"}, {"arm"}});
    return {way};
}

}  // namespace mechwright::quick_return
