#include "synthesis/local/local.h"

namespace mechwright {

void LocalOutcome::consider(const Program& program, const Eigen::VectorXd& point, const ProgramValues& values) {
    ++evaluations;
    if (!values.assembled) return;
    const double worst = mechwright::violation(program, point, values);
    const bool now = worst <= feasible_below;
    const bool before = violation <= feasible_below;
    const bool better = now && before ? values.objective < objective : now || (!before && worst < violation);
    if (!better) return;
    x = point;
    objective = values.objective;
    violation = worst;
}

}  // namespace mechwright
