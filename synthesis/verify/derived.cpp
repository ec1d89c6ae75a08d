#include "synthesis/verify/derived.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "synthesis/document/claimed_problem.h"
#include "synthesis/program/standing/singular.h"
#include "synthesis/verify/alternation.h"
#include "synthesis/verify/dwells.h"
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
        const double size = again[i].relative == 0 ? 0 : std::abs(again[i].margin / again[i].relative);
        check.passed = one.is_object() && one.value("name", Json()) == again[i].name &&
                       one.value("impossible", Json(false)) == again[i].impossible &&
                       close(one.value("relative", Json()), again[i].relative, within) &&
                       close(one.value("margin", Json()), again[i].margin, within * size) &&
                       one.value("warned_below", Json()) == singular_below;
    }
    for (const SingularMargin& m : again)
        check.detail += (check.detail.empty() ? "" : "; ") + to_text(m, claimed.problem.units);
    if (again.empty()) check.detail = "no margin is small";
    return check;
}

}  // namespace

std::vector<Check> check_derived(const Json& document) {
    std::vector<Check> checks;
    const auto [claim, defect] = read_claim(document);
    if (!defect.empty() || !why_not_evaluable(claim).empty()) return checks;
    const ClaimedDesign claimed = claimed_design(claim);
    std::map<std::string, std::size_t> seen;  // of each section, where it is a list
    for (const InputTask& task : input_tasks(claim)) {
        const Json& member = document[task.section()];
        const Json& stated = member.is_array() ? member[seen[task.section()]++] : member;
        if (!stated.contains("extremes")) continue;
        for (Check& check : check_alternation(stated, claim, task))
            checks.push_back(std::move(check));
    }
    if (document.contains("dwells"))
        for (Check& check : check_dwells(document["dwells"], claim))
            checks.push_back(std::move(check));
    // A design that comes apart needs no warning.
    if (document.contains("warnings") ||
        (!singular_margins(claimed.problem, claimed.design).empty() && all_passed(rebuilt(claim).of_motion)))
        checks.push_back(check_warnings(document, claimed));
    return checks;
}

}  // namespace mechwright
