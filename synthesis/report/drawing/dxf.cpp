#include "synthesis/report/drawing/dxf.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

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

/// The header, with the unit of lengths by its number there; 0 where it has none.
std::string header(std::string_view unit) {
    constexpr std::array<std::pair<std::string_view, int>, 8> units{
        {{"in", 1}, {"ft", 2}, {"mm", 4}, {"cm", 5}, {"m", 6}, {"um", 13}, {"\u00b5m", 13}, {"dm", 14}}};
    const auto known = std::find_if(units.begin(), units.end(), [&](const auto& one) { return one.first == unit; });
    return fmt::format("  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1009\n  9\n$INSUNITS\n 70\n{}\n  0\nENDSEC\n",
                       known == units.end() ? 0 : known->second);
}

/// What is no ASCII as \\U+XXXX, which stands for it in any code page; beyond those a question mark.
std::string in_code_page(std::string_view utf8) {
    std::string text;
    for (std::size_t i = 0; i < utf8.size(); ++i) {
        const auto byte = static_cast<unsigned char>(utf8[i]);
        const int following = byte < 0xC0 ? 0 : byte < 0xE0 ? 1 : byte < 0xF0 ? 2 : 3;
        if (following == 0) {
            if (byte >= 0x20 && byte < 0x7F) text += utf8[i];
            continue;
        }
        unsigned code = byte & (0x3Fu >> following);
        for (int k = 0; k < following && i + 1 < utf8.size(); ++k)
            code = code << 6 | (static_cast<unsigned char>(utf8[++i]) & 0x3Fu);
        text += code < 0x10000 ? fmt::format("\\U+{:04X}", code) : "?";
    }
    return text;
}

DxfCurve placed(const Outline& outline, const BodyPlace& place, std::string layer) {
    DxfCurve curve{std::move(layer), outline.vertices, outline.closed};
    for (ArcVertex& v : curve.vertices)
        v.at = in_drawing(place, v.at);
    return curve;
}

}  // namespace

std::string dxf_text(const DxfDrawing& drawing) {
    std::vector<std::string> layers;
    const auto note = [&](const std::string& layer) {
        if (std::find(layers.begin(), layers.end(), layer) == layers.end()) layers.push_back(layer);
    };
    std::string entities = "  0\nSECTION\n  2\nENTITIES\n";
    for (const DxfCurve& curve : drawing.curves) {
        note(curve.layer);
        entities += curve_text(curve);
    }
    for (const DxfCircle& circle : drawing.circles) {
        note(circle.layer);
        entities += fmt::format("  0\nCIRCLE\n  8\n{}\n", circle.layer) + point(10, circle.centre) +
                    fmt::format(" 40\n{}\n", circle.radius);
    }
    for (const DxfText& text : drawing.texts) {
        note(text.layer);
        entities += fmt::format("  0\nTEXT\n  8\n{}\n", text.layer) + point(10, text.at) +
                    fmt::format(" 40\n{}\n  1\n{}\n", text.height, in_code_page(text.text));
    }
    return header(drawing.unit) + layer_table(layers) + entities + "  0\nENDSEC\n  0\nEOF\n";
}

namespace {

/// The mechanism's drawing while it is put together.
struct DxfOfScene {
    const Scene& scene;
    std::span<const BodyPlace> places;
    DxfDrawing drawing{};

    void add(const Outline& outline, const BodyPlace& place, std::string layer) {
        DxfCurve curve = placed(outline, place, std::move(layer));
        if (const auto radius = outlines::radius_of(outline))
            drawing.circles.push_back({curve.layer, 0.5 * (curve.vertices[0].at + curve.vertices[2].at), *radius});
        else
            drawing.curves.push_back(std::move(curve));
    }
    void add_name(const Vector<double>& beside, const std::string& name) {
        const double gap = 0.6 * scene.symbol;
        drawing.texts.push_back({"NAMES", beside + Vector<double>{gap, gap}, scene.symbol, name});
    }
    void add_body(const Body& body, const BodyPlace& place) {
        for (const Outline& outline : body.outlines) {
            const bool own = outline.layer == Layer::link || outline.layer == Layer::block;
            add(outline, place, upper(own ? body.name : name_of(outline.layer)));
        }
        for (const Vector<double>& at : body.pins)
            drawing.circles.push_back({"PINS", in_drawing(place, at), 0.3 * scene.symbol});
        for (const Label& label : body.labels)
            add_name(in_drawing(place, label.at), label.text);
        if (body.pins.empty()) return;
        const Vector<double> middle = body.pins.size() > 1 ? 0.5 * (body.pins[0] + body.pins[1]) : body.pins[0];
        add_name(in_drawing(place, middle), body.name);
    }
};

}  // namespace

std::string dxf_of(const FinishedDesign& design, const Scene& scene, double crank_angle) {
    std::vector<BodyPlace> places(scene.bodies.size());
    place_bodies(design, crank_angle, design.motion.assembly, places);
    DxfOfScene made{scene, places};
    made.drawing.unit = design.units.length;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        made.add_body(scene.bodies[b], places[b]);
    for (const Outline& outline : scene.fixed)
        made.add(outline, {}, upper(name_of(outline.layer)));
    for (const Label& label : scene.ground.labels)
        made.add_name(label.at, label.text);
    for (const Vector<double>& pivot : scene.pivots)
        made.drawing.circles.push_back({"PIVOTS", pivot, 0.6 * scene.symbol});
    for (const TargetPlace& target : design.targets)
        made.drawing.circles.push_back({"TARGETS", target.at, 0.3 * scene.symbol});
    return dxf_text(made.drawing);
}

}  // namespace mechwright
