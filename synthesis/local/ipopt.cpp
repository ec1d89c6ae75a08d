#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <new>

#include "synthesis/local/local.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Ipopt::Number;

/// MUMPS, the linear solver beneath, keeps global state.
std::mutex one_at_a_time;

/// MUMPS does not survive a lack of memory: it crashes, or the run ends as if nothing were feasible. Before each run it
/// is made sure that this can be had, several times what programs of some dozen variables take.
constexpr std::size_t room_for_a_run = 32 << 20;

void make_sure_of_room() { ::operator delete(::operator new(room_for_a_run)); }

/// Iterations without anything better after which a run ends.
constexpr int most_without_gain = 60;

/// Ipopt's number for "no limit".
constexpr double no_limit = 2e19;

/// The program as Ipopt asks for it. Derivative matrices are dense; the Hessian is given as its lower triangle.
struct IpoptProgram final : Ipopt::TNLP {
    const Program& program;
    const LocalLimits& limits;
    VectorXd start;
    LocalOutcome best;
    VectorXd x;
    ProgramValues values;
    LagrangianHessian second;
    struct {
        double objective = unlimited;
        double violation = unlimited;
    } held;
    int without_gain = 0;  ///< iterations

    IpoptProgram(const Program& p, const VectorXd& s, const LocalLimits& l) : program(p), limits(l), start(s) {}

    /// Whether the program could be evaluated at this point; Ipopt is told the truth and steps back.
    bool at(const Number* point) {
        const auto n = static_cast<Index>(program.size());
        if (best.evaluations > 0 && std::equal(point, point + n, x.data())) return values.assembled;
        x = Eigen::Map<const VectorXd>(point, n);
        evaluate(program, x, true, values);
        best.consider(program, x, values);
        return values.assembled;
    }

    bool get_nlp_info(Ipopt::Index& n, Ipopt::Index& m, Ipopt::Index& in_jacobian, Ipopt::Index& in_hessian,
                      IndexStyleEnum& style) override {
        n = static_cast<Ipopt::Index>(program.size());
        m = static_cast<Ipopt::Index>(program.rows.size());
        in_jacobian = n * m;
        in_hessian = n * (n + 1) / 2;
        style = C_STYLE;
        return true;
    }

    bool get_bounds_info(Ipopt::Index n, Number* lower, Number* upper, Ipopt::Index m, Number* row_lower,
                         Number* row_upper) override {
        const auto limit = [](double v) { return std::clamp(v, -no_limit, no_limit); };
        for (Ipopt::Index i = 0; i < n; ++i) {
            lower[i] = limit(program.variables[static_cast<std::size_t>(i)].lower);
            upper[i] = limit(program.variables[static_cast<std::size_t>(i)].upper);
        }
        for (Ipopt::Index r = 0; r < m; ++r) {
            row_lower[r] = limit(program.rows[static_cast<std::size_t>(r)].lower);
            row_upper[r] = limit(program.rows[static_cast<std::size_t>(r)].upper);
        }
        return true;
    }

    bool get_starting_point(Ipopt::Index n, bool, Number* point, bool, Number*, Number*, Ipopt::Index, bool,
                            Number*) override {
        std::copy_n(start.data(), n, point);
        return true;
    }

    bool eval_f(Ipopt::Index, const Number* point, bool, Number& objective) override {
        if (!at(point)) return false;
        objective = values.objective;
        return true;
    }

    bool eval_grad_f(Ipopt::Index n, const Number* point, bool, Number* gradient) override {
        if (!at(point)) return false;
        std::copy_n(values.gradient.data(), n, gradient);
        return true;
    }

    bool eval_g(Ipopt::Index, const Number* point, bool, Ipopt::Index m, Number* rows) override {
        if (!at(point)) return false;
        std::copy_n(values.rows.data(), m, rows);
        return true;
    }

