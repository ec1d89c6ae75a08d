#include "synthesis/bench/kernels/screening.h"

#include <cmath>

#include "synthesis/bench/kernels/lanes.h"
#include "synthesis/bench/kernels/measured_kernel.h"
#include "synthesis/mechanism/four_bar/path/screening.h"

namespace mechwright::bench {

namespace {

using Lengths = std::array<Group, 4>;

std::vector<Lengths> candidates() {
    const auto inputs = CouplerPointKernel::usual();
    std::vector<Lengths> all(inputs.size() / std::tuple_size_v<Group>);
    for (std::size_t k = 0; k < inputs.size(); ++k)
        for (std::size_t i = 0; i < 4; ++i)
            all[k / std::tuple_size_v<Group>][i][k % std::tuple_size_v<Group>] = inputs[k].x[i];
    return all;
}

std::vector<ScreenedPoint> points() {
    std::vector<ScreenedPoint> all;
    for (int i = 0; i < 18; ++i) {
        const auto half = half_turn(0.35 * i);
        all.push_back({{std::cos(0.35 * i), std::sin(0.5 * i)}, 1, {half.cosine, half.sine}});
    }
    return all;
}

}  // namespace

std::vector<Row> measured_screening(const Effort& effort) {
    const std::vector<Lengths> all = candidates();
    const std::vector<ScreenedPoint> path = points();
    std::vector<std::pair<std::string_view, Piece>> forms;
    for (const auto& [set, name] : lane_names) {
        if (!is_available(set)) continue;
        forms.emplace_back(name, [&, chosen = set](benchmark::State& state) {
            for (auto _ : state)
                for (const Lengths& lengths : all)
                    benchmark::DoNotOptimize(four_bar_screening(chosen, 0, lengths, path, {true, true, true}));
        });
    }
    std::vector<Piece> pieces;
    for (const auto& form : forms)
        pieces.push_back(form.second);
    const std::vector<Timing> timings = timed(pieces, effort.pick(5, 21), effort.pick(0.1, 1.0));
    const double each = 1 / static_cast<double>(all.size() * std::tuple_size_v<Group>);
    std::vector<Row> rows;
    for (std::size_t i = 0; i < forms.size(); ++i) {
        const Timing& t = timings[i];
        rows.push_back(
            kernel_row("screening", forms[i].first, {{t.median * each, t.lower * each, t.upper * each}, {}, {}}));
    }
    return rows;
}

}  // namespace mechwright::bench
