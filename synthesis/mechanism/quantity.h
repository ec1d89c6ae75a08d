#pragma once
/// \file
/// What is measured of a mechanism: quantities, over the motion of a design, as functions of some of its dimensions.

#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <typeindex>
#include <vector>

#include "analysis/geometry/vector.h"
#include "analysis/numbers/scalar.h"

namespace mechwright {

/// Fifty decimal digits: what verification computes with. MPFR rounds every function correctly.
using Digits50 =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

/// By one function of MPFR.
template <>
inline SineAndCosine<Digits50> sine_and_cosine(const Digits50& angle) {
    SineAndCosine<Digits50> both;
    mpfr_sin_cos(both.sine.backend().data(), both.cosine.backend().data(), angle.backend().data(), MPFR_RNDN);
    return both;
}

enum class Unit { none, length, area, curvature, angle, force, torque, rate };

/// A plain number that says how a mechanism is judged, from a section of its own in the problem file.
struct Setting {
    std::string section;
    std::string name;
    double preset;
    double above;  ///< the value lies strictly between these two
    double below;
    std::string meaning;
    bool or_above = false;  ///< may be equal to `above`
    bool is_mass = false;   ///< inside such that times length over second squared it is a force

    static constexpr std::size_t most = 4;  ///< of one mechanism

    /// Whether a number is one that it can have.
    bool allows(double number) const { return (or_above ? number >= above : number > above) && number < below; }
};

/// What a mechanism is made of beside its dimensions, if anything: the motion program of a cam, the links and joints of
/// a linkage. Any value, shared by all copies of the mechanism; its functions know its type.
class Model {
public:
    Model() = default;
    template <class T>
    explicit Model(T value) : data_(std::make_shared<const T>(std::move(value))), type_(typeid(T)) {}

    /// The value, or null where there is none of this type.
    template <class T>
    const T* as() const {
        return type_ == typeid(T) ? static_cast<const T*>(data_.get()) : nullptr;
    }
    /// The value as its mechanism's functions get it.
    const void* data() const { return data_.get(); }

private:
    std::shared_ptr<const void> data_;
    std::type_index type_ = typeid(void);
};

/// What a mechanism's functions get beside the dimensions: the value of its model, null where it has none, the index of
/// the assembly, and which of several guided points or bodies (Mechanism::guided) and of several targets over input
/// ranges (Mechanism::over_input) is meant.
struct Form {
    const void* model = nullptr;
    std::size_t assembly = 0;
    std::size_t guided = 0;
    std::size_t over_input = 0;
};

struct FunctionTarget;
struct ErrorExtreme;
struct Interval;
template <class T>
struct LoopRow;

/// What a guided point follows for a stretch of its path.
enum class Followed { nothing, line, arc };

/// A function, a line or an arc as one of several that a problem asks for, each over an input range of its own.
struct AskedOverInput {
    std::string name{};
    double weight = 1;                                 ///< of its mean square in that of all
    std::shared_ptr<const FunctionTarget> function{};  ///< null: a guided point follows something
    Followed followed = Followed::nothing;
    bool full_turn = false;  ///< the crank has to turn fully
};

/// The discrete data of a design and the motion over which it is judged.
struct Motion {
    std::size_t assembly = 0;     ///< index into Mechanism::assemblies
    std::size_t family = 0;       ///< index into Mechanism::families
    const void* model = nullptr;  ///< the value of Mechanism::model
    const void* of = nullptr;     ///< the value of Quantity::of, of the one that is measured
    bool full_turn = true;
    double from = 0;  ///< crank angles in radians; for a full turn 0 and 2 pi
    double to = 0;
    std::array<double, Setting::most> settings{};  ///< values of Mechanism::settings
    const FunctionTarget* function = nullptr;      ///< what a function generator does; null without one
    Followed followed = Followed::nothing;         ///< by a guided point, over an input range
    /// Where functions, lines and arcs have names all of them; `function` and `followed` then are those of the quantity
    /// that is measured.
    const std::vector<AskedOverInput>* asked = nullptr;
    bool has_instant = false;      ///< velocities at one crank angle are asked for
    bool is_range_of_use = false;  ///< over the stretch between the targets of a path

