#include "synthesis/search/drawn_starts.h"

#include <algorithm>
#include <utility>

#include "synthesis/target/path/fit.h"

namespace mechwright {

namespace {

using Eigen::VectorXd;

/// Of starts that come close to the path so many times as many as are kept are ranked by all that is asked for.
constexpr int ranked_by_all = 3;
/// So many are drawn before it is seen which of them assemble.
constexpr std::uint64_t drawn_together = 512;

struct Candidate {
    double score = unlimited;
    VectorXd x{};
    bool preferred = false;
};

void sort_by_score(std::vector<Candidate>& all) {
    std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.score < b.score; });
}

/// The weighted sum of squares that is left of the path.
double rest_of_path(const Program& program, const VectorXd& x, PathResiduals& rest) {
    return path_residuals(program, x, false, rest) ? rest.value.squaredNorm() : unlimited;
}

bool has_requirements(const Program& program) {
    return std::any_of(program.rows.begin(), program.rows.end(), [](const Row& row) { return row.requirement; });
}

/// Objective and violation, both of order one; infinite where something has no value.
double merit_of_all(const Program& program, VectorXd& x, ProgramValues& values) {
    settle_epigraphs(program, x);
    evaluate(program, x, false, values);
    return values.assembled ? values.objective + 10 * violation(program, x, values) : unlimited;
}

}  // namespace

VectorXd DrawnStarts::draw(std::uint64_t k) const {
    VectorXd x = draws_(k);
    if (parts_.empty()) return x;
    const KnownPart& part = parts_[k % parts_.size()];
    for (const Eigen::Index v : part.known)
        x[v] = part.x[v];
    return x;
}

/// Of the draws from one number to before another those that may assemble at every target.
std::vector<NumberedDraw> DrawnStarts::draws_that_assemble(std::uint64_t first, std::uint64_t end) const {
    std::vector<NumberedDraw> draws;
    draws.reserve(end - first);
    for (std::uint64_t k = first; k < end; ++k) {
        VectorXd x = draw(k);
        if (linear_violation(program_, x) == 0) draws.push_back({k, std::move(x)});
    }
    keep_assembled(program_, draws);
    return draws;
}

std::vector<VectorXd> DrawnStarts::of_round(int round, int keep, int enough, int most, DrawCounts& counts) const {
    std::vector<Candidate> candidates;
    PathResiduals rest;
    const auto consider = [&](VectorXd x, bool preferred) {
        if (!fit_assembled(program_, x)) return;
        ++counts.assembled;
        const double score = rest_of_path(program_, x, rest);
        if (score < unlimited) candidates.push_back({score, std::move(x), preferred});
    };
    if (round == 0 && parts_.empty()) {
        VectorXd x = program_.reference;
        if (program_.untimed_path()) set_path_angles(program_, 0.5, 0.5, x);
        ++counts.drawn;
        if (linear_violation(program_, x) == 0) consider(std::move(x), true);
    }
    const auto all = static_cast<std::uint64_t>(most) * static_cast<std::uint64_t>(keep);
    const auto first = static_cast<std::uint64_t>(round) * all;
    std::uint64_t drawn = 0;
    while (drawn < all && static_cast<int>(candidates.size()) < enough * keep) {
        const std::uint64_t end = std::min(all, drawn + drawn_together);
        for (NumberedDraw& draw : draws_that_assemble(first + drawn, first + end)) {
            consider(std::move(draw.x), false);
            drawn = draw.number + 1 - first;
            if (static_cast<int>(candidates.size()) >= enough * keep) break;
        }
        if (static_cast<int>(candidates.size()) < enough * keep) drawn = end;
    }
    counts.drawn += static_cast<long>(drawn);
    sort_by_score(candidates);
    const auto kept = static_cast<std::size_t>(keep);
    if (has_requirements(program_) || !parts_.empty()) {
        candidates.resize(std::min(candidates.size(), ranked_by_all * kept));
        ProgramValues values;
        for (Candidate& candidate : candidates)
            candidate.score = merit_of_all(program_, candidate.x, values);
        sort_by_score(candidates);
    }
    candidates.resize(std::min(candidates.size(), kept));
    std::vector<VectorXd> starts;
    for (Candidate& candidate : candidates) {
        counts.preferred += candidate.preferred ? 1 : 0;
        starts.push_back(std::move(candidate.x));
    }
    return starts;
}

}  // namespace mechwright
