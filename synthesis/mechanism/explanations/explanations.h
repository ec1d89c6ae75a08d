#pragma once
/// \file
/// What the quantities of the registry mean to a designer: formula, source, usual values. `mechwright explain` prints
/// them; the registry itself says names, units and short meanings.

#include <span>
#include <string_view>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// How a quantity follows from the dimensions of mechanisms that do not say it themselves (Mechanism::formulas).
struct Formula {
    std::string_view of;      ///< a part of the mechanism's meaning ("flat-faced"); empty: of any
    std::string_view text;    ///< dimensions by their names in problem files
    std::string_view source;  ///< book and equation, or how it is derived
};

struct Explanation {
    std::string_view name;            ///< of the quantity
    std::string_view what;            ///< what it tells a designer
    std::string_view over;            ///< over which part of the motion it is taken
    std::vector<Formula> formulas{};  ///< where its mechanisms do not say them, the first that applies
    std::string_view usual;           ///< good values in practice, and who says so
    std::string_view undefined;       ///< where it has no value; empty: it always has one
    std::string_view require;         ///< the limit of an example: "min = 40"
    std::string_view objective;       ///< "minimize" or "maximize"; empty: neither makes sense alone
    std::string_view related;         ///< names, with commas between
};

/// Those of every mechanism, in the order in which they are shown.
std::span<const Explanation> explanations();

/// The explanation of a quantity, or null.
const Explanation* find_explanation(std::string_view quantity);

struct FormulaText {
    std::string_view text;
    std::string_view source;

    friend bool operator==(const FormulaText&, const FormulaText&) = default;
};

/// The formula that holds for a mechanism; nothing where none is known. It lives as long as the mechanism.
std::optional<FormulaText> formula_for(const Explanation& explanation, const Mechanism& mechanism);

/// The parts of the list that several kinds share, each in a file of its own; the others are Mechanism::explanations.
std::vector<Explanation> linkage_explanations();
std::vector<Explanation> ram_explanations();
std::vector<Explanation> target_explanations();

}  // namespace mechwright
