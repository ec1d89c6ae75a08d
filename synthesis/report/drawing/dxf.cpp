#include "synthesis/report/drawing/dxf.h"

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/mechanism/drawing/outlines.h"

namespace mechwright {

namespace {

std::string upper(std::string_view name) {
    std::string text(name);
    for (char& c : text)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c == ' ' ? '_' : c;
    return text;
}

std::string layer_table(const std::vector<std::string>& layers) {
    std::string text = fmt::format("  0\nSECTION\n  2\nTABLES\n  0\nTABLE\n  2\nLAYER\n 70\n{}\n", layers.size());
    constexpr int colours = 6;  // 1 to 6 of AutoCAD's colour index are the strong ones
    for (std::size_t i = 0; i < layers.size(); ++i)
        text += fmt::format("  0\nLAYER\n  2\n{}\n 70\n0\n 62\n{}\n  6\nCONTINUOUS\n", layers[i], 1 + i % colours);
    return text + "  0\nENDTAB\n  0\nENDSEC\n";
}

std::string point(int code, const Vector<double>& p) {
    return fmt::format(" {}\n{}\n {}\n{}\n {}\n0.0\n", code, p.x, code + 10, p.y, code + 20);
}

std::string polyline(const DxfCurve& curve) {
    std::string text =
        fmt::format("  0\nPOLYLINE\n  8\n{}\n 66\n1\n 70\n{}\n", curve.layer, curve.closed ? 1 : 0) + point(10, {0, 0});
    for (const ArcVertex& v : curve.vertices)
        text +=
            fmt::format("  0\nVERTEX\n  8\n{}\n", curve.layer) + point(10, v.at) + fmt::format(" 42\n{}\n", v.bulge);
    return text + fmt::format("  0\nSEQEND\n  8\n{}\n", curve.layer);
}

std::string curve_text(const DxfCurve& curve) {
    if (curve.vertices.size() != 2 || curve.closed || curve.vertices[0].bulge != 0) return polyline(curve);
    return fmt::format("  0\nLINE\n  8\n{}\n", curve.layer) + point(10, curve.vertices[0].at) +
           point(11, curve.vertices[1].at);
}

DxfCurve placed(const Outline& outline, const BodyPlace& place, std::string layer) {
    DxfCurve curve{std::move(layer), outline.vertices, outline.closed};
    for (ArcVertex& v : curve.vertices)
        v.at = in_drawing(place, v.at);
    return curve;
}

}  // namespace

std::string dxf_text(const std::vector<DxfCurve>& curves, const std::vector<DxfCircle>& circles) {
    std::vector<std::string> layers;
    const auto note = [&](const std::string& layer) {
        if (std::find(layers.begin(), layers.end(), layer) == layers.end()) layers.push_back(layer);
    };
    std::string entities = "  0\nSECTION\n  2\nENTITIES\n";
    for (const DxfCurve& curve : curves) {
        note(curve.layer);
        entities += curve_text(curve);
    }
    for (const DxfCircle& circle : circles) {
        note(circle.layer);
        entities += fmt::format("  0\nCIRCLE\n  8\n{}\n", circle.layer) + point(10, circle.centre) +
                    fmt::format(" 40\n{}\n", circle.radius);
    }
    return "  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1009\n  0\nENDSEC\n" + layer_table(layers) + entities +
           "  0\nENDSEC\n  0\nEOF\n";
}

std::string dxf_of(const FinishedDesign& design, const Scene& scene, double crank_angle) {
    std::vector<BodyPlace> places(scene.bodies.size());
    place_bodies(design, crank_angle, design.motion.assembly, places);
    std::vector<DxfCurve> curves;
    std::vector<DxfCircle> circles;
    const double pin = 0.3 * scene.symbol;
    const auto add = [&](const Outline& outline, const BodyPlace& place, std::string layer) {
        DxfCurve curve = placed(outline, place, std::move(layer));
        const auto radius = outline.layer == Layer::pitch ? outlines::radius_of(outline) : std::nullopt;
        if (radius)
            circles.push_back({curve.layer, 0.5 * (curve.vertices[0].at + curve.vertices[2].at), *radius});
        else
            curves.push_back(std::move(curve));
    };
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const Body& body = scene.bodies[b];
        for (const Outline& outline : body.outlines) {
            const bool own = outline.layer == Layer::link || outline.layer == Layer::block;
            add(outline, places[b], upper(own ? body.name : name_of(outline.layer)));
        }
        for (const Vector<double>& at : body.pins)
            circles.push_back({"PINS", in_drawing(places[b], at), pin});
    }
    for (const Outline& outline : scene.fixed)
        add(outline, {}, upper(name_of(outline.layer)));
    for (const Vector<double>& pivot : scene.pivots)
        circles.push_back({"PIVOTS", pivot, 2 * pin});
    for (const TargetPlace& target : design.targets)
        circles.push_back({"TARGETS", target.at, pin});
    return dxf_text(curves, circles);
}

}  // namespace mechwright
