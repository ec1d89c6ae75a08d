#pragma once
/// \file
/// One quantity of several: what is said of all functions, lines or arcs of a problem together, made of what is said of
/// each. Weights are those of the targets (Motion::asked).

#include <string>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The greatest of them. Its components are those of all of them; where these are more than a quantity can have
/// (Quantity::most_components), the greatest, in their order. Precondition: each is the greatest of its components, all
/// have one unit and one section.
Quantity greatest_together(std::string name, std::string meaning, std::vector<Quantity> parts);

/// sqrt(sum w q^2 / sum w), with the weight w of each one's target. Precondition: each has one component, all have one
/// unit and one section.
Quantity root_mean_together(std::string name, std::string meaning, std::vector<Quantity> parts);

}  // namespace mechwright
