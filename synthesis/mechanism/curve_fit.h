#pragma once
/// \file
/// The curve that a guided point draws over its whole motion, and where it comes nearest to targets: what a fit of
/// paths in any order works with (synthesis/search/curve).
///
/// A target counts by the nearest point of the curve, wherever that is, so that its distance has no crank angle as a
/// variable. At the nearest point the miss stands square on the curve, and what it changes by is the way of the curve
/// along its normal: one row of derivatives for each target. Where the motion ends before that, the nearest point is
/// its end, and both components of the miss count.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/geometry/vector.h"
#include "analysis/numbers/instruction_set.h"
#include "synthesis/mechanism/path_screening.h"

namespace mechwright {

struct LinearCondition;

/// Targets in groups of eight; the last group is filled up with copies of the last target, of weight 0.
struct GroupedTargets {
    std::size_t count = 0;
    std::vector<Group> x{};
    std::vector<Group> y{};
    std::vector<Group> weight{};
};

/// Points of the curve one after the other, in the frame of the mechanism; those of a closed curve end where they
/// begin. Where the point is quick they are closer to each other by the crank angle.
struct SampledCurve {
    static constexpr std::size_t most = 256;
    std::size_t count = 0;
    bool closed = false;
    double from = 0;  ///< crank angles in radians between which the mechanism moves
    double to = 0;
    std::array<double, most> crank_angle;
    std::array<double, most> x;
    std::array<double, most> y;
};

/// The chords of a sampled curve nearest to targets, by groups.
struct NearestChords {
    std::vector<Group> square{};  ///< of the distance
    std::vector<Group> chord{};   ///< its number, from 0
    std::vector<Group> part{};    ///< the nearest point of it, from its beginning, 0 to 1
};

/// Most arguments of a guided point that is fitted so.
inline constexpr std::size_t most_curve_arguments = 9;

/// A target that the end of the motion is nearest to: derivatives of that end by the arguments.
struct NearestEnd {
    std::size_t target = 0;
    Vector<double> miss{};  ///< from the target to the end
    std::array<double, most_curve_arguments> x{};
    std::array<double, most_curve_arguments> y{};
};

/// The nearest points of the curve itself, by groups.
struct NearestOnCurve {
    std::vector<Group> crank_angle{};
    std::vector<Group> square{};  ///< of the distance
    std::vector<Group> miss{};    ///< along the normal of the curve; 0 where the motion ends
    std::array<std::vector<Group>, most_curve_arguments> gradient{};  ///< of that by each argument
    std::vector<NearestEnd> ends{};
};

/// How curves of a mechanism are related.
struct CurveKin {
    /// Linear functions of the lengths whose signs tell the kinds of motion from each other: where one passes zero the
    /// curve may lose half of itself.
    const std::vector<LinearCondition>& (*borders)() = nullptr;
    /// Changes a linkage to a relative: its cognate, whose point draws the same curve at the same crank angles, or,
    /// `other_drive`, itself driven at the other fixed pivot, whose point draws the same curve as far as it comes
    /// there. False: there is none, and nothing is changed.
    bool (*to_relative)(bool other_drive, std::size_t& assembly, std::span<double> arguments) = nullptr;
};

/// How a mechanism's guided point is fitted. Its arguments are those of PointGuidance: lengths first, then the point on
/// its link, origin and tilt.
struct CurveFit {
    /// Samples of the curve, about `coarse` of them and more where it is quick. False: the links assemble nowhere.
    bool (*sample)(InstructionSet, std::size_t assembly, std::span<const double> arguments, std::size_t coarse,
                   SampledCurve& out) = nullptr;
    /// Points at the crank angles of a curve, of other arguments with the same lengths.
    void (*points)(InstructionSet, std::size_t assembly, std::span<const double> arguments,
                   SampledCurve& curve) = nullptr;
    /// The nearest points, from those of the chords; targets are in the frame of the mechanism.
    void (*nearest)(InstructionSet, std::size_t assembly, std::span<const double> arguments, const SampledCurve& curve,
                    const NearestChords& chords, const GroupedTargets& targets, NearestOnCurve& out) = nullptr;
    const CurveKin* kin = nullptr;
};

}  // namespace mechwright
