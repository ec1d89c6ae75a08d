#pragma once
/// \file
/// What a problem file needs to say a mechanism as the linkage that it is (`mechwright expand`): the sections that
/// describe it, and which quantities of the linkage those of the mechanism are. All of it lives as long as the program.

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "synthesis/mechanism/quantity.h"

namespace mechwright {

/// Limits on a quantity of the linkage, which make sure that it moves as the mechanism does.
struct Assurance {
    std::string_view quantity;
    Unit unit = Unit::none;
    std::optional<double> min{};  ///< radians, lengths
    std::optional<double> max{};
    std::string_view why{};  ///< what it says of the motion
};

/// A quantity of the mechanism by quantities of the linkage. Those of targets have the same names.
struct Counterpart {
    /// How it follows from those of the linkage: it is the one, or the least or the greatest of several.
    enum class By { same, least, greatest };

    std::string_view quantity;
    By by = By::same;
    std::array<std::string_view, 3> is{};  ///< as many as are not empty; none where it has no counterpart
    std::span<const Assurance> assured{};  ///< of the designs that have the quantity at all
    bool of_full_turn = false;             ///< it is so only of designs whose crank turns fully
    /// It is so only of limits of this value, radians, and more.
    std::optional<double> least_limit{};
    std::string_view why_not{};  ///< why there is no counterpart, and what would be one
};

struct AsLinkage {
    /// A target, and lines that name what it speaks of.
    struct Target {
        std::string_view section;
        std::string_view names;
    };
    /// From [links] to [signals], TOML. "name" in place of a number is a dimension; @assembly@ stands for the word of
    /// the assembly, @square@ for a right angle in the unit of the file. It stands where the mechanism is drawn: by
    /// the placement among its dimensions, or by a [placement] here.
    std::string_view sections;
    std::span<const std::string_view> assemblies{};  ///< words for the mechanism's
    std::span<const Target> targets{};
    std::span<const Counterpart> quantities{};
};

/// A quantity that every linkage has by the same name.
constexpr Counterpart same_of_linkages(std::string_view quantity) { return {.quantity = quantity, .is = {quantity}}; }

}  // namespace mechwright
