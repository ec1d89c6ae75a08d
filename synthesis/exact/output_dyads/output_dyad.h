#pragma once
/// \file
/// The dyad that ends on the output of a function: a rod that hangs on a pin whose places are known, and the lever, on
/// a pivot whose link is known, whose angle is the output. A six-bar of Watt's second or Stephenson's third kind is
/// such a dyad behind a four-bar.
///
/// Seen from the lever this is a dyad that guides a body (poses/dyads.h). With the outer pin in E_i, the lever's pivot
/// in G and its x axis turned by R_i since the first accuracy point, the rod between E_i and G + R_i f keeps its
/// length:
/// |(E_i - G) / R_i - f| does. So the body with displacements d_i = (E_i - E_1) / R_i and T_i = 1 / R_i has the moving
/// pivot x = E_1 - G and the fixed one a = f, the arm of the lever at the first point. (Derivation.)

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/geometry/vector.h"
#include "analysis/numbers/unit_vector.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/target/function/function_target.h"

namespace mechwright {

/// Links and pins by their numbers in the structure.
struct OutputDyad {
    std::size_t step = 0;    ///< of the order
    std::size_t choice = 0;  ///< which of the sides it is closed on
    std::size_t rod = 0;
    std::size_t lever = 0;              ///< or what slides
    std::size_t outer = 0;              ///< the pin of the rod whose places are known
    std::size_t inner = 0;              ///< the pin of both
    std::size_t pivot = 0;              ///< the pin of the lever
    std::size_t carrier = 0;            ///< the link that has the pivot, or the line
    std::size_t slide = linkage::none;  ///< none of a lever
    double sense = 1;                   ///< -1: the output is the angle of the frame against the lever
    bool counts_from_rod = true;  ///< its side is that of the line from the outer pin to the pivot, else the reverse

    bool slides() const { return slide != linkage::none; }
};

/// The dyad of the one function that is asked of a linkage; nothing where its output is placed in another way.
std::optional<OutputDyad> output_dyad(const LinkageModel& model);

/// Along what a pin goes that a slide has, in the frame of the link of its line.
template <class T>
struct SlideLine {
    Vector<T> pin;    ///< where it is without displacement and offset
    Vector<T> along;  ///< a unit vector
};

template <class T>
SlideLine<T> slide_line(const LinkageModel& model, const OutputDyad& dyad, std::span<const T> dimensions) {
    const std::vector<T> numbers = numbers_of(model, dimensions);
    const linkage::Slide& slide = model.structure.slides[dyad.slide];
    const Vector<T> through = linkage::place_of<T>(slide.line.through, numbers),
                    own = linkage::place_of<T>(coordinates_on(model.structure.pins[dyad.inner], slide.link), numbers);
    return {through + turned(own, unit_at(numbers[slide.angle])), linkage::direction_of<T>(slide.line, numbers)};
}

/// What is known at the accuracy points, in the frame of the link that has the lever's pivot or the slide's line.
template <class T>
struct KnownPlaces {
    std::vector<Vector<T>> outer;  ///< places of the outer pin
    std::vector<Vector<T>> turns;  ///< the lever's x axis, as it is turned where the output's scale starts at 0
    std::vector<T> ways;           ///< of a slide its displacement there
};

/// At the points (share, part) of a function, whose scales are the four dimensions from `scales` on; nothing where the
/// linkage before the dyad does not close at one of them. Dimensions of the dyad itself have no part in it.
std::optional<KnownPlaces<double>> known_places(const LinkageModel& model, const OutputDyad& dyad,
                                                std::span<const double> dimensions, std::size_t scales,
                                                std::size_t assembly, std::span<const Vector<double>> points);
/// The same in fifty digits.
std::optional<KnownPlaces<Digits50>> known_places_again(const LinkageModel& model, const OutputDyad& dyad,
                                                        std::span<const Digits50> dimensions, std::size_t scales,
                                                        std::size_t assembly, std::span<const Vector<double>> points);

}  // namespace mechwright
