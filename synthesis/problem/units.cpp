#include "synthesis/problem/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"

namespace mechwright {

namespace {

constexpr std::size_t longest_label = 20;

/// Rounded to a number of significant decimal digits.
double rounded(double value, int digits) {
    char text[64];
    const auto written = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits - 1);
    double result = value;
    std::from_chars(text, written.ptr, result);
    return result;
}

double degrees_of(double radians, const Units& units) {
    const double plain = radians * (180 / std::numbers::pi);
    if (!std::isfinite(plain)) return plain;
    for (const int digits : {15, 16}) {
        const double candidate = rounded(plain, digits);
        if (reading::to_radians(units, candidate) == radians) return candidate;
    }
    for (const double towards : {plain, 0.0, std::numeric_limits<double>::infinity()}) {
        const double candidate = std::nextafter(plain, towards);
        if (reading::to_radians(units, candidate) == radians) return candidate;
    }
    return plain;
}

}  // namespace

Unit unit_of(DimensionKind kind) {
    switch (kind) {
        case DimensionKind::angle: return Unit::angle;
        case DimensionKind::force: return Unit::force;
        case DimensionKind::rate: return Unit::rate;
        case DimensionKind::number: return Unit::none;
        default: return Unit::length;
    }
}

double in_file_unit(double value, Unit unit, const Units& units) {
    return unit == Unit::angle && units.degrees ? degrees_of(value, units) : value;
}

double from_file_unit(double number, Unit unit, const Units& units) {
    return unit == Unit::angle ? reading::to_radians(units, number) : number;
}

double file_units_per_inner(Unit unit, const Units& units) {
    return unit == Unit::angle && units.degrees ? 180 / std::numbers::pi : 1;
}

std::optional<double> times_mass(std::string_view mass, std::string_view force, std::string_view length) {
    struct Known {
        std::string_view name;
        double size;
    };
    // Kilograms, newtons, metres.
    constexpr std::array masses{Known{"g", 1e-3}, Known{"kg", 1}, Known{"t", 1e3}, Known{"lb", 0.45359237}};
    constexpr std::array forces{Known{"N", 1}, Known{"kN", 1e3}, Known{"kgf", 9.80665}, Known{"lbf", 4.4482216152605}};
    constexpr std::array lengths{Known{"mm", 1e-3}, Known{"cm", 1e-2}, Known{"m", 1}, Known{"in", 0.0254},
                                 Known{"ft", 0.3048}};
    const auto size = [](const auto& known, std::string_view name) {
        const auto at = std::find_if(known.begin(), known.end(), [&](const Known& k) { return k.name == name; });
        return at == known.end() ? 0 : at->size;
    };
    const double factor = size(masses, mass) * size(lengths, length), by = size(forces, force);
    if (factor == 0 || by == 0) return {};
    return factor / by;
}

double inner_per_file_unit(const Setting& setting, const Units& units) { return setting.is_mass ? units.per_mass : 1; }

std::string unit_label(Unit unit, const Units& units) {
    switch (unit) {
        case Unit::none: return {};
        case Unit::force: return units.force;
        case Unit::torque: return units.force.empty() ? "" : units.force + " " + unit_label(Unit::length, units);
        case Unit::rate: return units.force.empty() ? "" : units.force + "/" + unit_label(Unit::length, units);
        case Unit::angle: return units.degrees ? "deg" : "rad";
        case Unit::length: return reading::printable(units.length, longest_label);
        case Unit::area: return reading::printable(units.length, longest_label) + "^2";
        case Unit::curvature: return "1/" + reading::printable(units.length, longest_label);
    }
    return {};
}

}  // namespace mechwright
