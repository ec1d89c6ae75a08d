#include "synthesis/mechanism/cam/measured_program.h"

#include <algorithm>
#include <limits>

namespace mechwright::cam {

std::array<double, local_count> local_values(const Shares& shares, std::span<const double> dimensions) {
    std::array<double, local_count> x{};
    for (const Share& share : shares)
        x[share.local] += share.factor * dimensions[share.dimension];
    return x;
}

void Sum::add(double factor, const Dual<double, local_count>& value, const Shares& shares) const {
    add(factor, value.value);
    for (const Share& a : shares)
        out->gradient[component * dimensions + a.dimension] += factor * a.factor * value.partial[a.local];
}

void Sum::add(double factor, const SecondDual<double, local_count>& value, const Shares& shares) const {
    const std::size_t pairs = dimensions * (dimensions + 1) / 2;
    add(factor, value.value);
    for (const Share& a : shares) {
        if (!out->gradient.empty())
            out->gradient[component * dimensions + a.dimension] += factor * a.factor * value.first[a.local];
        for (const Share& b : shares)
            if (a.dimension >= b.dimension)
                out->hessian[component * pairs + a.dimension * (a.dimension + 1) / 2 + b.dimension] +=
                    factor * a.factor * b.factor * value.mixed(a.local, b.local);
    }
}

void clear(const Measurement& out, std::size_t components, std::size_t dimensions) {
    const auto zero = [](std::span<double> all, std::size_t count) {
        if (!all.empty()) std::fill_n(all.begin(), count, 0.0);
    };
    zero(out.value, components);
    zero(out.gradient, components * dimensions);
    zero(out.hessian, components * (dimensions * (dimensions + 1) / 2));
}

void set_to_nothing(const Measurement& out, std::size_t components) {
    if (!out.value.empty()) std::fill_n(out.value.begin(), components, std::numeric_limits<double>::quiet_NaN());
}

}  // namespace mechwright::cam
