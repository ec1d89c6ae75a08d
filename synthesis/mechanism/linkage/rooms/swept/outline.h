#pragma once
/// \file
/// The outline of what the straight line between two points of a linkage, a blade, sweeps over a motion, as curves that
/// meet at corners. Its curves are the paths of both points, the envelope of the blade (where its points move along the
/// blade: Bottema and Roth, Theoretical Kinematics, chapter 8), the blade where a stroke ends, and sides of a screen.

#include <array>
#include <cstddef>
#include <vector>

#include "analysis/geometry/vector.h"
#include "analysis/linkage/measuring/course.h"

namespace mechwright::measuring {

/// A curve by an input of the motion, or a straight one by its share.
struct SweptCurve {
    enum class Kind { first_path, second_path, envelope, blade, side };
    Kind kind = Kind::first_path;
    double from = 0, to = 0;        ///< inputs, or shares
    std::size_t piece = 0;          ///< of the motion
    std::size_t place = 0;          ///< of a blade: at which corner of its stroke
    Vector<double> start{}, end{};  ///< of a side

    bool is_straight() const { return kind == Kind::blade || kind == Kind::side; }
};

/// Where curves meet, and how that moves with the dimensions.
struct SweptCorner {
    enum class Kind {
        given,        ///< it does not, or what comes before it and after it is the same curve
        end,          ///< of a stroke: a limit or a given end
        rest,         ///< of the blade, by which a stroke ends
        first_folds,  ///< the first point moves along the blade
        second_folds,
        foot,          ///< of the instantaneous centre, on the blade where a stroke ends
        passed_again,  ///< another pass of the same path over a corner of it
        crossing
    };
    Kind kind = Kind::given;
    linkage::Extreme place{};  ///< of all but crossings and feet
    std::size_t piece = 0;
    std::size_t one = 0, other = 0;    ///< the curves that cross,
    double at_one = 0, at_other = 0;   ///< and where; of a foot its share of the blade
    std::array<double, 4> at_limit{};  ///< coordinates of the blade's ends, where the place is a limit
    std::size_t of = 0;                ///< of a foot the corner at which the stroke ends, of a pass that passed again
};

/// A part of a curve between two of its corners. What is swept lies to the left of it, or where `backward` is said to
/// the right.
struct SweptArc {
    std::size_t curve = 0;
    double from = 0, to = 0;
    std::size_t first = 0, last = 0;  ///< corners
    bool backward = false;
};

/// A part of the motion over which drives are analytic and the blade does not rest.
struct SweptPiece {
    Stretch stretch{};
    double within = linkage::by_itself;
    std::size_t stroke = 0;
};

struct SweptOutline {
    std::vector<SweptPiece> pieces{};
    std::vector<SweptCurve> curves{};
    std::vector<SweptCorner> corners{};
    std::vector<SweptArc> arcs{};
};

}  // namespace mechwright::measuring
