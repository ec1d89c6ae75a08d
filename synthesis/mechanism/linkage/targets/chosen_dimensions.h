#pragma once
/// \file
/// Dimensions of a linkage from where the pins are to be on its links.

#include <cstddef>
#include <span>
#include <vector>

#include "synthesis/mechanism/linkage/model.h"

namespace mechwright {

inline const linkage::Coordinates& coordinates_at(const LinkageModel& model, std::size_t link, std::size_t pin) {
    return linkage::coordinates_on(model.structure.pins[pin], link);
}

/// Dimensions of a linkage that are chosen one after the other so that pins come to where they are wanted on its links:
/// free ones as long as they are none of what has been placed or kept.
class ChosenDimensions {
public:
    /// Changes `dimensions` in place, which must outlive this.
    ChosenDimensions(const LinkageModel& model, const std::vector<bool>& free, std::span<double> dimensions);

    double value(const Affine& number) const { return number.at(std::span<const double>(dimensions_)); }

    /// Where a pin is on a link.
    Vector<double> place(std::size_t link, std::size_t pin) const;

    /// Gives a number a value; false where what it is a sum of is not free, and it has another.
    bool choose(const Affine& number, double to, bool angle = false);

    /// The same for the place of a pin on a link.
    bool move(std::size_t link, std::size_t pin, const Vector<double>& to);

    /// A pin stays where it is on a link.
    void keep(std::size_t link, std::size_t pin);

    /// Which dimensions have been chosen.
    const std::vector<bool>& chosen() const { return chosen_; }

private:
    void keep(const Affine& number);

    const LinkageModel& model_;
    std::vector<bool> open_;
    std::vector<bool> chosen_;
    std::span<double> dimensions_;
    double size_;
};

}  // namespace mechwright
