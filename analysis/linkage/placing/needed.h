#pragma once
/// \file
/// The plain steps (plain_steps.h) that a pin, the direction of a link and, where they are asked for, the margins of
/// all dyads depend on: the steps of the order (steps.h) taken apart, those that nothing asked for needs left out.

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include "analysis/linkage/placing/dyads.h"
#include "analysis/linkage/placing/plain_steps.h"
#include "analysis/linkage/placing/sizes.h"
#include "analysis/linkage/structure/steps.h"
#include "analysis/linkage/structure/structure.h"

namespace mechwright::linkage {

namespace detail {

/// Takes the steps of an order apart, as place.h and sizes.h run them.
class Needing {
public:
    using Kind = PlainStep::Kind;

    Needing(const Structure& structure, const Order& order, std::size_t numbers) : s(structure) {
        made.drives = static_cast<std::uint32_t>(s.drives.size());
        made.sides = static_cast<std::uint32_t>(order.choices);
        made.numbers = static_cast<std::uint32_t>(numbers);
        made.size = made.number(numbers);
        made.turning.assign(s.drives.size(), false);
        origins.assign(s.links, no_spot);
        alongs.assign(s.links, no_spot);
        swung.resize(s.links);
        turns.assign(s.links, no_spot);
        pins.assign(s.pins.size(), no_spot);
        origins[0] = turns[0] = Needed::origin;
        alongs[0] = Needed::axis;
        for (const Step& step : order.steps)
            take_apart(step);
    }

    const Structure& s;
    Needed made;
    std::vector<Spot> origins, alongs, turns, pins;

private:
    /// Of a link of a dyad: its direction from the pin on which it hangs to the dyad's, and that in its own frame.
    struct Swung {
        Spot direction = no_spot, own = no_spot;
    };
    std::vector<Swung> swung;

    struct LineSpots {
        Spot through, direction;
    };
    /// A circle of a locus: a pin on its link where it is centred, the direction and the length from there to the pin.
    struct CircleSpots {
        Spot own, direction, length;
    };

    Spot add(Kind kind, std::size_t numbers, std::initializer_list<Spot> in) {
        PlainStep step;
        step.kind = kind;
        std::copy(in.begin(), in.end(), step.in);
        step.out = static_cast<Spot>(made.size);
        made.size += numbers;
        made.steps.push_back(step);
        return step.out;
    }
    Spot number(Number i) const { return made.number(i); }
    Spot unit(Spot angle) { return add(Kind::unit, 2, {angle}); }
    Spot turned(Spot a, Spot by, bool back = false) {
        if (a == Needed::axis && !back) return by;
        if (by == Needed::axis) return a;
        return add(back ? Kind::turned_back : Kind::turned, 2, {a, by});
    }

    Spot place(const Coordinates& at) {
        if (at.polar) return add(Kind::scaled, 2, {number(at.first), unit(number(at.second))});
        return at.second == at.first + 1 ? number(at.first) : add(Kind::pair, 2, {number(at.first), number(at.second)});
    }
    Spot place(std::size_t pin, std::size_t link) { return place(coordinates_on(s.pins[pin], link)); }

    /// As line_part.
    LineSpots line(bool of_slide, std::size_t joint) {
        const LineSpots spots = line(of_slide ? s.slides[joint].line : s.slots[joint].line);
        if (!of_slide) return spots;
        return {add(Kind::offset, 2, {spots.through, number(s.slides[joint].offset), spots.direction}),
                spots.direction};
    }
    LineSpots line(const Line& line) {
        const Spot through = place(line.through);
        const Spot direction = line.by_angle ? unit(number(line.angle))
                                             : add(Kind::line, 3, {add(Kind::less, 2, {place(line.towards), through})});
        return {through, direction};
    }
    /// A place that a link carries.
    Spot carried(std::size_t link, Spot own) {
        return link == 0 ? own : add(Kind::carried, 2, {origins[link], own, alongs[link]});
    }
    LineSpots line_on(std::size_t link, const LineSpots& own) {
        return {carried(link, own.through), turned(own.direction, alongs[link])};
    }

