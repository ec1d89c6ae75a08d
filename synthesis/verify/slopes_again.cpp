#include "synthesis/verify/slopes_again.h"

#include <algorithm>
#include <utility>

namespace mechwright {

namespace {

/// The determinant of a square matrix.
Digits50 determinant(std::vector<RowAgain> rows) {
    Digits50 product = 1;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto pivot =
            std::max_element(rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
                             [&](const RowAgain& a, const RowAgain& b) { return abs(a[k]) < abs(b[k]); });
        if ((*pivot)[k] == 0) return 0;
        if (pivot != rows.begin() + static_cast<std::ptrdiff_t>(k)) {
            std::swap(*pivot, rows[k]);
            product = -product;
        }
        product *= rows[k][k];
        for (std::size_t i = k + 1; i < rows.size(); ++i) {
            const Digits50 factor = rows[i][k] / rows[k][k];
            for (std::size_t j = k; j < rows.size(); ++j)
                rows[i][j] -= factor * rows[k][j];
        }
    }
    return product;
}

}  // namespace

std::vector<std::size_t> open_dimensions(const Claim& claim) {
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < claim.design.size(); ++k)
        if (const auto& given = claim.given[k]; given && !given->tied() && given->min != given->max) open.push_back(k);
    return open;
}

std::vector<RowAgain> slopes_again(const Rebuilt& design, const ValuesAgain& values, Digits50* sides) {
    const Claim& claim = *design.claim;
    const std::vector<std::size_t> open = open_dimensions(claim);
    if (open.empty()) return std::vector<RowAgain>(values(design.dimensions).size());
    const Digits50 part_of_size("1e-18");
    const std::vector<Digits50> here = sides ? values(design.dimensions) : std::vector<Digits50>{};
    Digits50 apart = 0, steepest = 0;
    std::vector<RowAgain> rows;
    for (const std::size_t k : open) {
        const Digits50 step = part_of_size * std::max<Digits50>(abs(design.dimensions[k]), 1);
        std::vector<Digits50> more = design.dimensions, less = more;
        for (std::size_t i = 0; i < more.size(); ++i) {
            Digits50 change = i == k ? step : Digits50(0);
            if (claim.given[i])
                for (const auto& [other, times] : claim.given[i]->tie.terms)
                    if (other == k) change = times * step;
            more[i] += change;
            less[i] -= change;
        }
        const std::vector<Digits50> above = values(more), below = values(less);
        rows.resize(above.size());
        for (std::size_t i = 0; i < above.size(); ++i) {
            rows[i].push_back((above[i] - below[i]) / (2 * step));
            if (!sides) continue;
            steepest = std::max<Digits50>(steepest, abs(rows[i].back()));
            apart = std::max<Digits50>(apart, abs(above[i] + below[i] - 2 * here[i]) / step);
        }
    }
    if (sides) *sides = steepest > 0 ? Digits50(apart / steepest) : Digits50(0);
    return rows;
}

void scale_columns(std::vector<RowAgain>& rows) {
    const Digits50 nothing("1e-20");
    std::vector<Digits50> lengths(rows.empty() ? 0 : rows[0].size());
    for (std::size_t k = 0; k < lengths.size(); ++k) {
        for (const RowAgain& row : rows)
            lengths[k] += row[k] * row[k];
        lengths[k] = sqrt(lengths[k]);
    }
    const Digits50 least = lengths.empty() ? nothing : nothing * *std::max_element(lengths.begin(), lengths.end());
    for (RowAgain& row : rows)
        for (std::size_t k = 0; k < lengths.size(); ++k)
            row[k] = lengths[k] > least ? Digits50(row[k] / lengths[k]) : Digits50(0);
}

std::vector<std::size_t> independent_columns(std::vector<RowAgain> rows, double independent_beyond) {
    std::vector<std::size_t> pivots;
    Digits50 first = 0;
    for (std::size_t rank = 0; rank < rows.size() && rank < rows[0].size(); ++rank) {
        std::size_t r = rank, c = 0;
        Digits50 pivot = 0;
        for (std::size_t i = rank; i < rows.size(); ++i)
            for (std::size_t k = 0; k < rows[i].size(); ++k)
                if (abs(rows[i][k]) > pivot) {
                    pivot = abs(rows[i][k]);
                    r = i;
                    c = k;
                }
        if (rank == 0) first = pivot;
        if (!(pivot > independent_beyond * first)) break;
        std::swap(rows[rank], rows[r]);
        pivots.push_back(c);
        for (std::size_t i = rank + 1; i < rows.size(); ++i) {
            const Digits50 factor = rows[i][c] / rows[rank][c];
            for (std::size_t k = 0; k < rows[i].size(); ++k)
                rows[i][k] -= factor * rows[rank][k];
            rows[i][c] = 0;
        }
    }
    return pivots;
}

std::vector<RowAgain> in_columns(const std::vector<RowAgain>& rows, const std::vector<std::size_t>& columns) {
    std::vector<RowAgain> kept;
    for (const RowAgain& row : rows) {
        kept.emplace_back();
        for (const std::size_t k : columns)
            kept.back().push_back(row[k]);
    }
    return kept;
}

bool balances(const std::vector<RowAgain>& rows, const std::vector<bool>& equality) {
    bool positive = false, negative = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::vector<RowAgain> others = rows;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        const Digits50 weight = i % 2 == 0 ? determinant(others) : Digits50(-determinant(others));
        if (!equality[i]) (weight > 0 ? positive : negative) = true;
    }
    return positive != negative;
}

}  // namespace mechwright
