#pragma once
/// \file
/// The farthest places in a direction of all that the pins of a room go through, exactly.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "synthesis/mechanism/linkage/rooms/contacts_along.h"
#include "synthesis/mechanism/linkage/rooms/outline_samples.h"

namespace mechwright::measuring {

/// Finds them beside samples of the outline, of which there is at least one.
template <std::size_t K>
class FarthestPlaces {
public:
    FarthestPlaces(linkage::Measured<double, K>& measured, const Course& course, const OutlineSamples& outline)
        : measured_(measured), course_(course), outline_(outline), along_(measured, course, ends_) {}

    /// What a box of a direction is touched by.
    Contacts contacts_in(double direction) {
        Contacts contacts;
        for (std::size_t side = 0; side < contacts.size(); ++side)
            contacts[side] = farthest_in(direction + turn_of_side(side));
        return contacts;
    }
    /// How far out they are.
    ContactsAlong<double, K>& along() { return along_; }

    /// Goes on with a contact to another direction nearby.
    void resettle(Contact& contact, double direction) {
        constexpr int most_steps = 6;
        for (int i = 0; contact.place.stationary && i < most_steps; ++i) {
            const auto [out, across] = along_.series(contact, direction);
            const double step = -out.derivative(1) / out.derivative(2) * measured_.rate();
            if (!(std::abs(step) < farthest_step())) return;
            contact.place.at += step;
            if (std::abs(step) < 1e-15 * (1 + std::abs(contact.place.at))) return;
        }
    }

    /// Whether two contacts are the same place of the motion, so near that one can be gone on with to the other.
    bool is_same(const Contact& a, const Contact& b) const {
        if (a.pin != b.pin || a.place.stationary != b.place.stationary) return false;
        double way = std::abs(a.place.at - b.place.at);
        if (outline_.seamless) way = std::min(way, std::abs(way - course_.period()));
        return way < 0.5 * farthest_step();
    }

private:
    /// The farthest place of all in a direction: of samples that are farther than their neighbours and near the
    /// farthest.
    Contact farthest_in(double direction) {
        const Vector<double> way{std::cos(direction), std::sin(direction)};
        far_.clear();
        double best = -std::numeric_limits<double>::infinity();
        for (const OutlineSample& sample : outline_.samples)
            best = std::max(best, far_.emplace_back(dot(sample.at, way)));
        Contact farthest;
        double value = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < outline_.samples.size(); ++i) {
            const double here = far_[i], before = outline_.samples[i].first ? -1e300 : far_[i - 1],
                         after = outline_.samples[i].last ? -1e300 : far_[i + 1];
            if (here < before || here < after) continue;
            // Between samples a parabola is no more above them than a quarter of their second difference.
            const double rises =
                (before > -1e300 ? std::abs(here - before) : 0) + (after > -1e300 ? std::abs(here - after) : 0);
            if (here + rises < best) continue;
            double settled_value = 0;
            const Contact one = settled(i, direction, settled_value);
            if (!(settled_value > value)) continue;
            value = settled_value;
            farthest = one;
        }
        return farthest;
    }

    /// The farthest place in a direction next to a sample that is as far as its neighbours: where it is stationary
    /// between these, or an end.
    Contact settled(std::size_t index, double direction, double& value) {
        const OutlineSample& sample = outline_.samples[index];
        value = along_.of(sample.contact, direction).out;
        if (sample.is_fixed()) return sample.contact;
        const bool is_end = !outline_.seamless && (sample.first || sample.last);
        const double here = sample.contact.place.at,
                     step = std::abs(outline_.samples[sample.first ? index + 1 : index - 1].contact.place.at - here);
        const double low = !sample.first ? outline_.samples[index - 1].contact.place.at
                           : is_end      ? here
                                         : here - step,
                     high = !sample.last ? outline_.samples[index + 1].contact.place.at
                            : is_end     ? here
                                         : here + step;
        Contact contact = sample.contact;
        contact.place.stationary = true;
        contact.place.limit = {};
        if (!find_stationary(contact, direction, low, high)) return sample.contact;
        const double found = along_.of(contact, direction).out;
        if (is_end && !(found > value)) return sample.contact;
        value = found;
        return contact;
    }
    /// Puts a contact where it is farthest between two inputs: by Newton's method, by halves where that leaves them, by
    /// quarters next to a limit. False where that is at one of them.
    bool find_stationary(Contact& contact, double direction, double low, double high) {
        constexpr int most_steps = 80;
        constexpr double settled_within = 1e-15, end_within = 1e-12;
        const double first = low, last = high, rate = measured_.rate();
        const linkage::Travel& travel = course_.travel;
        const auto between = [&] {
            const double share = first == travel.from && travel.first.exists() ? 0.25
                                 : last == travel.to && travel.last.exists()   ? 0.75
                                                                               : 0.5;
            return low + share * (high - low);
        };
        double& at = contact.place.at;
        if (!(at > low && at < high)) at = between();
        for (int i = 0; i < most_steps; ++i) {
            const auto [out, across] = along_.series(contact, direction);
            const double slope = out.derivative(1) / rate, bend = out.derivative(2) / (rate * rate);
            (slope > 0 ? low : high) = at;
            double next = at - slope / bend;
            const bool newton = bend < 0 && next > low && next < high;
            if (!newton) next = between();
            const double moved = std::abs(next - at);
            if (newton || next != at) at = next;
            if (moved <= settled_within * (1 + std::abs(at))) break;
        }
        return at - first > end_within * (last - first) && last - at > end_within * (last - first);
    }
    /// So far a contact goes on at the most.
    double farthest_step() const { return 0.1 * measured_.unit_of_input(); }

    linkage::Measured<double, K>& measured_;
    const Course& course_;
    const OutlineSamples& outline_;
    const linkage::MovingEnds<double> ends_{};
    ContactsAlong<double, K> along_;
    std::vector<double> far_{};
};

}  // namespace mechwright::measuring
