#pragma once
/// \file
/// Which link has its direction next, from links that have theirs: by a drive, a slide, a gear or a rack.

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "analysis/linkage/structure/ordering.h"

namespace mechwright::linkage::detail {

inline bool turn_by_drive(Ordering& o, std::size_t link) {
    for (std::size_t i = 0; i < o.s.drives.size(); ++i) {
        const Drive& drive = o.s.drives[i];
        if (drive.of_slide) continue;
        const auto other = other_end(link, drive.link, drive.on);
        if (!other || !o.turned[*other]) continue;
        Step& step = o.add(Step::Kind::driven);
        step.link = link;
        step.other = *other;
        step.input = i;
        step.reversed = link == drive.on;
        o.turn(link, Group::Kind::drive, o.unwound[*other]);
        return true;
    }
    return false;
}

inline bool turn_by_slide(Ordering& o, std::size_t link) {
    for (std::size_t i = 0; i < o.s.slides.size(); ++i) {
        const Slide& slide = o.s.slides[i];
        const auto other = other_end(link, slide.link, slide.line.on);
        if (!other || !o.turned[*other]) continue;
        Step& step = o.add(Step::Kind::held);
        step.link = link;
        step.other = *other;
        step.joint = i;
        step.reversed = link == slide.line.on;
        if (!o.placed[*other]) o.by[link] = *other;
        o.turn(link, Group::Kind::guided, o.unwound[*other]);
        return true;
    }
    return false;
}

inline bool turn_by_gear(Ordering& o, std::size_t link) {
    for (std::size_t i = 0; i < o.s.gears.size(); ++i) {
        const Gear& gear = o.s.gears[i];
        const std::size_t all[]{gear.first, gear.second, gear.carrier};
        if (std::find(std::begin(all), std::end(all), link) == std::end(all)) continue;
        if (!std::all_of(std::begin(all), std::end(all), [&](std::size_t l) { return l == link || o.turned[l]; }))
            continue;
        for (const std::size_t l : all)
            if (l != link) o.unwind(l);
        Step& step = o.add(Step::Kind::geared);
        step.link = link;
        step.joint = i;
        step.first.link = gear.first;
        step.second.link = gear.second;
        step.other = gear.carrier;
        o.turn(link, Group::Kind::geared, true);
        return true;
    }
    return false;
}

inline bool turn_by_rack(Ordering& o, std::size_t link) {
    for (std::size_t i = 0; i < o.s.racks.size(); ++i) {
        const Rack& rack = o.s.racks[i];
        const auto other = other_end(link, rack.wheel, rack.carrier);
        const Slide& slide = o.s.slides[rack.slide];
        if (!other || !o.turned[*other] || !o.placed[slide.link] || !o.placed[slide.line.on]) continue;
        o.unwind(*other);
        Step& step = o.add(Step::Kind::wheeled);
        step.link = link;
        step.other = *other;
        step.joint = i;
        step.first.link = slide.link;
        step.second.link = slide.line.on;
        step.reversed = link == rack.carrier;
        o.turn(link, Group::Kind::geared, true);
        return true;
    }
    return false;
}

inline bool turn_any(Ordering& o) {
    for (std::size_t link = 1; link < o.s.links; ++link)
        if (!o.turned[link] &&
            (turn_by_drive(o, link) || turn_by_slide(o, link) || turn_by_gear(o, link) || turn_by_rack(o, link)))
            return true;
    return false;
}

}  // namespace mechwright::linkage::detail
