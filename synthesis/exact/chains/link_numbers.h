#pragma once
/// \file
/// The numbers of a linkage's links as far as they are given, and rows of what they have to be: sums of dimensions that
/// follow from where pins are.

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/problem/problem.h"

namespace mechwright {

/// A sum of dimensions that has to be a value, an angle up to whole turns.
struct ChainRow {
    Affine number;
    double value = 0;
    bool angle = false;
};

/// The numbers of a structure for dimensions some of which are given: ranges that hold one value.
struct LinkNumbers {
    std::span<const DimensionRange> dimensions;
    const LinkageModel& model;

    const Affine& number(linkage::Number i) const { return model.numbers[i]; }
    /// The value of a sum of given dimensions.
    std::optional<double> constant(const Affine& affine) const;
    /// 1 where a number can only be greater than a value, -1 where only less; else 1, which is as good.
    double side_of(const Affine& affine, double value) const;
    std::optional<std::complex<double>> constant_place(const linkage::Coordinates& at) const;
    /// The direction on a link from a place that is given to another pin, as far as its numbers say it.
    std::optional<std::complex<double>> direction_to(const linkage::Coordinates& at,
                                                     const std::complex<double>& from) const;
    /// That a pin is at a place on its link.
    void add_place(std::vector<ChainRow>& rows, const linkage::Coordinates& at,
                   const std::complex<double>& on_link) const;
};

/// Dimensions that rows are to say: what is to be found but for numbers of targets.
std::vector<std::size_t> open_dimensions(const Mechanism& mechanism, std::span<const DimensionRange> ranges);

/// Whether a number is one dimension, or less one, and a constant.
bool is_turn_of_one(const Affine& number);

/// The open dimensions that rows say nothing of.
std::vector<std::size_t> dimensions_unsaid(const Mechanism& mechanism, std::span<const DimensionRange> ranges,
                                           const std::vector<ChainRow>& rows);

/// How many of the open dimensions rows of lengths leave undetermined.
std::size_t undetermined_lengths(const Mechanism& mechanism, std::span<const DimensionRange> ranges,
                                 const std::vector<ChainRow>& rows);

/// The open dimensions that the rows say, into those of a design; whether given ones agree.
bool solve_rows(const Mechanism& mechanism, std::span<const DimensionRange> ranges, const std::vector<ChainRow>& rows,
                std::vector<double>& dimensions);

}  // namespace mechwright
