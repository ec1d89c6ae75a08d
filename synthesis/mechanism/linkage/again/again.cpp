#include "synthesis/mechanism/linkage/again/again.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "synthesis/mechanism/linkage/again/follow.h"
#include "synthesis/mechanism/over_range.h"

namespace mechwright {

std::optional<LoopPose<double>> pose_of_dyads(linkage::Driven<double>& moving, double input) {
    if (!moving.place(input)) return {};
    LoopPose<double> pose;
    constexpr double the_same = 1e-6;
    for (std::size_t i = 0; i < moving.pose.links.size(); ++i) {
        const linkage::LinkPlace<double>& link = moving.pose.links[i];
        pose.origins.push_back(link.origin);
        // Gears know whole turns, where they are known.
        const double turn = moving.pose.turns[i];
        const bool known = std::hypot(std::cos(turn) - link.along.x, std::sin(turn) - link.along.y) < the_same;
        pose.turns.push_back(known ? turn : std::atan2(link.along.y, link.along.x));
    }
    return pose;
}

namespace {

constexpr double bracket = 1e-7;     // radians, within which doubles find the end of a motion
constexpr double end_within = 1e-9;  // radians, that an end may be off

/// A linkage with the means to follow it, first in doubles.
struct FollowedMotion {
    const LinkageModel& model;
    std::vector<Digits50> dimensions;
    linkage::Driven<double> moving;
    Follower<double> plain;

    FollowedMotion(Form form, std::span<const Digits50> d, const std::vector<double>& rounded)
        : model(linkage_of(form.model)),
          dimensions(d.begin(), d.end()),
          moving(driven(model, rounded, form.assembly)),
          plain(model, numbers_of(model, std::span<const double>(rounded))) {}

    /// Stands at an input between two others, if the dyads close somewhere there.
    bool start_between(double from, double to) {
        constexpr double golden = 0.38196601125010515;
        constexpr int most_tries = 64;
        for (int i = 1; i <= most_tries; ++i) {
            const double at = from + (to - from) * std::fmod(i * golden, 1.0);
            const auto pose = pose_of_dyads(moving, model.input_of(at));
            if (pose && plain.start(at, *pose)) return true;
        }
        return false;
    }

    /// The input, up to `beyond`, at which the pose where `plain` stands comes to its end: halving, in fifty digits,
    /// between where there is a pose and where there is none.
    double end_toward(double beyond) const {
        Follower<Digits50> precise(model, numbers_of(model, std::span<const Digits50>(dimensions)));
        if (!precise.start(plain.at, pose_as<Digits50>(plain.pose))) return plain.at;
        const double way = beyond > plain.at ? 1 : -1;
        double step = std::min(4 * bracket * plain.unit(), std::abs(beyond - plain.at));
        const double enough = 1e-16 * (plain.unit() + std::abs(plain.at));
        for (; step > enough; step /= 2)
            if (const double to = precise.at.convert_to<double>() + way * step; (beyond - to) * way >= 0)
                precise.step(to);
        return precise.at.convert_to<double>();
    }

