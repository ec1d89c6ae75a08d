#include "synthesis/exact/chains/guided_chains.h"

#include <algorithm>
#include <vector>

namespace mechwright {

namespace {

using homotopy::SecondDyad;

constexpr std::size_t frame = 0;

bool has_line(const linkage::Structure& s, std::size_t link) {
    return std::any_of(s.slides.begin(), s.slides.end(),
                       [&](const linkage::Slide& slide) { return slide.link == link || slide.line.on == link; });
}

/// The links that join the body to the frame by two pins.
void add_rockers(const linkage::Structure& s, const GuidedChains& known, std::vector<GuidedChains>& all) {
    for (std::size_t link = 1; link < s.links; ++link) {
        if (link == known.crank || link == known.body || has_line(s, link)) continue;
        const auto moving = one_pin_of(s, link, known.body), fixed = one_pin_of(s, link, frame);
        if (!moving || !fixed || *moving == *fixed) continue;
        GuidedChains chains = known;
        chains.second = SecondDyad::rocker;
        chains.link = link;
        chains.moving = *moving;
        chains.fixed = *fixed;
        all.push_back(chains);
    }
}

/// What slides on the frame with a pin of the body, and on the body with a pin of the frame.
void add_slides(const linkage::Structure& s, const GuidedChains& known, std::vector<GuidedChains>& all) {
    for (std::size_t i = 0; i < s.slides.size(); ++i) {
        const linkage::Slide& slide = s.slides[i];
        const bool ram = slide.line.on == frame;
        if (slide.link == known.crank || slide.link == known.body || (!ram && slide.line.on != known.body)) continue;
        const auto pin = one_pin_of(s, slide.link, ram ? known.body : frame);
        if (!pin) continue;
        GuidedChains chains = known;
        chains.second = ram ? SecondDyad::ram : SecondDyad::block;
        chains.link = slide.link;
        (ram ? chains.moving : chains.fixed) = *pin;
        chains.slide = i;
        all.push_back(chains);
    }
}

void add_slots(const linkage::Structure& s, const GuidedChains& known, std::vector<GuidedChains>& all) {
    for (std::size_t i = 0; i < s.slots.size(); ++i) {
        const linkage::Slot& slot = s.slots[i];
        const bool ram = slot.line.on == frame && is_on(s.pins[slot.pin], known.body);
        const bool block = slot.line.on == known.body && is_on(s.pins[slot.pin], frame);
        if (slot.loose || (!ram && !block)) continue;
        GuidedChains chains = known;
        chains.second = ram ? SecondDyad::ram : SecondDyad::block;
        (ram ? chains.moving : chains.fixed) = slot.pin;
        chains.slot = i;
        all.push_back(chains);
    }
}

/// All chains that the body hangs on beside a crank, rockers first.
std::vector<GuidedChains> chains_beside(const linkage::Structure& s, const GuidedChains& known) {
    std::vector<GuidedChains> all;
    add_rockers(s, known, all);
    add_slides(s, known, all);
    add_slots(s, known, all);
    return all;
}

std::optional<GuidedChains> driven_by_crank(const linkage::Structure& s, GuidedChains known) {
    const linkage::Drive& drive = s.drives.front();
    if (drive.of_slide || drive.on != frame || known.body == drive.link) return {};
    known.crank = drive.link;
    const auto pivot = one_pin_of(s, frame, known.crank), pin = one_pin_of(s, known.crank, known.body);
    if (!pivot || !pin || *pivot == *pin) return {};
    known.crank_pivot = *pivot;
    known.crank_pin = *pin;
    const auto all = chains_beside(s, known);
    if (all.size() != 1) return {};
    return all.front();
}

/// The first rocker takes the place of the crank.
std::optional<GuidedChains> driven_otherwise(const linkage::Structure& s, GuidedChains known) {
    known.crank = linkage::none;
    const auto all = chains_beside(s, known);
    if (all.size() != 2 || all.front().second != SecondDyad::rocker) return {};
    GuidedChains chains = all.back();
    chains.by_crank = false;
    chains.crank = all.front().link;
    chains.crank_pivot = all.front().fixed;
    chains.crank_pin = all.front().moving;
    return chains;
}

}  // namespace

std::optional<std::size_t> one_pin_of(const linkage::Structure& s, std::size_t one, std::size_t other) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < s.pins.size(); ++i) {
        if (!is_on(s.pins[i], one) || !is_on(s.pins[i], other)) continue;
        if (found) return {};
        found = i;
    }
    return found;
}

std::optional<GuidedChains> guided_chains(const LinkageModel& model) {
    const linkage::Structure& s = model.structure;
    if (model.guided.size() != 1 || model.guided.front().follows || s.drives.size() != 1) return {};
    GuidedChains known;
    known.body = model.guided.front().link;
    known.point = model.guided.front().pin;
    if (known.body == frame) return {};
    const auto chains = driven_by_crank(s, known);
    return chains ? chains : driven_otherwise(s, known);
}

}  // namespace mechwright