    /// As tie_part and locus_line.
    LineSpots line_of(const Locus& locus, std::size_t pin) {
        const Tie& tie = locus.tie;
        if (locus.kind == Locus::Kind::slot) return line_on(tie.base, line(false, tie.joint));
        const Spot own = pin == none ? Needed::origin : place(pin, locus.link), along = alongs[locus.link];
        const LineSpots part = line(tie.kind <= Tie::Kind::carries, tie.joint);
        Spot moved = own;
        if (tie.kind == Tie::Kind::in_slot)
            moved = add(Kind::less, 2, {own, place(s.slots[tie.joint].pin, locus.link)});
        else if (tie.kind != Tie::Kind::slides)
            moved = add(Kind::less, 2, {own, part.through});
        LineSpots placed;
        if (tie.kind == Tie::Kind::slides || tie.kind == Tie::Kind::in_slot)
            placed = line_on(tie.base, part);
        else
            placed = {tie.kind == Tie::Kind::carries ? origins[tie.base] : pins[tie.base],
                      turned(part.direction, along)};
        placed.through = add(Kind::carried, 2, {placed.through, moved, along});
        return placed;
    }

    /// As extended_part and extended_to, and as locus_part.
    CircleSpots circle_of(const Locus& locus, std::size_t pin) {
        const Spot own = place(locus.centre, locus.link);
        Spot arm;
        if (locus.extended == none) {
            arm = add(Kind::less, 2, {place(pin, locus.link), own});
        } else {
            const Slide& slide = s.slides[locus.tie.joint];
            const LineSpots part = line(true, locus.tie.joint);
            const Spot turn = unit(number(slide.angle)), at = place(pin, locus.tie.base);
            Spot direction = part.direction, to_pin;
            if (slide.link == locus.tie.base) {
                to_pin = add(Kind::carried, 2, {part.through, at, turn});
            } else {
                to_pin = turned(add(Kind::less, 2, {at, part.through}), turn, true);
                direction = add(Kind::negated, 2, {turned(direction, turn, true)});
            }
            arm = add(Kind::reached, 2, {add(Kind::less, 2, {to_pin, own}), made.drive(locus.extended), direction});
        }
        const Spot direction = add(Kind::arm, 3, {arm});
        return {own, direction, direction + 2};
    }

    void hang(std::size_t link, Spot own, Spot at) { origins[link] = add(Kind::hung, 2, {at, own, alongs[link]}); }
    void swing(const Locus& locus, const CircleSpots& circle, Spot direction) {
        alongs[locus.link] = turned(direction, circle.direction, true);
        swung[locus.link] = {direction, circle.direction};
        hang(locus.link, circle.own, pins[locus.centre]);
    }
    Spot side(const Step& step) const { return step.choice == none ? Needed::axis : made.side(step.choice); }
    void margin(Spot outer, Spot inner) { made.margins.push_back({outer, inner}); }

    Spot circles(const Step& step, Spot a, Spot b) {
        const Spot first = pins[step.first.centre], second = pins[step.second.centre];
        const CarriedRound& round = step.round;
        if (!round.exists()) return add(Kind::circles, 7, {first, second, a, b, side(step)});
        const Spot arm = add(Kind::less, 2, {place(round.pin, round.link), place(round.centre, round.link)}),
                   base = add(Kind::less, 2, {pins[round.fixed], pins[round.centre]}),
                   dyad = add(Kind::round_dyad, RoundDyad<double>::count, {arm, base, a, b});
        made.steps.back().first = step.first.centre == round.fixed;
        return add(Kind::round_circles, 7, {first, second, a, b, side(step), alongs[round.link], dyad});
    }
    /// As carried_part and carry.
    void carry(const Step& step) {
        const Spot own = place(step.pin, step.link);
        if (step.from == CarriedFrom::origin || step.link == 0) {
            pins[step.pin] = carried(step.link, own);
            return;
        }
        const Spot base = pins[step.first.centre], arm = add(Kind::less, 2, {own, place(step.first.centre, step.link)});
        pins[step.pin] =
            step.from == CarriedFrom::pin
                ? add(Kind::carried, 2, {base, arm, alongs[step.link]})
                : add(Kind::carried, 2, {base, turned(arm, swung[step.link].own, true), swung[step.link].direction});
    }

