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