    /// Follows from where it stands towards an end; where it comes to.
    template <class Use>
    double follow(double end, const Use& use) {
        return plain.follow(end, bracket, use) ? end : end_toward(end);
    }
};

std::vector<double> rounded(std::span<const Digits50> dimensions) {
    std::vector<double> plain;
    for (const Digits50& d : dimensions)
        plain.push_back(d.convert_to<double>());
    return plain;
}

Motion own_motion(Form form, std::span<const Digits50> dimensions) {
    const std::vector<double> plain = rounded(dimensions);
    const LinkageModel& model = linkage_of(form.model);
    Motion motion;
    motion.full_turn = false;
    motion.family = model.driven_by_slide() ? 0 : 1;
    motion.from = 1;
    const Motion stated = motion_of_linkage(form, plain, nullptr);  // which of several motions is meant
    if (!(stated.from <= stated.to)) return motion;
    FollowedMotion followed(form, dimensions, plain);
    if (!followed.start_between(stated.from, stated.to)) return motion;
    const linkage::Inputs inputs = inputs_of(model, plain, followed.moving);
    const double at = followed.plain.at, way = 2 * std::numbers::pi * model.turns;
    const LoopPose<double> start = followed.plain.pose;
    const auto pass = [](const auto&) {};
    const double last = followed.follow(inputs.cyclic ? at + way : model.of_motion(inputs.to), pass);
    if (inputs.cyclic && last == at + way) {
        motion.full_turn = true;
        motion.family = 0;
        motion.from = 0;
        motion.to = way;
        return motion;
    }
    motion.to = last;
    if (followed.plain.start(at, start))
        motion.from = followed.follow(inputs.cyclic ? at - way : model.of_motion(inputs.from), pass);
    return motion;
}

/// On which side a dyad is closed, times a length: > 0 left or ahead.
double side_of(const linkage::Structure& s, const linkage::Group& group, const Follower<double>& follower) {
    const Loop<double>& loop = follower.loop;
    const Vector<double> first = loop.pin(group.outer[0], follower.pose), inner = loop.pin(group.pin, follower.pose);
    if (group.kind == linkage::Group::Kind::rrr)
        return cross(loop.pin(group.outer[1], follower.pose) - first, inner - first);
    const linkage::Line& line = group.by_slide ? s.slides[group.joint].line : s.slots[group.joint].line;
    return dot(loop.direction(line, follower.pose), inner - first);
}

/// The dyads that leave their sides along the way, by their inner pins, and the input where each is first seen to.
struct Sides {
    const LinkageModel& model;
    std::size_t assembly;
    std::vector<std::pair<std::string, double>> left{};

