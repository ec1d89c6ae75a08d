#include "synthesis/study/run.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <new>

#include "synthesis/document/document.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/work_sharing.h"
#include "synthesis/solve/solve.h"
#include "synthesis/study/points.h"
#include "synthesis/study/row.h"
#include "synthesis/study/tolerance.h"

namespace mechwright {

namespace {

using Clock = std::chrono::steady_clock;

/// Objectives that agree to this part are the same optimum.
constexpr double same_within = 1e-6;

/// What all workers of a run share.
struct Shared {
    const PreparedStudy& prepared;
    StudyStore& store;
    const StudyRunOptions& options;
    std::atomic<bool> stop = false;  ///< from outside, by the clock or by a fault: no other point is begun
    std::atomic<std::uint64_t> done = 0;
    std::atomic<std::uint64_t> solved = 0;
    std::uint64_t points = 0;
    std::mutex mutex{};
    std::string fault{};

    bool stopped() {
        if ((options.stop != nullptr && options.stop->load()) || Clock::now() >= options.deadline) stop = true;
        return stop;
    }

    void done_with(std::uint64_t count, bool newly) {
        done += count;
        if (newly) solved += count;
        if (!options.progress) return;
        const std::lock_guard lock(mutex);
        options.progress(done, solved, points);
    }

    void fail(const std::string& why) {
        stop = true;
        const std::lock_guard lock(mutex);
        if (fault.empty()) fault = why;
    }
};

/// Why a problem could not be read, without the file's name, which says nothing about the point.
std::string reason(const ReadProblem& read) {
    const auto first =
        std::find_if(read.messages.begin(), read.messages.end(), [](const Message& m) { return !m.warning; });
    return first == read.messages.end() ? "cannot be read" : first->text;
}

/// The problem of a point, of whose quantities only those are verified that the study wants.
ReadProblem with_wanted(ReadProblem read, const Study& study) {
    if (study.quantities.empty() || !read.ok()) return read;
    read.problem.wanted.emplace();
    for (const std::string& name : study.quantities)
        if (const int i = find_quantity(*read.problem.mechanism, name); i >= 0)
            read.problem.wanted->push_back(static_cast<std::size_t>(i));
    return read;
}

/// One worker on one strand.
class StrandRun {
public:
    StrandRun(Shared& shared, std::uint64_t number)
        : shared_(shared),
          number_(number),
          strand_(strand_at(*shared.prepared.study, number)),
          varied_(shared.prepared.text, shared.prepared.file) {}

    void run() {
        const StrandCheck check = shared_.store.check_of(number_);
        if (check.finished) return shared_.done_with(strand_.count, false);
        for (std::uint64_t i = 0; i < strand_.count; ++i)
            if (!first_time(strand_.first + i)) return;
        const std::optional<bool> differs = check.differed ? true : last_differs();
        if (!differs || (*differs && !solve_all_again())) return;
        shared_.store.put_check(number_, {*differs, true});
    }

private:
    /// Solves a point, unless it is in the data. False if the run has to end.
    bool first_time(std::uint64_t point) {
        std::optional<KnownPoint> known = shared_.store.find(point);
        if (known) {
            shared_.done_with(1, false);
        } else {
            if (shared_.stopped()) return false;
            const ReadProblem read = read_point(point);
            if (!read.ok()) {
                shared_.store.put(invalid_row(shared_.prepared, point, fault_.empty() ? reason(read) : fault_));
                known = KnownPoint{};
            } else {
                known = solve_first(point, read.problem);
                if (!known) return false;
            }
            shared_.done_with(1, true);
        }
        before_ = std::move(known);
        return true;
    }

    ReadProblem read_point(std::uint64_t point) {
        fault_ = varied_.put(*shared_.prepared.study, point_values(*shared_.prepared.study, point));
        if (fault_.empty()) return with_wanted(varied_.read(), *shared_.prepared.study);
        ReadProblem failed;
        failed.messages.push_back({shared_.prepared.file, 0, 0, fault_});
        return failed;
    }

    Result solved(const Problem& problem, const Design* neighbour) {
        RunOptions options;
        options.stop = shared_.options.stop;
        options.neighbour = neighbour;
        return solve(problem, options);
    }

    /// From the neighbour where there is one that can help, else by a search of its own; nothing if interrupted.
    std::optional<KnownPoint> solve_first(std::uint64_t point, const Problem& problem) {
        const bool helped = strand_.neighbours && point != strand_.first && before_ && before_->design &&
                            before_->status == name_of(Status::solved) && !before_->proved;
        if (helped) {
            const Result near = solved(problem, &*before_->design);
            if (near.status == Status::interrupted) return {};
            if (near.status == Status::solved)
                return keep(point, problem, near, near.search.complete() ? Start::own : Start::neighbour, false);
        }
        const Result own = solved(problem, nullptr);
        if (own.status == Status::interrupted) return {};
        return keep(point, problem, own, Start::own, false);
    }

