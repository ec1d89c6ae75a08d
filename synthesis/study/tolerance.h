#pragma once
/// \file
/// Tolerances of a finished design: samples of the dimensions that pieces really have, and the first-order effect of
/// each dimension on each quantity.

#include <optional>
#include <string>
#include <vector>

#include "synthesis/problem/study/study.h"
#include "synthesis/program/result.h"
#include "synthesis/study/run.h"

namespace mechwright {

/// What was made of the tolerances that are given, so that as many pieces meet all limits as is asked for.
struct AllocatedTolerances {
    std::vector<double> times;        ///< as wide as it is given, for each deviation
    std::vector<std::string> limits;  ///< that keep them from being wider: "swing <= 61"
    double share = 0;                 ///< of pieces that meet all limits, no less than this but for bad luck
    double cost = 0, usual_cost = 0;  ///< by the law asked for, and of the tolerances that are given
};

/// A design and how far each of its dimensions is off from piece to piece.
struct TolerancedDesign {
    Problem problem;
    Solution nominal;
    std::vector<double> sizes;  ///< one for each deviation of the study: standard deviation, or half the width
    std::optional<AllocatedTolerances> allocated{};
};

/// The design that a file gives, or that is found for it. Where there is none, `why` says so.
std::optional<TolerancedDesign> toleranced_design(const PreparedStudy& prepared, const StudyRunOptions& options,
                                                  std::string& why);

/// The standard deviation of a dimension whose deviation has this size; of a pin in its hole that in any direction.
double standard_deviation(const Deviation& deviation, double size);

/// By how much a piece is off: a dimension by `x`, a pin by a vector in the frame of the link that has its hole.
using Off = Vector<double>;

/// A piece as it is made, and the problem whose mechanism it is: that of the design but for where its holes are.
struct Piece {
    Problem problem;
    Solution solution;
};

/// A piece that is off by what is said, one for each deviation of the study.
Piece piece_of(const TolerancedDesign& design, const Study& study, const std::vector<Off>& offs);

/// A piece: every dimension with its deviation, drawn for this sample alone. The zone of a grade or a
/// class lies evenly about the nominal size and is six standard deviations wide, or the whole width of a uniform
/// distribution. Pins touch their holes in directions that are all as likely: without load for one, each as far off as
/// its clearance lets it be.
Piece sample(const TolerancedDesign& design, const Study& study, std::uint64_t number);

/// By how much a quantity is off for a unit of each deviation of the study; of a pin for a unit in the worst direction.
/// In the problem's inner units; from `sensitivities`, and of pins and where there are none from pieces that are off by
/// little. Nothing where one of these has no such value.
std::optional<std::vector<double>> changes_of(const TolerancedDesign& design, const Study& study, std::size_t quantity);

/// The derivatives of a quantity with respect to the dimensions, in the problem's inner units, from the exact gradients
/// of the analysis (of a least or greatest value those of the component that is it: envelope theorem); nothing where
/// the quantity has none.
std::optional<std::vector<double>> sensitivities(const Problem& problem, std::size_t quantity, const Design& design);

/// What deviations do to a quantity. In the file's units.
struct QuantitySpread {
    std::string quantity;
    std::string unit;
    double nominal = 0;
    std::optional<double> first_order;                  ///< standard deviation that the sensitivities predict
    double worst = 0;                                   ///< as far off as they predict with all zones at their ends
    std::vector<double> derivatives;                    ///< one for each deviation; empty where there are none
    std::vector<double> parts;                          ///< of the predicted variance
    double mean = 0, deviation = 0;                     ///< of the samples
    double least = 0, low = 0, high = 0, greatest = 0;  ///< low and high enclose 95 % of the samples
};

struct ToleranceReport {
    std::vector<std::string> dimensions;  ///< that deviate, and clearances
    std::vector<double> standard_deviations;
    std::vector<QuantitySpread> quantities;
    std::uint64_t samples = 0;
    std::uint64_t assembled = 0;
    std::uint64_t within_limits = 0;  ///< samples that meet all requirements that are limits
    bool has_limits = false;
    std::vector<double> sizes;  ///< as the study says them: standard deviation, or half the width or the clearance
    std::vector<bool> uniform;
    std::vector<bool> clearances;  ///< which of them are
    std::vector<int> grades;       ///< the coarsest of ISO 286 that is no wider; 0 where none is known
    std::optional<AllocatedTolerances> allocated;
    double wanted_share = 0;  ///< of the allocation
};

/// Samples from the data, sensitivities from the design.
ToleranceReport tolerance_report(const PreparedStudy& prepared, const TolerancedDesign& design,
                                 const std::filesystem::path& data);

}  // namespace mechwright