    void dyad(const Step& step) {
        const bool of_circles[]{step.first.kind == Locus::Kind::circle, step.second.kind == Locus::Kind::circle};
        CircleSpots first{}, second{};
        if (of_circles[0]) first = circle_of(step.first, step.pin);
        if (of_circles[1]) {
            second = circle_of(step.second, step.pin);
            const Spot centre = pins[step.first.centre];
            const Spot out = circles(step, first.length, second.length);
            margin(out + 4, out + 5);
            pins[step.pin] = add(Kind::reached, 2, {centre, first.length, out});
            swing(step.first, first, out);
            swing(step.second, second, out + 2);
            return;
        }
        const LineSpots line = line_of(step.second, step.pin);
        Spot out;
        if (of_circles[0]) {
            out = add(Kind::circle_line, 7,
                      {pins[step.first.centre], line.through, line.direction, first.length, side(step)});
            margin(out + 4, out + 5);
            swing(step.first, first, out + 2);
        } else {
            const LineSpots other = line_of(step.first, step.pin);
            out = add(Kind::meeting, 4, {other.through, other.direction, line.through, line.direction});
            margin(out + 2, out + 3);
        }
        pins[step.pin] = out;
        for (const Locus* locus : {&step.first, &step.second})
            if (locus->kind == Locus::Kind::line) hang(locus->link, place(step.pin, locus->link), out);
    }

    void through(const Step& step) {
        const LineSpots part = line(!step.reversed, step.joint);
        const Spot own = place(step.pin, step.link);
        Spot height = add(Kind::height, 1, {Needed::origin, part.direction, add(Kind::less, 2, {part.through, own})});
        Spot far_own = no_spot, turn = no_spot;
        if (step.other != none) {
            far_own = place(step.far_pin, step.other);
            turn = unit(number(s.slides[step.joint].angle));
            height = add(Kind::height, 1, {height, part.direction, turned(far_own, turn)});
        }
        const Spot out =
            add(Kind::passing, 6, {pins[step.pin], pins[step.far_pin], part.direction, height, side(step)});
        margin(out + 2, out + 3);
        alongs[step.link] = out;
        hang(step.link, own, pins[step.pin]);
        if (step.other == none) return;
        alongs[step.other] = turned(turn, out);
        hang(step.other, far_own, pins[step.far_pin]);
    }

    /// A link turned against another one; backwards where `reversed`.
    void turn(const Step& step, Spot angle, Spot direction) {
        alongs[step.link] = turned(alongs[step.other], direction, step.reversed);
        turns[step.link] = add(step.reversed ? Kind::difference : Kind::sum, 1, {turn_of(step.other), angle});
    }
    /// Turns that nothing asks for are not made, and stand at 0.
    Spot turn_of(std::size_t link) const { return turns[link] == no_spot ? Needed::origin : turns[link]; }

    void slide(const Step& step, Spot displacement) {
        const LineSpots part = line(true, step.joint);
        const Spot own = add(Kind::reached, 2, {part.through, displacement, part.direction});
        origins[step.link] = step.reversed ? add(Kind::hung, 2, {origins[step.other], own, alongs[step.link]})
                                           : add(Kind::carried, 2, {origins[step.other], own, alongs[step.other]});
    }

