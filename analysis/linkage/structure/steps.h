#pragma once
/// \file
/// A linkage as one flat list of plain steps, each of which places what the steps before it allow: what place.h runs
/// through at every crank angle. order.h makes the list.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mechwright::linkage {

/// One linear condition on where a link of known direction is, that it has with placed links or pins.
struct Tie {
    enum class Kind : std::uint8_t {
        slides,   ///< it slides on a line of a placed link
        carries,  ///< a placed link slides on its line
        in_slot,  ///< a pin of it is in a slot of a placed link
        over_pin  ///< its slot is over a placed pin
    };
    Kind kind = Kind::slides;
    std::size_t joint = 0;  ///< the slide or slot
    std::size_t base = 0;   ///< the placed link; of `over_pin` the placed pin
};

/// Where a pin can be before it is joined to something else.
struct Locus {
    enum class Kind : std::uint8_t {
        circle,  ///< its link turns about a placed pin
        line,    ///< its link, of known direction, has a tie
        slot     ///< it is in a slot of a placed link
    };
    Kind kind = Kind::circle;
    std::size_t link = 0;    ///< that is placed with the pin; of a slot the one it is in
    std::size_t centre = 0;  ///< the placed pin
    Tie tie{};               ///< of a slot its joint
    /// Of a circle whose pin is on another link, which a drive slides along `link` or `link` along it: that drive.
    std::size_t extended = static_cast<std::size_t>(-1);
};

inline constexpr std::size_t none = static_cast<std::size_t>(-1);

/// How a dyad of two links of constant lengths hangs between a pin that a driven link carries round and one of the
/// frame.
struct CarriedRound {
    std::size_t pin = none;     ///< the outer pin that goes round
    std::size_t centre = none;  ///< the pin of the frame about which it does
    std::size_t link = none;    ///< what carries it, driven against the frame
    std::size_t input = none;   ///< the drive
    std::size_t fixed = none;   ///< the other outer pin, on the frame

    bool exists() const { return pin != none; }
};

/// From where a link carries a pin.
enum class CarriedFrom : std::uint8_t {
    origin,  ///< of the link
    pin,     ///< the placed pin on which the link hangs
    first,   ///< the same, along the first link of the dyad before, which it is
    second   ///< along the second one
};

struct Step {
    enum class Kind : std::uint8_t {
        driven,   ///< direction: against another link by an input
        held,     ///< direction: by a slide to a link of known direction
        geared,   ///< direction: by a gear to two links of known turn
        wheeled,  ///< direction: by the displacement of a placed rack
        slid,     ///< place: by the displacement of a slide that is an input
        racked,   ///< place: by the displacement of a rack whose wheel is turned
        pinned,   ///< place: a pin of it is placed
        tied,     ///< place: two ties
        dyad,     ///< a pin on two loci, and the links that it places
        through,  ///< a link on a placed pin whose line passes another one at a distance
        carried,  ///< a pin by its placed link
        unwound,  ///< the turn of a placed link from its direction
        stopped,  ///< nothing: how far a joint or a drive is from a stop
        together  ///< the links of a larger group (Order::larger)
    };
    Kind kind = Kind::driven;
    std::size_t link = none;   ///< that is placed or turned
    std::size_t other = none;  ///< the link against which; of `through` the link that slides, if one does
    std::size_t pin = none;    ///< that is placed; of `pinned` and `through` the placed one
    /// Of `through` the pin that the line passes; of `carried` the pin of the dyad before; of `stopped` the centre of
    /// an arc.
    std::size_t far_pin = none;
    std::size_t joint = none;   ///< the slide, slot, gear or rack; of `stopped` with `pin` the slot, with `far_pin` the
                                ///< circular one, else the slide; of `together` which larger group
    std::size_t input = none;   ///< the drive; of `racked` the rack
    bool reversed = false;      ///< the joint names the placed link second; of `stopped` it is the greatest value
    std::size_t choice = none;  ///< which of the sides decides
    std::size_t margin = none;  ///< which of the margins it has
    Locus first{}, second{};  ///< of a dyad: a circle before a line; of a gear its two links (`other` is its carrier);
                              ///< of `wheeled` slide and line, of `racked` wheel and carrier; of `carried` about which
                              ///< pin the link turns
    CarriedFrom from = CarriedFrom::origin;  ///< of `carried`
    CarriedRound round{};                    ///< of a dyad that hangs so

    /// Whether it places something where two lines meet: its margin is the sine of the angle between them, no length.
    bool is_of_lines() const { return kind == Kind::tied || (kind == Kind::dyad && first.kind != Locus::Kind::circle); }
    /// Whether a radius of a dyad follows from an input.
    bool is_extended() const { return first.extended != none || second.extended != none; }
    /// Whether its margin is an angle: how far a drive that turns is from a stop.
    bool is_of_angle() const { return kind == Kind::stopped && joint == none; }
};