    bool eval_jac_g(Ipopt::Index n, const Number* point, bool, Ipopt::Index m, Ipopt::Index, Ipopt::Index* row,
                    Ipopt::Index* column, Number* jacobian) override {
        if (jacobian == nullptr) {
            for (Ipopt::Index r = 0, k = 0; r < m; ++r)
                for (Ipopt::Index i = 0; i < n; ++i, ++k) {
                    row[k] = r;
                    column[k] = i;
                }
            return true;
        }
        if (!at(point)) return false;
        for (Ipopt::Index r = 0, k = 0; r < m; ++r)
            for (Ipopt::Index i = 0; i < n; ++i, ++k)
                jacobian[k] = values.jacobian(r, i);
        return true;
    }

    bool eval_h(Ipopt::Index n, const Number* point, bool, Number weight, Ipopt::Index m, const Number* multipliers,
                bool, Ipopt::Index, Ipopt::Index* row, Ipopt::Index* column, Number* hessian) override {
        if (hessian == nullptr) {
            for (Ipopt::Index i = 0, k = 0; i < n; ++i)
                for (Ipopt::Index j = 0; j <= i; ++j, ++k) {
                    row[k] = i;
                    column[k] = j;
                }
            return true;
        }
        if (!at(point)) return false;
        ++best.hessians;
        lagrangian_hessian(program, x, weight, Eigen::Map<const VectorXd>(multipliers, m), second);
        if (!second.value.allFinite()) return false;
        for (Ipopt::Index i = 0, k = 0; i < n; ++i)
            for (Ipopt::Index j = 0; j <= i; ++j, ++k)
                hessian[k] = second.value(i, j);
        return true;
    }

    /// Called once in each iteration.
    bool intermediate_callback(Ipopt::AlgorithmMode, Ipopt::Index, Number, Number, Number, Number, Number, Number,
                               Number, Number, Ipopt::Index, const Ipopt::IpoptData*,
                               Ipopt::IpoptCalculatedQuantities*) override {
        return !limits.reached() && best.evaluations < limits.most_evaluations && !stalls();
    }

    /// Whether nothing better has been come across for long: where the worst of something changes from one to another
    /// there is no point at which Ipopt's own conditions hold, and it would go on to the end of its iterations.
    bool stalls() {
        if (best.violation < held.violation || best.objective < held.objective - 1e-9 * std::abs(held.objective)) {
            held = {best.objective, best.violation};
            without_gain = 0;
        }
        return ++without_gain > most_without_gain;
    }

    void finalize_solution(Ipopt::SolverReturn, Ipopt::Index, const Number*, const Number*, const Number*, Ipopt::Index,
                           const Number*, const Number*, Number, const Ipopt::IpoptData*,
                           Ipopt::IpoptCalculatedQuantities*) override {}
};

/// How far a run that stays near its start is moved away from bounds and constraints: relative to them, and at most
/// this part of their range.
constexpr double push = 1e-9;

/// Whether all first slacks will be more than rounding when the start is moved so far. Ipopt 3.11.9 derives multipliers
/// by `mu-based` from the slacks, and `CalculateSafeSlack` mends those that rounding has made zero with the multipliers
/// before, of which there are none yet: it reads through a null pointer. The constant multipliers that it begins with
/// by default ask for no slacks.
bool first_slacks_hold(const Program& program, const VectorXd& start) {
    constexpr double least = 1e-13;  // Ipopt multiplies rows by 1e-8 or more, and mends slacks below 2e-23 here
    ProgramValues values;
    evaluate(program, start, false, values);
    const auto holds = [](double value, double lower, double upper) {
        if (lower == upper) return true;
        const auto of_bound = [&](double bound) {
            const double size = std::max(1.0, std::abs(bound));
            return !std::isfinite(bound) ||
                   std::min(push * size, push * (upper - lower)) > least * (size + std::abs(value));
        };
        return of_bound(lower) && of_bound(upper);
    };
    bool all = values.assembled;
    for (std::size_t i = 0; i < program.size(); ++i)
        all = all && holds(start[static_cast<Index>(i)], program.variables[i].lower, program.variables[i].upper);
    for (std::size_t r = 0; all && r < program.rows.size(); ++r)
        all = holds(values.rows[static_cast<Index>(r)], program.rows[r].lower, program.rows[r].upper);
    return all;
}

