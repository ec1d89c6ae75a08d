#pragma once
/// \file
/// Pictures of a mechanism as SVG.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/report/drawing/scene.h"

namespace mechwright {

/// A text (UTF-8) as it stands in HTML, SVG and their attributes, without the control characters that these cannot
/// hold.
std::string escaped(std::string_view text);

/// How the drawing lies in the picture: pixels = origin + scale (x, -y).
struct SvgView {
    double scale = 1;
    Vector<double> origin;
    double width = 0;
    double height = 0;

    Vector<double> pixels(const Vector<double>& p) const { return {origin.x + scale * p.x, origin.y - scale * p.y}; }
};

/// The whole scene in a picture of a width; not higher than `most_height`.
SvgView view_of(const Scene& scene, double width, double most_height);

/// "matrix(...)": what brings a body's outlines, drawn in its own frame in pixels, to its place.
std::string svg_matrix(const SvgView& view, const BodyPlace& place);

/// What does not move: ground and paths; and with the design its targets with their errors.
std::string svg_fixed(const Scene& scene, const SvgView& view);
std::string svg_fixed(const FinishedDesign& design, const Scene& scene, const SvgView& view);

/// One body in its own frame, in pixels; its names stand upright where it is not turned.
std::string svg_body(const Body& body, const SvgView& view);

/// The bodies, each a group of class "body" with the name of the body, at the crank angle.
std::string svg_bodies(const FinishedDesign& design, const Scene& scene, const SvgView& view, double crank_angle,
                       std::size_t assembly);

/// The same for bodies that are somewhere.
std::string svg_bodies(const Scene& scene, const SvgView& view, std::span<const BodyPlace> places);

/// The limit positions, in groups of class "ghost".
std::string svg_ghosts(const FinishedDesign& design, const Scene& scene, const SvgView& view);

/// An SVG file with a title above its content (SVG, `height` high).
std::string svg_file(std::string_view title, double width, double height, std::string_view content);

/// Width and height of such a file.
Vector<double> svg_file_size(double width, double height);

/// A picture that stands alone, at the start of the motion, with its title above it, a scale, and `below` (SVG,
/// `below_height` high) beneath; one that is not small has the names and lengths of links.
struct SvgPicture {
    std::string title;
    double width = 640;
    std::string below;
    double below_height = 0;
    std::optional<double> at{};              ///< the crank angle; else pictured_angle
    std::vector<std::string> title_block{};  ///< rows below all, for drawings on paper
    std::vector<Label> marks{};  ///< places in the drawing; those that are too far away to be shown are left out
};
std::string svg_picture(const FinishedDesign& design, const SvgPicture& picture);

/// The crank angle at which pictures show a design: the start of its motion, or of its input range.
double pictured_angle(const FinishedDesign& design);

}  // namespace mechwright
