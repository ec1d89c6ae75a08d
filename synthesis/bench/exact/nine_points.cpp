#include "synthesis/bench/exact/nine_points.h"

#include "synthesis/exact/homotopy/doubled.h"

namespace mechwright::bench {

using namespace homotopy;

namespace {

// As the program has it for its lanes: everything it calls made part of it.
[[gnu::flatten]] std::vector<GuidancePath> one_by_one(const NinePoints& points, const TrackingOptions& options) {
    using Single = Lanes<1>;
    std::vector<GuidancePath> starts;
    for (const GuidanceValues& solution : points.start->solutions)
        starts.push_back(beginning_at(solution));
    std::vector<GuidancePath> out(starts.size());
    Tracker<GuidanceSystem, Single, 1> tracker(points.target.system, points.start->parameters, points.target.parameters,
                                               options);
    std::ptrdiff_t next = 0;
    const auto count = static_cast<std::ptrdiff_t>(starts.size());
    tracker.run(
        starts, [&] { return next < count ? next++ : -1; }, {}, out);
    return out;
}

template <InstructionSet set>
std::vector<GuidancePath> in_lanes(const NinePoints& points, const TrackingOptions& options) {
    return track(points.target.system, points.start->solutions, points.start->parameters, points.target.parameters,
                 options, 1, {}, set);
}

}  // namespace

NinePoints nine_points() {
    const std::vector<GuidedPlace> places{{{0.25, 0}, {}},    {{0.52, 0.10}, {}}, {{0.80, 0.70}, {}},
                                          {{1.20, 1.00}, {}}, {{1.40, 1.30}, {}}, {{1.10, 1.48}, {}},
                                          {{0.70, 1.40}, {}}, {{0.20, 1.00}, {}}, {{0.02, 0.40}, {}}};
    const GuidanceTarget target = guidance_target(places);
    return {places, target, &start_system(target.system)};
}

std::vector<PathsBy> ways_to_follow() {
    std::vector<PathsBy> ways{{"one by one", one_by_one},
                              {"2 lanes, baseline x86-64", in_lanes<InstructionSet::baseline>}};
    if (is_available(InstructionSet::avx2)) ways.push_back({"4 lanes, AVX2", in_lanes<InstructionSet::avx2>});
    if (is_available(InstructionSet::avx512)) ways.push_back({"8 lanes, AVX-512", in_lanes<InstructionSet::avx512>});
    return ways;
}

TrackingOptions with_tolerance(double prediction_error) {
    TrackingOptions options;
    options.correction_error *= prediction_error / options.prediction_error;
    options.prediction_error = prediction_error;
    return options;
}

Ends ends_of(const NinePoints& points, const std::vector<GuidancePath>& paths) {
    constexpr double regular = 1e-11;  // the last correction of a refined end, as the solver asks it
    Ends ends;
    SeenOrbits seen;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        ends.steps += static_cast<double>(paths[i].steps) / static_cast<double>(paths.size());
        GuidanceValues end = paths[i].point;
        if (paths[i].end != PathEnd::reached || refine(points.target.system, end, points.target.parameters) > regular)
            continue;
        ++ends.reached;
        ends.distinct += !seen.find_or_keep(orbit_of(points.target.system, end), i);
    }
    return ends;
}

}  // namespace mechwright::bench
