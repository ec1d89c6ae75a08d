#include "synthesis/bench/curves/campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "synthesis/bench/curves/best_known.h"
#include "synthesis/bench/profiles/success.h"

namespace mechwright::bench {

double least_error(const Sheet& sheet, const std::string& shape) {
    double least = std::numeric_limits<double>::infinity();
    for (const BestKnown& known : best_known())
        if (known.shape == shape) least = known.rms;
    for (const Row& row : sheet.where("shape", shape))
        if (const double error = sheet.number(row, "path-rms"); error < least) least = error;
    return least;
}

std::string share_text(double hits, double runs) {
    const Interval95 interval = wilson(hits, runs);
    return fmt::format("{:.1f} % ({:.1f} to {:.1f} %)", 100 * hits / runs, 100 * interval.lower, 100 * interval.upper);
}

double quantile(std::vector<double> numbers, double part) {
    std::sort(numbers.begin(), numbers.end());
    return numbers[static_cast<std::size_t>(part * static_cast<double>(numbers.size() - 1))];
}

}  // namespace mechwright::bench
