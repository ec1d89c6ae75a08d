#pragma once
/// \file
/// What the rest of the program knows of a mechanism: a value with the names of its dimensions and quantities,
/// functions that measure them, and what it can do besides. The reader, the messages, the methods, the verification and
/// the results all take it from here, whether it is one of the fixed kinds or was made while the program runs.

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/geometry/arc_fit.h"
#include "analysis/geometry/vector.h"
#include "synthesis/mechanism/as_linkage.h"
#include "synthesis/mechanism/curve_fit.h"
#include "synthesis/mechanism/drawing/body.h"
#include "synthesis/mechanism/path_screening.h"
#include "synthesis/mechanism/quantity.h"
#include "synthesis/mechanism/task.h"

namespace mechwright {

enum class DimensionKind {
    length,      ///< > 0
    coordinate,  ///< a length of either sign
    angle,       ///< radians, of either sign
    force,       ///< of either sign; grows with the lengths for given masses and spring rates
    rate,        ///< force over length, of a spring; does not grow with the lengths
    number       ///< anything else that does not
};

/// Whether dimensions of this kind grow in proportion when a mechanism is made larger.
constexpr bool scales(DimensionKind kind) {
    return kind != DimensionKind::angle && kind != DimensionKind::rate && kind != DimensionKind::number;
}

struct Dimension {
    std::string name;
    DimensionKind kind;
    bool required;  ///< if not, and not named in a problem file, it is 0
    std::string meaning;
    bool of_segment = false;  ///< stands in a [[segment]] of a cam's motion, not in [dimensions]
    bool of_target = false;   ///< stands in [function] or [line], not in [dimensions]
};

/// A number that stands in the section of its target, and is 0 in problems without one.
inline Dimension number_of_target(std::string name, DimensionKind kind, std::string meaning) {
    return {std::move(name), kind, false, std::move(meaning), false, true};
}

/// A linear condition on the dimensions: sum of coefficient[i] dimension[i] >= 0.
struct LinearCondition {
    std::string name;
    std::vector<double> coefficients;
};

/// How far dimensions, of which there are as many as coefficients or more, are from where a condition ends.
double margin_of(const LinearCondition& condition, std::span<const double> dimensions);

/// A kind of motion that designs can have: with all its conditions met a design has that motion at every crank angle.
struct Family {
    std::string name;
    bool full_turn;
    std::vector<LinearCondition> conditions;
    /// Components that must all be >= 0 for the design to assemble over its motion; none where the conditions say it
    /// all.
    std::optional<Quantity> assembly_margin{};
    int turns = 1;  ///< of the crank, after which everything is where it was
};

/// The distance from a target to the point that the mechanism guides, at a crank angle; derivatives with respect to the
/// arguments of the guidance, then the crank angle.
struct PathMiss {
    Vector<double> miss;  ///< target - point
    double margin;  ///< assembly margin: < 0 where the mechanism does not assemble; then miss is that of the nearest
                    ///< toggle
    std::span<double> gradient_x;  ///< one more than arguments each, or empty
    std::span<double> gradient_y;
    std::span<double> hessian_x;  ///< lower triangles by rows, or empty
    std::span<double> hessian_y;
};

/// The same for a body: `place` as for a path, `turn` the difference of the unit vectors in which the body faces.
struct PoseMiss {
    PathMiss place;
    PathMiss turn;
};

/// In place of a number that a target brings, where there is no such target.
inline constexpr std::size_t no_dimension = static_cast<std::size_t>(-1);

/// Which dimensions play which part in a path: the point's coordinates on the guiding link, the placement in the
/// drawing (`no_dimension` where they are given or follow from others); and the numbers of the path and the poses
/// themselves, where a problem has them (target/with_targets.h).
struct PathRoles {
    std::size_t along;
    std::size_t across;
    std::size_t origin_x;
    std::size_t origin_y;
    std::size_t tilt;
    std::size_t start = no_dimension;  ///< the crank angle that prescribed angles are counted from
    std::size_t body = no_dimension;   ///< the angle from the guiding link to the guided body
};

/// Why ranges of dimensions hold no design of a mechanism.
struct Objection {
    std::size_t dimension;  ///< the one to change
    std::string why;        ///< what is wrong, and what would be right
};

/// Which of its motions a linkage makes: what it can reach without being taken apart is a circuit, and of a circuit
/// what lies between two positions in which a dyad is at its limit is a branch.
struct CircuitAndBranch {
    int circuit;  ///< from 1, by the least crank angle
    int branch;   ///< of the circuit, from 1, the same
};

struct Check {
    std::string name;
    bool passed;
    std::string detail;  ///< what was found, with numbers
};

/// A mechanism that guides a point of one of its links.
struct PointGuidance {
    Reads reads{};  ///< the dimensions that the point depends on; at most `most_reads`
    PathRoles roles{};
    /// Problem files say which point it is, and have its numbers in the sections of targets.
    bool named = false;
    void (*miss)(Form, std::span<const double> arguments, double crank_angle, const Vector<double>& target,
                 PathMiss& out) = nullptr;
    /// The point in fifty digits, by another way.
    Vector<Digits50> (*point)(Form, std::span<const Digits50> arguments, const Digits50& crank_angle) = nullptr;
    /// Ranks candidates for a path, many at once; null: they are evaluated one by one.
    PathScreening screening = nullptr;
    /// Fits whole curves to paths in any order; without it, by the crank angles of the targets.
    CurveFit curve{};
    /// Whether the guided points of two designs draw one curve though the designs are different: cognates. Null where
    /// there are none.
    bool (*draws_same_curve)(std::span<const double> a, std::span<const double> b) = nullptr;