/// One equation of a larger group: what a joint or drive says of the places of its links.
struct LoopEquation {
    enum class Kind : std::uint8_t {
        pin_x,  ///< the pin `joint` is at one place of both links
        pin_y,
        slide_turn,  ///< the slide `joint`: the first link is at its angle to the second
        slide_line,  ///< its origin is on the line of the second
        slot,        ///< the slot `joint`: its pin, of the first link, is on the line of the second
        gear,        ///< first, second, carrier
        rack,        ///< what slides, what it slides on, wheel, carrier
        drive_turn,  ///< the drive `joint`: the angle from the second link to the first
        drive_slide  ///< the displacement of the first link on the second
    };
    Kind kind = Kind::pin_x;
    std::size_t joint = 0;
    std::size_t links[4]{none, none, none, none};
};

/// A coordinate of a link.
struct LinkUnknown {
    std::size_t link = 0;
    int part = 0;  ///< 0, 1: x and y of its origin; 2: its turn
};

/// What a larger group has to solve: as many equations as unknowns.
struct LargerGroup {
    std::vector<LinkUnknown> unknowns{};
    std::vector<LoopEquation> equations{};
};

/// How some links are placed together.
struct Group {
    enum class Kind : std::uint8_t {
        drive,   ///< one link by an input
        geared,  ///< one link by a gear, belt or rack
        guided,  ///< one link whose direction is known, by one position
        rrr,
        rrp,
        rpr,
        rpp,
        prp,
        larger  ///< no dyad: placed by solving its equations together
    };
    Kind kind = Kind::drive;
    std::vector<std::size_t> links{};
    std::size_t pin = none;            ///< the inner pin of a dyad
    std::size_t choice = none;         ///< which of the sides decides, where there are two
    std::size_t outer[2]{none, none};  ///< pins from which a side is counted: two of rrr, the first of rrp and rpr
    std::size_t joint = none;          ///< of rrp and rpr: the slide, or the slot, whose line it is
    bool by_slide = false;             ///< the joint is a slide, else a slot
    std::size_t larger = none;         ///< which of Order::larger

    /// How many there are; 0 of a larger group, whose number depends on the dimensions and the input.
    int assemblies() const { return kind == Kind::larger ? 0 : choice == none ? 1 : 2; }
};

/// A linkage in the order in which it is placed.
struct Order {
    std::vector<Step> steps{};
    std::vector<Group> groups{};
    std::size_t choices = 0;  ///< dyads with two assemblies
    std::size_t margins = 0;
    std::size_t stops =
        0;  ///< of the margins the last so many, which have only one side each: `outer` and `inner` are it
    std::vector<LargerGroup> larger{};

    /// Those of larger groups are among them.
    std::size_t margins_of_dyads() const { return margins - stops; }
    bool is_stop(std::size_t margin) const { return margin >= margins_of_dyads(); }
    bool has_dyad_margins() const { return margins_of_dyads() > larger.size(); }

    /// Whether every group is placed by closed form.
    bool closed() const { return larger.empty(); }
};

/// The margin that a group has, none if it has none.
inline std::size_t margin_of(const Order& order, const Group& group) {
    for (const Step& step : order.steps) {
        if (step.margin == none) continue;
        const bool by_pin = group.pin != none && group.choice == step.choice &&
                            (step.kind == Step::Kind::dyad ? step.pin : step.far_pin) == group.pin;
        const bool by_link = group.pin == none && step.kind == Step::Kind::tied &&
                             std::find(group.links.begin(), group.links.end(), step.link) != group.links.end();
        if (by_pin || by_link) return step.margin;
    }
    return none;
}

inline const Step& step_of(const Order& order, std::size_t margin) {
    return *std::find_if(order.steps.begin(), order.steps.end(),
                         [margin](const Step& step) { return step.margin == margin; });
}

/// The step of a larger group that has this margin; null if it is another's.
inline const Step* step_together(const Order& order, std::size_t margin) {
    for (const Step& step : order.steps)
        if (step.margin == margin && margin != none) return step.kind == Step::Kind::together ? &step : nullptr;
    return nullptr;
}

inline bool is_of_lines(const Order& order, std::size_t margin) { return step_of(order, margin).is_of_lines(); }

/// Whether a margin is a length.
inline bool is_length(const Order& order, std::size_t margin) {
    const Step& step = step_of(order, margin);
    return !step.is_of_lines() && !step.is_of_angle() && step.kind != Step::Kind::together;
}

/// Whether some dyad closes by lengths, or some displacement has stops: of two lines there is a point but where they
/// are parallel.
inline bool closes_by_lengths(const Order& order) {
    for (std::size_t i = 0; i < order.margins; ++i)
        if (is_length(order, i)) return true;
    return false;
}

}  // namespace mechwright::linkage
