#include "synthesis/mechanism/linkage/targets/guidance.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "analysis/linkage/motion/driven.h"
#include "analysis/linkage/placing/needed.h"
#include "synthesis/mechanism/linkage/again/follow.h"
#include "synthesis/mechanism/linkage/targets/needed_guidance.h"
#include "synthesis/mechanism/linkage/targets/seeded.h"

namespace mechwright {

namespace {

constexpr std::size_t most_arguments = 64;  // for which no memory is asked for

/// The guided point in the drawing, and the direction in which a body on its link faces there.
template <class T>
struct Guided {
    std::array<T, 4> coordinates;  ///< of the point, then of the direction
    double margin;                 ///< the least of all dyads
};

/// Whether a margin is to a stop of the slide that drives which no dimension changes. Displacements of targets are kept
/// on the stroke by what asks for them (input.h), and may be its ends, where rounding would decide of a margin.
bool is_end_of_stroke(const LinkageModel& model, std::size_t margin) {
    if (!model.driven_by_slide() || !model.order.is_stop(margin)) return false;
    const linkage::Step& step = linkage::step_of(model.order, margin);
    const linkage::Stops& stops = model.structure.drives.front().stops;
    return step.input == 0 && model.numbers[step.reversed ? *stops.max : *stops.min].terms.empty();
}

double least_margin(const LinkageModel& model, const linkage::Pose<double>& pose) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pose.margins.size(); ++i)
        for (const double one : {pose.margins[i].outer, pose.margins[i].inner})
            if (!(one >= least) && !is_end_of_stroke(model, i)) least = one;
    return least;
}

/// Where the linkage does not close, its dyads stand at their limits. `body` is the angle from the link to the body.
template <class T>
Guided<T> guided(const LinkageModel& model, const Form& form, const Ways& ways, std::span<const T> dimensions,
                 const T& crank_angle, const T& body) {
    using std::cos, std::sin;
    const GuidedPoint& point = model.guided[form.guided];
    const std::vector<T> numbers = numbers_of(model, dimensions);
    linkage::Driven<T> driven(model.structure, model.order, std::span<const T>(numbers), model.sides[form.assembly],
                              laws_of(model));
    driven.shortfall = std::numeric_limits<double>::infinity();
    driven.set_ways(ways);
    driven.place(crank_angle);
    const T tilt = model.placement[2].at(dimensions);
    const Vector<T> across{cos(tilt), sin(tilt)}, turn{cos(body), sin(body)};
    const Vector<T> at = turned(driven.pose.pins[point.pin], across);
    const Vector<T> facing = turned(turned(driven.pose.links[point.link].along, across), turn);
    const T scale = model.scale.at(dimensions);
    Guided<T> made{{model.placement[0].at(dimensions) + scale * at.x, model.placement[1].at(dimensions) + scale * at.y,
                    facing.x, facing.y},
                   0};
    if constexpr (std::is_same_v<T, double>) made.margin = least_margin(model, driven.pose);
    return made;
}

/// Where the derivatives of one coordinate are written to.
struct Into {
    std::span<double> gradient, hessian;
};

/// The Hessian of coordinates by sweeps back in dual numbers.
template <std::size_t Count>
void add_hessians(const LinkageModel& model, const Form& form, std::span<const double> arguments,
                  const std::array<Into, Count>& into) {
    using First = Dual<double, seeded_at_once>;
    const std::size_t n = arguments.size();
    WorkingRow<First, most_arguments> room;
    const std::span<First> seeded = room.of(n);
    for (std::size_t from = 0; from < n; from += seeded_at_once) {
        std::copy(arguments.begin(), arguments.end(), seeded.begin());
        const std::size_t end = std::min(from + seeded_at_once, n);
        for (std::size_t i = from; i < end; ++i)
            seeded[i] = First::variable(arguments[i], i - from);
        NeededGuidance<First> at(model, form, seeded, Count == 4);
        for (std::size_t c = 0; c < Count; ++c) {
            const std::span<const First> gradient = at.gradient(c);
            for (std::size_t more = from; more < n; ++more)
                for (std::size_t less = from; less < std::min(end, more + 1); ++less)
                    into[c].hessian[more * (more + 1) / 2 + less] = -gradient[more].partial[less - from];
        }
    }
}

/// What is missed by the steps that the guided point needs alone; nothing where these do not say where it is.
template <std::size_t Count>
std::optional<double> miss_needed(const LinkageModel& model, const Form& form, std::span<const double> arguments,
                                  const std::array<double, Count>& wanted, std::array<double, Count>& missed,
                                  const std::array<Into, Count>& into) {
    if (!model.guided[form.guided].needed.closed) return {};
    NeededGuidance<double> at(model, form, arguments, Count == 4);
    if (!at.exists()) return {};
    for (std::size_t c = 0; c < Count; ++c) {
        missed[c] = wanted[c] - at.coordinate(c);
        if (into[c].gradient.empty()) continue;
        const std::span<const double> gradient = at.gradient(c);
        std::transform(gradient.begin(), gradient.end(), into[c].gradient.begin(), std::negate<>());
    }
    if (!into[0].hessian.empty()) add_hessians(model, form, arguments, into);
    return at.least_margin();
}

