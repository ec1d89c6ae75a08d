#pragma once
/// \file
/// The real configurations of a larger group, once what it hangs on is placed. Of a triad all of them, by its
/// polynomial (triad.h); of any other group those that Newton's method finds from many random places, which need not be
/// all.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "analysis/linkage/groups/triad.h"
#include "analysis/linkage/motion/driven.h"

namespace mechwright::linkage {

struct Configurations {
    /// Places of the group's unknowns, turns in [0, 2 pi), in the order of the turns of its links.
    std::vector<std::vector<double>> all{};
    bool complete = false;  ///< there are no others
};

namespace detail {

/// An angle in [0, 2 pi); what is below 0 by rounding is 0.
inline double folded_turn(double angle) {
    constexpr double turn = 2 * std::numbers::pi, rounding = 1e-12;
    const double folded = angle - turn * std::floor(angle / turn);
    return turn - folded < rounding ? folded - turn : folded;
}

class ConfigurationList {
public:
    explicit ConfigurationList(GroupSolver<double>& solver) : solver_(solver) {}

    /// Newton's method from the places of the solver; whether it finds a configuration that is not in the list.
    bool add(int steps, double longest) {
        constexpr double regular = 1e-12;
        if (!solver_.solve(steps, longest) || !(std::abs(solver_.determinant()) > regular) || !solver_.faces_right())
            return false;
        std::vector<double> one = solver_.places;
        for (std::size_t i = 0; i < one.size(); ++i)
            if (solver_.group().unknowns[i].part == 2) one[i] = folded_turn(one[i]);
        if (std::any_of(found.begin(), found.end(), [&](const auto& other) { return is_same(one, other); }))
            return false;
        found.push_back(std::move(one));
        return true;
    }
    void sort() {
        const auto turns_of = [this](const std::vector<double>& one) {
            std::vector<double> turns;
            for (std::size_t i = 0; i < one.size(); ++i)
                if (solver_.group().unknowns[i].part == 2) turns.push_back(one[i]);
            return turns;
        };
        std::sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
            const std::vector<double> first = turns_of(a), second = turns_of(b);
            for (std::size_t i = 0; i < first.size(); ++i)
                if (std::abs(first[i] - second[i]) > 1e-9) return first[i] < second[i];
            return a < b;
        });
    }

    std::vector<std::vector<double>> found{};

private:
    bool is_same(const std::vector<double>& a, const std::vector<double>& b) const {
        constexpr double within = 1e-7;
        for (std::size_t i = 0; i < a.size(); ++i) {
            const bool turn = solver_.group().unknowns[i].part == 2;
            const double apart = a[i] - b[i];
            if (std::abs(turn ? std::remainder(apart, 2 * std::numbers::pi) : apart / solver_.unit(i)) > within)
                return false;
        }
        return true;
    }

    GroupSolver<double>& solver_;
};

/// From random places: until the last ones that were new are long ago.
inline void search_configurations(GroupSolver<double>& solver, ConfigurationList& list) {
    constexpr int least = 400, patience = 4, most = 6000, steps = 60;
    constexpr double longest = 0.7, spread = 2;
    std::mt19937_64 draw(1);
    const auto number = [&draw] { return static_cast<double>(draw() >> 11) * 0x1p-52 - 1; };
    Vector<double> centre{0, 0};
    double count = 0;
    for (const LoopEquation& e : solver.group().equations)
        for (const std::size_t link : e.links)
            if (link != none && !std::any_of(solver.group().unknowns.begin(), solver.group().unknowns.end(),
                                             [link](const LinkUnknown& u) { return u.link == link; })) {
                centre = centre + solver.plain_pose().links[link].origin;
                ++count;
            }
    if (count > 0) centre = (1 / count) * centre;
    for (int tries = 1, last = 0; tries <= most && tries <= std::max(least, patience * last); ++tries) {
        for (std::size_t i = 0; i < solver.unknowns(); ++i) {
            const int part = solver.group().unknowns[i].part;
            solver.places[i] = part == 2 ? std::numbers::pi * number()
                                         : (part == 0 ? centre.x : centre.y) + spread * solver.size() * number();
        }
        if (list.add(steps, longest)) last = tries;
    }
}

}  // namespace detail

/// Those of a larger group in the pose of a linkage in which all that it hangs on is placed, at its inputs.
inline Configurations configurations(const Structure& s, std::span<const double> numbers, Driven<double>& driven,
                                     std::size_t group) {
    constexpr std::size_t degree = 6;
    GroupSolver<double>& solver = driven.groups[group];
    if (solver.group().unknowns.size() != solver.group().equations.size()) return {};
    solver.hang_on(driven.inputs(), driven.pose);
    detail::ConfigurationList list(solver);
    detail::TriadReader triad(s, solver.group(), numbers, driven.pose);
    const bool is_triad = triad.read();
    if (is_triad) {
        Pose<double> pose = driven.pose;
        for (const double turn :
             near_zeros([&](double angle) { return detail::missed_by(triad.ties, angle); }, degree)) {
            if (!detail::place_triad(triad, turn, pose)) continue;
            for (std::size_t i = 0; i < solver.unknowns(); ++i) {
                const auto& [link, part] = solver.group().unknowns[i];
                const LinkPlace<double>& at = pose.links[link];
                solver.places[i] = part == 0   ? at.origin.x
                                   : part == 1 ? at.origin.y
                                               : std::atan2(at.along.y, at.along.x);
            }
            list.add(40, 1e3);
        }
    } else {
        detail::search_configurations(solver, list);
    }
    list.sort();
    return {std::move(list.found), is_triad};
}

}  // namespace mechwright::linkage
