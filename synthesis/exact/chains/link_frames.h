#pragma once
/// \file
/// How the links of a linkage lie in the drawing where places of their pins are known there: their frames, as far as
/// given numbers say them.

#include <complex>
#include <optional>
#include <vector>

#include "synthesis/exact/chains/link_numbers.h"

namespace mechwright {

/// The frame of a link in the drawing; a length of 1 on it is `size` there.
struct LinkFrame {
    std::complex<double> origin;
    std::complex<double> direction;  ///< of its x axis, of length 1
    double size = 1;

    std::complex<double> on_link(const std::complex<double>& drawn) const {
        return (drawn - origin) / (size * direction);
    }
};

/// A pin that is known, on a link.
struct KnownPin {
    linkage::Coordinates at;
    std::complex<double> drawn;
};

/// A line of a link: what its angle is, and how it runs in the drawing.
struct KnownLine {
    Affine angle;
    std::complex<double> along;
};

struct LinkReader {
    const LinkageModel& model;
    LinkNumbers numbers;
    double size;  ///< of a length of 1 of the links, in the drawing

    /// How a link may lie in the drawing: its directions where they are given, else by two pins or a line.
    std::vector<LinkFrame> frames_of(const std::vector<KnownPin>& pins, const std::optional<KnownLine>& line = {},
                                     const std::optional<std::complex<double>>& given = {}) const;

    /// The frame, whose placement may be given.
    std::vector<LinkFrame> frames_of_frame(const std::vector<KnownPin>& pins,
                                           const std::optional<KnownLine>& line = {}) const;

    const linkage::Coordinates& at(std::size_t pin, std::size_t link) const {
        return coordinates_on(model.structure.pins[pin], link);
    }
};

}  // namespace mechwright
