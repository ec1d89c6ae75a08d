#include "synthesis/mechanism/linkage/targets/chosen_dimensions.h"

#include <algorithm>
#include <cmath>

namespace mechwright {

ChosenDimensions::ChosenDimensions(const LinkageModel& model, const std::vector<bool>& free,
                                   std::span<double> dimensions)
    : model_(model),
      open_(free),
      chosen_(free.size(), false),
      dimensions_(dimensions),
      size_(linkage::farthest_point(model.structure, numbers_of(model, std::span<const double>(dimensions)))) {}

Vector<double> ChosenDimensions::place(std::size_t link, std::size_t pin) const {
    const linkage::Coordinates& c = coordinates_at(model_, link, pin);
    const double a = value(model_.numbers[c.first]), b = value(model_.numbers[c.second]);
    return c.polar ? Vector<double>{a * std::cos(b), a * std::sin(b)} : Vector<double>{a, b};
}

bool ChosenDimensions::choose(const Affine& number, double to, bool angle) {
    const double now = value(number);
    double change = to - now;
    if (angle) change = std::remainder(change, 2 * std::acos(-1.0));
    for (const auto& [dimension, factor] : number.terms) {
        if (!open_[dimension] || factor == 0) continue;
        dimensions_[dimension] += change / factor;
        chosen_[dimension] = true;
        keep(number);
        return true;
    }
    constexpr double same_within = 1e-9;
    return std::abs(change) <= same_within * (angle ? 1 : std::max(std::abs(to), size_));
}

bool ChosenDimensions::move(std::size_t link, std::size_t pin, const Vector<double>& to) {
    const linkage::Coordinates& c = coordinates_at(model_, link, pin);
    const Affine &first = model_.numbers[c.first], &second = model_.numbers[c.second];
    if (!c.polar) return choose(first, to.x) && choose(second, to.y);
    const bool there = to.x == 0 && to.y == 0;
    return choose(first, std::hypot(to.x, to.y)) && (there || choose(second, std::atan2(to.y, to.x), true));
}

void ChosenDimensions::keep(std::size_t link, std::size_t pin) {
    const linkage::Coordinates& c = coordinates_at(model_, link, pin);
    keep(model_.numbers[c.first]);
    keep(model_.numbers[c.second]);
}

void ChosenDimensions::keep(const Affine& number) {
    for (const auto& term : number.terms)
        open_[term.first] = false;
}

}  // namespace mechwright
