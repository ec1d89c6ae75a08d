#pragma once
/// \file
/// What a linkage is made of, as its mechanism's functions get it (Form::model): the structure, with numbers that are
/// sums of multiples of the mechanism's dimensions, the order in which it is placed, its drives and assemblies. Lengths
/// are before `scale`, in the frame of the frame; angles are radians.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/linkage/measuring/signals.h"
#include "analysis/linkage/motion/driven.h"
#include "analysis/linkage/motion/follow_way.h"
#include "analysis/linkage/placing/plain_steps.h"
#include "analysis/linkage/structure/inputs.h"
#include "analysis/linkage/structure/steps.h"
#include "analysis/linkage/structure/structure.h"
#include "synthesis/mechanism/affine.h"
#include "synthesis/mechanism/drawing/body.h"
#include "synthesis/mechanism/linkage/rooms/rooms.h"
#include "synthesis/mechanism/quantity.h"

namespace mechwright {

/// A drive beside its joint: input = ratio times that of the master + phase, or the lift of a motion + phase.
struct LinkageDrive {
    double ratio = 1;
    double phase = 0;               ///< radians, or a length
    std::optional<double> speed{};  ///< turns per minute
    /// Lifts are radians, or lengths.
    std::shared_ptr<const linkage::DriveMotion<double>> motion{};
    std::shared_ptr<const linkage::DriveMotion<Digits50>> motion_again{};
};

/// A signal's name and the unit of its values.
struct NamedSignal {
    std::string name;
    Unit unit = Unit::none;
};

/// A point that a target speaks of, and the link on which it is guided.
struct GuidedPoint {
    std::size_t pin = 0;
    std::size_t link = 0;
    bool is_body = false;                     ///< the link is a body that takes poses
    std::string name{};                       ///< of the target, where it has one
    bool follows = false;                     ///< a line or an arc; else it is of a path or of poses
    linkage::Needed needed{.closed = false};  ///< what it depends on; set when the mechanism is made
};

/// What is asked of a linkage over an input range: that a signal is a function of the input, or that a guided point
/// follows a line or an arc.
struct LinkageInputTarget {
    std::string name{};                     ///< where it has one
    Followed followed = Followed::nothing;  ///< nothing: the signal is a function
    std::size_t of = 0;                     ///< the guided point, or the signal
};

struct LinkageModel {
    std::vector<std::string> links;   ///< the frame first
    std::vector<std::string> pins;    ///< of points, too, that are on one link only
    std::vector<std::string> slides;  ///< empty where a slide has no name
    linkage::Structure structure;
    linkage::Order order;
    std::vector<Affine> numbers;                  ///< of the structure
    std::vector<bool> lengths;                    ///< which of these are
    std::vector<Affine> as_drawn{};               ///< of a piece whose holes are off: those by which it has been drawn
    std::vector<LinkageDrive> drives;             ///< the master first
    std::vector<std::vector<std::int8_t>> sides;  ///< [assembly][choice of the order], 1 or -1
    std::array<Affine, 3> placement{};            ///< origin-x, origin-y, tilt of the frame in the drawing
    Affine scale{1, {}};                          ///< of all lengths; > 0
    std::vector<linkage::Signal> signals{};
    std::vector<NamedSignal> signal_names{};       ///< one for each
    std::vector<GuidedPoint> guided{};             ///< those of paths, of poses, of lines and arcs (Form::guided)
    std::vector<LinkageInputTarget> over_input{};  ///< functions, lines, arcs (Form::over_input)
    std::vector<LinkageRoom> rooms{};
    std::vector<LinkageRegion> regions{};  ///< lengths of these are not divided (over_unit)
    std::optional<double> at{};            ///< an input of the master that belongs to the motion
    int turns = 1;                         ///< of the master, after which everything is where it was; 0: never
    double unit = 1;                       ///< the length by which its lengths are divided (over_unit)
    /// Of a driven slide the displacement, not divided, that counts as much as a radian does: a power of two, so that
    /// inputs of the analysis are of order one and no digit is lost. 1 where the master turns.
    double input_length = 1;
    /// Between which displacements the slide that drives can be in any design, in the file's lengths; set where it
    /// does.
    std::optional<std::array<double, 2>> reach{};
    std::vector<std::size_t> redundant{};  ///< links that are left out of the order: the others place what they join
    std::vector<linkage::Assembled> starts{};  ///< [assembly] of larger groups, with the dimensions `sketched`
    std::vector<double> sketched{};
    std::vector<bool> sketched_lengths{};                                   ///< which of these are lengths
    std::shared_ptr<const char> identity = std::make_shared<const char>();  ///< of models whose ways are the same

