#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <cmath>
#include <mutex>

#include "synthesis/local/local.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Ipopt::Number;

/// MUMPS, the linear solver beneath, keeps global state.
std::mutex one_at_a_time;

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

    IpoptProgram(const Program& p, const VectorXd& s, const LocalLimits& l) : program(p), limits(l), start(s) {}

    /// Whether the program could be evaluated at this point; Ipopt is told the truth and steps back.
    bool at(const Number* point) {
        const auto n = static_cast<Index>(program.size());
        if (x.size() == n && std::equal(point, point + n, x.data())) return values.assembled;
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
        const Eigen::MatrixXd full = lagrangian_hessian(program, x, weight, Eigen::Map<const VectorXd>(multipliers, m));
        for (Ipopt::Index i = 0, k = 0; i < n; ++i)
            for (Ipopt::Index j = 0; j <= i; ++j, ++k)
                hessian[k] = full(i, j);
        return true;
    }

    bool intermediate_callback(Ipopt::AlgorithmMode, Ipopt::Index, Number, Number, Number, Number, Number, Number,
                               Number, Number, Ipopt::Index, const Ipopt::IpoptData*,
                               Ipopt::IpoptCalculatedQuantities*) override {
        return !limits.reached() && best.evaluations < limits.most_evaluations;
    }

    void finalize_solution(Ipopt::SolverReturn, Ipopt::Index, const Number*, const Number*, const Number*, Ipopt::Index,
                           const Number*, const Number*, Number, const Ipopt::IpoptData*,
                           Ipopt::IpoptCalculatedQuantities*) override {}
};

}  // namespace

LocalOutcome ipopt(const Program& program, const VectorXd& start, const LocalLimits& limits) {
    const std::lock_guard lock(one_at_a_time);
    const Ipopt::SmartPtr<IpoptProgram> tnlp = new IpoptProgram(program, start, limits);
    if (program.size() == 0) {
        tnlp->at(start.data());
        return tnlp->best;
    }
    const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
    const auto options = application->Options();
    const bool accepted = options->SetStringValue("linear_solver", "mumps") && options->SetStringValue("sb", "yes") &&
                          options->SetIntegerValue("print_level", 0) && options->SetIntegerValue("max_iter", 500) &&
                          options->SetNumericValue("tol", std::max(limits.tolerance, 1e-10)) &&
                          options->SetNumericValue("bound_relax_factor", 0) &&
                          options->SetStringValue("honor_original_bounds", "yes");
    // An empty name keeps a stray ipopt.opt in the working directory from changing results.
    if (accepted && application->Initialize("") == Ipopt::Solve_Succeeded)
        application->OptimizeTNLP(GetRawPtr(tnlp));  // its verdict is not evidence; `best` is what counts
    return tnlp->best;
}

}  // namespace mechwright