    static constexpr std::size_t most_reads = 31;  ///< of a guided body, too
};

/// A mechanism that guides a body on the link of its guided point.
struct BodyGuidance {
    Reads reads{};             ///< the dimensions that the pose depends on, before the angle of the body
    std::string angle_from{};  ///< what that angle is counted from, in words
    void (*miss)(Form, std::span<const double> arguments, double crank_angle, const Vector<double>& target,
                 const Vector<double>& facing, PoseMiss& out) = nullptr;
    /// The direction of the guiding link in fifty digits, by another way, from the arguments of the point; null: where
    /// a point one length ahead along it lies.
    Digits50 (*direction)(Form, std::span<const Digits50> arguments, const Digits50& crank_angle) = nullptr;
};

/// What one of several paths and poses of a problem guides: the target's name, its numbers among the dimensions, and
/// its body, where it has poses.
struct GuidedTarget {
    std::string name;
    PathRoles roles{};
    std::optional<BodyGuidance> body{};
};

/// A mechanism whose input can turn over a range with ends among the design variables: for functions, lines and arcs,
/// and between the targets of a path. The arguments of its quantities are dimensions of the mechanism, then the crank
/// angle at the start of the range and the range.
struct InputRange {
    Reads reads{};    ///< those dimensions
    Quantity margin;  ///< components, `most_margins` at most, >= 0 where a design assembles over the range
    /// Quantities of the same names as some of the mechanism's that know that the ends of the motion move.
    std::vector<Quantity> quantities{};
    std::size_t start = no_dimension;  ///< of functions, lines and arcs; the next one is the range