    void operator()(const Follower<double>& follower) {
        const double size = follower.loop.size();
        constexpr double rounding = 1e-7;  // at a limit places are as exact as the root of the digits
        for (const linkage::Group& group : model.order.groups) {
            if (group.choice == linkage::none) continue;
            const double unit = group.kind == linkage::Group::Kind::rrr ? size * size : size;
            const double side = side_of(model.structure, group, follower) * model.sides[assembly][group.choice];
            const std::string& pin = model.pins[group.pin];
            const auto is_pin = [&](const auto& known) { return known.first == pin; };
            if (side < -rounding * unit && std::none_of(left.begin(), left.end(), is_pin))
                left.emplace_back(pin, follower.at);
        }
    }
};

/// By how much a linkage in fifty digits fails to come to one of several inputs on the way; absent where all have
/// poses.
std::optional<double> lost_at(const LinkageModel& model, std::span<const Digits50> dimensions,
                              const std::vector<std::pair<double, LoopPose<double>>>& poses) {
    Follower<Digits50> precise(model, numbers_of(model, dimensions));
    for (const auto& [at, pose] : poses)
        if (!precise.start(at, pose_as<Digits50>(pose))) return at;
    return {};
}

/// Where larger groups, as the joints' equations lead them, are not on the branch on which they were measured; absent
/// where they are everywhere.
std::optional<double> astray_at(const LinkageModel& model, linkage::Driven<double>& moving,
                                const std::vector<std::pair<double, LoopPose<double>>>& poses) {
    constexpr double within = 1e-5;  // near a limit places are as exact as the root of the digits
    for (const auto& [at, pose] : poses) {
        if (!moving.place(model.input_of(at))) return at;
        for (const linkage::LargerGroup& group : model.order.larger)
            for (const linkage::LinkUnknown& unknown : group.unknowns) {
                const Vector<double> apart = moving.pose.links[unknown.link].along - pose.along(unknown.link);
                if (!(std::hypot(apart.x, apart.y) <= within)) return at;
            }
    }
    return {};
}

std::string input_text(const LinkageModel& model, double input) {
    return model.driven_by_slide() ? fmt::format("displacement {:.9g}", input)
                                   : fmt::format("crank angle {:.9g} deg", input * 180 / std::numbers::pi);
}

}  // namespace

Motion linkage_motion_again(Form form, std::span<const Digits50> dimensions,
                            const std::optional<Vector<Digits50>>& crank_range) {
    Motion motion;
    if (crank_range) {
        motion.family = linkage_of(form.model).driven_by_slide() ? 0 : 1;
        motion = over_range(motion, *crank_range);
    } else {
        motion = own_motion(form, dimensions);
    }
    motion.assembly = form.assembly;
    return motion;
}

std::vector<Check> check_linkage_motion(const Motion& motion, std::span<const Digits50> dimensions) {
    const char *closes = "joints close over the whole motion", *stays = "dyads stay on their sides";
    const LinkageModel& model = linkage_of(motion.model);
    const std::vector<double> plain = rounded(dimensions);
    if (!(motion.from <= motion.to)) return {{closes, false, "it assembles nowhere"}};
    FollowedMotion followed({motion.model, motion.assembly}, dimensions, plain);
    if (!followed.start_between(motion.from, motion.to))
        return {{closes, false, "no pose of its dyads closes its loops"}};
    Sides sides{model, motion.assembly};
    std::vector<std::pair<double, LoopPose<double>>> some;
    int count = 0;
    const auto see = [&](const Follower<double>& follower) {
        constexpr int every = 24;
        sides(follower);
        if (count++ % every == 0) some.emplace_back(follower.at, follower.pose);
    };
    const double at = followed.plain.at;
    const LoopPose<double> start = followed.plain.pose;
    const double last = followed.follow(motion.to, see);
    const LoopPose<double> at_end = followed.plain.pose;
    double first = motion.from;
    if (followed.plain.start(at, start)) first = followed.follow(motion.from, see);
    const double unit = followed.plain.unit();
    for (const auto& [reached, end] : {std::pair(last, motion.to), std::pair(first, motion.from)})
        if (std::abs(reached - end) > end_within * unit)
            return {{closes, false, fmt::format("it comes apart at {}", input_text(model, reached))}};
    if (const auto lost = lost_at(model, dimensions, some))
        return {{closes, false, fmt::format("in fifty digits it does not close at {}", input_text(model, *lost))}};
    std::vector<Check> checks{
        {closes, true, fmt::format("followed in {} steps, {} of them in fifty digits", count, some.size())}};
    if (motion.full_turn) {
        double apart = 0;
        for (std::size_t i = 0; i < at_end.turns.size(); ++i) {
            const Vector<double> way = at_end.origins[i] - followed.plain.pose.origins[i];
            const double turn = at_end.turns[i] - followed.plain.pose.turns[i];
            apart =
                std::max({apart, std::hypot(way.x, way.y) / followed.plain.loop.size(), std::abs(std::sin(turn / 2))});
        }
        checks.push_back({"comes back to where it began", apart < end_within,
                          fmt::format("to {:.2g} of its size after {} of the drive", apart,
                                      model.turns == 1 ? "a turn" : fmt::format("{} turns", model.turns))});
    }
    if (!model.order.closed()) {
        const auto astray = astray_at(model, followed.moving, some);
        checks.push_back({"larger groups stay on their branch", !astray,
                          astray ? "not at " + input_text(model, *astray)
                                 : fmt::format("at {} poses that the joints' equations lead to", some.size())});
    }
    if (model.sides[motion.assembly].empty()) return checks;
    std::string places;
    for (const auto& [pin, input] : sides.left)
        places += fmt::format("{}{} near {}", places.empty() ? "" : ", ", pin, input_text(model, input));
    checks.push_back({stays, sides.left.empty(),
                      sides.left.empty() ? "all over the motion"
                                         : "not at " + places +
                                               ": it goes straight through a change point, where it may take either"});
    return checks;
}

}  // namespace mechwright
