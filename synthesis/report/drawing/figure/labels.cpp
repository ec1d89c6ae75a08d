#include "synthesis/report/drawing/figure/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "synthesis/problem/text.h"

namespace mechwright {

TextBox text_box(std::string text, std::string_view kind, double letter_size) {
    constexpr double width_of_letter = 0.6, height_of_letter = 1.15;
    const double letters = reading::count_characters(text);
    return {std::move(text), kind, {}, width_of_letter * letter_size * letters, height_of_letter * letter_size};
}

std::vector<std::string> folded_text(std::string_view text, double width) {
    constexpr double letter_width = 7.3;  // of the sans-serif that figures are written in, bold, on average
    std::vector<std::string> lines;
    std::istringstream words{std::string(text)};
    for (std::string word; words >> word;)
        if (!lines.empty() && letter_width * (reading::count_characters(lines.back() + word) + 1) < width)
            lines.back() += " " + word;
        else
            lines.push_back(word);
    return lines;
}

bool overlap(const TextBox& a, const TextBox& b) {
    return std::abs(a.middle.x - b.middle.x) < 0.5 * (a.width + b.width) &&
           std::abs(a.middle.y - b.middle.y) < 0.5 * (a.height + b.height);
}

std::vector<Stroke> strokes_of(const Outline& outline, const BodyPlace& place, const SvgView& view) {
    const std::vector<ArcVertex>& v = outline.vertices;
    std::vector<Stroke> strokes;
    for (std::size_t i = 0; i + (outline.closed ? 0 : 1) < v.size(); ++i) {
        const Vector<double> a = in_drawing(place, v[i].at), b = in_drawing(place, v[(i + 1) % v.size()].at);
        const double bulge = v[i].bulge;
        constexpr int parts = 8;
        const int pieces = std::abs(bulge) > 0.02 ? parts : 1;
        Vector<double> last = a;
        for (int k = 1; k <= pieces; ++k) {
            Vector<double> next = b;
            if (k < pieces) {
                // The arc bulges to the right of its chord.
                const double half = 2 * std::atan(bulge), t = half * (2.0 * k / pieces - 1);
                const Vector<double> chord = b - a;
                const double along = 0.5 * (1 + std::sin(t) / std::sin(half));
                const double across = 0.5 * (std::cos(t) - std::cos(half)) / std::sin(half);
                next = a + along * chord - across * left_of(chord);
            }
            strokes.push_back({view.pixels(last), view.pixels(next)});
            last = next;
        }
    }
    return strokes;
}

double covered(const TextBox& box, const Stroke& stroke) {
    const Vector<double> along = stroke.to - stroke.from, from = stroke.from - box.middle;
    double first = 0, last = 1;
    const auto clip = [&](double start, double step, double half) {
        if (step == 0) {
            if (std::abs(start) > half) last = -1;
            return;
        }
        const double a = (-half - start) / step, b = (half - start) / step;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    };
    clip(from.x, along.x, 0.5 * box.width);
    clip(from.y, along.y, 0.5 * box.height);
    return std::max(0.0, last - first) * std::hypot(along.x, along.y);
}

double Labels::clearance(const Vector<double>& normal, const TextBox& box) {
    constexpr double gap = 3;
    return gap + 0.5 * (std::abs(normal.x) * box.width + std::abs(normal.y) * box.height);
}

std::vector<Vector<double>> Labels::beside_line(const Vector<double>& from, const Vector<double>& to,
                                                const TextBox& box) {
    const Vector<double> way = to - from;
    const double length = std::hypot(way.x, way.y);
    const Vector<double> along = (1 / std::max(length, 1e-9)) * way, normal = left_of(along);
    std::vector<Vector<double>> places;
    for (const double far : {0.0, 6.0, 14.0})
        for (const double part : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9})
            for (const double side : {1.0, -1.0})
                places.push_back(from + part * way + side * (clearance(normal, box) + far) * normal);
    for (const double far : {6.0, 14.0}) {
        places.push_back(to + (clearance(along, box) + far) * along);
        places.push_back(from - (clearance(along, box) + far) * along);
    }
    return places;
}

const TextBox& Labels::place(TextBox box, const std::vector<Vector<double>>& places) {
    constexpr double over_text = 1e4, later = 0.7;
    double least = std::numeric_limits<double>::infinity();
    Vector<double> best{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        box.middle = places[i];
        double cost = later * static_cast<double>(i);
        for (const TextBox& other : placed)
            if (overlap(box, other)) cost += over_text;
        for (const Stroke& stroke : strokes)
            cost += stroke.weight * covered(box, stroke);
        if (cost >= least) continue;
        least = cost;
        best = box.middle;
    }
    box.middle = best;
    return placed.emplace_back(std::move(box));
}

}  // namespace mechwright
