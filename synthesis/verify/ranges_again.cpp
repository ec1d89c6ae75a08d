#include "synthesis/verify/ranges_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace mechwright {

namespace {

/// Of dimensions by name: the sum of those in `plus` is at least that of those in `minus`.
struct AtLeast {
    std::string_view why;
    std::vector<std::string_view> plus;
    std::vector<std::string_view> minus;
};

/// All conditions of one way in which a mechanism can be put together.
using Way = std::vector<AtLeast>;

/// The loop of four links closes somewhere: none is longer than the other three together.
Way four_links_close(std::string_view output) {
    const std::vector<std::string_view> links{"ground", "crank", "coupler", output};
    Way way;
    for (const std::string_view longest : links) {
        std::vector<std::string_view> others;
        std::copy_if(links.begin(), links.end(), std::back_inserter(others),
                     [&](std::string_view link) { return link != longest; });
        way.push_back({"no link is longer than the other three together", others, {longest}});
    }
    return way;
}

/// The crank passes both places on the line of ground: there the pin is ground + crank and |ground - crank| away from
/// the rocker's pivot, and both have to lie between the difference and the sum of coupler and rocker.
Way crank_turns(std::string_view longer, std::string_view shorter, std::string_view output) {
    const std::string_view near = "the crank passes the near side of the ground";
    return {{near, {longer, output}, {shorter, "coupler"}},
            {near, {longer, "coupler"}, {shorter, output}},
            {"the crank passes the far side of the ground", {"coupler", output}, {longer, shorter}}};
}

/// Both sides on which a pin that goes round stands farthest from the slide line.
Way rod_reaches(std::string_view arm, std::string_view offset) {
    const std::string_view why = "the rod reaches the slide line from the pin where it is farthest away";
    return {{why, {"rod", offset}, {arm}}, {why, {"rod"}, {arm, offset}}};
}

/// Every way in which a mechanism of the registry can move; none where nothing is known here.
std::vector<Way> ways_of(std::string_view mechanism, bool full_turn) {
    if (mechanism == "four-bar") {
        if (!full_turn) return {four_links_close("rocker")};
        return {crank_turns("ground", "crank", "rocker"), crank_turns("crank", "ground", "rocker")};
    }
    if (mechanism == "slider-crank") {
        if (full_turn) return {rod_reaches("crank", "offset")};
        const std::string_view why = "crank and rod together reach the slide line";
        return {{{why, {"rod", "crank"}, {"offset"}}, {why, {"rod", "crank", "offset"}, {}}}};
    }
    if (mechanism == "crank-shaper") {
        Way way{{"the crank is shorter than the centre distance", {"centre-distance"}, {"crank"}}};
        if (full_turn)
            way.push_back({"the rod reaches the ram line from the upright lever", {"rod", "ram-distance"}, {"lever"}});
        return {way};
    }
    if (mechanism == "whitworth") {
        Way way{{"the crank is longer than the centre distance", {"crank"}, {"centre-distance"}}};
        if (full_turn) way.push_back({"the arm turns past the rod", {"rod"}, {"arm"}});
        return {way};
    }
    if (mechanism == "drag-link") {
        if (!full_turn) return {four_links_close("follower")};
        Way way = crank_turns("crank", "ground", "follower");
        for (const AtLeast& condition : rod_reaches("arm", "slide-offset"))
            way.push_back(condition);
        return {way};
    }
    return {};
}

/// Whether only a crank that turns fully can be the answer: the path closes, a line or an arc is followed by one that
/// turns, or a quantity is named that nothing else has.
bool has_to_turn(const ProofContext& c) {
    const Claim& claim = *c.design.claim;
    if (claim.path && claim.path->closed) return true;
    if (claim.followed && claim.followed->full_turn) return true;
    if (claim.crank_range || claim.path || claim.function || claim.followed) return false;
    const auto& families = claim.mechanism->families;
    const auto limited = std::find_if(families.begin(), families.end(), [](const Family& f) { return !f.full_turn; });
    if (limited == families.end()) return true;
    Motion motion = c.design.motion;
    motion.family = static_cast<std::size_t>(limited - families.begin());
    motion.full_turn = false;
    motion.from = 0;
    motion.to = 1;
    const auto lacks = [&](std::size_t quantity) {
        const Quantity& q = claim.mechanism->quantities[quantity];
        return q.path == PathMeasure::none && !q.defined(motion);
    };
    return std::any_of(claim.requirements.begin(), claim.requirements.end(),
                       [&](const ClaimedRequirement& r) { return lacks(r.quantity); }) ||
           (claim.objective && std::any_of(claim.objective->terms.begin(), claim.objective->terms.end(),
                                           [&](const ClaimedTerm& t) { return lacks(t.quantity); }));
}

/// The greatest value of what a condition needs to be at least 0, over the ranges; tied dimensions move together.
Digits50 greatest(const ProofContext& c, const AtLeast& condition) {
    const Claim& claim = *c.design.claim;
    std::vector<Digits50> coefficient(claim.design.size(), Digits50(0));
    const auto add = [&](std::string_view name, int sign) {
        const auto i = static_cast<std::size_t>(find_dimension(*claim.mechanism, name));
        const auto& given = claim.given[i];
        if (given && given->tie.times != 0)
            coefficient[given->tie.of] += sign * Digits50(given->tie.times);
        else
            coefficient[i] += sign;
    };
    for (const std::string_view name : condition.plus)
        add(name, 1);
    for (const std::string_view name : condition.minus)
        add(name, -1);
    Digits50 sum = 0;
    for (std::size_t i = 0; i < coefficient.size(); ++i) {
        if (coefficient[i] == 0) continue;
        const DigitsRange range = range_again(c, i, Strictness::loosened);
        sum += coefficient[i] * (coefficient[i] > 0 ? range.greatest : range.least);
    }
    return sum;
}

}  // namespace

Finding check_ranges_again(const ProofContext& c) {
    if (!c.infeasible) return fails("it says nothing of the best design");
    const std::vector<Way> ways = ways_of(c.problem.mechanism->name, has_to_turn(c));
    if (ways.empty()) return fails("ranges exclude no mechanism of this kind");
    std::string why;
    for (const Way& way : ways) {
        const auto missed =
            std::find_if(way.begin(), way.end(), [&](const AtLeast& condition) { return greatest(c, condition) < 0; });
        if (missed == way.end())
            return fails("there are dimensions in the ranges that meet the conditions of a motion");
        if (why.find(missed->why) == std::string::npos) why += (why.empty() ? "" : "; ") + std::string(missed->why);
    }
    return holds("within the ranges it cannot be that " + why);
}

}  // namespace mechwright
