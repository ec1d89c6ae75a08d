#include <numbers>

#include "analysis/cam/roller_follower.h"
#include "analysis/cam/segment.h"
#include "synthesis/bench/extremes/cases.h"
#include "synthesis/bench/extremes/given_design.h"
#include "synthesis/exact/closed_form/closed_form.h"

namespace mechwright::bench {

namespace {

using namespace cam;

constexpr std::size_t mechanisms = 16;

constexpr std::string_view motion_text = R"(
[[segment]]
kind = "rise"
angle = 90
lift = 20
law = "cycloidal"
[[segment]]
kind = "dwell"
angle = 90
[[segment]]
kind = "return"
angle = 90
lift = 20
law = "cycloidal"
[[segment]]
kind = "dwell"
angle = 90
)";

constexpr std::string_view translating_text = R"(schema = 1
mechanism = "cam"
[cam]
follower = "roller"
[dimensions]
prime-radius = 40
offset = 5
roller-radius = 8
)";

constexpr std::string_view oscillating_text = R"(schema = 1
mechanism = "cam"
[cam]
follower = "roller"
motion = "oscillating"
[dimensions]
prime-radius = 40
pivot-distance = 93
arm-length = 80
roller-radius = 8
)";

constexpr std::string_view size_text = R"(schema = 1
mechanism = "cam"
[cam]
follower = "knife"
[dimensions]
prime-radius = { min = 5, max = 200 }
offset = { min = -50, max = 50 }
[[require]]
quantity = "pressure-angle-rise"
max = 30
[[require]]
quantity = "pressure-angle-return"
max = 45
[objective]
minimize = "prime-radius"
)";

std::shared_ptr<const Problem> cam_problem(std::string_view text) {
    return problem_of(std::string(text) + std::string(motion_text));
}

/// Of the motion above, for a lift in its unit.
Segment<double> segment(SegmentKind kind, double lift) {
    return {kind, {SegmentLaw::Form::law, Law::cycloidal, false}, std::numbers::pi / 2, lift};
}

/// The samples are of the whole turn, a quarter of them of the rise.
template <class Follower>
double sampled_pressure_angle(const Follower& follower, double lift, int samples) {
    const Segment<double> rise = segment(SegmentKind::rise, lift);
    double greatest = 0;
    for (int i = 0; i <= samples / 4; ++i) {
        const auto p = pitch_point(follower, lift_at(rise, 0, 4.0 * i / samples, 0.0));
        greatest = std::max(greatest, std::abs(pressure_angle(p)));
    }
    return greatest;
}

/// Cams of several sizes; `varied` changes the dimensions of number k, `sampled` knows the follower.
ExtremeCase pressure_angle_case(std::string_view name, std::string_view text,
                                const std::function<void(std::vector<double>&, std::size_t)>& varied,
                                std::function<double(const std::vector<double>&, int)> sampled) {
    const auto problem = cam_problem(text);
    const auto designs = std::make_shared<std::vector<GivenDesign>>();
    for (std::size_t k = 0; k < mechanisms; ++k) {
        std::vector<double> dimensions = dimensions_of(*problem);
        varied(dimensions, k);
        designs->emplace_back(problem, std::move(dimensions));
    }
    const auto index = static_cast<std::size_t>(find_quantity(*problem->mechanism, "pressure-angle-rise"));
    return {name, mechanisms, [=](std::size_t k, int samples) { return sampled((*designs)[k].dimensions, samples); },
            [=](std::size_t k) { return (*designs)[k].quantity(index); },
            [=](std::size_t k) { return (*designs)[k].quantity_again(index); }};
}

ExtremeCase translating() {
    return pressure_angle_case(
        "pressure angle, translating roller", translating_text,
        [](std::vector<double>& dimensions, std::size_t k) {
            dimensions[0] = 30 + 30 * random_number(k, 0);
            dimensions[1] = 10 * random_number(k, 1);
        },
        [](const std::vector<double>& d, int samples) {
            return sampled_pressure_angle(TranslatingRoller<double>{d[0], d[1], d[2], 1}, 20, samples);
        });
}

ExtremeCase oscillating() {
    return pressure_angle_case(
        "pressure angle, oscillating roller", oscillating_text,
        [](std::vector<double>& dimensions, std::size_t k) {
            dimensions[0] = 30 + 20 * random_number(k, 0);
            dimensions[1] = 88 + 10 * random_number(k, 1);
        },
        [](const std::vector<double>& d, int samples) {
            return sampled_pressure_angle(OscillatingRoller<double>{d[0], d[1], d[2], d[3], 1},
                                          20 * std::numbers::pi / 180, samples);
        });
}

/// The least prime radius: that of a cam centre as far below the follower's lowest position as the tangents to the
/// lift's curve ask, by limits of 30 degrees for the rise and 45 for the return. `p` and `q` are the greatest of
/// velocity times cot(limit), less the lift.
template <class T>
T size_of(const T& p, const T& q) {
    using std::hypot, std::sqrt;
    const T root = sqrt(T(3)), offset = (p - q) / (root + 1);
    return hypotenuse(offset, T(p - root * offset));
}

double sampled_size(int samples) {
    const Segment<double> rise = segment(SegmentKind::rise, 20), fall = segment(SegmentKind::fall, 20);
    double p = 0, q = 0;
    for (int i = 0; i <= samples / 4; ++i) {
        const double u = 4.0 * i / samples;
        const auto up = lift_at(rise, 0, u, 0.0), down = lift_at(fall, 0, u, 20.0);
        p = std::max(p, up.v * std::sqrt(3.0) - up.s);
        q = std::max(q, -down.v - down.s);
    }
    return size_of(p, q);
}

/// (h/pi) (t - atan t) with t = 2 pi cot(limit) / angle, where the cycloidal law's slope is the limit's.
Digits50 size_in_digits() {
    const auto extreme = [](const Digits50& t) { return Digits50(20 / pi<Digits50>() * (t - atan(t))); };
    return size_of(extreme(Digits50(4 * sqrt(Digits50(3)))), extreme(4));
}

/// The exact one with its certificate and all requirements evaluated.
ExtremeCase cam_size() {
    const auto problem = cam_problem(size_text);
    return {"smallest cam", 1, [](std::size_t, int samples) { return sampled_size(samples); },
            [=](std::size_t) { return solve_in_closed_form(*problem)->best->objective; },
            [](std::size_t) { return size_in_digits(); }};
}

}  // namespace

std::vector<ExtremeCase> cam_extremes() { return {translating(), oscillating(), cam_size()}; }

}  // namespace mechwright::bench
