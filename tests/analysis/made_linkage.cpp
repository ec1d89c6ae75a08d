#include "tests/analysis/made_linkage.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mechwright::test {

namespace {

using Places = std::vector<Precise>;
using At = Vector<Precise>;

/// The misses as they are defined, in terms of links' angles.
struct Misses {
    const MadeLinkage& made;
    const Places& places;

    Precise number(linkage::Number n) const { return Precise(made.numbers[n]); }
    At coordinates(const linkage::Coordinates& c) const { return {number(c.first), number(c.second)}; }
    Precise angle(std::size_t link) const { return link == 0 ? Precise(0) : places[3 * link - 1]; }
    At rotated(std::size_t link, const At& own) const {
        const Precise c = cos(angle(link)), s = sin(angle(link));
        return {own.x * c - own.y * s, own.x * s + own.y * c};
    }
    At at(std::size_t link, const At& own) const {
        const At r = rotated(link, own);
        return link == 0 ? r : At{places[3 * link - 3] + r.x, places[3 * link - 2] + r.y};
    }
    At along(const linkage::Line& line) const {
        if (line.by_angle) return {cos(number(line.angle)), sin(number(line.angle))};
        const At d = coordinates(line.towards) - coordinates(line.through);
        return (Precise(1) / sqrt(d.x * d.x + d.y * d.y)) * d;
    }
    /// Along and to the left of a line.
    At in_line(const linkage::Line& line, const At& where) const {
        const At u = rotated(line.on, along(line)), d = where - at(line.on, coordinates(line.through));
        return {u.x * d.x + u.y * d.y, u.x * d.y - u.y * d.x};
    }
};

/// Solves a square system by elimination with column pivots.
Places solved(std::vector<Places> rows, Places right) {
    const std::size_t n = right.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < n; ++i)
            if (abs(rows[i][k]) > abs(rows[pivot][k])) pivot = i;
        std::swap(rows[k], rows[pivot]);
        std::swap(right[k], right[pivot]);
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const Precise factor = rows[i][k] / rows[k][k];
            for (std::size_t j = k; j < n; ++j)
                rows[i][j] -= factor * rows[k][j];
            right[i] -= factor * right[k];
        }
    }
    for (std::size_t k = 0; k < n; ++k)
        right[k] /= rows[k][k];
    return right;
}

}  // namespace

Places misses(const MadeLinkage& made, const Places& drives, const Places& places) {
    const Misses m{made, places};
    const linkage::Structure& s = made.s;
    Places all;
    const auto add = [&](const At& v) {
        all.push_back(v.x);
        all.push_back(v.y);
    };
    for (const linkage::Pin& pin : s.pins)
        for (std::size_t k = 1; k < pin.points.size(); ++k)
            add(m.at(pin.points[k].link, m.coordinates(pin.points[k].at)) -
                m.at(pin.points[0].link, m.coordinates(pin.points[0].at)));
    for (const linkage::Slide& slide : s.slides)
        add({m.angle(slide.link) - m.angle(slide.line.on) - m.number(slide.angle),
             m.in_line(slide.line, m.at(slide.link, {0, 0})).y - m.number(slide.offset)});
    for (const linkage::Slot& slot : s.slots) {
        const linkage::Point& p = s.pins[slot.pin].points[0];
        all.push_back(m.in_line(slot.line, m.at(p.link, m.coordinates(p.at))).y);
    }
    for (const linkage::Gear& g : s.gears)
        all.push_back(m.angle(g.second) - m.angle(g.carrier) -
                      m.number(g.ratio) * (m.angle(g.first) - m.angle(g.carrier)) - m.number(g.phase));
    for (std::size_t i = 0; i < s.drives.size(); ++i) {
        const linkage::Drive& d = s.drives[i];
        if (d.of_slide)
            all.push_back(m.in_line(s.slides[d.slide].line, m.at(s.slides[d.slide].link, {0, 0})).x - drives[i]);
        else
            all.push_back(m.angle(d.link) - m.angle(d.on) - drives[i]);
    }
    return all;
}

Places places_by_newton(const MadeLinkage& made, const std::vector<double>& drives, const linkage::Pose<double>& near) {
    const Places inputs(drives.begin(), drives.end());
    Places places;
    for (std::size_t link = 1; link < made.s.links; ++link) {
        const auto& at = near.links[link];
        // A little off, so that nothing but convergence makes them right.
        places.push_back(Precise(at.origin.x) + 1e-7);
        places.push_back(Precise(at.origin.y) - 1e-7);
        places.push_back(Precise(std::atan2(at.along.y, at.along.x)) + 1e-7);
    }
    // Angles of gears and drives differ from those of directions by full turns.
    for (std::size_t link = 1; link < made.s.links; ++link)
        places[3 * link - 1] +=
            Precise(std::round((near.turns[link] - std::atan2(near.links[link].along.y, near.links[link].along.x)) /
                               (2 * std::numbers::pi))) *
            2 * pi<Precise>() * (near.turns[link] != 0 ? 1 : 0);
    const std::size_t n = places.size();
    for (int round = 0; round < 12; ++round) {
        const Places miss = misses(made, inputs, places);
        EXPECT_EQ(miss.size(), n);
        std::vector<Places> rows(n, Places(n));
        const Precise step("1e-25");
        for (std::size_t j = 0; j < n; ++j) {
            Places there = places, back = places;
            there[j] += step;
            back[j] -= step;
            const Places a = misses(made, inputs, there), b = misses(made, inputs, back);
            for (std::size_t i = 0; i < n; ++i)
                rows[i][j] = (a[i] - b[i]) / (2 * step);
        }
        const Places change = solved(rows, miss);
        Precise greatest = 0;
        for (std::size_t j = 0; j < n; ++j) {
            places[j] -= change[j];
            greatest = std::max<Precise>(greatest, abs(change[j]));
        }
        if (greatest < Precise("1e-35")) return places;
    }
    ADD_FAILURE() << "Newton's method does not converge";
    return places;
}

double error_of(const linkage::Pose<double>& pose, const Places& places, double size) {
    Precise greatest = 0;
    for (std::size_t link = 1; link < pose.links.size(); ++link) {
        const auto& at = pose.links[link];
        const Precise x = at.origin.x - places[3 * link - 3], y = at.origin.y - places[3 * link - 2];
        const Precise c = at.along.x - cos(places[3 * link - 1]), s = at.along.y - sin(places[3 * link - 1]);
        greatest = std::max<Precise>({greatest, sqrt(x * x + y * y), size * sqrt(c * c + s * s)});
    }
    return static_cast<double>(greatest);
}

}  // namespace mechwright::test
