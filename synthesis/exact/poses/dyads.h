#pragma once
/// \file
/// Dyads that guide a body through given poses (Burmester): a point of the body that stays equally far from a fixed
/// point, so that a link can join the two.
///
/// In complex numbers, with the body's reference point of the first pose as the origin: moving pivot x (in the first
/// pose) and fixed pivot a. A displacement that shifts the reference point by d and turns the body by T = e^(i angle)
/// takes the moving pivot to d + x T, and |d + x T - a| = |x - a| means, multiplied out,
///     |d|^2 - 2 Re(conj(d) a) + 2 Re(conj(d) T x) + 2 Re((1 - T) x conj(a)) = 0:
/// one linear equation in the seven numbers 1, a, x and x conj(a), real and imaginary parts. Four displacements leave
/// three dimensions of such sevens; that the last two are the product of the others makes two conics in their
/// projective plane, which meet in four points.

#include <Eigen/Core>
#include <array>
#include <complex>
#include <optional>
#include <span>
#include <vector>

namespace mechwright {

/// A displacement of a body from its first pose.
struct Displacement {
    std::complex<double> shift;  ///< of its reference point
    std::complex<double> turn;   ///< e^(i angle)
};

/// A dyad over the complex numbers: coordinates of both pivots, which are real where it can be built.
struct ComplexDyad {
    std::array<std::complex<double>, 2> fixed;
    std::array<std::complex<double>, 2> moving;  ///< in the first pose
};

/// A dyad that can be built.
struct Dyad {
    std::complex<double> fixed;
    std::complex<double> moving;  ///< in the first pose
};

/// A moving pivot whose places lie on a straight line: the dyad of a slider.
struct SliderDyad {
    std::complex<double> moving;  ///< in the first pose
    std::complex<double> normal;  ///< of the slide line, of length 1
};

/// Linear conditions on (1, a.x, a.y, x.x, x.y, Re(x conj(a)), Im(x conj(a))).
using DyadCondition = Eigen::Matrix<double, 1, 7>;
using DyadConditions = Eigen::Matrix<double, 4, 7>;

DyadCondition condition_of(const Displacement& displacement);
/// The fixed pivot lies on the line through a point in a direction.
DyadCondition fixed_pivot_on_line(std::complex<double> point, std::complex<double> direction);
/// The moving pivot lies, in the first pose, on the line through a point in a direction.
DyadCondition moving_pivot_on_line(std::complex<double> point, std::complex<double> direction);

/// What four conditions leave.
struct DyadSolutions {
    std::vector<ComplexDyad> dyads;      ///< regular ones, four at most, each corrected by Newton's method
    std::size_t at_infinity = 0;         ///< a pivot of these lies infinitely far away
    std::size_t singular = 0;            ///< coincide with others, as far as doubles tell
    std::vector<ComplexDyad> unsettled;  ///< where Newton's method ended for these
    bool isolated = true;                ///< false: the conditions are not independent, and whole families meet them
};

/// The dyads that meet four conditions: four over the complex numbers. Lengths should be near 1.
DyadSolutions dyads_meeting(const DyadConditions& conditions);

/// Those that guide a body through five poses.
DyadSolutions dyads_through(std::span<const Displacement, 4> displacements);

/// The dyad of a given fixed pivot through three poses, where there is one.
std::optional<Dyad> dyad_with_fixed_pivot(std::complex<double> fixed, std::span<const Displacement, 2> displacements);

struct Line {
    std::complex<double> point;
    std::complex<double> direction;
};

/// The moving pivots that go with a fixed pivot through two poses: those of a line, given by its point nearest to the
/// body's reference point.
std::optional<Line> moving_pivots_of(std::complex<double> fixed, const Displacement& displacement);

/// How many numbers choose a slider dyad through so many poses, 2 to 4.
constexpr std::size_t numbers_of_slider(std::size_t poses) { return 4 - poses; }

/// A point of the body whose places in two to four poses lie on a line: in four poses the one that there is (Ball's
/// point), in fewer one that the numbers, in (0, 1), choose. Nothing where the poses leave more than that.
std::optional<SliderDyad> slider_through(std::span<const Displacement> displacements, std::span<const double> numbers);

/// Whether both pivots are real but for rounding, and the dyad as one that can be built.
std::optional<Dyad> real_dyad(const ComplexDyad& dyad);

/// How far the dyad is from guiding the body through a displacement, over the size of what cancels.
double residual(const ComplexDyad& dyad, const Displacement& displacement);

}  // namespace mechwright
