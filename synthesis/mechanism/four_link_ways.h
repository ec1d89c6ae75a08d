#pragma once
/// \file
/// How the loop of four links can move, for verification (Mechanism::ways_again).

#include <algorithm>
#include <array>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The loop of four links closes somewhere: none is longer than the other three together.
inline Way four_links_close(std::string_view output) {
    const std::array<std::string_view, 4> links{"ground", "crank", "coupler", output};
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
inline Way crank_turns(std::string_view longer, std::string_view shorter, std::string_view output) {
    const std::string_view near = "the crank passes the near side of the ground";
    return {{near, {longer, output}, {shorter, "coupler"}},
            {near, {longer, "coupler"}, {shorter, output}},
            {"the crank passes the far side of the ground", {"coupler", output}, {longer, shorter}}};
}

}  // namespace mechwright
