#include "synthesis/bench/profiles/runs.h"

#include <algorithm>
#include <limits>

namespace mechwright::bench {

namespace {

struct Weights {
    double gradient = 1;
    double hessian = 1;
};

Runs read(const Sheet& sheet, const std::vector<Row>& rows) {
    Runs all;
    Weights weights;
    for (const Row& row : rows) {
        const std::string target = sheet.text(row, "target");
        if (target == cost_of_one) {
            weights = {sheet.number(row, "gradients"), sheet.number(row, "hessians")};
            all.problem = sheet.text(row, "problem");
            all.variables = sheet.number(row, "variables");
            continue;
        }
        const double evaluations = sheet.number(row, "values") + weights.gradient * sheet.number(row, "gradients") +
                                   weights.hessian * sheet.number(row, "hessians");
        all.search = sheet.text(row, "search");
        if (target == whole_run)
            all.runs.push_back({evaluations, {}});
        else
            all.runs.back().until[target] = evaluations;
    }
    return all;
}

}  // namespace

int Runs::successes(const std::string& target) const {
    return static_cast<int>(
        std::count_if(runs.begin(), runs.end(), [&](const Run& run) { return run.until.contains(target); }));
}

double Runs::expected_evaluations(const std::string& target) const {
    double sum = 0;
    for (const Run& run : runs) {
        const auto met = run.until.find(target);
        sum += met == run.until.end() ? run.whole : met->second;
    }
    const int met = successes(target);
    return met > 0 ? sum / met : std::numeric_limits<double>::infinity();
}

std::vector<Runs> runs_of(const Sheet& sheet) {
    std::vector<Runs> all;
    for (const std::string& name : sheet.distinct("measurement"))
        all.push_back(read(sheet, sheet.where("measurement", name)));
    std::erase_if(all, [](const Runs& runs) { return runs.runs.empty(); });
    return all;
}

}  // namespace mechwright::bench