    static constexpr std::size_t most_margins = 8;
};

/// A scale of what a function asks for, as dimensions: an angle or a length, and what they are in words.
struct OutputScale {
    DimensionKind kind = DimensionKind::angle;
    std::string start{};
    std::string range{};
};

/// A mechanism that generates functions.
struct FunctionGeneration {
    OutputScale output{};
    /// The greatest and the mean error. Their arguments are dimensions of the mechanism, then start and range of the
    /// input and of the output.
    std::vector<Quantity> quantities{};
    /// Sets dimensions to what comes close to the function for given scales; false where nothing does. The scales may
    /// be turned by half a turn where that is allowed.
    bool (*fit)(const FunctionTarget&, std::span<double> dimensions, std::span<double, 4> scales, bool turns_input,
                bool turns_output) = nullptr;
    /// Where the error of a design is extreme, in order along the range. The arguments are those of function-max.
    std::vector<ErrorExtreme> (*extremes)(const FunctionTarget&, Form, std::span<const double> arguments) = nullptr;
    /// The loop equation (loop_row.h) over ranges of input and output.
    LoopRow<Interval> (*loop_row)(const Interval& input, const Interval& output) = nullptr;
};

/// A line or an arc as a mechanism's guided point follows it over the input range.
struct FollowedShape {
    std::string name;                ///< of its section in problem files and documents
    std::vector<Dimension> numbers;  ///< of the shape itself, three at most
    /// The greatest distance and how far the shape is followed. Their arguments are those of the guided point, then
    /// start and range of the input and the shape's numbers.
    std::vector<Quantity> quantities{};
    std::size_t place = no_dimension;  ///< the first of its numbers
    std::size_t guided = 0;            ///< the point that follows, as Form::guided
    /// The extremes of the distance, in order along the input range. The arguments are those of the deviation.
    std::vector<ErrorExtreme> (*extremes)(Form, std::span<const double> arguments) = nullptr;
    /// Sets those of its numbers that are free to what comes close to the path.
    void (*fit)(Form, std::span<const double> arguments, std::span<double> shape,
                const std::array<bool, 3>& free) = nullptr;
};

/// What one of several functions, lines and arcs of a problem has of its own: the target's name, its numbers among the
/// dimensions, and what the mechanism does for it.
struct InputTarget {
    std::string name{};
    std::size_t start = no_dimension;  ///< of its input range; the next one is the range
    std::optional<FunctionGeneration> function{};
    std::optional<FollowedShape> shape{};
};

/// How a quantity of a mechanism follows from its dimensions, which have their names in problem files.
struct QuantityFormula {
    std::string quantity;
    std::string text;
    std::string source;  ///< book and equation, or how it is derived
};

/// A condition on dimensions by their names: the sum of those in `plus` is at least that of those in `minus`.
struct AtLeast {
    std::string_view why;
    std::vector<std::string_view> plus;
    std::vector<std::string_view> minus;
};

/// All conditions of one way in which a mechanism can move.
using Way = std::vector<AtLeast>;

/// The motion as a table: names and units of its columns, and one row at a crank angle.
struct MotionTable {
    std::vector<std::string> columns;
    std::vector<Unit> units;
    /// Returns false where the mechanism does not assemble.
    bool (*row)(const Motion&, std::span<const double> dimensions, double crank_angle, std::span<double> row) = nullptr;
};

/// The pin joints of a mechanism, which can have clearance.
struct PinJoints {
    std::vector<std::string> names;
    /// The model with the hole of each joint moved on its link: in the frame of that link, a length of the drawing.
    Model (*moved)(const Model&, std::span<const double> dimensions, std::span<const Vector<double>> by) = nullptr;
};

struct MovingDesign;
struct FigurePanel;
struct Explanation;
struct Mechanism;

/// A mechanism with a part that is cut along a closed curve, which the tables of its motion describe
/// ("profile-radius"). Curves lie in the part's own plane as it lies at crank angle 0.
struct CutProfile {
    /// Of the roller that runs on the part, 0 where none does.
    double (*roller_radius)(const MovingDesign&) = nullptr;
    /// Crank angles at which curves may have corners of their curvature: from 0 to a whole turn.
    std::vector<double> (*corners)(const MovingDesign&) = nullptr;
    /// The closed curve that lies so far outward from the profile, as arcs within a tolerance.
    std::vector<ArcVertex> (*curve)(const MovingDesign&, double offset, double tolerance) = nullptr;
};

/// A mechanism that can be drawn. Its frame is that of the problem where the mechanism has a placement in it.
struct Drawing {
    /// The bodies that move, the driven one first. `symbol` is the size of what has no size of its own, such as a ram;
    /// curves stay within `tolerance`.
    std::vector<Body> (*bodies)(const MovingDesign&, double symbol, double tolerance) = nullptr;
    /// Where they are at a crank angle, in an assembly; false where it does not assemble.
    bool (*place)(const MovingDesign&, double crank_angle, std::size_t assembly, std::span<BodyPlace> places) = nullptr;
    /// Pivots on the ground.
    std::vector<Vector<double>> (*pivots)(const MovingDesign&) = nullptr;
    /// Crank angles of the positions in which the output turns back, or which limit the motion; for cams the least and
    /// the greatest lift.
    std::vector<double> (*limits)(const MovingDesign&) = nullptr;
    /// What else does not move, in the drawing: guides, slots, wheels. Null: nothing, or the slide of a body "ram".
    Body (*ground)(const MovingDesign&, double symbol) = nullptr;
    /// The figure that shows where its dimensions are, of the mechanism with the numbers of all targets
    /// (drawing/figure.h). Null: it has none.
    std::vector<FigurePanel> (*figure)(const std::shared_ptr<const Mechanism>&) = nullptr;
    /// Adds boxes that parts need, and regions that they keep in or out of, to the ground. Null: there are none.
    void (*rooms)(const MovingDesign&, Body& ground) = nullptr;
};

/// What has no value is what a mechanism cannot do; what has one is whole.
struct Mechanism {
    std::string name;
    std::string meaning;
    std::vector<Dimension> dimensions;
    std::vector<std::string> assemblies;            ///< first is the default
    std::vector<std::string> assembly_documents{};  ///< what documents say for each, JSON; empty: its name
    std::vector<Quantity> quantities;
    std::vector<Family> families;
    std::vector<Setting> settings{};  ///< at most Setting::most
    Model model{};
    /// The sections of a problem file that it was made from, a JSON object: those that describe a linkage, or the rooms
    /// and regions of a mechanism of the list; empty where there are none. Documents repeat it, so that who reads them
    /// can make the mechanism again.
    std::string made_from{};
    /// Its model with the lengths that are no dimensions over a unit, as programs take dimensions; null: it has none.
    Model (*model_over)(const Model&, double unit) = nullptr;
    /// What its lengths are measured against; null: the greatest of the dimensions that are lengths.
    double (*size)(Form, std::span<const double> dimensions) = nullptr;