/// Keeps the first iterate where the start is: by default it is moved a hundredth of each range into the interior, and
/// as far away from each constraint.
bool stays_near(Ipopt::OptionsList& options) {
    constexpr double first_barrier = 1e-7;
    for (const char* option : {"bound_push", "bound_frac", "slack_bound_push", "slack_bound_frac"})
        if (!options.SetNumericValue(option, push)) return false;
    return options.SetStringValue("bound_mult_init_method", "mu-based") &&
           options.SetNumericValue("mu_init", first_barrier);
}

/// Where memory is short, the constructor throws an exception of Ipopt's own.
Ipopt::IpoptApplication* new_application() {
    try {
        return new Ipopt::IpoptApplication(false);
    } catch (const Ipopt::IpoptException&) {
        throw std::bad_alloc();
    }
}

/// Ipopt's last word; a stop on request is ours.
std::string_view verdict_of(Ipopt::ApplicationReturnStatus status, const IpoptProgram& run) {
    switch (status) {
        case Ipopt::Solve_Succeeded: return "ipopt: converged";
        case Ipopt::Solved_To_Acceptable_Level: return "ipopt: nearly converged";
        case Ipopt::Infeasible_Problem_Detected: return "ipopt: locally infeasible";
        case Ipopt::Search_Direction_Becomes_Too_Small: return "ipopt: steps too small";
        case Ipopt::Diverging_Iterates: return "ipopt: diverged";
        case Ipopt::Maximum_Iterations_Exceeded: return "ipopt: iterations used up";
        case Ipopt::Restoration_Failed: return "ipopt: restoration failed";
        case Ipopt::Error_In_Step_Computation: return "ipopt: no step";
        case Ipopt::Not_Enough_Degrees_Of_Freedom: return "ipopt: more equalities than variables";
        case Ipopt::Invalid_Number_Detected: return "ipopt: not assembled";
        case Ipopt::User_Requested_Stop:
            if (run.limits.reached()) return "ipopt: stopped";
            return run.without_gain > most_without_gain ? "ipopt: no more gain" : "ipopt: evaluations used up";
        default: return "ipopt: failed";
    }
}

}  // namespace

LocalOutcome ipopt(const Program& program, const VectorXd& start, const LocalLimits& limits) {
    const std::lock_guard lock(one_at_a_time);
    const Ipopt::SmartPtr<IpoptProgram> tnlp = new IpoptProgram(program, start, limits);
    if (program.size() == 0) {
        tnlp->at(start.data());
        tnlp->best.verdict = "ipopt: no variables";
        return tnlp->best;
    }
    make_sure_of_room();
    const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new_application();
    const Ipopt::SmartPtr<Ipopt::OptionsList> options = application->Options();
    const bool accepted = options->SetStringValue("linear_solver", "mumps") && options->SetStringValue("sb", "yes") &&
                          options->SetIntegerValue("print_level", 0) && options->SetIntegerValue("max_iter", 500) &&
                          options->SetNumericValue("tol", std::max(limits.tolerance, 1e-10)) &&
                          options->SetNumericValue("bound_relax_factor", 0) &&
                          options->SetStringValue("honor_original_bounds", "yes") &&
                          (!limits.near_optimum || !first_slacks_hold(program, start) || stays_near(*options));
    // An empty name keeps a stray ipopt.opt in the working directory from changing results.
    Ipopt::ApplicationReturnStatus verdict = Ipopt::Internal_Error;
    if (accepted && application->Initialize("") == Ipopt::Solve_Succeeded)
        verdict = application->OptimizeTNLP(GetRawPtr(tnlp));
    // The verdict is not evidence, `best` is what counts; but a run that lacked memory is not finished.
    if (verdict == Ipopt::Insufficient_Memory) throw std::bad_alloc();
    tnlp->best.verdict = verdict_of(verdict, *tnlp);
    return tnlp->best;
}

}  // namespace mechwright
