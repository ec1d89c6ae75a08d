#pragma once
/// \file
/// The order in which a linkage is placed: drives, gears and Assur groups, each as soon as what it hangs on is placed,
/// else in the order of the links. Dyads become steps of closed form; what is left are larger groups, the least sets of
/// links whose equations have to be solved together (components.h).

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/linkage/structure/carried_round.h"
#include "analysis/linkage/structure/components.h"
#include "analysis/linkage/structure/directions.h"
#include "analysis/linkage/structure/mobility.h"
#include "analysis/linkage/structure/ordering.h"
#include "analysis/linkage/structure/stops.h"

namespace mechwright::linkage {

namespace detail {

/// The displacement of a slide that is an input, or that of a rack, from the placed link at its other end.
inline bool slide_to_place(Ordering& o, std::size_t link) {
    const auto slid = [&](std::size_t slide, Step::Kind kind) -> Step* {
        const auto other = other_end(link, o.s.slides[slide].link, o.s.slides[slide].line.on);
        if (!other || !o.placed[*other]) return nullptr;
        Step& step = o.add(kind);
        step.link = link;
        step.other = *other;
        step.joint = slide;
        step.reversed = link == o.s.slides[slide].line.on;
        return &step;
    };
    for (std::size_t i = 0; i < o.s.drives.size(); ++i)
        if (o.s.drives[i].of_slide)
            if (Step* step = slid(o.s.drives[i].slide, Step::Kind::slid)) {
                step->input = i;
                o.from[link] = Group::Kind::drive;
                return true;
            }
    for (std::size_t i = 0; i < o.s.racks.size(); ++i) {
        const Rack& rack = o.s.racks[i];
        const Slide& slide = o.s.slides[rack.slide];
        const auto other = other_end(link, slide.link, slide.line.on);
        if (!other || !o.placed[*other] || !o.turned[rack.wheel] || !o.turned[rack.carrier]) continue;
        o.unwind(rack.wheel);
        o.unwind(rack.carrier);
        Step& step = *slid(rack.slide, Step::Kind::racked);
        step.input = i;
        step.first.link = rack.wheel;
        step.second.link = rack.carrier;
        o.from[link] = Group::Kind::geared;
        return true;
    }
    return false;
}

inline bool place_one(Ordering& o, std::size_t link) {
    Group::Kind kind = Group::Kind::guided;
    if (!slide_to_place(o, link)) {
        if (const std::size_t pin = known_pin(o, link); pin != none) {
            Step& step = o.add(Step::Kind::pinned);
            step.link = link;
            step.pin = pin;
            o.hang(link, pin);
        } else {
            const std::vector<Tie> ties = ties_of(o, link);
            if (ties.size() < 2) return false;
            Step& step = o.add(Step::Kind::tied);
            step.link = link;
            step.first = {Locus::Kind::line, link, none, ties[0]};
            step.second = {Locus::Kind::line, link, none, ties[1]};
            step.margin = o.order.margins++;
            // A slot's block is a link without mass: one more sliding joint, or pin, of a dyad.
            const auto is_slide = [](const Tie& t) { return t.kind <= Tie::Kind::carries; };
            if (o.from[link] == Group::Kind::guided && is_slide(ties[0]) && !is_slide(ties[1]))
                kind = ties[1].kind == Tie::Kind::over_pin ? Group::Kind::rpp : Group::Kind::prp;
        }
    }
    if (o.from[link] != Group::Kind::guided) kind = o.from[link];
    o.place(link);
    add_group(o, kind, {link});
    return true;
}

inline bool place_any(Ordering& o) {
    for (std::size_t link = 1; link < o.s.links; ++link)
        if (o.turned[link] && !o.placed[link] && place_one(o, link)) return true;
    return false;
}

/// The circle of a pin of a link that a drive slides along another one with a placed pin: a telescope.
inline std::optional<Locus> extended_locus(const Ordering& o, std::size_t link) {
    for (std::size_t i = 0; i < o.s.drives.size(); ++i) {
        if (!o.s.drives[i].of_slide) continue;
        const Slide& slide = o.s.slides[o.s.drives[i].slide];
        const auto other = other_end(link, slide.link, slide.line.on);
        if (!other || o.turned[*other]) continue;
        if (const std::size_t centre = known_pin(o, *other); centre != none)
            return Locus{Locus::Kind::circle, *other, centre, {Tie::Kind::slides, o.s.drives[i].slide, link}, i};
    }
    return {};
}

/// Places the outer link of a telescope whose inner one is placed.
inline void extend(Ordering& o, const Locus& locus) {
    const std::size_t link = locus.tie.base;
    const bool reversed = o.s.slides[locus.tie.joint].line.on == link;
    for (const Step::Kind kind : {Step::Kind::held, Step::Kind::slid}) {
        Step& step = o.add(kind);
        step.link = link;
        step.other = locus.link;
        step.joint = locus.tie.joint;
        step.reversed = reversed;
        if (kind == Step::Kind::slid) step.input = locus.extended;
    }
    o.turned[link] = true;
    o.place(link);
}

/// Where a pin that is not placed can be, by each of its links and slots.
inline std::vector<Locus> loci_of(const Ordering& o, std::size_t pin) {
    std::vector<Locus> loci;
    for (const Point& point : o.s.pins[pin].points) {
        if (o.turned[point.link]) {
            if (const auto ties = ties_of(o, point.link); !ties.empty())
                loci.push_back({Locus::Kind::line, point.link, none, ties[0]});
        } else if (const std::size_t centre = known_pin(o, point.link); centre != none) {
            loci.push_back({Locus::Kind::circle, point.link, centre, {}});
        } else if (const auto extended = extended_locus(o, point.link)) {
            loci.push_back(*extended);
        }
    }
    std::stable_sort(loci.begin(), loci.end(), [](const Locus& a, const Locus& b) { return a.link < b.link; });
    for (std::size_t i = 0; i < o.s.slots.size(); ++i)
        if (o.s.slots[i].pin == pin && o.placed[o.s.slots[i].line.on])
            loci.push_back(
                {Locus::Kind::slot, o.s.slots[i].line.on, none, {Tie::Kind::in_slot, i, o.s.slots[i].line.on}});
    return loci;
}

/// Names the slide or slot that a side is counted along.
inline void name_joint(Group& group, const Tie& tie) {
    group.joint = tie.joint;
    group.by_slide = tie.kind <= Tie::Kind::carries;
}

inline void join(Ordering& o, std::size_t pin, Locus first, Locus second) {
    const bool circles[]{first.kind == Locus::Kind::circle, second.kind == Locus::Kind::circle};
    if (!circles[0] && circles[1]) std::swap(first, second);
    Step& step = o.add(Step::Kind::dyad);
    step.pin = pin;
    step.first = first;
    step.second = second;
    step.margin = o.order.margins++;
    Group group;
    group.pin = pin;
    group.kind = circles[0] && circles[1]   ? Group::Kind::rrr
                 : circles[0] || circles[1] ? Group::Kind::rrp
                                            : Group::Kind::prp;
    if (group.kind != Group::Kind::prp) group.choice = step.choice = o.order.choices++;
    if (group.kind == Group::Kind::rrp) name_joint(group, second.tie);
    group.outer[0] = first.centre;
    group.outer[1] = second.centre;
    o.known[pin] = true;
    for (const Locus& locus : {first, second}) {
        if (locus.kind == Locus::Kind::slot) continue;
        if (locus.kind == Locus::Kind::line)
            o.hang(locus.link, pin);
        else if (locus.extended != none)
            o.hang(locus.link, locus.centre);
        else
            o.hang(locus.link, locus.centre, locus.link == first.link ? CarriedFrom::first : CarriedFrom::second, pin);
        group.links.push_back(locus.link);
        o.turned[locus.link] = true;
        o.place(locus.link);
        if (locus.extended == none) continue;
        group.links.push_back(locus.tie.base);
        extend(o, locus);
    }
    std::sort(group.links.begin(), group.links.end());
    o.order.groups.push_back(std::move(group));
}

inline bool join_any(Ordering& o) {
    for (std::size_t pin = 0; pin < o.s.pins.size(); ++pin) {
        if (o.known[pin]) continue;
        if (const auto loci = loci_of(o, pin); loci.size() >= 2) return join(o, pin, loci[0], loci[1]), true;
    }
    return false;
}

/// A link that turns about a placed pin, and whose line passes another placed pin at a distance.
inline void pass(Ordering& o, std::size_t link, std::size_t pin, std::size_t far_pin, const Tie& tie,
                 std::size_t slider) {
    Step& step = o.add(Step::Kind::through);
    step.link = link;
    step.other = slider;
    step.pin = pin;
    step.far_pin = far_pin;
    step.joint = tie.joint;
    step.reversed = tie.kind == Tie::Kind::over_pin;  // the joint is a slot
    step.margin = o.order.margins++;
    step.choice = o.order.choices++;
    Group group;
    group.kind = Group::Kind::rpr;
    group.links = {link};
    group.pin = far_pin;
    group.choice = step.choice;
    group.outer[0] = pin;
    name_joint(group, tie);
    o.turned[link] = true;
    o.hang(link, pin);
    o.place(link);
    if (slider != none) {
        group.links.push_back(slider);
        o.turned[slider] = true;
        o.hang(slider, far_pin);
        o.place(slider);
    }
    std::sort(group.links.begin(), group.links.end());
    o.order.groups.push_back(std::move(group));
}

inline bool pass_any(Ordering& o) {
    for (std::size_t link = 1; link < o.s.links; ++link) {
        if (o.turned[link]) continue;
        const std::size_t pin = known_pin(o, link);
        if (pin == none) continue;
        for (std::size_t i = 0; i < o.s.slots.size(); ++i) {
            const Slot& slot = o.s.slots[i];
            if (slot.line.on != link || !o.known[slot.pin] || is_on(o.s.pins[slot.pin], link)) continue;
            return pass(o, link, pin, slot.pin, {Tie::Kind::over_pin, i, slot.pin}, none), true;
        }
        for (std::size_t i = 0; i < o.s.slides.size(); ++i) {
            const Slide& slide = o.s.slides[i];
            if (slide.line.on != link || o.turned[slide.link]) continue;
            if (const std::size_t far_pin = known_pin(o, slide.link, pin); far_pin != none)
                return pass(o, link, pin, far_pin, {Tie::Kind::slides, i, link}, slide.link), true;
        }
    }
    return false;
}

/// The linkage with a placed link first at every pin that has one, so that equations speak of what is placed.
inline Structure placed_first(const Ordering& o) {
    Structure s = o.s;
    for (Pin& pin : s.pins)
        std::stable_partition(pin.points.begin(), pin.points.end(), [&](const Point& p) { return o.placed[p.link]; });
    return s;
}

/// The equation that a row of velocities belongs to; `second` of the two rows of a pin or slide.
inline LoopEquation loop_equation(const Structure& s, const Equation& row, bool second) {
    using Kind = LoopEquation::Kind;
    const std::size_t i = row.index;
    const auto sliding = [&](std::size_t slide) { return std::pair(s.slides[slide].link, s.slides[slide].line.on); };
    switch (row.by) {
        case Joined::pin: return {second ? Kind::pin_y : Kind::pin_x, i, {s.pins[i].points[0].link, row.link}};
        case Joined::slide: {
            const auto [link, on] = sliding(i);
            return {second ? Kind::slide_line : Kind::slide_turn, i, {link, on}};
        }
        case Joined::slot: return {Kind::slot, i, {s.pins[s.slots[i].pin].points[0].link, s.slots[i].line.on}};
        case Joined::gear: return {Kind::gear, i, {s.gears[i].first, s.gears[i].second, s.gears[i].carrier}};
        case Joined::rack: {
            const auto [link, on] = sliding(s.racks[i].slide);
            return {Kind::rack, i, {link, on, s.racks[i].wheel, s.racks[i].carrier}};
        }
        case Joined::drive: break;
    }
    if (!s.drives[i].of_slide) return {Kind::drive_turn, i, {s.drives[i].link, s.drives[i].on}};
    const auto [link, on] = sliding(s.drives[i].slide);
    return {Kind::drive_slide, i, {link, on}};
}

/// The turns that a gear or rack reads of links that are placed already.
inline void unwind_for(Ordering& o, const LoopEquation& equation) {
    const bool gear = equation.kind == LoopEquation::Kind::gear, rack = equation.kind == LoopEquation::Kind::rack;
    for (std::size_t k = gear ? 0 : 2; k < (gear ? 3 : rack ? 4 : 0); ++k)
        if (o.turned[equation.links[k]]) o.unwind(equation.links[k]);
}

/// The least links that have to be placed together, as one group.
inline void place_together(Ordering& o) {
    const Structure s = placed_first(o);
    const VelocityEquations<double> all = velocity_equations(s, random_instant<double>(s, 1, {}));
    std::vector<std::size_t> names, position(all.unknowns, none);
    for (std::size_t u = 0; u < all.unknowns; ++u)
        if (u % 3 == 2 ? !o.turned[u / 3 + 1] : !o.placed[u / 3 + 1]) {
            position[u] = names.size();
            names.push_back(u);
        }
    Pattern pattern;
    pattern.unknowns = names.size();
    for (std::size_t i = 0; i < names.size(); ++i)
        pattern.twin.push_back(names[i] % 3 == 2 ? i : position[names[i] / 3 * 3 + 1 - names[i] % 3]);
    std::vector<std::size_t> row_of;
    for (std::size_t i = 0; i < all.equations.size(); ++i) {
        std::vector<std::size_t> in;
        for (std::size_t u = 0; u < all.unknowns; ++u)
            if (position[u] != none && all.row(i)[u] != 0) in.push_back(position[u]);
        if (in.empty()) continue;
        pattern.unknowns_of.push_back(std::move(in));
        row_of.push_back(i);
    }
    LargerGroup larger;
    std::vector<std::size_t> links;
    std::vector<bool> whole(o.s.links, false), turning(o.s.links, false), mine(names.size(), false);
    for (const std::size_t u : first_component(pattern)) {
        const std::size_t link = names[u] / 3 + 1;
        mine[u] = true;
        larger.unknowns.push_back({link, static_cast<int>(names[u] % 3)});
        (names[u] % 3 == 2 ? turning : whole)[link] = true;
        if (links.empty() || links.back() != link) links.push_back(link);
    }
    for (std::size_t i = 0; i < row_of.size(); ++i) {
        const auto& in = pattern.unknowns_of[i];
        if (!std::all_of(in.begin(), in.end(), [&](std::size_t u) { return mine[u]; })) continue;
        const Equation& row = all.equations[row_of[i]];
        const bool second = row_of[i] > 0 && all.equations[row_of[i] - 1].by == row.by &&
                            all.equations[row_of[i] - 1].index == row.index &&
                            all.equations[row_of[i] - 1].link == row.link;
        larger.equations.push_back(loop_equation(s, row, second));
        unwind_for(o, larger.equations.back());
    }
    Step& step = o.add(Step::Kind::together);
    step.joint = o.order.larger.size();
    step.margin = o.order.margins++;
    add_group(o, Group::Kind::larger, links);
    o.order.groups.back().larger = step.joint;
    o.order.larger.push_back(std::move(larger));
    for (const std::size_t link : links) {
        if (turning[link]) o.turned[link] = o.unwound[link] = true;
        if (!whole[link]) continue;
        o.turned[link] = true;
        o.place(link);
    }
}

/// Groups of which a link has its direction from a link of a later one by a slide are one: an RPP.
inline void merge_held(Ordering& o) {
    std::vector<Group>& groups = o.order.groups;
    for (std::size_t link = 1; link < o.s.links; ++link) {
        if (o.by[link] == none) continue;
        const auto of = [&](std::size_t l) {
            return std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
                return std::find(g.links.begin(), g.links.end(), l) != g.links.end();
            });
        };
        const auto mine = of(link), others = of(o.by[link]);
        if (mine == groups.end() || others == groups.end() || mine >= others) continue;
        if (mine->links.size() != 1 || others->links.size() != 1 || others->kind == Group::Kind::larger) continue;
        others->kind = Group::Kind::rpp;
        others->links.push_back(link);
        std::sort(others->links.begin(), others->links.end());
        groups.erase(mine);
    }
}

}  // namespace detail

/// The order of a linkage that its drives settle (Mobility::settled), deterministic. Links that nothing settles are in
/// its last, larger group.
inline Order order_of(const Structure& s) {
    detail::Ordering o(s);
    const auto all_placed = [&] { return std::find(o.placed.begin(), o.placed.end(), false) == o.placed.end(); };
    while (!all_placed())
        if (!detail::turn_any(o) && !detail::place_any(o) && !detail::join_any(o) && !detail::pass_any(o))
            detail::place_together(o);
    detail::merge_held(o);
    detail::add_stops(s, o.order);
    for (Step& step : o.order.steps)
        step.round = detail::carried_round(o.order, step);
    return std::move(o.order);
}

}  // namespace mechwright::linkage
