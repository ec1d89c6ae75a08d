#pragma once
/// \file
/// The discrete side of a cam's motion: which segments follow one another, and by which laws each may move. Their
/// angles and lifts are dimensions of the mechanism, so that they can be designed.

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/cam/segment.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The names of cam::SegmentKind, in its order.
inline constexpr std::array<std::string_view, 4> segment_kind_names{"rise", "return", "dwell", "cycle"};

/// A law by the name that problem files have for it.
struct NamedLaw {
    std::string_view name;
    cam::SegmentLaw law;
};

/// Every law that a rise or return can have, and other names for them (VDI 2143 and common abbreviations).
std::span<const NamedLaw> cam_laws();
std::span<const NamedLaw> cam_law_aliases();

/// Lifts at parts of the turn as a periodic spline, over their greatest difference.
struct LiftTable {
    std::vector<double> angle;  ///< radians, increasing, within a turn
    std::vector<double> lift;
    double range = 0;  ///< greatest less least lift: what the splines are divided by
    cam::PeriodicSpline<double> spline;
    cam::PeriodicSpline<Digits50> spline_again;
};

/// Precondition: three angles or more, increasing from >= 0, all less than a turn; lifts of the same number, not all
/// equal.
std::shared_ptr<const LiftTable> lift_table(std::vector<double> angle, std::vector<double> lift);

struct SegmentPlan {
    cam::SegmentKind kind = cam::SegmentKind::dwell;
    std::vector<std::size_t> laws{};  ///< candidates, indices into cam_laws(); empty for a dwell or a table
    // Of a polynomial: how many derivatives are given at each end, how many further terms there are, and which of the
    // mechanism's coefficients they are (start, end, shape one after the other).
    std::size_t start_count = 0;
    std::size_t end_count = 0;
    std::size_t shape_count = 0;
    std::size_t first_coefficient = 0;
    std::shared_ptr<const LiftTable> table{};
    cam::ContourKind contour = cam::ContourKind::none;  ///< of a cycle that follows from the cam's contour
};

struct MotionProgram {
    std::vector<SegmentPlan> segments;

    static constexpr std::size_t most_segments = 12;
    static constexpr std::size_t most_coefficients = 16;
    static constexpr std::size_t most_ends = 3;   ///< derivatives given at an end of a polynomial
    static constexpr std::size_t most_shape = 6;  ///< further terms of a polynomial, or coefficients of a spline
};

/// The motion of a follower on a cam of a specified contour: one cycle.
std::shared_ptr<const MotionProgram> contour_program(cam::ContourKind kind);

enum class CamFollower { knife, roller, flat };

/// What kind of cam a mechanism is.
struct CamKind {
    CamFollower follower;
    bool oscillating;
    cam::ContourKind contour = cam::ContourKind::none;
};

/// The model of a cam: its kind and, in a problem or a design, its motion.
struct CamModel {
    CamKind kind;
    std::shared_ptr<const MotionProgram> program{};
};

/// The model and the program of a cam's motion. Precondition: the motion is that of a cam, with a program.
inline const CamModel& model_of(const Motion& motion) { return *static_cast<const CamModel*>(motion.model); }
inline const MotionProgram& program_of(const Motion& motion) { return *model_of(motion).program; }

/// How many choices of laws there are. The assembly of a cam numbers them, times two: even with the cam turning
/// counter-clockwise, odd clockwise.
std::size_t law_choices(const MotionProgram& program);

/// The law of a segment in an assembly: its index in cam_laws(). Precondition: the segment has laws.
std::size_t law_of(const MotionProgram& program, std::size_t assembly, std::size_t segment);

/// +1 for a cam that turns counter-clockwise.
inline int sense_of(std::size_t assembly) { return assembly % 2 == 0 ? 1 : -1; }

namespace cam {

/// Where angles, lifts and coefficients stand among the dimensions that follow a mechanism's geometry.
struct ProgramSlots {
    std::size_t first;  ///< the number of dimensions before them

    constexpr std::size_t angle(std::size_t segment) const { return first + segment; }
    constexpr std::size_t lift(std::size_t segment) const { return first + MotionProgram::most_segments + segment; }
    constexpr std::size_t coefficient(std::size_t i) const { return first + 2 * MotionProgram::most_segments + i; }
    constexpr std::size_t end() const { return coefficient(MotionProgram::most_coefficients); }
};

/// The parameters of one segment: lift at its start, its own lift, its angle, then a polynomial's numbers.
template <class T>
struct SegmentParameters {
    T start_lift{};
    T lift{};
    T angle{};
    std::array<T, MotionProgram::most_ends> start{};
    std::array<T, MotionProgram::most_ends> end{};
    std::array<T, MotionProgram::most_shape> shape{};
};

template <class T>
Segment<T> segment_of(const MotionProgram& program, std::size_t assembly, std::size_t index,
                      const SegmentParameters<T>& p) {
    const SegmentPlan& plan = program.segments[index];
    Segment<T> segment;
    segment.kind = plan.kind;
    segment.angle = p.angle;
    segment.lift = p.lift;
    if (plan.table) {
        segment.law.form = SegmentLaw::Form::table;
        if constexpr (std::is_same_v<Constant<T>, double>)
            segment.table = &plan.table->spline;
        else
            segment.table = &plan.table->spline_again;
    } else if (!plan.laws.empty()) {
        segment.law = cam_laws()[law_of(program, assembly, index)].law;
    }
    BoundaryPolynomial<T>& boundary = segment.boundary;
    boundary.start_count = plan.start_count;
    boundary.end_count = plan.end_count;
    boundary.shape_count = plan.shape_count;
    std::copy(p.start.begin(), p.start.end(), boundary.start.begin());
    std::copy(p.end.begin(), p.end.end(), boundary.end.begin());
    std::copy(p.shape.begin(), p.shape.end(), boundary.shape.begin());
    return segment;
}

/// +1, -1 or 0: how a segment's lift counts in those after it.
inline int lift_sign(SegmentKind kind) { return kind == SegmentKind::rise ? 1 : kind == SegmentKind::fall ? -1 : 0; }

/// The parameters of a segment from all dimensions of a mechanism.
template <class T>
SegmentParameters<T> parameters_of(const MotionProgram& program, const ProgramSlots& slots, std::span<const T> d,
                                   std::size_t index) {
    const SegmentPlan& plan = program.segments[index];
    SegmentParameters<T> p;
    for (std::size_t i = 0; i < index; ++i)
        p.start_lift += T(lift_sign(program.segments[i].kind)) * d[slots.lift(i)];
    p.lift = d[slots.lift(index)];
    p.angle = d[slots.angle(index)];
    std::size_t c = slots.coefficient(plan.first_coefficient);
    if (plan.laws.empty()) return p;
    for (std::size_t i = 0; i < plan.start_count && i < p.start.size(); ++i)
        p.start[i] = d[c++];
    for (std::size_t i = 0; i < plan.end_count && i < p.end.size(); ++i)
        p.end[i] = d[c++];
    for (std::size_t i = 0; i < plan.shape_count; ++i)
        p.shape[i] = d[c++];
    return p;
}

}  // namespace cam

}  // namespace mechwright
