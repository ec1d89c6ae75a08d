#pragma once
/// \file
/// What one method answers to a problem, and how far two answers lie apart.

#include <string>
#include <string_view>
#include <vector>

#include "synthesis/program/result.h"
#include "synthesis/solve/solve.h"

namespace mechwright::bench {

/// What an answer consists of.
enum class AnswerKind {
    optimum,     ///< the objective of the best design
    design,      ///< a design of a problem that asks for no best one
    trade_off,   ///< the two ends of a front
    infeasible,  ///< how closely the requirements can be met
    none         ///< the method came to no answer
};

struct Answer {
    AnswerKind kind = AnswerKind::none;
    std::string method;           ///< that gave it: what "auto" chose
    std::vector<double> numbers;  ///< that two methods have to agree on, in the file's units
    std::vector<double> scales;   ///< what counts as one, for numbers that are zero by rounding
    Result result;
};

Answer answer_of(Problem problem, std::string_view method, const RunOptions& options);

/// The greatest difference of two answers' numbers, relative; of numbers that are zero by rounding, in their scales.
/// Infinite where the answers are not of one kind. 0 for two designs that nothing tells apart.
double difference(const Answer& a, const Answer& b);

/// Differences to this are rounding.
inline constexpr double agree_within = 1e-8;

/// The methods that answer a problem and that are worth comparing: not "auto", which chooses among them, and not
/// branch-and-bound, which begins with the answer of another.
std::vector<std::string> methods_for(const Problem& problem);

/// Where a local method ends that starts near an optimum: whether it knows the optimum where its search does not come
/// across it.
struct Return {
    double away = 0;        ///< of the start, as a part of every variable
    double difference = 0;  ///< of the end from the optimum, relative; infinite where it cannot start there
};

/// From the farthest of 10^-3, 10^-4, 10^-5 and 10^-6 away from which the method comes back to the optimum; the last of
/// them where it comes back from none. Starts that are themselves no worse than `agree_within` show nothing and do not
/// count.
Return return_from_nearby(const Problem& problem, const Design& design, std::string_view method);

/// Why only one method answers a problem; empty where more do.
std::string_view why_alone(const Problem& problem, const Answer& answer);

std::string_view name_of(AnswerKind kind);

}  // namespace mechwright::bench
