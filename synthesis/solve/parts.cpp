#include "synthesis/solve/parts.h"

#include <algorithm>
#include <cstddef>

namespace mechwright {

void begin_at(Problem& problem, const Design& design) {
    for (std::size_t i = 0; i < design.dimensions.size(); ++i)
        if (DimensionRange& range = problem.dimensions[i]; !range.fixed() && !range.tied())
            range.start = std::clamp(design.dimensions[i], range.min, range.max);
}

RunOptions quiet(RunOptions options) {
    options.progress = nullptr;
    options.bounding = nullptr;
    return options;
}

void add_work(SearchReport& whole, const SearchReport& part) {
    whole.starts += part.starts;
    whole.drawn += part.drawn;
    whole.assembled += part.assembled;
    whole.optimised += part.optimised;
    whole.sources += part.sources;
    whole.evaluations += part.evaluations;
}

}  // namespace mechwright