/// Makes derivatives by the last of so many arguments, which was multiplied by a factor, those by what it was.
template <std::size_t Count>
void by_factor(const std::array<Into, Count>& into, std::size_t arguments, double factor) {
    const std::size_t last = arguments - 1;
    for (const Into& one : into) {
        if (!one.gradient.empty()) one.gradient[last] *= factor;
        if (one.hessian.empty()) continue;
        const std::size_t row = last * (last + 1) / 2;
        for (std::size_t i = 0; i <= last; ++i)
            one.hessian[row + i] *= i < last ? factor : factor * factor;
    }
}

/// What is missed of the first of four coordinates, with its derivatives by the dimensions, the angle of the body where
/// it is guided, and the input of the analysis.
template <std::size_t Count>
double miss_at_input(Form form, std::span<const double> dimensions, double input,
                     const std::array<double, Count>& wanted, std::array<double, Count>& missed,
                     const std::array<Into, Count>& into) {
    const LinkageModel& model = linkage_of(form.model);
    constexpr bool faces = Count == 4;
    WorkingRow<double, most_arguments> room;
    const std::span<double> arguments = room.of(dimensions.size() + 1);
    std::copy(dimensions.begin(), dimensions.end(), arguments.begin());
    arguments.back() = input;
    if (const auto margin = miss_needed(model, form, arguments, wanted, missed, into)) return *margin;
    const std::size_t n = arguments.size(), lengths = n - (faces ? 2 : 1);
    const Ways ways = ways_of(model, arguments.first(lengths), form.assembly);
    const auto place = [&]<class T>(std::span<const T> x) {
        return guided<T>(model, form, ways, x.first(lengths), x[n - 1], faces ? x[n - 2] : T(0));
    };
    const Guided<double> here = place(std::span<const double>(arguments));
    for (std::size_t c = 0; c < Count; ++c)
        missed[c] = wanted[c] - here.coordinates[c];
    if (!into[0].hessian.empty())
        by_pairs(arguments, [&](const auto& seeded, const SeededPair& carried) {
            const auto at = place(seeded);
            for (std::size_t c = 0; c < Count; ++c) {
                for (std::size_t v = 0; v < seeded_at_once && !into[c].gradient.empty(); ++v)
                    if (carried[v] < n) into[c].gradient[carried[v]] = -at.coordinates[c].first[v];
                for_each_pair(carried, n, [&](std::size_t v, std::size_t w, std::size_t entry) {
                    into[c].hessian[entry] = -at.coordinates[c].mixed(v, w);
                });
            }
        });
    else if (!into[0].gradient.empty())
        by_few(arguments, [&](const auto& seeded, std::size_t from, std::size_t count) {
            const auto at = place(seeded);
            for (std::size_t c = 0; c < Count; ++c)
                for (std::size_t i = 0; i < count; ++i)
                    into[c].gradient[from + i] = -at.coordinates[c].partial[i];
        });
    return here.margin;
}

/// The same for a crank angle, or a displacement among the arguments, and by that.
template <std::size_t Count>
double miss(Form form, std::span<const double> dimensions, double crank_angle, const std::array<double, Count>& wanted,
            std::array<double, Count>& missed, const std::array<Into, Count>& into) {
    const double factor = linkage_of(form.model).input_per_argument();
    const double margin = miss_at_input<Count>(form, dimensions, factor * crank_angle, wanted, missed, into);
    if (factor != 1) by_factor(into, dimensions.size() + 1, factor);
    return margin;
}

void miss_point(Form form, std::span<const double> dimensions, double crank_angle, const Vector<double>& target,
                PathMiss& out) {
    std::array<double, 2> missed{};
    out.margin = miss<2>(form, dimensions, crank_angle, {target.x, target.y}, missed,
                         {Into{out.gradient_x, out.hessian_x}, Into{out.gradient_y, out.hessian_y}});
    out.miss = {missed[0], missed[1]};
}

void miss_body(Form form, std::span<const double> dimensions, double crank_angle, const Vector<double>& target,
               const Vector<double>& facing, PoseMiss& out) {
    std::array<double, 4> missed{};
    out.place.margin = out.turn.margin =
        miss<4>(form, dimensions, crank_angle, {target.x, target.y, facing.x, facing.y}, missed,
                {Into{out.place.gradient_x, out.place.hessian_x}, Into{out.place.gradient_y, out.place.hessian_y},
                 Into{out.turn.gradient_x, out.turn.hessian_x}, Into{out.turn.gradient_y, out.turn.hessian_y}});
    out.place.miss = {missed[0], missed[1]};
    out.turn.miss = {missed[2], missed[3]};
}

