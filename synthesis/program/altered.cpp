// Programs that ask for something else than the problem does, made from its own.

#include <cmath>

#include "synthesis/program/program.h"

namespace mechwright {

Program magnified(Program program, double size) {
    const auto divide = [&](std::vector<LinearTerm>& terms) {
        for (LinearTerm& term : terms)
            term.factor /= size;
    };
    for (Epigraph& epigraph : program.epigraphs) {
        divide(epigraph.outputs);
        for (Row& row : program.rows)
            if (row.form.variables.size() == 1 && row.form.variables.front().index == epigraph.variable)
                divide(row.form.outputs);
    }
    divide(program.objective.outputs);
    program.objective.constant /= size;
    return program;
}

Program relaxed(Program program) {
    constexpr double far = 1e3;
    const std::size_t shortfall = program.variables.size();
    program.variables.push_back({"shortfall", 0, far});
    program.reference.conservativeResize(program.reference.size() + 1);
    program.reference[program.reference.size() - 1] = 0;
    std::vector<Row> rows;
    std::vector<LinearTerm> missed;
    for (const Row& row : program.rows) {
        if (!row.requirement || row.equality()) {
            rows.push_back(row);
            continue;
        }
        const auto add = [&](double lower, double upper, double sign) {
            rows.push_back(row);
            rows.back().lower = lower;
            rows.back().upper = upper;
            rows.back().form.variables.push_back({shortfall, sign});
        };
        if (std::isfinite(row.lower)) add(row.lower, unlimited, 1);
        if (std::isfinite(row.upper)) add(-unlimited, row.upper, -1);
    }
    program.rows = std::move(rows);
    program.objective = {{}, {{shortfall, 1}}, 0};
    program.closest_to_reference = false;
    return program;
}

}  // namespace mechwright
