#include "synthesis/exact/chains/link_numbers.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace mechwright {

namespace {

using Point = std::complex<double>;

bool is_angle(const Mechanism& mechanism, std::size_t dimension) {
    return mechanism.dimensions[dimension].kind == DimensionKind::angle;
}

/// The least difference of two angles.
double apart(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

/// The dimensions that the rows of lengths are about, and these as equations.
struct LengthEquations {
    std::vector<std::size_t> dimensions;
    Eigen::MatrixXd factors;
    Eigen::VectorXd values;
};

LengthEquations length_equations(const Mechanism& mechanism, std::span<const DimensionRange> ranges,
                                 const std::vector<ChainRow>& rows) {
    LengthEquations e;
    for (const std::size_t i : open_dimensions(mechanism, ranges))
        if (!is_angle(mechanism, i)) e.dimensions.push_back(i);
    const auto count = std::count_if(rows.begin(), rows.end(), [](const ChainRow& row) { return !row.angle; });
    e.factors = Eigen::MatrixXd::Zero(count, static_cast<Eigen::Index>(e.dimensions.size()));
    e.values = Eigen::VectorXd::Zero(count);
    Eigen::Index k = 0;
    for (const ChainRow& row : rows) {
        if (row.angle) continue;
        e.values[k] = row.value - row.number.constant;
        for (const auto& [dimension, factor] : row.number.terms) {
            const auto at = std::find(e.dimensions.begin(), e.dimensions.end(), dimension);
            if (at == e.dimensions.end())
                e.values[k] -= factor * ranges[dimension].min;
            else
                e.factors(k, at - e.dimensions.begin()) = factor;
        }
        ++k;
    }
    return e;
}

}  // namespace

std::optional<double> LinkNumbers::constant(const Affine& affine) const {
    double value = affine.constant;
    for (const auto& [dimension, factor] : affine.terms) {
        if (!dimensions[dimension].fixed()) return {};
        value += factor * dimensions[dimension].min;
    }
    return value;
}

double LinkNumbers::side_of(const Affine& affine, double value) const {
    double greatest = affine.constant;
    for (const auto& [dimension, factor] : affine.terms)
        greatest += factor * (factor > 0 ? dimensions[dimension].max : dimensions[dimension].min);
    return greatest <= value ? -1 : 1;
}

std::optional<Point> LinkNumbers::constant_place(const linkage::Coordinates& at) const {
    const auto first = constant(number(at.first)), second = constant(number(at.second));
    if (!first || !second) return {};
    return at.polar ? std::polar(*first, *second) : Point(*first, *second);
}

std::optional<Point> LinkNumbers::direction_to(const linkage::Coordinates& at, const Point& from) const {
    if (const auto place = constant_place(at))
        return std::abs(*place - from) > 0 ? std::optional((*place - from) / std::abs(*place - from)) : std::nullopt;
    const auto first = constant(number(at.first)), second = constant(number(at.second));
    if (at.polar) {
        if (!second || from != Point(0)) return {};
        return side_of(number(at.first), 0) * std::polar(1.0, *second);
    }
    if (second && *second == from.imag()) return Point(side_of(number(at.first), from.real()), 0);
    if (first && *first == from.real()) return Point(0, side_of(number(at.second), from.imag()));
    return {};
}

void LinkNumbers::add_place(std::vector<ChainRow>& rows, const linkage::Coordinates& at, const Point& on_link) const {
    rows.push_back({number(at.first), at.polar ? std::abs(on_link) : on_link.real(), false});
    rows.push_back({number(at.second), at.polar ? std::arg(on_link) : on_link.imag(), at.polar});
}

std::vector<std::size_t> open_dimensions(const Mechanism& mechanism, std::span<const DimensionRange> ranges) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < ranges.size(); ++i)
        if (!ranges[i].fixed() && !mechanism.dimensions[i].of_target) open.push_back(i);
    return open;
}

bool is_turn_of_one(const Affine& number) {
    return number.terms.size() == 1 && std::abs(number.terms.front().second) == 1;
}

std::vector<std::size_t> dimensions_unsaid(const Mechanism& mechanism, std::span<const DimensionRange> ranges,
                                           const std::vector<ChainRow>& rows) {
    std::vector<std::size_t> all;
    for (const std::size_t i : open_dimensions(mechanism, ranges)) {
        const bool angle = is_angle(mechanism, i);
        const bool said = std::any_of(rows.begin(), rows.end(), [&](const ChainRow& row) {
            return row.angle == angle && (!angle || is_turn_of_one(row.number)) &&
                   std::any_of(row.number.terms.begin(), row.number.terms.end(),
                               [&](const auto& term) { return term.first == i; });
        });
        if (!said) all.push_back(i);
    }
    return all;
}

std::size_t undetermined_lengths(const Mechanism& mechanism, std::span<const DimensionRange> ranges,
                                 const std::vector<ChainRow>& rows) {
    const LengthEquations e = length_equations(mechanism, ranges, rows);
    if (e.dimensions.empty()) return 0;
    return e.dimensions.size() - static_cast<std::size_t>(e.factors.colPivHouseholderQr().rank());
}

bool solve_rows(const Mechanism& mechanism, std::span<const DimensionRange> ranges, const std::vector<ChainRow>& rows,
                std::vector<double>& dimensions) {
    constexpr double agree_within = 1e-9;
    const LengthEquations e = length_equations(mechanism, ranges, rows);
    bool agree = true;
    double size = 0;
    for (const ChainRow& row : rows)
        if (!row.angle) size = std::max(size, std::abs(row.value));
    if (!e.dimensions.empty()) {
        const Eigen::VectorXd found = e.factors.colPivHouseholderQr().solve(e.values);
        for (std::size_t i = 0; i < e.dimensions.size(); ++i)
            dimensions[e.dimensions[i]] = found[static_cast<Eigen::Index>(i)];
        agree = (e.factors * found - e.values).cwiseAbs().maxCoeff() <= agree_within * size;
    } else {
        agree = e.values.size() == 0 || e.values.cwiseAbs().maxCoeff() <= agree_within * size;
    }
    for (const ChainRow& row : rows)
        if (row.angle && is_turn_of_one(row.number) && !ranges[row.number.terms.front().first].fixed())
            dimensions[row.number.terms.front().first] =
                (row.value - row.number.constant) * row.number.terms.front().second;
    for (const ChainRow& row : rows)
        if (row.angle && apart(row.number.at(std::span<const double>(dimensions)), row.value) > agree_within)
            agree = false;
    return agree;
}

}  // namespace mechwright
