#pragma once
/// \file
/// Dakota's files of parameters and results, in its standard format: a file of variables and of what is wanted of each
/// response in, a file of values out. A variable is named by the path of a value in the problem file, a response by a
/// quantity, "objective", "violation" or "design." and a dimension.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mechwright::dakota {

struct Variable {
    std::string name;
    std::string value;  ///< as written
};

/// What is wanted of a response: the sum of 1 (value), 2 (gradient) and 4 (Hessian matrix).
struct Response {
    std::string name;
    int wanted = 0;
};

struct Evaluation {
    std::vector<Variable> variables;
    std::vector<Response> responses;
    std::vector<std::size_t> derivative_variables;  ///< indices of variables
    std::string id;
};

struct ReadEvaluations {
    std::vector<Evaluation> evaluations;
    std::string fault;  ///< what is wrong with the text; empty if nothing is
};

/// The evaluations of a file of parameters: one, or those of a batch, one after the other.
ReadEvaluations read_parameters(std::string_view text);

/// The results of one evaluation of a problem file, or "FAIL" and the reason. Gradients are given for designs whose
/// dimensions are all given, with respect to dimensions. `file` is the problem file's name, `text` what stands in it.
std::string results_of(const Evaluation& evaluation, std::string_view text, const std::string& file);

/// The results of all evaluations of a file, those of a batch with lines "#" between them.
std::string results_of(const std::vector<Evaluation>& evaluations, std::string_view text, const std::string& file);

}  // namespace mechwright::dakota
