#pragma once
/// \file
/// A square matrix of doubles in triangular factors, by elimination with row pivots (Golub and Van Loan, Matrix
/// Computations, algorithm 3.4.1), with its scale-free determinant. Nothing is allocated after it is made.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace mechwright::linkage {

class Factors {
public:
    explicit Factors(std::size_t size = 0) : n_(size), entries_(size * size), pivots_(size), scales_(size) {}

    std::size_t size() const { return n_; }
    /// Row by row: what is factored.
    void clear() { std::fill(entries_.begin(), entries_.end(), 0.0); }
    double& at(std::size_t row, std::size_t column) { return entries_[row * n_ + column]; }

    /// Factors what stands in `at`. Returns the determinant of the rows as unit vectors, in [-1, 1] (Hadamard); 0 where
    /// it is singular to the last bit, and then there is nothing to solve with.
    double factor() {
        double determinant = 1;
        for (std::size_t i = 0; i < n_; ++i) {
            double square = 0;
            for (std::size_t j = 0; j < n_; ++j)
                square += at(i, j) * at(i, j);
            scales_[i] = square > 0 ? 1 / std::sqrt(square) : 0;
            for (std::size_t j = 0; j < n_; ++j)
                at(i, j) *= scales_[i];
        }
        for (std::size_t k = 0; k < n_; ++k) {
            std::size_t pivot = k;
            for (std::size_t i = k + 1; i < n_; ++i)
                if (std::abs(at(i, k)) > std::abs(at(pivot, k))) pivot = i;
            pivots_[k] = pivot;
            if (!(std::abs(at(pivot, k)) > 0)) return 0;
            if (pivot != k) {
                std::swap_ranges(&at(k, 0), &at(k, 0) + n_, &at(pivot, 0));
                determinant = -determinant;
            }
            determinant *= at(k, k);
            for (std::size_t i = k + 1; i < n_; ++i) {
                const double factor = at(i, k) /= at(k, k);
                if (factor == 0) continue;
                for (std::size_t j = k + 1; j < n_; ++j)
                    at(i, j) -= factor * at(k, j);
            }
        }
        return determinant;
    }
    /// The least size of a pivot, of rows that are unit vectors: how far they are from depending on each other. After
    /// they are factored.
    double least_pivot() const {
        double least = 1;
        for (std::size_t k = 0; k < n_; ++k)
            least = std::min(least, std::abs(entries_[k * n_ + k]));
        return least;
    }
    /// Solves with the right side `b`, in place.
    void solve(std::span<double> b) const {
        for (std::size_t i = 0; i < n_; ++i)
            b[i] *= scales_[i];
        for (std::size_t k = 0; k < n_; ++k)
            std::swap(b[k], b[pivots_[k]]);
        for (std::size_t i = 0; i < n_; ++i)
            for (std::size_t j = 0; j < i; ++j)
                b[i] -= entries_[i * n_ + j] * b[j];
        for (std::size_t i = n_; i-- > 0;) {
            for (std::size_t j = i + 1; j < n_; ++j)
                b[i] -= entries_[i * n_ + j] * b[j];
            b[i] /= entries_[i * n_ + i];
        }
    }
    /// Writes the inverse, row by row, with `column` for working space.
    void invert(std::span<double> inverse, std::span<double> column) const {
        for (std::size_t j = 0; j < n_; ++j) {
            std::fill(column.begin(), column.end(), 0.0);
            column[j] = 1;
            solve(column);
            for (std::size_t i = 0; i < n_; ++i)
                inverse[i * n_ + j] = column[i];
        }
    }

private:
    std::size_t n_;
    std::vector<double> entries_;
    std::vector<std::size_t> pivots_;
    std::vector<double> scales_;
};

}  // namespace mechwright::linkage
