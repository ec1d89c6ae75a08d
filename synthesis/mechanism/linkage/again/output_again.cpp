#include "synthesis/mechanism/linkage/again/output_again.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "synthesis/mechanism/linkage/again/measured.h"
#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/mechanism/over_range.h"

namespace mechwright {

namespace {

constexpr std::size_t scale_count = 4;  ///< the last of the arguments: start and range of input and output
using again::missing;

}  // namespace

LinkageOutputAgain::LinkageOutputAgain(const Motion& motion, std::span<const Digits50> arguments)
    : scan_(within_input(motion, arguments.last(scale_count)), arguments.first(arguments.size() - scale_count)),
      output_(linkage_of(motion.model).over_input[static_cast<const LinkageMeasure*>(motion.of)->over_input].of) {
    if (scan_.empty() || !linkage::turns_are_alike(scan_.model.signals, output_)) return;
    const std::span<const Digits50> four = arguments.last(scale_count);
    const double away = error(four[0].convert_to<double>(), four[2].convert_to<double>()) / (2 * std::numbers::pi);
    if (std::isfinite(away)) whole_turns_ = -std::round(away);
}

double LinkageOutputAgain::error(double input, double asked) const {
    if (scan_.empty()) return missing;
    const double inside = std::clamp(input, scan_.at.front(), scan_.at.back());
    const SeriesSignals* signals = scan_.look(inside);
    if (signals == nullptr) return missing;
    return signals->by_time(scan_.model.signals[output_], 0).c[0] + 2 * std::numbers::pi * whole_turns_ - asked;
}

Digits50 LinkageOutputAgain::error(const Digits50& input, const Digits50& asked) const {
    if (scan_.empty()) return missing;
    const auto near = input.convert_to<double>();
    SignalsAgain<Digits50> signals = scan_.precise(scan_.nearest(near));
    Digits50 output = signals.value(output_, input);
    // A range may end where the linkage can go no further.
    if (!isfinite(output) && (near <= scan_.at.front() || near >= scan_.at.back())) {
        SignalsAgain<Digits50> end = scan_.at_end(near >= scan_.at.back());
        output = end.value(output_, end.follower.at);
    }
    return output + 2 * pi<Digits50>() * whole_turns_ - asked;
}

}  // namespace mechwright
