#include "synthesis/mechanism/drag_link/again.h"

#include "synthesis/mechanism/four_link_ways.h"
#include "synthesis/mechanism/quick_return/check_ram.h"
#include "synthesis/mechanism/quick_return/measure_ram_again.h"
#include "synthesis/mechanism/quick_return/ram_motion_again.h"
#include "synthesis/mechanism/quick_return/rod_reaches.h"

namespace mechwright::quick_return {

template struct again::RamAgain<again::DragLinkGeometry>;

std::vector<Way> drag_link_ways(bool full_turn) {
    if (!full_turn) return {four_links_close("follower")};
    Way way = crank_turns("crank", "ground", "follower");
    for (const AtLeast& condition : rod_reaches("arm", "slide-offset"))
        way.push_back(condition);
    return {way};
}

}  // namespace mechwright::quick_return
