#pragma once
/// \file
/// Several results side by side: the engineer's question which mechanism to use.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "synthesis/program/result.h"
#include "synthesis/report/text/numbers.h"

namespace mechwright {

/// One of the designs to be compared.
struct Compared {
    Problem problem;
    Result result;
};

/// The designs in the order in which they are to be shown: verified ones first, those of searches that were stopped
/// among them, and where all files have the same objective the better ones first; else in the order given.
std::vector<Compared> ranked(std::vector<Compared> all);

/// One row for each design: its file, mechanism, objective (or what became of it instead), size, transmission angle,
/// time ratio, stroke and speed variation, of cams their size and pressure angle; columns in which no design has a
/// value are left out. Below it, whose search was stopped, and which design is the best by the common objective.
std::string comparison_table(const std::vector<Compared>& all, const TextStyle& style);

/// The same as comma-separated values with all digits, in which missing values are empty.
std::string comparison_csv(const std::vector<Compared>& all);

/// The same as a list of objects {file, mechanism, status, [objective], quantities by name}.
nlohmann::ordered_json comparison_json(const std::vector<Compared>& all);

/// What is asked of the designs differently, one line for each file that differs from the first; empty if nothing is.
std::string differences_of_tasks(const std::vector<Compared>& all);

}  // namespace mechwright
