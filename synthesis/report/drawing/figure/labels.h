#pragma once
/// \file
/// Texts that stand where they cover nothing: each has places where it could be, the best first.

#include <string>
#include <string_view>
#include <vector>

#include "synthesis/mechanism/drawing/body.h"
#include "synthesis/report/drawing/svg.h"

namespace mechwright {

/// A text in a picture, in pixels.
struct TextBox {
    std::string text;
    std::string_view kind;  ///< its class in SVG
    Vector<double> middle{};
    double width = 0;
    double height = 0;
};

/// A text with the room that it needs, somewhere.
TextBox text_box(std::string text, std::string_view kind, double letter_size);

/// A text in lines that are not wider than so many pixels.
std::vector<std::string> folded_text(std::string_view text, double width);

bool overlap(const TextBox& a, const TextBox& b);

/// A straight stroke of a picture, and how bad it is to write across it.
struct Stroke {
    Vector<double> from, to;
    double weight = 1;
};

/// An outline where it is, as straight strokes in pixels.
std::vector<Stroke> strokes_of(const Outline& outline, const BodyPlace& place, const SvgView& view);

/// How long the part of a stroke is that a box covers.
double covered(const TextBox& box, const Stroke& stroke);

/// Finds room for one text after the other.
struct Labels {
    std::vector<Stroke> strokes;
    std::vector<TextBox> placed;

    /// How far the middle of a text has to be from a line of this normal, to stand beside it.
    static double clearance(const Vector<double>& normal, const TextBox& box);
    /// Places beside a line, the middle first.
    static std::vector<Vector<double>> beside_line(const Vector<double>& from, const Vector<double>& to,
                                                   const TextBox& box);

    /// The text at that of its places where it covers least; a later place has to cover clearly less.
    const TextBox& place(TextBox box, const std::vector<Vector<double>>& places);
};

}  // namespace mechwright