/// The pose in fifty digits by the equations of all joints, from that of the dyads on their sides; none where they do
/// not close.
std::optional<LoopPose<Digits50>> pose_again(Form form, std::span<const Digits50> dimensions,
                                             const Digits50& crank_angle) {
    const LinkageModel& model = linkage_of(form.model);
    std::vector<double> plain;
    for (const Digits50& d : dimensions)
        plain.push_back(d.convert_to<double>());
    linkage::Driven<double> moving = driven(model, plain, form.assembly);
    moving.shortfall = 1e-13 * size_of(moving);
    const auto near = pose_of_dyads(moving, model.input_of(crank_angle.convert_to<double>()));
    if (!near) return {};
    Follower<Digits50> precise(model, numbers_of(model, dimensions));
    if (!precise.start(crank_angle, pose_as<Digits50>(*near))) return {};
    return precise.pose;
}

Vector<Digits50> point_in_fifty_digits(Form form, std::span<const Digits50> dimensions, const Digits50& crank_angle) {
    const LinkageModel& model = linkage_of(form.model);
    const auto pose = pose_again(form, dimensions, crank_angle);
    if (!pose) return {Digits50(std::numeric_limits<double>::quiet_NaN()), 0};
    const Loop<Digits50> loop(model.structure, numbers_of(model, dimensions));
    const Digits50 tilt = model.placement[2].at(dimensions), scale = model.scale.at(dimensions);
    const Vector<Digits50> at =
        turned(loop.pin(model.guided[form.guided].pin, *pose), Vector<Digits50>{cos(tilt), sin(tilt)});
    return {model.placement[0].at(dimensions) + scale * at.x, model.placement[1].at(dimensions) + scale * at.y};
}

Digits50 direction_in_fifty_digits(Form form, std::span<const Digits50> dimensions, const Digits50& crank_angle) {
    const LinkageModel& model = linkage_of(form.model);
    const auto pose = pose_again(form, dimensions, crank_angle);
    if (!pose) return std::numeric_limits<double>::quiet_NaN();
    return pose->turns[model.guided[form.guided].link] + model.placement[2].at(dimensions);
}

/// The dimension that a number is, if it is just that.
std::size_t dimension_of(const Affine& number) {
    const bool plain = number.constant == 0 && number.terms.size() == 1 && number.terms.front().second == 1;
    return plain ? number.terms.front().first : no_dimension;
}

/// Of how many numbers of the links a dimension is a part.
std::size_t uses_of(const LinkageModel& model, std::size_t dimension) {
    return static_cast<std::size_t>(std::count_if(model.numbers.begin(), model.numbers.end(), [&](const Affine& a) {
        return std::any_of(a.terms.begin(), a.terms.end(), [&](const auto& term) { return term.first == dimension; });
    }));
}

}  // namespace

linkage::Needed needed_for_guidance(const LinkageModel& model, const GuidedPoint& guided) {
    linkage::Needed needed = linkage::needed_of(model.structure, model.order, model.numbers.size(), guided.pin,
                                                guided.is_body ? guided.link : linkage::none, true);
    assert(needed.margins.empty() || needed.margins.size() == model.order.margins);
    for (std::size_t i = needed.margins.size(); i-- > 0;)
        if (is_end_of_stroke(model, i)) needed.margins.erase(needed.margins.begin() + static_cast<std::ptrdiff_t>(i));
    return needed;
}

PathRoles linkage_path_roles(const LinkageModel& model, const GuidedPoint& guided) {
    PathRoles roles{no_dimension, no_dimension, dimension_of(model.placement[0]), dimension_of(model.placement[1]),
                    dimension_of(model.placement[2])};
    const linkage::Pin& pin = model.structure.pins[guided.pin];
    if (const linkage::Coordinates& at = pin.points.front().at; pin.points.size() == 1 && !at.polar) {
        const std::size_t along = dimension_of(model.numbers[at.first]),
                          across = dimension_of(model.numbers[at.second]);
        const auto is_its_own = [&](std::size_t d) { return d != no_dimension && uses_of(model, d) == 1; };
        if (along != across && is_its_own(along) && is_its_own(across)) {
            roles.along = along;
            roles.across = across;
        }
    }
    return roles;
}

PointGuidance linkage_point_guidance(const LinkageModel& model, std::size_t dimensions) {
    PointGuidance guidance;
    guidance.reads = Reads(dimensions);
    guidance.named = true;
    guidance.roles = linkage_path_roles(model, model.guided.front());
    guidance.miss = miss_point;
    guidance.point = point_in_fifty_digits;
    return guidance;
}

Vector<double> guided_point_of_linkage(Form form, std::span<const double> dimensions, double crank_angle) {
    const LinkageModel& model = linkage_of(form.model);
    const Ways ways = ways_of(model, dimensions, form.assembly);
    const double input = model.input_per_argument() * crank_angle;
    const auto at = guided(model, form, ways, dimensions, input, 0.0).coordinates;
    return {at[0], at[1]};
}

BodyGuidance linkage_body_guidance(const LinkageModel& model, const GuidedPoint& guided, std::size_t dimensions) {
    BodyGuidance guidance;
    guidance.reads = Reads(dimensions);
    guidance.angle_from = "the x axis of the link '" + model.links[guided.link] + "'";
    guidance.miss = miss_body;
    guidance.direction = direction_in_fifty_digits;
    return guidance;
}

}  // namespace mechwright
