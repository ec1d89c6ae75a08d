#pragma once
/// \file
/// Triads: larger groups of one body on three ties that are one equation each, with the links of its legs. A tie holds
/// a place of the body at a distance from a placed one (a link between two pins), or on a placed line (a pin in a slot,
/// a slide), or a line of the body over a placed place. Two equations are linear in the body's place once they are
/// subtracted from a third; what is left is a trigonometric polynomial in its turn, with six zeros at most (reference:
/// one body on three ties; derivation).

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/linkage/groups/group_solver.h"
#include "analysis/linkage/groups/trigonometric.h"

namespace mechwright::linkage {

namespace detail {

/// One tie of the body: square |p|^2 + factor p + constant = 0 for the body's origin p.
struct BodyTie {
    enum class Kind { at_distance, on_line, over_place };
    Kind kind = Kind::at_distance;
    Vector<double> own{};                 ///< the place on the body; of `over_place` the normal of its line
    Vector<double> placed{};              ///< the placed place, or one of the placed line
    Vector<double> normal{};              ///< of the placed line
    double length = 0;                    ///< the distance; of `over_place` that of the line from the body's origin
    std::size_t leg = none;               ///< the link of the leg, if there is one
    Vector<double> leg_own{}, leg_far{};  ///< of a leg its place at the body, and its other one
    Vector<double> leg_turn{1, 0};        ///< its direction: against the body, or of a leg that slides as it is
};

struct TieEquation {
    double square;
    Vector<double> factor;
    double constant;
};

inline TieEquation equation_of(const BodyTie& tie, const Vector<double>& along) {
    const Vector<double> own = turned(tie.own, along);
    switch (tie.kind) {
        case BodyTie::Kind::at_distance: {
            const Vector<double> way = own - tie.placed;
            return {1, 2.0 * way, dot(way, way) - tie.length * tie.length};
        }
        case BodyTie::Kind::on_line: return {0, tie.normal, dot(tie.normal, own - tie.placed)};
        case BodyTie::Kind::over_place: break;
    }
    return {0, -own, dot(own, tie.placed) - tie.length};
}

/// Finds the body of a triad and its ties in a pose in which all that it hangs on is placed.
class TriadReader {
public:
    TriadReader(const Structure& s, const LargerGroup& group, std::span<const double> numbers, const Pose<double>& pose)
        : s_(s), numbers_(numbers), pose_(pose), in_(s.links, false), equations_(group.equations) {
        for (const LinkUnknown& unknown : group.unknowns) {
            if (!in_[unknown.link]) links_.push_back(unknown.link);
            in_[unknown.link] = true;
        }
    }

    std::size_t body = 0;
    std::vector<BodyTie> ties{};

    bool read() {
        for (const std::size_t link : links_) {
            body = link;
            ties.clear();
            if (read_ties() && ties.size() == 3) {
                std::stable_sort(ties.begin(), ties.end(),
                                 [](const BodyTie& a, const BodyTie& b) { return a.kind < b.kind; });
                return true;
            }
        }
        return false;
    }

private:
    using Kind = LoopEquation::Kind;