    KnownPoint keep(std::uint64_t point, const Problem& problem, const Result& result, Start start, bool differed) {
        const StudyRow row = row_of(shared_.prepared, point, problem, result, start, differed);
        shared_.store.put(row);
        return {std::string(name_of(result.status)), std::string(name_of(start)), result.search.complete(), row.design};
    }

    /// Solves a point once more, now without help, and keeps the better design. Whether the help was no help; nothing
    /// if interrupted.
    std::optional<bool> solve_again(std::uint64_t point, const KnownPoint& known) {
        const Problem problem = read_point(point).problem;  // it could be read before
        const Result own = solved(problem, nullptr);
        if (own.status == Status::interrupted) return {};
        const Solution helped = assess(problem, *known.design);
        const bool better =
            own.status == Status::solved && preferred(problem, *own.best, helped) &&
            std::abs(own.best->objective - helped.objective) > same_within * std::max(1.0, std::abs(helped.objective));
        if (better)
            keep(point, problem, own, Start::both, true);
        else
            shared_.store.put_solved_both_ways(point);
        return better;
    }

    bool had_help(const std::optional<KnownPoint>& known) const {
        return known && known->design && known->start == name_of(Start::neighbour);
    }

    /// Whether the last point, if it was solved from a neighbour, has a better design than that; nothing if
    /// interrupted.
    std::optional<bool> last_differs() {
        const std::uint64_t last = strand_.first + strand_.count - 1;
        const std::optional<KnownPoint> known = shared_.store.find(last);
        if (!had_help(known)) return false;
        const std::optional<bool> differs = solve_again(last, *known);
        if (differs.value_or(false)) shared_.store.put_check(number_, {true, false});
        return differs;
    }

    bool solve_all_again() {
        for (std::uint64_t i = 0; i < strand_.count; ++i) {
            const std::optional<KnownPoint> known = shared_.store.find(strand_.first + i);
            if (had_help(known) && (shared_.stopped() || !solve_again(strand_.first + i, *known))) return false;
        }
        return true;
    }

    Shared& shared_;
    std::uint64_t number_;
    Strand strand_;
    VariedProblem varied_;
    std::optional<KnownPoint> before_{};
    std::string fault_{};
};

/// Samples of tolerances: a strand of them is evaluated and put at once.
void run_samples(Shared& shared, const TolerancedDesign& design, std::uint64_t number) {
    const Strand strand = strand_at(*shared.prepared.study, number);
    if (shared.store.check_of(number).finished) return shared.done_with(strand.count, false);
    std::vector<StudyRow> rows;
    for (std::uint64_t i = 0; i < strand.count; ++i) {
        if (shared.stopped()) return;
        const Piece piece = sample(design, *shared.prepared.study, strand.first + i);
        rows.push_back(evaluated_row(shared.prepared, strand.first + i, piece.problem, piece.solution));
    }
    shared.store.put(rows);
    shared.store.put_check(number, {false, true});
    shared.done_with(strand.count, true);
}

}  // namespace

StudyRun run_study(const PreparedStudy& prepared, StudyStore& store, const StudyRunOptions& options) {
    const Study& study = *prepared.study;
    const std::uint64_t last = std::min(options.last_strand, strand_count(study));
    Shared shared{prepared, store, options};
    if (options.first_strand < last) {
        const Strand first = strand_at(study, options.first_strand), end = strand_at(study, last - 1);
        shared.points = end.first + end.count - first.first;
    }
    StudyRun run;
    run.points = shared.points;
    std::optional<TolerancedDesign> design;
    if (study.tolerances()) {
        std::string why;
        design = toleranced_design(prepared, options, why);
        if (!design) {
            run.fault = why;
            run.unsolved_design = true;
            return run;
        }
        run.design = std::make_shared<const TolerancedDesign>(*design);
    }
    const auto strands = static_cast<int>(last - std::min(options.first_strand, last));
    share_work(strands, options.jobs, [&](int i) {
        if (shared.stopped()) return;
        const std::uint64_t number = options.first_strand + static_cast<std::uint64_t>(i);
        try {
            design ? run_samples(shared, *design, number) : StrandRun(shared, number).run();
        } catch (const std::bad_alloc&) {
            shared.stop = true;
            throw;
        } catch (const std::exception& fault) {
            shared.fail(fault.what());
        }
    });
    run.solved = shared.solved;
    run.fault = shared.fault;
    run.complete = run.fault.empty() && !shared.stop && shared.done == shared.points;
    return run;
}

}  // namespace mechwright
