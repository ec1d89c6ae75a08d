#include "synthesis/verify/derived.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/document/claimed_problem.h"
#include "synthesis/document/followed_document.h"
#include "synthesis/document/function_document.h"
#include "synthesis/mechanism/function_target.h"
#include "synthesis/program/error_extremes.h"
#include "synthesis/program/singular.h"
#include "synthesis/verify/rebuilt.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

bool close(const Json& stated, const Json& again, double within) {
    return stated.is_number() && again.is_number() && std::abs(stated.get<double>() - again.get<double>()) <= within;
}

Check check_warnings(const Json& document, const ClaimedDesign& claimed) {
    constexpr double within = 1e-9;
    const auto again = singular_margins(claimed.problem, claimed.design);
    const Json stated = document.value("warnings", Json::array());
    Check check{"warns of singular positions as the rule says", stated.is_array() && stated.size() == again.size(), {}};
    for (std::size_t i = 0; check.passed && i < again.size(); ++i) {
        const Json& one = stated[i];
        check.passed = one.is_object() && one.value("name", Json()) == again[i].name &&
                       close(one.value("relative", Json()), again[i].relative, within) &&
                       close(one.value("margin", Json()), again[i].margin,
                             within * std::abs(again[i].margin / again[i].relative)) &&
                       one.value("warned_below", Json()) == singular_below;
    }
    for (const SingularMargin& m : again)
        check.detail += (check.detail.empty() ? "" : "; ") + to_text(m, claimed.problem.units);
    if (again.empty()) check.detail = "no margin is small";
    return check;
}

/// The error of an expression at a place, in fifty digits and the document's unit; its absolute value.
Digits50 error_at(const Claim& claim, const Rebuilt& design, double x) {
    FunctionTarget one = *claim.function;
    one.accuracy_points = {x};
    const FunctionTarget there = at_accuracy_points(one);
    Motion motion = design.motion;
    motion.function = &there;
    const Quantity& deviation = deviation_from(*claim.mechanism, "function");
    return in_document(deviation.measure_again(motion, design.dimensions), deviation.unit, claim.units);
}

/// Why the list of extremes is not that of the design; empty if it is.
std::string extremes_defect(const Json& stated, const Json& again, const char* place, const char* error) {
    if (!stated.is_array() || stated.size() != again.size())
        return fmt::format("{} are stated, there are {}", stated.size(), again.size());
    double greatest = 0, span = 0;
    for (const Json& e : again) {
        greatest = std::max(greatest, std::abs(e[error].get<double>()));
        span = std::max(span, std::abs(e[place].get<double>() - again[0][place].get<double>()));
    }
    constexpr double place_within = 1e-5, error_within = 1e-7;
    for (std::size_t i = 0; i < again.size(); ++i) {
        const Json& one = stated[i];
        if (!one.is_object() || !close(one.value(place, Json()), again[i][place], place_within * span) ||
            !close(one.value(error, Json()), again[i][error], error_within * greatest))
            return fmt::format("extreme {} is stated as {}, it is {}", i + 1, one.dump(), again[i].dump());
    }
    return {};
}

/// Of errors that are nothing but rounding neither places nor their number mean anything.
bool is_rounding(const Json& again, const char* error) {
    constexpr double rounding = 1e-11;
    return std::all_of(again.begin(), again.end(),
                       [&](const Json& e) { return std::abs(e[error].get<double>()) < rounding; });
}

Check check_extremes(const Json& stated, const Claim& claim, const ClaimedDesign& claimed) {
    Check check{"extremes of the error are as stated", false, {}};
    const char* place = claim.function ? "x" : "crank_angle";
    const char* error = claim.function ? "error" : "distance";
    const Json again = claim.function ? function_document(claimed.problem, &claimed.design)
                                      : followed_document(claimed.problem, &claimed.design);
    const Json extremes = stated.value("extremes", Json());
    if (is_rounding(again["extremes"], error)) {
        check.passed = extremes.is_array() && std::all_of(extremes.begin(), extremes.end(), [&](const Json& e) {
                           return e.is_object() && close(e.value(error, Json()), 0, 1e-10);
                       });
        check.detail =
            check.passed ? "the error is nothing but rounding" : "the error is nothing but rounding, and not stated so";
        return check;
    }
    check.detail = extremes_defect(extremes, again["extremes"], place, error);
    for (const char* count : {"alternating", "free"})
        if (check.detail.empty() && stated.value(count, Json()) != again[count])
            check.detail = fmt::format("{} is stated as {}, it is {}", count, stated.value(count, Json()).dump(),
                                       again[count].dump());
    if (check.detail.empty() && claim.function && !claim.function->expression.empty()) {
        constexpr double relative = 1e-7, absolute = 1e-9;
        const Rebuilt design = rebuilt(claim);
        for (const Json& e : extremes) {
            const Digits50 there = error_at(claim, design, e["x"].get<double>());
            const double size = std::abs(e["error"].get<double>());
            if (!(abs(there - size) <= relative * size + absolute))
                check.detail = fmt::format("the error at x = {} is stated as {}, measured again {}", e["x"].dump(),
                                           size, there.convert_to<double>());
        }
    }
    check.passed = check.detail.empty();
    if (check.passed) check.detail = fmt::format("{} extremes derived again", extremes.size());
    return check;
}

}  // namespace

std::vector<Check> check_derived(const Json& document) {
    std::vector<Check> checks;
    const auto [claim, defect] = read_claim(document);
    if (!defect.empty() || !why_not_evaluable(claim).empty()) return checks;
    const ClaimedDesign claimed = claimed_design(claim);
    for (const char* target : {"function", "line", "arc"})
        if (document.contains(target) && document[target].is_object() && document[target].contains("extremes"))
            checks.push_back(check_extremes(document[target], claim, claimed));
    // A design that comes apart needs no warning.
    if (document.contains("warnings") ||
        (!singular_margins(claimed.problem, claimed.design).empty() && all_passed(rebuilt(claim).of_motion)))
        checks.push_back(check_warnings(document, claimed));
    return checks;
}

}  // namespace mechwright
