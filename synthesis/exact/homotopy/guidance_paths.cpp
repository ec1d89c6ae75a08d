#include "synthesis/exact/homotopy/guidance_paths.h"

#include <atomic>
#include <functional>

#include "synthesis/program/work_sharing.h"

namespace mechwright::homotopy {

namespace {

/// What the workers of one call share.
struct Work {
    const GuidanceSystem& system;
    const std::vector<GuidancePath>& starts;
    const GuidanceParameters& from;
    const GuidanceParameters& to;
    const TrackingOptions& options;
    const RunEnd& end;
    std::vector<GuidancePath>& out;
    std::atomic<std::ptrdiff_t> next{0};

    std::ptrdiff_t take() {
        const std::ptrdiff_t path = next++;
        return path < static_cast<std::ptrdiff_t>(starts.size()) ? path : -1;
    }
};

template <class T, std::size_t N>
void work_on(Work& work) {
    Tracker<GuidanceSystem, T, N> tracker(work.system, work.from, work.to, work.options);
    tracker.run(
        work.starts, [&work] { return work.take(); }, work.end, work.out);
}

// One body for each instruction set, with everything it calls made part of it.

[[gnu::flatten]] void work_baseline(Work& work) { work_on<Lanes<2>, 2>(work); }
[[gnu::flatten]] void wide_baseline(Work& work) { work_on<Doubled<Lanes<2>>, 2>(work); }

#if defined(__x86_64__)

[[gnu::flatten, gnu::target("avx2")]] void work_avx2(Work& work) { work_on<Lanes<4>, 4>(work); }
[[gnu::flatten, gnu::target("avx2")]] void wide_avx2(Work& work) { work_on<Doubled<Lanes<4>>, 4>(work); }

[[gnu::flatten, gnu::target("avx512f")]] void work_avx512(Work& work) { work_on<Lanes<8>, 8>(work); }
[[gnu::flatten, gnu::target("avx512f")]] void wide_avx512(Work& work) { work_on<Doubled<Lanes<8>>, 8>(work); }

#endif

using Body = void (*)(Work&);

Body body_for(InstructionSet set) {
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return work_avx512;
    if (set == InstructionSet::avx2) return work_avx2;
#endif
    static_cast<void>(set);
    return work_baseline;
}

Body wide_body_for(InstructionSet set) {
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return wide_avx512;
    if (set == InstructionSet::avx2) return wide_avx2;
#endif
    static_cast<void>(set);
    return wide_baseline;
}

std::vector<GuidancePath> tracked(const GuidanceSystem& system, const std::vector<GuidancePath>& starts,
                                  const GuidanceParameters& from, const GuidanceParameters& to,
                                  const TrackingOptions& options, int jobs, const RunEnd& end, Body body) {
    std::vector<GuidancePath> out(starts.size());
    Work work{system, starts, from, to, options, end, out};
    share_work(jobs, jobs, [&](int) { body(work); });
    return out;
}

}  // namespace

std::vector<GuidancePath> track(const GuidanceSystem& system, const std::vector<GuidanceValues>& starts,
                                const GuidanceParameters& from, const GuidanceParameters& to,
                                const TrackingOptions& options, int jobs, const RunEnd& end, InstructionSet set) {
    std::vector<GuidancePath> beginnings;
    for (const GuidanceValues& start : starts)
        beginnings.push_back(beginning_at(start));
    return tracked(system, beginnings, from, to, options, jobs, end, body_for(set));
}

std::vector<GuidancePath> track_wide(const GuidanceSystem& system, const std::vector<GuidancePath>& stopped,
                                     const GuidanceParameters& from, const GuidanceParameters& to,
                                     const TrackingOptions& options, int jobs, const RunEnd& end, InstructionSet set) {
    return tracked(system, stopped, from, to, options, jobs, end, wide_body_for(set));
}

GuidancePath beginning_at(const GuidanceValues& solution) {
    GuidancePath path;
    path.point = solution;
    return path;
}

double refine(const GuidanceSystem& system, GuidanceValues& solution, const GuidanceParameters& at) {
    constexpr int most_corrections = 8;
    using T = Doubled<double>;
    GuidanceSystem::Point<T> u;
    GuidanceSystem::Parameters<T> p;
    for (std::size_t i = 0; i < u.size(); ++i)
        u[i] = {T(solution[i].re), T(solution[i].im)};
    for (std::size_t i = 0; i < p.size(); ++i)
        p[i] = {T(at[i].re), T(at[i].im)};
    Augmented<T, GuidanceSystem::size> matrix;
    double last = 1;
    for (int k = 0; k < most_corrections && last > 1e-20; ++k) {
        system.linearise(u, p, static_cast<const GuidanceSystem::Parameters<T>*>(nullptr), matrix);
        solve(matrix);
        double correction = 0, size = 0;
        for (std::size_t i = 0; i < u.size(); ++i) {
            const Complex<T>& change = matrix[i][GuidanceSystem::size];
            u[i] = u[i] + change;
            correction = std::max(correction, norm(change).high);
            size = std::max(size, norm(u[i]).high);
        }
        const double relative = std::sqrt(correction / size);
        if (!std::isfinite(relative)) return 1;
        if (k > 3 && relative >= last) break;
        last = relative;
    }
    for (std::size_t i = 0; i < u.size(); ++i)
        solution[i] = {u[i].re.high, u[i].im.high};
    return last;
}

}  // namespace mechwright::homotopy
