#pragma once
/// \file
/// A linkage half placed: which of its links and pins are known, and what the next ones can hang on.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/linkage/structure/steps.h"
#include "analysis/linkage/structure/structure.h"

namespace mechwright::linkage::detail {

/// What is placed so far, and the steps that did it.
struct Ordering {
    const Structure& s;
    Order order{};
    std::vector<bool> turned{};     ///< links of known direction
    std::vector<bool> placed{};     ///< links
    std::vector<bool> known{};      ///< pins
    std::vector<bool> unwound{};    ///< links whose turn is known, not their direction alone
    std::vector<std::size_t> by{};  ///< for links of known direction: the link that it came from by a slide, else none
    std::vector<Group::Kind> from{};  ///< for links of known direction: what turned them
    std::vector<Step> hung{};         ///< for links: as the steps that carry their pins say it, from where

    explicit Ordering(const Structure& structure)
        : s(structure),
          turned(s.links, false),
          placed(s.links, false),
          known(s.pins.size(), false),
          unwound(s.links, false),
          by(s.links, none),
          from(s.links, Group::Kind::guided),
          hung(s.links) {
        turned[0] = unwound[0] = true;
        place(0);
    }

    Step& add(Step::Kind kind) {
        order.steps.emplace_back().kind = kind;
        return order.steps.back();
    }
    /// A link is placed: so are its pins.
    void place(std::size_t link) {
        placed[link] = true;
        for (std::size_t pin = 0; pin < s.pins.size(); ++pin) {
            if (known[pin] || !is_on(s.pins[pin], link)) continue;
            known[pin] = true;
            Step& step = order.steps.emplace_back(hung[link]);
            step.kind = Step::Kind::carried;
            step.link = link;
            step.pin = pin;
        }
    }
    /// A link is about to be placed by a pin of it.
    void hang(std::size_t link, std::size_t pin, CarriedFrom how = CarriedFrom::pin, std::size_t far_pin = none) {
        hung[link].first = {Locus::Kind::circle, link, pin, {}};
        hung[link].from = how;
        hung[link].far_pin = far_pin;
    }
    void turn(std::size_t link, Group::Kind kind, bool with_turn) {
        turned[link] = true;
        unwound[link] = with_turn;
        from[link] = kind;
    }
    /// The turn of a link of known direction, where only that is known.
    void unwind(std::size_t link) {
        if (unwound[link]) return;
        add(Step::Kind::unwound).link = link;
        unwound[link] = true;
    }
};

/// The link at the other end of a joint of two links, if the first is at one end.
inline std::optional<std::size_t> other_end(std::size_t link, std::size_t a, std::size_t b) {
    if (link == a && link != b) return b;
    if (link == b && link != a) return a;
    return {};
}

/// The conditions on where a link of known direction is, in the order of slides and slots.
inline std::vector<Tie> ties_of(const Ordering& o, std::size_t link) {
    std::vector<Tie> ties;
    for (std::size_t i = 0; i < o.s.slides.size(); ++i) {
        const Slide& slide = o.s.slides[i];
        if (slide.link == link && o.placed[slide.line.on]) ties.push_back({Tie::Kind::slides, i, slide.line.on});
        if (slide.line.on == link && o.placed[slide.link]) ties.push_back({Tie::Kind::carries, i, slide.link});
    }
    for (std::size_t i = 0; i < o.s.slots.size(); ++i) {
        const Slot& slot = o.s.slots[i];
        const bool on = is_on(o.s.pins[slot.pin], link);
        if (on && o.placed[slot.line.on]) ties.push_back({Tie::Kind::in_slot, i, slot.line.on});
        if (!on && slot.line.on == link && o.known[slot.pin]) ties.push_back({Tie::Kind::over_pin, i, slot.pin});
    }
    return ties;
}

/// A placed pin of a link, but not a certain one.
inline std::size_t known_pin(const Ordering& o, std::size_t link, std::size_t but = none) {
    for (std::size_t pin = 0; pin < o.s.pins.size(); ++pin)
        if (pin != but && o.known[pin] && is_on(o.s.pins[pin], link)) return pin;
    return none;
}

inline void add_group(Ordering& o, Group::Kind kind, std::vector<std::size_t> links) {
    Group& group = o.order.groups.emplace_back();
    group.kind = kind;
    group.links = std::move(links);
    std::sort(group.links.begin(), group.links.end());
}

}  // namespace mechwright::linkage::detail
