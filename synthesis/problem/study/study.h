#pragma once
/// \file
/// A study: one problem file solved many times with some of its values changed, or a finished design with its
/// dimensions off by a little.

#include <toml++/toml.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mechwright {

/// Numbers from one to another, in the file's units.
struct StudyRange {
    double from = 0;
    double to = 0;
    std::uint64_t count = 0;   ///< steps where values are taken one after the other; 0: not given
    bool logarithmic = false;  ///< evenly spaced in their logarithms
    bool whole = false;        ///< both ends are written as whole numbers: so are the values that are whole

    /// The number at a part of the way, 0 to 1: to fifteen digits, as a person would write it.
    double at(double part) const;
};

/// What one axis of a study varies.
struct StudyAxis {
    std::string name;                 ///< the path of a value, or "case"
    std::optional<StudyRange> range;  ///< else:
    toml::array values;               ///< what is put at the path; for cases tables of paths and values
    std::vector<std::string> labels;  ///< of the values, in data and pictures

    bool cases() const { return name == "case"; }
    /// How many values it has where they are taken one after the other.
    std::uint64_t count() const { return range ? range->count : values.size(); }
    /// Whether it has nothing but numbers.
    bool numeric() const;
};

/// A value that follows from those of axes by an expression.
struct FollowingValue {
    std::string path;
    std::string expression;
    std::vector<std::pair<std::string, std::size_t>> variables;  ///< name in the expression, axis
};

enum class StudyDesign { grid, one_at_a_time, sobol, latin_hypercube };

/// By how much a dimension is off from piece to piece; or where a pin touches its hole, anywhere around.
struct Deviation {
    std::size_t dimension = 0;
    bool uniform = false;  ///< else normal
    double size = 0;       ///< half the width or the clearance, or the standard deviation; in the problem's inner units
    int grade = 0;         ///< of ISO 286, which says the size; 0: none
    int general = 0;       ///< class of ISO 2768 that says it: 1 to 4 for f, m, c, v; 0: none
    std::optional<std::size_t> joint{};  ///< of the mechanism's pin joints, in place of a dimension
};

struct Mechanism;

/// What a deviation is of, as reports and weights call it: a dimension, or "clearance C".
std::string name_of_deviation(const Deviation& deviation, const Mechanism& mechanism);

/// Tolerances that a study is to find: as wide as limits allow, where those that are given are the usual ones.
struct Allocation {
    double share = 0.9973;        ///< of pieces that are to meet all limits
    double exponent = 1;          ///< a tolerance costs weight / (its width over the usual one)^exponent
    std::vector<double> weights;  ///< one for each deviation
};

enum class ChartKind { map, contours, curves, front };

/// A picture of a study's data.
struct StudyChart {
    ChartKind kind = ChartKind::map;
    std::string name;  ///< of its file
    std::string title;
    std::string x;
    std::string y;                         ///< of maps and contours
    std::string value;                     ///< of curves and fronts: upwards
    std::string family;                    ///< of curves: one for each of its values; empty: a single one
    std::string each;                      ///< a picture for each of its values; empty: a single one
    std::string where;                     ///< SQL: only points for which this is so; empty: those that are solved
    bool logarithmic = false;              ///< the axis of x
    std::vector<double> levels;            ///< of contours; empty: chosen
    std::vector<std::string> maximized{};  ///< columns of a front in which more is better
};

struct Study {
    StudyDesign design = StudyDesign::grid;
    std::uint64_t count = 0;  ///< points of a random design, or samples
    std::uint64_t seed = 1;
    std::vector<StudyAxis> axes;
    std::vector<FollowingValue> following;
    std::vector<Deviation> deviations;  ///< of a tolerance study, which has no axes
    bool as_linkage = false;  ///< pins of a built-in kind have clearance: it is studied as the linkage that it is
    std::optional<Allocation> allocation;
    std::vector<std::string> quantities;  ///< that are wanted; empty: all
    std::vector<StudyChart> charts;

    bool tolerances() const { return !deviations.empty() || as_linkage; }
    bool random() const { return design == StudyDesign::sobol || design == StudyDesign::latin_hypercube; }
};

}  // namespace mechwright
