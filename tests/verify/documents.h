#pragma once
/// \file
/// Result documents made by hand for the tests of verification, and their checks.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/four_bar.h"
#include "synthesis/verify/verify.h"

namespace mechwright::test {

using Json = nlohmann::ordered_json;

/// A crank-rocker with given swing (radians) and the crank angle of one stroke (radians, not pi), of the best
/// transmission angle, on a ground link of length 1: closed form, see classical_optimum in documents.cpp.
FourBar<double> classical_optimum(double stroke, double swing);

/// Adds design, requirements, objective, quantities and path to a document that has the rest, with the values that the
/// registry's own measures give; names as in the document.
struct DocumentOf {
    FourBar<double> links;
    std::string assembly = "open";
    std::vector<double> placement;      ///< point-along ... crank-start, angles in degrees; or empty
    std::vector<std::string> required;  ///< quantities that are to equal what they are
    std::string maximized;
    std::vector<double> crank_range;  ///< degrees; or empty
};
Json document(const DocumentOf& parts);

/// Adds a path that the design of the document meets exactly, but for `miss` in the x of each point, at the given crank
/// angles (degrees).
void add_path(Json& document, const std::vector<double>& crank_angles, double miss, bool prescribed);

/// The names of the checks that fail, in order.
std::vector<std::string> failures(const Json& document);

/// Every member of the document, at any depth, replaced by values of every type and verified: no crash, no exception,
/// no hang. In the short form each member is replaced by three of the values, others for the next. How many documents
/// that were; the document is as before.
int verified_with_members_replaced(Json& document);
/// The same of one of its members and those below.
int verified_with_members_replaced(Json& document, Json& at);

/// All checks in words.
std::string told(const std::vector<Check>& checks);

}  // namespace mechwright::test