    bool driven_by_slide() const { return structure.drives.front().of_slide; }
    /// The master's input as the analysis has it, for one of a motion, and back.
    double input_of(double of_motion) const { return of_motion / input_length; }
    double of_motion(double input) const { return input * input_length; }
    /// An input among the arguments of quantities and targets is a length like others, over the unit of the model,
    /// where a slide drives: so much of a motion's is one there, and so much of the analysis.
    double unit_of_input() const { return driven_by_slide() ? unit : 1; }
    double input_per_argument() const { return input_of(unit_of_input()); }
    /// Whether the master has stops, so that its motion is no cycle.
    bool has_stops() const { return structure.drives.front().stops.any(); }
};

inline const LinkageModel& linkage_of(const void* model) { return *static_cast<const LinkageModel*>(model); }

/// The numbers of the structure.
template <class T>
std::vector<T> numbers_of(const LinkageModel& model, std::span<const T> dimensions) {
    std::vector<T> numbers;
    numbers.reserve(model.numbers.size());
    for (const Affine& number : model.numbers)
        numbers.push_back(number.at(dimensions));
    return numbers;
}

/// The same linkage where lengths that are no dimensions are over a unit, as the dimensions are then to be.
LinkageModel over_unit(LinkageModel model, double unit);
/// As Mechanism::model_over.
Model linkage_over_unit(const Model& model, double unit);

/// By which the drives follow an angle or displacement of the master, in doubles or fifty digits; its own law is the
/// identity.
template <class R>
std::vector<linkage::DriveLawIn<R>> laws_in(std::span<const LinkageDrive> drives);
/// By which one of them follows an input of the analysis (LinkageModel::input_of), and by which all do.
linkage::DriveLaw law_of(const LinkageModel& model, std::size_t drive);
std::vector<linkage::DriveLaw> laws_of(const LinkageModel& model);
std::vector<linkage::DriveLawIn<Digits50>> laws_again_of(const LinkageModel& model);

/// The ways of its larger groups along the motion of a design, for the inputs of its cycle: what its assembly becomes
/// where the dimensions change from `sketched`. Empty where there are no such groups.
using Ways = std::vector<std::shared_ptr<const linkage::Way>>;
Ways ways_of(const LinkageModel& model, std::span<const double> dimensions, std::size_t assembly);

/// The linkage of some dimensions in one assembly, driven by its master's input of the analysis. Lengths are before
/// `scale`.
linkage::Driven<double> driven(const LinkageModel& model, std::span<const double> dimensions, std::size_t assembly);

/// The inputs of the analysis over which a linkage of some dimensions is looked at.
linkage::Inputs inputs_of(const LinkageModel& model, std::span<const double> dimensions,
                          const linkage::Driven<double>& driven);

/// The frame in the drawing, and how many times its lengths are as long there.
struct LinkagePlacement {
    BodyPlace frame;
    double scale;

    Vector<double> in_drawing(const Vector<double>& at) const { return mechwright::in_drawing(frame, scale * at); }
};

LinkagePlacement placement_of(const LinkageModel& model, std::span<const double> dimensions);

}  // namespace mechwright
