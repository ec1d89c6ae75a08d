#include "synthesis/bench/curves/best_known.h"

namespace mechwright::bench {

std::span<const BestKnown> best_known() { return {}; }

}  // namespace mechwright::bench
