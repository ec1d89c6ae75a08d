#pragma once
/// \file
/// The two chains that a guided link of a linkage hangs on: the crank that drives it, and from another point or line of
/// it a rocker, a slide or a block to the frame. Or, where something else drives the linkage, such as a crank with a
/// rod to one of them, two such chains of which at least one is a rocker.

#include <cstddef>
#include <optional>

#include "synthesis/exact/homotopy/guidance_system.h"
#include "synthesis/mechanism/linkage/model.h"

namespace mechwright {

/// Links, pins and joints by their numbers in the structure; `linkage::none` where a kind has not the one.
struct GuidedChains {
    std::size_t body = 0;
    std::size_t point = 0;  ///< the pin that is guided
    bool by_crank = true;   ///< the crank is what drives; else it is a rocker, and something else drives the linkage
    std::size_t crank = 0;
    std::size_t crank_pivot = 0;
    std::size_t crank_pin = 0;
    homotopy::SecondDyad second = homotopy::SecondDyad::rocker;
    std::size_t link = linkage::none;    ///< the rocker, or what slides on the frame or on which the body slides
    std::size_t moving = linkage::none;  ///< a pin of the body: of a rocker, or that a slide or slot leads
    std::size_t fixed = linkage::none;   ///< a pin of the frame: of a rocker or of a block
    std::size_t slide = linkage::none;   ///< of a ram on the frame, or of a block on the body
    std::size_t slot = linkage::none;    ///< the same without a link
};

/// The one pin of two links; nothing where they have none or several.
std::optional<std::size_t> one_pin_of(const linkage::Structure& structure, std::size_t one, std::size_t other);

/// The chains of the one point or body that is guided; nothing where it hangs in another way.
std::optional<GuidedChains> guided_chains(const LinkageModel& model);

}  // namespace mechwright
