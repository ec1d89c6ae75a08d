#pragma once
/// \file
/// A design with everything that is needed to draw it and to show its motion, read from a result document or from a
/// problem that leaves nothing open.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// A point that a mechanism is to pass, and where it does.
struct TargetPlace {
    Vector<double> at;
    std::optional<double> direction;  ///< of a guided body, radians
    std::optional<Vector<double>> reached;
};

/// A moving design with its units and targets.
struct FinishedDesign : MovingDesign {
    Units units;
    std::shared_ptr<const FunctionTarget> function;  ///< as those of the problem, that the motion refers to
    std::optional<FollowedTarget> followed;
    std::shared_ptr<const std::vector<AskedOverInput>> over_input;
    std::vector<TargetPlace> targets;
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

/// What the motion is counted in: an angle, or the length by which a slide is driven.
Unit input_unit(const FinishedDesign& design);

/// `steps` + 1 crank angles (radians) from one end of the motion to the other, even in the file's unit, so that whole
/// degrees stay whole degrees; none where it does not assemble.
std::vector<double> even_angles(const FinishedDesign& design, int steps);

/// A value of a row of the motion table as files have it.
double in_file_unit(const FinishedDesign& design, const MotionRow& row, std::size_t column);

}  // namespace mechwright
