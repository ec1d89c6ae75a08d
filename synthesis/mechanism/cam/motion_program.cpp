#include "synthesis/mechanism/cam/motion_program.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>

namespace mechwright {

namespace {

using cam::Law;
using cam::SegmentLaw;

constexpr SegmentLaw full(Law law) { return {SegmentLaw::Form::law, law, false}; }
constexpr SegmentLaw to_rest(Law law) { return {SegmentLaw::Form::law, law, true}; }

constexpr std::array<NamedLaw, 19> laws{{
    {"constant-velocity", full(Law::constant_velocity)},
    {"parabolic", full(Law::parabolic)},
    {"harmonic", full(Law::harmonic)},
    {"double-harmonic", full(Law::double_harmonic)},
    {"cycloidal", full(Law::cycloidal)},
    {"modified-trapezoid", full(Law::modified_trapezoid)},
    {"modified-sine", full(Law::modified_sine)},
    {"modified-constant-velocity", full(Law::modified_constant_velocity)},
    {"3-4-5", full(Law::polynomial_345)},
    {"4-5-6-7", full(Law::polynomial_4567)},
    {"kloomok-muffley", full(Law::kloomok_muffley)},
    {"half-parabolic", full(Law::half_parabolic)},
    {"half-parabolic-to-rest", to_rest(Law::half_parabolic)},
    {"half-harmonic", full(Law::half_harmonic)},
    {"half-harmonic-to-rest", to_rest(Law::half_harmonic)},
    {"half-cycloidal", full(Law::half_cycloidal)},
    {"half-cycloidal-to-rest", to_rest(Law::half_cycloidal)},
    {"polynomial", {SegmentLaw::Form::polynomial, Law::polynomial_345, false}},
    {"spline", {SegmentLaw::Form::spline, Law::polynomial_345, false}},
}};

constexpr std::array<NamedLaw, 15> aliases{{
    {"straight-line", full(Law::constant_velocity)},
    {"quadratic-parabola", full(Law::parabolic)},
    {"constant-acceleration", full(Law::parabolic)},
    {"simple-sine", full(Law::harmonic)},
    {"simple-harmonic", full(Law::harmonic)},
    {"shm", full(Law::harmonic)},
    {"double-sine", full(Law::double_harmonic)},
    {"inclined-sine", full(Law::cycloidal)},
    {"bestehorn-sine", full(Law::cycloidal)},
    {"modified-acceleration-trapezoid", full(Law::modified_trapezoid)},
    {"modified-sine-line", full(Law::modified_sine)},
    {"mcv50", full(Law::modified_constant_velocity)},
    {"msc50", full(Law::modified_constant_velocity)},
    {"5th-degree-polynomial", full(Law::polynomial_345)},
    {"7th-degree-polynomial", full(Law::polynomial_4567)},
}};

template <class R>
cam::PeriodicSpline<R> spline_of(const std::vector<double>& angle, const std::vector<double>& lift, double range) {
    const R turn = 2 * boost::math::constants::pi<R>();
    std::vector<R> knot, value;
    for (const double a : angle)
        knot.push_back(R(a) / turn);
    for (const double s : lift)
        value.push_back(R(s) / R(range));
    return cam::periodic_spline<R>(knot, value);
}

}  // namespace

std::span<const NamedLaw> cam_laws() { return laws; }
std::span<const NamedLaw> cam_law_aliases() { return aliases; }

std::shared_ptr<const LiftTable> lift_table(std::vector<double> angle, std::vector<double> lift) {
    LiftTable table;
    const auto [least, greatest] = std::minmax_element(lift.begin(), lift.end());
    table.range = *greatest - *least;
    table.spline = spline_of<double>(angle, lift, table.range);
    table.spline_again = spline_of<Digits50>(angle, lift, table.range);
    table.angle = std::move(angle);
    table.lift = std::move(lift);
    return std::make_shared<const LiftTable>(std::move(table));
}

std::shared_ptr<const MotionProgram> contour_program(cam::ContourKind kind) {
    MotionProgram program;
    program.segments.emplace_back();
    program.segments.back().kind = cam::SegmentKind::cycle;
    program.segments.back().contour = kind;
    return std::make_shared<const MotionProgram>(std::move(program));
}

std::size_t law_choices(const MotionProgram& program) {
    std::size_t choices = 1;
    for (const SegmentPlan& segment : program.segments)
        choices *= std::max<std::size_t>(segment.laws.size(), 1);
    return choices;
}

std::size_t law_of(const MotionProgram& program, std::size_t assembly, std::size_t segment) {
    std::size_t choice = assembly / 2;
    for (std::size_t i = 0; i < segment; ++i)
        choice /= std::max<std::size_t>(program.segments[i].laws.size(), 1);
    const auto& candidates = program.segments[segment].laws;
    return candidates[choice % candidates.size()];
}

}  // namespace mechwright
