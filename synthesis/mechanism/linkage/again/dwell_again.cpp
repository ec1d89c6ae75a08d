// A dwell in fifty digits, from the equations of the joints.

#include <array>
#include <optional>
#include <vector>

#include "synthesis/mechanism/linkage/again/measured.h"
#include "synthesis/mechanism/linkage/dwell.h"
#include "synthesis/mechanism/linkage/quantities.h"

namespace mechwright {

namespace {

again::Measured dwelling(const Scan& scan, const LinkageMeasure& of) {
    return again::measured(scan, of.asked.signal, static_cast<int>(of.asked.derivative));
}

}  // namespace

std::vector<DwellExtremeAgain> dwell_extremes_again(const Quantity& quantity, const Motion& motion,
                                                    std::span<const Digits50> dimensions) {
    const LinkageMeasure& of = *quantity.of.as<LinkageMeasure>();
    const Scan scan(motion_for(quantity, motion), quantity.reads.of(dimensions));
    if (scan.empty()) return {};
    const auto parts = again::parts_of(scan, of.stretch);
    if (parts.empty()) return {};
    const double period = scan.to() - scan.from();
    const bool is_cycle = scan.full_turn() && parts.size() == 1 && parts[0].y - parts[0].x == period;
    std::vector<DwellExtremeAgain> all;
    for (const again::Extreme& one : again::every_extreme(dwelling(scan, of), parts, is_cycle)) {
        const bool later = !all.empty() && one.at < all.back().input;
        all.push_back({later ? Digits50(one.at + period) : one.at, one.value});
    }
    return all;
}

std::vector<Digits50> dwell_again(const Quantity& quantity, const Motion& motion, std::span<const Digits50> dimensions,
                                  std::span<const double> inputs) {
    const Scan scan(motion_for(quantity, motion), quantity.reads.of(dimensions));
    std::vector<Digits50> values(inputs.size(), Digits50(again::missing));
    if (scan.empty()) return values;
    const again::Measured f = dwelling(scan, *quantity.of.as<LinkageMeasure>());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const bool later = scan.full_turn() && inputs[i] > scan.to();
        values[i] = f.at(later ? inputs[i] - (scan.to() - scan.from()) : inputs[i]);
    }
    return values;
}

}  // namespace mechwright