    void geared(const Step& step) {
        const Gear& gear = s.gears[step.joint];
        const Kind kind = step.link == step.second.link  ? Kind::geared_second
                          : step.link == step.first.link ? Kind::geared_first
                                                         : Kind::geared_carrier;
        turns[step.link] = add(kind, 1,
                               {turn_of(step.first.link), turn_of(step.second.link), turn_of(step.other),
                                number(gear.ratio), number(gear.phase)});
        alongs[step.link] = unit(turns[step.link]);
    }

    void wheeled(const Step& step) {
        const Rack& rack = s.racks[step.joint];
        const LineSpots placed = line_on(step.second.link, line(true, rack.slide));
        const Spot way = add(Kind::displacement, 1, {placed.direction, origins[step.first.link], placed.through});
        const Spot angle = add(Kind::rack_turn, 1, {way, number(rack.phase), number(rack.radius)});
        turn(step, angle, unit(angle));
    }

    void stopped(const Step& step) {
        const Stops& stops = stops_of(s, step);
        const Spot limit = number(step.reversed ? *stops.max : *stops.min);
        Spot value;
        if (step.input != none) {
            value = made.drive(step.input);
        } else {
            const LineSpots placed = line_on(step.other, step.far_pin != none ? line(s.circular[step.joint].ends->line)
                                                                              : line(step.pin == none, step.joint));
            value = add(Kind::displacement, 1,
                        {placed.direction, step.pin == none ? origins[step.link] : pins[step.pin], placed.through});
        }
        const Spot out =
            step.reversed ? add(Kind::difference, 1, {limit, value}) : add(Kind::difference, 1, {value, limit});
        margin(out, out);
    }