    /// Whether no design of this mechanism lies in the given ranges, where that shows at a glance; null: no such check.
    std::optional<Objection> (*objection)(std::span<const double> least, std::span<const double> greatest) = nullptr;
    /// The rod of a drive of a ram, where the sine of the rod's greatest slope is at least half of the stroke over it
    /// whenever its crank turns fully; not known of others.
    std::size_t rod_sloped_by_stroke = no_dimension;
    /// The motion of a finished design: its family, and the given crank range or else the full turn or the whole
    /// assembled range. A design that does not assemble anywhere has from > to. Model and settings are left to
    /// `motion_of`.
    Motion (*motion)(Form, std::span<const double> dimensions, const double* crank_range) = nullptr;
    /// The same derived again for verification, by another way: the range where one is given. The lengths are > 0.
    Motion (*motion_again)(Form, std::span<const Digits50> dimensions,
                           const std::optional<Vector<Digits50>>& crank_range) = nullptr;
    /// Every way in which it can assemble somewhere, or turn fully, written from the geometry for verification and not
    /// from the conditions of `families`; null: ranges exclude none.
    std::vector<Way> (*ways_again)(bool full_turn) = nullptr;
    /// In one phrase what kind of linkage the dimensions make ("crank-rocker", change points named).
    std::string (*describe)(Form, std::span<const double> dimensions) = nullptr;
    /// In words what a motion comes nearest to where it would come apart ("the linkage comes near to where ..."); null:
    /// that is the meaning of the family's assembly margin.
    std::string (*nearest_limit)(const Motion&, std::span<const double> dimensions) = nullptr;
    /// Which circuit and branch a motion belongs to, where these are numbered; null: they have words of their own.
    std::optional<CircuitAndBranch> (*circuit)(const Motion&, std::span<const double> dimensions) = nullptr;
    /// Checks of assembly, circuit and branch over the whole motion, in extended precision.
    std::vector<Check> (*check_motion)(const Motion&, std::span<const Digits50> dimensions) = nullptr;

    MotionTable table{};
    /// Those that are not said of every mechanism alike (explanations.h).
    std::vector<QuantityFormula> formulas{};
    /// What its own quantities mean, of those that no other kind has (explanations.h); null: there are none.
    std::vector<Explanation> (*explanations)() = nullptr;
    std::vector<Task> tasks{};
    std::optional<Drawing> drawing{};
    std::optional<CutProfile> profile{};
    std::optional<AsLinkage> as_linkage{};
    std::optional<PinJoints> pin_joints{};

