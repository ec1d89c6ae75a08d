#pragma once
/// \file
/// What a point or a direction of a linkage depends on, as one flat list of plain steps: each makes one thing, a place,
/// a direction or a number, of others that are made already. Everything stands in one row of numbers, a vector in two
/// of them, so that a step names what it takes and makes by position alone. needed.h makes the list, once for each
/// structure; needed_place.h runs through it, needed_back.h back.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mechwright::linkage {

/// A position in the row.
using Spot = std::uint32_t;
inline constexpr Spot no_spot = static_cast<Spot>(-1);

/// What a step makes of what it takes; vectors in capitals. Angles in radians, lengths in the unit of the numbers.
struct PlainStep {
    enum class Kind : std::uint8_t {
        pair,          ///< (a, b)
        unit,          ///< (cos a, sin a)
        scaled,        ///< a B
        less,          ///< A - B
        negated,       ///< -A
        offset,        ///< A + b left(C)
        reached,       ///< A + b C
        arm,           ///< A / |A| and |A|
        line,          ///< the same, and (0, 0) for (0, 0)
        height,        ///< a + B x C
        turned,        ///< A B as complex numbers
        turned_back,   ///< A by the conjugate of B
        carried,       ///< A + B C
        hung,          ///< A - B C
        sum,           ///< a + b
        difference,    ///< a - b
        displacement,  ///< A . (B - C)
        circles,     ///< centres A and B, radii c and d, side e: both directions to the pin, margins, sine between them
        round_dyad,  ///< what a RoundDyad is: arm A, base B, lengths c and d; `first`: the first pin is fixed
        round_circles,  ///< as circles, of a dyad that is carried round, with the crank's x axis F and the numbers g of
                        ///< it
        circle_line,    ///< centre A, line through B along C, radius d, side e: the pin, its direction, margins, run
        meeting,        ///< lines through A along B, through C along D: where, margins
        passing,  ///< pins A and B, line's direction C, height d, side e: the x axis, margins, run, inverse distance
        geared_second,   ///< first a, second b, carrier c, ratio d, phase e of a gear: the turn of its second link
        geared_first,    ///< ... of its first
        geared_carrier,  ///< ... of its carrier
        rack_turn,       ///< displacement a, phase b, radius c
        rack_way,        ///< wheel a, carrier b, radius c, phase d
        unwound          ///< the turn of a link by its x axis A
    };
    Kind kind = Kind::pair;
    bool first = true, second = true;  ///< of circles: which of the two directions are needed
    std::uint32_t link = 0;            ///< of `unwound`
    Spot in[7]{no_spot, no_spot, no_spot, no_spot, no_spot, no_spot, no_spot};
    Spot out = 0;

    bool is_of_circles() const { return kind == Kind::circles || kind == Kind::round_circles; }
};

/// Both sides of one margin.
struct MarginSpots {
    Spot outer = 0;
    Spot inner = 0;
};

/// All that is needed for what is asked of a linkage. The row begins with (0, 0), the origin of the frame, and (1, 0),
/// its x axis; then come for each drive its input with cosine and sine, the sides, the numbers, and what is made.
struct Needed {
    static constexpr Spot origin = 0, axis = 2, first_drive = 4;

    std::vector<PlainStep> steps{};
    std::size_t moving = 0;  ///< the first that depends on an input; those before it are run once for each design
    std::uint32_t drives = 0, sides = 0, numbers = 0;
    std::size_t size = 0;                ///< of the row
    std::vector<MarginSpots> margins{};  ///< of all dyads and stops, where they are asked for
    std::vector<bool> turning{};         ///< [drive]: cosine and sine of the input are needed
    Spot point = no_spot;                ///< the place of the pin that is asked for
    Spot along = no_spot;                ///< the x axis of the link that is asked for
    bool closed = true;                  ///< false: a larger group is among what is needed; there are no steps

    Spot drive(std::size_t i) const { return first_drive + 3 * static_cast<Spot>(i); }
    Spot side(std::size_t i) const { return drive(drives) + static_cast<Spot>(i); }
    Spot number(std::size_t i) const { return side(sides) + static_cast<Spot>(i); }
};

}  // namespace mechwright::linkage
