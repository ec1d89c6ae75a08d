#pragma once
/// \file
/// The links of a linkage as bodies: bars, plates, slots, blocks on their slides, wheels by their pitch circles.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/linkage/placing/place.h"
#include "analysis/linkage/structure/structure.h"
#include "synthesis/mechanism/drawing/body.h"

namespace mechwright {

/// What something passes on its line.
struct Extent {
    double from = 0;
    double to = 0;
};

/// What bodies are made from: a linkage of given numbers. Lengths of bodies, displacements and distances here are after
/// `scale`, numbers before it.
struct LinkageShape {
    const linkage::Structure& structure;
    std::span<const double> numbers;
    std::span<const std::string> links;
    std::span<const std::string> pins;
    double scale = 1;
    std::size_t first_body = 1;    ///< the link that is body 0
    std::vector<Extent> slides{};  ///< of each the displacements
    std::vector<Extent> slots{};   ///< of each where its pin goes, from the line's place `through`
    std::vector<Extent> arcs{};    ///< of each circular slot the directions of its pin on the link that has it, radians

    Vector<double> at(const linkage::Coordinates& own) const { return scale * linkage::place_of(own, numbers); }
};

/// The line of a slide or slot in the frame of its link; of a slide where the origin of what slides is.
struct GuidingLine {
    Vector<double> through;
    Vector<double> direction;

    Vector<double> at(double displacement) const { return through + displacement * direction; }
};

GuidingLine slide_line(const LinkageShape& shape, std::size_t slide);
GuidingLine slot_line(const LinkageShape& shape, std::size_t slot);

/// The displacement of a slide, and how far the pin of a slot is along its line, in a pose (before `scale`).
double slide_displacement(const LinkageShape& shape, std::size_t slide, const linkage::Pose<double>& pose);
double slot_displacement(const LinkageShape& shape, std::size_t slot, const linkage::Pose<double>& pose);

/// The direction, from a circular slot's centre on the link that has it, in which its pin is in a pose; within half a
/// turn of `near`.
double arc_direction(const LinkageShape& shape, std::size_t slot, const linkage::Pose<double>& pose, double near = 0);

/// A wheel on a link.
struct Wheel {
    Vector<double> centre;
    double radius;
};

/// The wheels of a gear or belt on its first and second link, which turn about pins of the carrier: pitch circles that
/// touch, R1 + R2 = d where they turn against each other, abs(R1 - R2) = d where one is inside the other; of a belt,
/// whose radii nothing says but their ratio, within 0.6 d together. Absent where both turn about one place, or not
/// about a pin of the carrier.
std::optional<std::array<Wheel, 2>> wheels_of(const LinkageShape& shape, const linkage::Gear& gear);

/// The wheel of a rack, in its link's frame, and the rack's pitch line in the frame of the link that slides, as far as
/// they touch. Absent where the wheel does not turn about a pin of the link that the rack slides on.
struct RackWheel {
    Wheel wheel;
    Vector<double> from, to;
};
std::optional<RackWheel> rack_of(const LinkageShape& shape, const linkage::Rack& rack);

/// Which body a link is where link `first` is body 0; the_ground for the frame.
std::size_t body_of(std::size_t first, std::size_t link);

/// A link in its own frame; the frame without a plate, on the ground's layer. Points that are on this link only guide
/// something; pins are joints. `symbol` as in Drawing::bodies.
Body link_body(const LinkageShape& shape, std::size_t link, double symbol);

}  // namespace mechwright
