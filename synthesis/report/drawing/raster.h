#pragma once
/// \file
/// SVG turned into other kinds of pictures, by rsvg-convert.

#include <optional>
#include <string>
#include <string_view>

namespace mechwright {

enum class RasterFormat { png, pdf };

/// What the ending of a file's name asks for; nothing for any other ending.
std::optional<RasterFormat> raster_format_of(std::string_view file);

/// The picture in the format; a PNG has `zoom` times as many pixels each way as the SVG has units. Throws ChartFault
/// where there is no rsvg-convert or it fails.
std::string rasterised(const std::string& svg, RasterFormat format, int zoom = 2);

/// The svg element alone of an SVG file, to stand inside another.
std::string svg_element(const std::string& svg);

}  // namespace mechwright