    Vector<double> place(std::size_t pin, std::size_t link) const {
        return place_of(coordinates_on(s_.pins[pin], link), numbers_);
    }
    std::optional<Vector<double>> placed(std::size_t pin) const {
        for (const Point& point : s_.pins[pin].points)
            if (!in_[point.link]) return pose_.links[point.link].at(place_of(point.at, numbers_));
        return {};
    }
    bool read_ties() {
        for (const LoopEquation& e : equations_) {
            if (e.kind == Kind::gear || e.kind == Kind::rack || e.kind >= Kind::drive_turn) return false;
            if (e.kind == Kind::slot && !read_slot(e)) return false;
        }
        return std::all_of(links_.begin(), links_.end(),
                           [this](std::size_t link) { return link == body || leg(link); });
    }
    bool read_slot(const LoopEquation& e) {
        const Part<double> line = line_part(s_, false, e.joint, numbers_);
        BodyTie tie;
        if (e.links[0] == body && !in_[e.links[1]]) {
            const LinkPlace<double>& on = pose_.links[e.links[1]];
            tie.kind = BodyTie::Kind::on_line;
            tie.own = place(s_.slots[e.joint].pin, body);
            tie.placed = on.at(line.through);
            tie.normal = left_of(turned(line.direction, on.along));
        } else if (const auto at = placed(s_.slots[e.joint].pin); at && e.links[1] == body) {
            tie.kind = BodyTie::Kind::over_place;
            tie.placed = *at;
            tie.own = left_of(line.direction);
            tie.length = dot(tie.own, line.through);
        } else {
            return false;
        }
        ties.push_back(tie);
        return true;
    }
    /// A link between the body and what is placed: two pins, or a pin and a slide.
    bool leg(std::size_t link) {
        std::size_t at_body = none, at_place = none, slide = none;
        for (const LoopEquation& e : equations_) {
            const bool pin = e.kind == Kind::pin_x, slides = e.kind == Kind::slide_line;
            if ((!pin && !slides) || (pin && !is_on(s_.pins[e.joint], link)) ||
                (slides && e.links[0] != link && e.links[1] != link))
                continue;
            std::size_t& joint = slides ? slide : placed(e.joint) ? at_place : at_body;
            if (joint != none && joint != e.joint) return false;
            joint = e.joint;
        }
        if (at_body != none && !is_on(s_.pins[at_body], body)) return false;
        BodyTie tie;
        tie.leg = link;
        if (at_body != none && at_place != none && slide == none) {
            tie.own = place(at_body, body);
            tie.placed = *placed(at_place);
            tie.leg_own = place(at_body, link);
            tie.leg_far = place(at_place, link);
            const Vector<double> arm = tie.leg_own - tie.leg_far;
            tie.length = std::hypot(arm.x, arm.y);
        } else if (at_body != none && at_place == none && slide != none) {
            if (!on_guide(slide, link, at_body, tie)) return false;
        } else if (at_body == none && at_place != none && slide != none) {
            if (!over_body(slide, link, at_place, tie)) return false;
        } else {
            return false;
        }
        ties.push_back(tie);
        return true;
    }
    /// A leg of known direction that slides on what is placed, or carries what does.
    bool on_guide(std::size_t slide, std::size_t link, std::size_t pin, BodyTie& tie) {
        const Slide& joint = s_.slides[slide];
        const bool slides = joint.link == link;
        const std::size_t other = slides ? joint.line.on : joint.link;
        if (in_[other]) return false;
        const Part<double> line = line_part(s_, true, slide, numbers_);
        const LinkPlace<double>& on = pose_.links[other];
        tie.kind = BodyTie::Kind::on_line;
        tie.leg_turn = pose_.links[link].along;
        tie.leg_own = place(pin, link);
        tie.own = place(pin, body);
        tie.normal = left_of(turned(line.direction, slides ? on.along : tie.leg_turn));
        tie.placed = (slides ? on.at(line.through) : on.origin - turned(line.through, tie.leg_turn)) +
                     turned(tie.leg_own, tie.leg_turn);
        return true;
    }
    /// A leg that turns about a placed pin and slides on the body, or the body on it.
    bool over_body(std::size_t slide, std::size_t link, std::size_t pin, BodyTie& tie) {
        const Slide& joint = s_.slides[slide];
        const bool slides = joint.link == link && joint.line.on == body;
        if (!slides && !(joint.link == body && joint.line.on == link)) return false;
        const Part<double> line = line_part(s_, true, slide, numbers_);
        const Vector<double> angle = unit_at(numbers_[joint.angle]);
        tie.kind = BodyTie::Kind::over_place;
        tie.placed = *placed(pin);
        tie.leg_far = place(pin, link);
        tie.leg_turn = slides ? angle : conjugate(angle);
        const Vector<double> left = left_of(line.direction);
        tie.own = slides ? left : turned(left, tie.leg_turn);
        tie.length =
            slides ? dot(left, line.through + turned(tie.leg_far, angle)) : dot(left, tie.leg_far - line.through);
        return true;
    }

    const Structure& s_;
    std::span<const double> numbers_;
    const Pose<double>& pose_;
    std::vector<bool> in_;
    std::vector<std::size_t> links_;
    const std::vector<LoopEquation>& equations_;
};

/// The body's place by the two equations that are linear in it, times their determinant, and that.
inline std::pair<Vector<double>, double> body_place(std::span<const BodyTie> ties, const Vector<double>& along) {
    const TieEquation base = equation_of(ties[0], along);
    TieEquation line[2]{equation_of(ties[1], along), equation_of(ties[2], along)};
    for (TieEquation& each : line)
        if (each.square != 0) each = {0, each.factor - base.factor, each.constant - base.constant};
    return {{line[1].constant * line[0].factor.y - line[0].constant * line[1].factor.y,
             line[0].constant * line[1].factor.x - line[1].constant * line[0].factor.x},
            cross(line[0].factor, line[1].factor)};
}

/// Where a body at some turn misses its first tie, times the square of that determinant; with no distance the
/// determinant of all three.
inline double missed_by(std::span<const BodyTie> ties, double turn) {
    const Vector<double> along = unit_at(turn);
    const auto [at, determinant] = body_place(ties, along);
    const TieEquation base = equation_of(ties[0], along);
    const double rest = dot(base.factor, at) + determinant * base.constant;
    return base.square == 0 ? rest : dot(at, at) + determinant * rest;
}

/// Puts body and legs of a triad where they are at some turn of the body.
inline bool place_triad(const TriadReader& triad, double turn, Pose<double>& pose) {
    const Vector<double> along = unit_at(turn);
    auto [at, determinant] = body_place(triad.ties, along);
    if (determinant == 0) return false;
    LinkPlace<double>& body = pose.links[triad.body];
    body = {(1 / determinant) * at, along};
    for (const BodyTie& tie : triad.ties) {
        if (tie.leg == none) continue;
        LinkPlace<double>& leg = pose.links[tie.leg];
        if (tie.kind == BodyTie::Kind::on_line) {
            hang(leg, tie.leg_own, body.at(tie.own));
            continue;
        }
        const Vector<double> own = tie.leg_own - tie.leg_far, way = body.at(tie.own) - tie.placed;
        const double length = std::hypot(way.x, way.y) * std::hypot(own.x, own.y);
        leg.along = tie.kind == BodyTie::Kind::over_place ? turned(tie.leg_turn, along)
                                                          : (1 / length) * turned(way, conjugate(own));
        hang(leg, tie.leg_far, tie.placed);
    }
    return true;
}

}  // namespace detail

}  // namespace mechwright::linkage
