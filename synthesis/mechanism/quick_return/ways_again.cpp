#include "synthesis/mechanism/four_link_ways.h"
#include "synthesis/mechanism/quick_return/again.h"

namespace mechwright::quick_return {

namespace {

/// Both sides on which a pin that goes round stands farthest from the slide line.
Way rod_reaches(std::string_view arm, std::string_view offset) {
    const std::string_view why = "the rod reaches the slide line from the pin where it is farthest away";
    return {{why, {"rod", offset}, {arm}}, {why, {"rod"}, {arm, offset}}};
}

}  // namespace

std::vector<Way> slider_crank_ways(bool full_turn) {
    if (full_turn) return {rod_reaches("crank", "offset")};
    const std::string_view why = "crank and rod together reach the slide line";
    return {{{why, {"rod", "crank"}, {"offset"}}, {why, {"rod", "crank", "offset"}, {}}}};
}

std::vector<Way> crank_shaper_ways(bool full_turn) {
    Way way{{"the crank is shorter than the centre distance", {"centre-distance"}, {"crank"}}};
    if (full_turn)
        way.push_back({"the rod reaches the ram line from the upright lever", {"rod", "ram-distance"}, {"lever"}});
    return {way};
}

std::vector<Way> whitworth_ways(bool full_turn) {
    Way way{{"the crank is longer than the centre distance", {"crank"}, {"centre-distance"}}};
    if (full_turn) way.push_back({"the arm turns past the rod", {"rod"}, {"arm"}});
    return {way};
}

std::vector<Way> drag_link_ways(bool full_turn) {
    if (!full_turn) return {four_links_close("follower")};
    Way way = crank_turns("crank", "ground", "follower");
    for (const AtLeast& condition : rod_reaches("arm", "slide-offset"))
        way.push_back(condition);
    return {way};
}

}  // namespace mechwright::quick_return