    std::optional<PointGuidance> point{};
    std::optional<BodyGuidance> body{};
    /// What each of the paths and poses of a problem guides, where these have names; `point` and `body` then are of the
    /// first that has them, and Form::guided says which is meant.
    std::vector<GuidedTarget> guided{};
    std::optional<InputRange> input{};
    std::optional<FunctionGeneration> function{};
    std::optional<FollowedShape> line{};
    std::optional<FollowedShape> arc{};
    /// Functions, lines and arcs of a problem in which these have names; `function`, `line` and `arc` then are absent,
    /// and Form::over_input says which is meant.
    std::vector<InputTarget> over_input{};
    /// At one crank angle: their arguments are dimensions of the mechanism, then that angle.
    std::vector<Quantity> at_instant{};
    /// The targets that problems can have, named as their sections, in the order in which their numbers follow the
    /// mechanism's own dimensions (target/with_targets.h).
    std::vector<std::string> targets{};
    std::shared_ptr<const Mechanism> plain{};  ///< the same without the numbers of any target, where this one has some
    std::shared_ptr<const Mechanism> whole{};  ///< the same with those of all, where this one has not

    Form form(std::size_t assembly, std::size_t guided_target = 0, std::size_t input_target = 0) const {
        return {model.data(), assembly, guided_target, input_target};
    }
    /// Of the path or the poses of this number: which dimensions play which part, and the body, null for a path.
    const PathRoles& roles_of(std::size_t target) const { return guided.empty() ? point->roles : guided[target].roles; }
    const BodyGuidance* body_of(std::size_t target) const {
        const std::optional<BodyGuidance>& one = guided.empty() ? body : guided[target].body;
        return one ? &*one : nullptr;
    }
};

/// Whether its links and joints are those that a problem file describes: it then is not of the list.
inline bool is_described(const Mechanism& mechanism) { return !mechanism.made_from.empty() && !mechanism.as_linkage; }

/// A mechanism with the numbers and quantities of all targets that problems can have.
inline const Mechanism& whole_of(const Mechanism& mechanism) { return mechanism.whole ? *mechanism.whole : mechanism; }

/// The motion of a finished design by the mechanism's own account, with its model; settings are left to the caller.
Motion motion_of(const Mechanism& mechanism, std::span<const double> dimensions, std::size_t assembly,
                 const double* crank_range);

/// Every mechanism there is, in the order in which they are listed: the fixed kinds, then those added; with the numbers
/// and quantities of all targets that problems can have.
std::vector<std::shared_ptr<const Mechanism>> mechanisms();

/// What a mechanism lacks or has too much of; empty if it is whole.
std::string why_not_whole(const Mechanism& mechanism);

/// Adds a mechanism to the list for as long as the program runs, so that problem files and documents can name it; its
/// name must be new. Throws std::invalid_argument, saying what is missing, where it is not whole. Safe while other
/// threads read the list.
std::shared_ptr<const Mechanism> add_mechanism(Mechanism mechanism);

/// The mechanism of this name, or null.
std::shared_ptr<const Mechanism> find_mechanism(std::string_view name);

/// What the guided point, or the guided body, of a mechanism misses of a target at a crank angle; of several the one
/// that the form says. The dimensions are in mechanism order.
void miss_of_point(const Mechanism& mechanism, const Form& form, std::span<const double> dimensions, double crank_angle,
                   const Vector<double>& target, PathMiss& out);
void miss_of_body(const Mechanism& mechanism, const Form& form, std::span<const double> dimensions, double crank_angle,
                  const Vector<double>& target, const Vector<double>& facing, PoseMiss& out);

/// The guided point in fifty digits, by another way.
Vector<Digits50> point_again(const Mechanism& mechanism, const Form& form, std::span<const Digits50> dimensions,
                             const Digits50& crank_angle);

/// The index of a dimension or quantity of this name, or -1.
int find_dimension(const Mechanism& mechanism, std::string_view name);
int find_quantity(const Mechanism& mechanism, std::string_view name);

/// The quantity that is the greatest error of what a section asks for: "function", "line" or "arc".
const Quantity& deviation_from(const Mechanism& mechanism, std::string_view section);

/// The candidate closest to a misspelt name by edit distance, or empty if none is close enough to be meant.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace mechwright
