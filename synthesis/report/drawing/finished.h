#pragma once
/// \file
/// A design with everything that is needed to draw it and to show its motion, read from a result document or from a
/// problem that leaves nothing open.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "synthesis/program/result.h"

namespace mechwright {

/// A point that a mechanism is to pass, and where it does.
struct TargetPlace {
    Vector<double> at;
    std::optional<double> direction;  ///< of a guided body, radians
    std::optional<Vector<double>> reached;
};

/// Lengths in the problem's unit, angles in radians.
struct FinishedDesign {
    std::shared_ptr<const Mechanism> mechanism;
    Units units;
    Motion motion;  ///< refers to mechanism and function
    std::vector<double> dimensions;
    std::shared_ptr<const FunctionTarget> function;
    std::vector<TargetPlace> targets;
    bool guides_body = false;

    /// The value of a dimension, 0 where the mechanism has none of this name.
    double operator[](std::string_view dimension) const;
    /// Whether it moves at all.
    bool assembles() const { return motion.from <= motion.to; }
};

struct FinishedOrNot {
    FinishedDesign design;
    std::string defect;  ///< why the document holds no design that can be shown; empty if it does
};

/// The design of a result document or of a document that `analyse` prints.
FinishedOrNot finished_design(const nlohmann::ordered_json& document);

/// A design of a problem.
FinishedDesign finished_design(const Problem& problem, const Design& design);

/// The document of another design of a result, from its alternatives or its front: that of the result with the other
/// design in the place of its own, and with what is said of that. What is not stated is evaluated again. Precondition:
/// `other` is an object with a design.
nlohmann::ordered_json with_other_design(const nlohmann::ordered_json& document, const nlohmann::ordered_json& other);

}  // namespace mechwright
