#include "synthesis/mechanism/stationary.h"

namespace mechwright {

namespace {

constexpr double half_turn = std::numbers::pi;

/// Samples on both sides of a place, ever closer to it.
void add_cluster(double place, double widest, const Sweep& sweep, std::vector<double>& samples) {
    constexpr int halvings = 36;
    double step = 0.61 * widest;
    for (int k = 0; k < halvings; ++k, step /= 2)
        for (const double x : {place - step, place + step})
            if (x > sweep.from && x < sweep.to) samples.push_back(x);
}

}  // namespace

std::vector<double> sample_angles(const Sweep& sweep, const std::vector<double>& fast) {
    const double span = sweep.to - sweep.from;
    const int steps = std::max(32, static_cast<int>(std::ceil(span * 360 / half_turn)));
    std::vector<double> samples;
    samples.reserve(static_cast<std::size_t>(steps) + 1);
    for (int i = 0; i < steps; ++i)
        samples.push_back(sweep.from + i * (span / steps));
    samples.push_back(sweep.to);

    const double widest = span / steps;
    add_cluster(sweep.from, widest, sweep, samples);
    add_cluster(sweep.to, widest, sweep, samples);
    for (double k = std::ceil(sweep.from / half_turn); k * half_turn <= sweep.to; ++k)
        add_cluster(k * half_turn, widest, sweep, samples);
    for (const double place : fast)
        add_cluster(place, widest, sweep, samples);
    std::sort(samples.begin(), samples.end());
    samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
    return samples;
}

}  // namespace mechwright
