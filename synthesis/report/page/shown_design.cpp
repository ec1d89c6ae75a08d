#include "synthesis/report/page/shown_design.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/drawing/motion_plots.h"
#include "synthesis/report/page/tables.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "pages hold numbers with their lowest byte first");

constexpr double sketch_width = 640, most_sketch_height = 520;
constexpr double greatest_integer = 32767;

template <class Number>
std::string base64_of(const std::vector<Number>& numbers) {
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return base64(bytes);
}

std::int16_t integer(double value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -greatest_integer, greatest_integer)));
}

/// Where the bodies are in an assembly, at every angle.
Json places_of(const FinishedDesign& design, std::size_t bodies, const SvgView& view, std::size_t assembly,
               const std::vector<double>& angles) {
    std::vector<BodyPlace> places(bodies);
    std::vector<double> numbers;
    double farthest = 1;
    for (const double angle : angles) {
        const bool assembled = place_bodies(design, angle, assembly, places);
        for (const BodyPlace& place : places) {
            const Vector<double> at = assembled ? view.pixels(place.at) : Vector<double>{};
            const Vector<double> turn = assembled ? place.turn : Vector<double>{};
            numbers.insert(numbers.end(), {at.x, at.y, turn.x, turn.y});
            farthest = std::max({farthest, std::abs(at.x), std::abs(at.y)});
        }
    }
    const double scale = farthest / greatest_integer;
    std::vector<std::int16_t> integers;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        integers.push_back(integer(i % 4 < 2 ? numbers[i] / scale : numbers[i] * greatest_integer));
    return {{"scale", scale}, {"places", base64_of(integers)}};
}

Json assemblies_of(const FinishedDesign& design, std::size_t bodies, const SvgView& view,
                   const std::vector<double>& angles) {
    Json list = Json::array();
    const std::size_t own = design.motion.assembly;
    const auto& names = design.mechanism->assemblies;
    list.push_back(places_of(design, bodies, view, own, angles));
    list.back()["name"] = names.empty() ? std::string_view("") : names[own];
    if (names.size() == 2) {
        list.push_back(places_of(design, bodies, view, 1 - own, angles));
        list.back()["name"] = names[1 - own];
    }
    return list;
}

/// The turns of a motion, begun ones whole; of a page as many as do not make it slow to open.
int turns_of(const FinishedDesign& design) {
    constexpr double most = 16;
    if (input_unit(design) != Unit::angle) return 1;
    const double turns = (design.motion.to - design.motion.from) / (2 * std::numbers::pi);
    return static_cast<int>(std::clamp(std::ceil(turns - 1e-9), 1.0, most));
}

Json plots_of(const MotionPlots& plots) {
    Json list = Json::array();
    for (const MotionPlot& plot : plots.plots) {
        Json levels = Json::array(), curves = Json::array();
        for (const PlotLevel& level : plot.levels)
            levels.push_back({level.name, level.value});
        for (const MotionCurve& curve : plot.curves)
            curves.push_back({curve.name, base64_of(std::vector<float>(curve.values.begin(), curve.values.end()))});
        list.push_back({{"title", plot.title}, {"unit", plot.unit}, {"levels", levels}, {"curves", curves}});
    }
    return list;
}

}  // namespace

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= count ? digits[group >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

ShownParts shown_parts(const DesignToShow& shown, int steps_of_turn, bool with_thumbnail) {
    constexpr double fineness = 2e-4;  // of curves: an eighth of a pixel at most
    const FinishedDesign& design = shown.design;
    const int steps = steps_of_turn * turns_of(design);
    const Scene scene = scene_of(design, fineness);
    const SvgView view = view_of(scene, sketch_width, most_sketch_height);
    ShownParts parts;
    parts.view_box = fmt::format("0 0 {:.0f} {:.0f}", view.width, view.height);
    const std::string bodies = svg_bodies(design, scene, view, pictured_angle(design), design.motion.assembly);
    parts.drawing =
        svg_fixed(design, scene, view) + svg_ghosts(design, scene, view) + "<g id=\"bodies\">" + bodies + "</g>";
    if (with_thumbnail)
        parts.thumbnail = fmt::format("<svg viewBox=\"{}\" aria-hidden=\"true\" class=\"small\">{}{}</svg>",
                                      parts.view_box, svg_fixed(design, scene, view), bodies);
    parts.tables = tables_of(shown.document);

    const std::vector<double> angles = even_angles(design, steps);
    Json names = Json::array();
    for (const Body& body : scene.bodies)
        names.push_back(body.name);
    const MotionPlots plots = motion_plots(design, shown.document, steps);
    parts.motion = {{"from", plots.angles.front()},
                    {"to", plots.angles.back()},
                    {"start", in_file_unit(pictured_angle(design), input_unit(design), design.units)},
                    {"name", plots.angle_name},
                    {"unit", plots.angle_unit},
                    {"closed", design.motion.full_turn},
                    {"steps", steps},
                    {"bodies", names},
                    {"assemblies", assemblies_of(design, scene.bodies.size(), view, angles)},
                    {"plots", plots_of(plots)}};
    return parts;
}

}  // namespace mechwright