    void take_apart(const Step& step) {
        switch (step.kind) {
            case Step::Kind::driven: turn(step, made.drive(step.input), made.drive(step.input) + 1); break;
            case Step::Kind::held: {
                const Spot angle = number(s.slides[step.joint].angle);
                turn(step, angle, unit(angle));
                break;
            }
            case Step::Kind::geared: geared(step); break;
            case Step::Kind::wheeled: wheeled(step); break;
            case Step::Kind::slid: slide(step, made.drive(step.input)); break;
            case Step::Kind::racked: {
                const Rack& rack = s.racks[step.input];
                slide(step, add(Kind::rack_way, 1,
                                {turn_of(step.first.link), turn_of(step.second.link), number(rack.radius),
                                 number(rack.phase)}));
                break;
            }
            case Step::Kind::pinned: hang(step.link, place(step.pin, step.link), pins[step.pin]); break;
            case Step::Kind::tied: {
                const LineSpots first = line_of(step.first, none), second = line_of(step.second, none);
                origins[step.link] =
                    add(Kind::meeting, 4, {first.through, first.direction, second.through, second.direction});
                margin(origins[step.link] + 2, origins[step.link] + 3);
                break;
            }
            case Step::Kind::dyad: dyad(step); break;
            case Step::Kind::through: through(step); break;
            case Step::Kind::carried: carry(step); break;
            case Step::Kind::unwound:
                turns[step.link] = add(Kind::unwound, 1, {alongs[step.link]});
                made.steps.back().link = static_cast<std::uint32_t>(step.link);
                break;
            case Step::Kind::stopped: stopped(step); break;
            case Step::Kind::together: break;
        }
    }
};

/// Leaves out steps that nothing asked for needs, puts those that depend on no input first, and what is made close
/// together.
inline void keep_needed(Needed& needed) {
    constexpr std::size_t nothing = static_cast<std::size_t>(-1);
    const Spot first_made = needed.number(needed.numbers);
    std::vector<std::size_t> maker(needed.size, nothing);
    std::vector<std::size_t> lengths(needed.steps.size());
    for (std::size_t i = 0; i < needed.steps.size(); ++i) {
        const std::size_t end = i + 1 < needed.steps.size() ? needed.steps[i + 1].out : needed.size;
        lengths[i] = end - needed.steps[i].out;
        std::fill(maker.begin() + needed.steps[i].out, maker.begin() + static_cast<std::ptrdiff_t>(end), i);
    }
    std::vector<bool> wanted(needed.size, false);
    const auto need = [&](Spot spot) {
        if (spot != no_spot) wanted[spot] = true;
    };
    need(needed.point);
    need(needed.along);
    for (const MarginSpots& margin : needed.margins) {
        need(margin.outer);
        need(margin.inner);
    }
    std::vector<bool> kept(needed.steps.size(), false), moving(needed.steps.size(), false);
    for (std::size_t i = needed.steps.size(); i-- > 0;) {
        PlainStep& step = needed.steps[i];
        const auto from = wanted.begin() + step.out;
        kept[i] = std::find(from, from + static_cast<std::ptrdiff_t>(lengths[i]), true) !=
                  from + static_cast<std::ptrdiff_t>(lengths[i]);
        if (step.is_of_circles()) {
            step.first = wanted[step.out];
            step.second = wanted[step.out + 2];
        }
        if (kept[i]) std::for_each(std::begin(step.in), std::end(step.in), need);
    }
    const Spot first_drive = needed.drive(0), end_of_drives = needed.drive(needed.drives);
    std::vector<PlainStep> fixed, others;
    std::vector<Spot> moved(needed.size);
    for (Spot i = 0; i < first_made; ++i)
        moved[i] = i;
    for (std::size_t i = 0; i < needed.steps.size(); ++i) {
        if (!kept[i]) continue;
        for (const Spot in : needed.steps[i].in) {
            if (in == no_spot) continue;
            const bool of_drive = in >= first_drive && in < end_of_drives;
            if (of_drive || (maker[in] != nothing && moving[maker[in]])) moving[i] = true;
            if (of_drive && (in - first_drive) % 3 == 1) needed.turning[(in - first_drive) / 3] = true;
        }
    }
    Spot next = first_made;
    for (const bool now_moving : {false, true})
        for (std::size_t i = 0; i < needed.steps.size(); ++i) {
            if (!kept[i] || moving[i] != now_moving) continue;
            PlainStep step = needed.steps[i];
            for (std::size_t k = 0; k < lengths[i]; ++k)
                moved[step.out + k] = next++;
            for (Spot& in : step.in)
                if (in != no_spot) in = moved[in];
            step.out = moved[step.out];
            (now_moving ? others : fixed).push_back(step);
        }
    const auto move = [&](Spot& spot) {
        if (spot != no_spot) spot = moved[spot];
    };
    move(needed.point);
    move(needed.along);
    for (MarginSpots& margin : needed.margins) {
        move(margin.outer);
        move(margin.inner);
    }
    for (const Spot spot : {needed.point, needed.along})
        if (spot != no_spot && spot >= first_drive && spot < end_of_drives)
            needed.turning[(spot - first_drive) / 3] = true;
    needed.moving = fixed.size();
    needed.steps = std::move(fixed);
    needed.steps.insert(needed.steps.end(), others.begin(), others.end());
    needed.size = next;
}

}  // namespace detail

/// What a pin (or none), the x axis of a link (or none) and, if asked for, the margins of all dyads and stops depend
/// on, of a structure with so many numbers.
inline Needed needed_of(const Structure& s, const Order& order, std::size_t numbers, std::size_t pin, std::size_t link,
                        bool with_margins) {
    if (!order.closed()) {
        Needed none_of_it;
        none_of_it.closed = false;
        return none_of_it;
    }
    detail::Needing needing(s, order, numbers);
    Needed needed = std::move(needing.made);
    if (pin != none) needed.point = needing.pins[pin];
    if (link != none) needed.along = needing.alongs[link];
    if (!with_margins) needed.margins.clear();
    detail::keep_needed(needed);
    return needed;
}

}  // namespace mechwright::linkage
