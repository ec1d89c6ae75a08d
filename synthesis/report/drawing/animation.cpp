#include "synthesis/report/drawing/animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "synthesis/report/drawing/raster.h"
#include "synthesis/report/files/gnuplot.h"
#include "synthesis/report/files/temporary_folder.h"

namespace mechwright {

namespace {

constexpr double fineness = 1e-4;  // of curves, over the extent

/// A scene without names, and where its bodies are in the course of the motion; a motion that is no full turn goes back
/// to its start.
struct Moving {
    Scene scene;
    std::vector<std::vector<BodyPlace>> places;
};

Moving moving(const FinishedDesign& design, int steps) {
    Moving all{scene_of(design, fineness), {}};
    for (Body& body : all.scene.bodies)
        body.labels.clear();
    std::vector<BodyPlace> places(all.scene.bodies.size());
    for (const double angle : even_angles(design, steps))
        if (place_bodies(design, angle, design.motion.assembly, places)) all.places.push_back(places);
    if (!design.motion.full_turn)
        for (std::size_t i = all.places.size(); i-- > 1;)
            all.places.push_back(all.places[i - 1]);
    return all;
}

/// What stands in a group that goes through the values of a transformation; at the first one where nothing moves.
std::string animated(std::string_view type, const std::string& values, double seconds, const std::string& content) {
    return fmt::format(
        "<g transform=\"{0}({1})\"><animateTransform attributeName=\"transform\" type=\"{0}\" "
        "dur=\"{2:g}s\" repeatCount=\"indefinite\" values=\"{3}\"/>{4}</g>",
        type, values.substr(0, values.find(';')), seconds, values, content);
}

/// A body that is moved and, within that, turned.
std::string moving_body(const Moving& all, std::size_t b, const SvgView& view, double seconds) {
    std::string shifts, turns;
    double angle = 0;
    for (const std::vector<BodyPlace>& places : all.places) {
        const BodyPlace& place = places[b];
        const Vector<double> at = view.pixels(place.at);
        const double turn = std::atan2(-place.turn.y, place.turn.x);
        angle += std::remainder(turn - angle, 2 * std::numbers::pi);
        const char* between = shifts.empty() ? "" : ";";
        shifts += fmt::format("{}{:.2f} {:.2f}", between, at.x, at.y);
        turns += fmt::format("{}{:.3f}", between, angle * 180 / std::numbers::pi);
    }
    return animated("translate", shifts, seconds,
                    animated("rotate", turns, seconds, svg_body(all.scene.bodies[b], view)));
}

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream out(file, std::ios::binary);
    out << bytes;
    if (!out.flush()) throw ChartFault("cannot write " + file.string());
}

}  // namespace

std::string svg_animation(const FinishedDesign& design, const SvgPicture& picture, double seconds) {
    constexpr int steps = 120;
    const Moving all = moving(design, steps);
    const SvgView view = view_of(all.scene, picture.width, picture.width);
    std::string text = svg_fixed(design, all.scene, view) + "\n";
    for (std::size_t b = 0; b < all.scene.bodies.size(); ++b)
        text += moving_body(all, b, view, seconds);
    return svg_file(picture.title, picture.width, view.height, text);
}

std::string gif_animation(const FinishedDesign& design, const SvgPicture& picture, double seconds) {
    constexpr int frames_per_second = 20, most_frames = 120;
    const int round = std::clamp(static_cast<int>(std::lround(seconds * frames_per_second)), 2, most_frames);
    const Moving all = moving(design, design.motion.full_turn ? round : (round + 1) / 2);
    const SvgView view = view_of(all.scene, picture.width, picture.width);
    const std::string fixed = svg_fixed(design, all.scene, view);
    const TemporaryFolder folder;
    std::string script = "unset border\nunset tics\nunset key\nset margins 0, 0, 0, 0\nset autoscale fix\n";
    // The last place is the first one again.
    for (std::size_t i = 0; i + 1 < all.places.size(); ++i) {
        const std::filesystem::path frame = folder.path / fmt::format("{}.png", i);
        const std::string svg =
            svg_file(picture.title, picture.width, view.height, fixed + svg_bodies(all.scene, view, all.places[i]));
        write_bytes(frame, rasterised(svg, RasterFormat::png, 1));
        script += fmt::format("plot {} binary filetype=png with rgbimage\n", gnuplot_text(frame.string()));
    }
    const Vector<double> size = svg_file_size(picture.width, view.height);
    return gnuplot_picture(script, {.format = Picture::Format::gif,
                                    .width = static_cast<int>(std::lround(size.x)),
                                    .height = static_cast<int>(std::lround(size.y)),
                                    .delay = seconds / static_cast<double>(all.places.size() - 1)});
}

}  // namespace mechwright