    Form form() const { return {model, assembly}; }
};

/// Which dimensions a formula reads, in the order of its arguments.
class Reads {
public:
    Reads() = default;
    /// The first so many of the mechanism.
    Reads(std::size_t count);
    Reads(std::vector<std::size_t> dimensions);

    /// These, then so many more that stand next to each other.
    Reads and_then(std::size_t first, std::size_t count) const;

    std::size_t size() const { return dimensions_.size(); }
    std::size_t operator[](std::size_t argument) const { return dimensions_[argument]; }
    auto begin() const { return dimensions_.begin(); }
    auto end() const { return dimensions_.end(); }

    static constexpr std::size_t most = 64;
    /// The arguments, of all dimensions: these themselves where they are the first, else in `room`.
    std::span<const double> of(std::span<const double> dimensions, std::span<double, most> room) const;
    std::vector<Digits50> of(std::span<const Digits50> dimensions) const;

private:
    std::vector<std::size_t> dimensions_;
    bool are_the_first_ = true;
};

/// Where a measure writes its smooth components. Derivatives are with respect to its arguments; an empty span is not
/// asked for and costs nothing.
struct Measurement {
    std::span<double> value;     ///< [component]
    std::span<double> gradient;  ///< [component][argument]
    std::span<double> hessian;   ///< [component][pair], lower triangle by rows
};

/// How a quantity follows from its components. Each component is smooth in the dimensions; the quantity itself need not
/// be, so optimisers are given the components.
enum class Reduce { only, least, greatest };

/// What a quantity says of a coupler path, if it does.
enum class PathMeasure { none, sum_of_squares, root_mean_square, greatest };

/// In place of the number of a target, where all of them together are meant.
inline constexpr std::size_t every_target = static_cast<std::size_t>(-1);

struct Quantity {
    std::string name;
    Unit unit;
    std::string meaning;
    Reduce reduce = Reduce::only;
    Reads reads{};  ///< the dimensions that it depends on

    /// Whether it has a value for designs of this motion's family. What is not defined cannot be required there.
    bool (*defined)(const Motion&) = nullptr;
    /// How many components it has over this motion; at most `most_components`.
    std::size_t (*components)(const Motion&) = nullptr;
    /// Components by the formulas the optimisers use.
    void (*measure)(const Motion&, std::span<const double> arguments, const Measurement& out) = nullptr;
    /// The quantity measured again over the continuous motion in extended precision, by another way than `measure`.
    Digits50 (*measure_again)(const Motion&, std::span<const Digits50> arguments) = nullptr;

    PathMeasure path = PathMeasure::none;  ///< path quantities have none of the four functions
    std::size_t of_target = every_target;  ///< of several targets of its section that one alone; else all of them
    bool worst_first = false;              ///< the first component always is the quantity; the others are runners-up
    bool paired = false;     ///< each second component is the negative of the one before: of absolute values
    std::string section{};   ///< it has a value only in problems with this section
    Model of{};              ///< what it is measured of, where one function measures several
    bool of_motion = false;  ///< it depends on which crank angles are passed
    bool whole = false;      ///< over the whole motion, where others are over a part of it (whole_quantities.h)

    static constexpr std::size_t most_components = 32;
};

/// The motion as the functions of a quantity get it.
Motion motion_for(const Quantity& quantity, Motion motion);

/// Whether it has a value over a motion, and how many components.
bool is_defined(const Quantity& quantity, const Motion& motion);
std::size_t count_components(const Quantity& quantity, const Motion& motion);

/// A quantity's components of a design, whose dimensions are in mechanism order.
void measure(const Quantity& quantity, const Motion& motion, std::span<const double> dimensions,
             const Measurement& out);

/// The quantity of a design, measured again.
Digits50 measure_again(const Quantity& quantity, const Motion& motion, std::span<const Digits50> dimensions);

}  // namespace mechwright
