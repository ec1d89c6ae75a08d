#pragma once
/// \file
/// The guided point and body of a linkage by no more steps than they need (GuidedPoint::needed), with first
/// derivatives by one sweep back for each coordinate and second ones by the same sweep in dual numbers: one for each
/// few arguments, each of which gives as many columns of the Hessian. What it takes to work in stands on the stack, but
/// for linkages of hundreds of numbers.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "analysis/linkage/placing/needed_back.h"
#include "analysis/linkage/placing/needed_place.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/linkage/targets/working_row.h"

namespace mechwright {

/// A linkage of some dimensions, its guided point at a crank angle.
template <class T>
class NeededGuidance {
public:
    /// Dimensions, where a body is guided the angle from the link to it, and the crank angle of the master.
    NeededGuidance(const LinkageModel& model, const Form& form, std::span<const T> arguments, bool of_body)
        : model_(model), needed_(model.guided[form.guided].needed), arguments_(arguments), of_body_(of_body) {
        const linkage::Needed& needed = needed_;
        row_ = row_room_.of(needed.size);
        const std::span<const T> dimensions = this->dimensions();
        const std::span<T> numbers = row_.subspan(needed.number(0), needed.numbers);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = model.numbers[i].at(dimensions);
        constexpr double any = std::numeric_limits<double>::infinity();
        closed_ = linkage::set_design<T, T>(needed, numbers, model.sides[form.assembly], row_, any);
        for (std::size_t i = 0; i < model.drives.size(); ++i) {
            linkage::set_input<T>(needed, i, linkage::input_by(law_of(model, i), arguments.back()), row_);
        }
        closed_ = closed_ && linkage::place_needed<T>(needed, row_, any);
        across_ = unit_at(model.placement[2].at(dimensions));
        scale_ = model.scale.at(dimensions);
        at_ = turned(vector(needed.point), across_);
        if (!of_body) return;
        turn_ = unit_at(arguments[arguments.size() - 2]);
        facing_ = turned(turned(vector(needed.along), across_), turn_);
    }

    /// False where outer pins of a dyad coincide, so that nothing says where it is.
    bool exists() const { return closed_; }
    /// Of the point in the drawing, then of the direction in which the body faces.
    T coordinate(std::size_t c) const {
        if (c >= 2) return c == 2 ? facing_.x : facing_.y;
        return model_.placement[c].at(dimensions()) + scale_ * (c == 0 ? at_.x : at_.y);
    }
    /// The least of all dyads and stops.
    double least_margin() const {
        double least = std::numeric_limits<double>::infinity();
        for (const linkage::MarginSpots& margin : needed_.margins)
            for (const linkage::Spot spot : {margin.outer, margin.inner})
                if (const double one = number_as<double>(value_of(row_[spot])); !(one >= least)) least = one;
        return least;
    }
    /// The derivatives of a coordinate by all arguments, which stay until the next are asked for.
    std::span<const T> gradient(std::size_t c) {
        const linkage::Needed& needed = needed_;
        const std::span<T> change = change_room_.of(needed.size), gradient = gradient_room_.of(arguments_.size());
        linkage::start_back<T>(needed, change);
        std::fill(gradient.begin(), gradient.end(), T(0));
        const Vector<T> one{T(c % 2 == 0 ? 1 : 0), T(c % 2 == 0 ? 0 : 1)};
        if (c < 2) {
            put(change, needed.point, scale_ * turned(one, conjugate(across_)));
            add(gradient, model_.placement[2], scale_ * dot(left_of(at_), one));
            add(gradient, model_.scale, dot(at_, one));
            add(gradient, model_.placement[c], T(1));
        } else {
            put(change, needed.along, turned(one, conjugate(turned(across_, turn_))));
            const T of_angle = dot(left_of(facing_), one);
            add(gradient, model_.placement[2], of_angle);
            gradient[arguments_.size() - 2] = of_angle;
        }
        linkage::sweep_back<T>(needed, row_, change);
        for (std::size_t i = 0; i < model_.numbers.size(); ++i)
            add(gradient, model_.numbers[i], change[needed.number(i)]);
        for (std::size_t i = 0; i < model_.drives.size(); ++i)
            gradient.back() = gradient.back() + rate_of(i) * change[needed.drive(i)];
        return gradient;
    }

private:
    std::span<const T> dimensions() const { return arguments_.first(arguments_.size() - (of_body_ ? 2 : 1)); }
    /// The derivative of a drive's input by the master's.
    T rate_of(std::size_t drive) const {
        return linkage::input_by(law_of(model_, drive), arguments_.back(), linkage::by_itself, true);
    }
    Vector<T> vector(linkage::Spot spot) const { return {row_[spot], row_[spot + 1]}; }
    static Vector<T> conjugate(const Vector<T>& a) { return {a.x, -a.y}; }
    static void put(std::span<T> change, linkage::Spot spot, const Vector<T>& x) {
        change[spot] = x.x;
        change[spot + 1] = x.y;
    }
    static void add(std::span<T> gradient, const Affine& number, const T& change) {
        for (const auto& [dimension, factor] : number.terms)
            gradient[dimension] = gradient[dimension] + factor * change;
    }

    static constexpr std::size_t most_spots = 768, most_arguments = 64;

    const LinkageModel& model_;
    const linkage::Needed& needed_;
    std::span<const T> arguments_;
    bool of_body_;
    WorkingRow<T, most_spots> row_room_, change_room_;
    WorkingRow<T, most_arguments> gradient_room_;
    std::span<T> row_{};
    Vector<T> across_{}, at_{}, turn_{}, facing_{};
    T scale_{};
    bool closed_ = false;
};

}  // namespace mechwright
