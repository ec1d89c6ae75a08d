#include "synthesis/target/over_input/together.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace mechwright {

namespace {

/// What a quantity of several is made of (Quantity::of).
struct Together {
    std::vector<Quantity> parts;
    std::vector<std::vector<std::size_t>> arguments;  ///< of each part, as places among those of the whole
};

const Together& together_of(const Motion& motion) { return *static_cast<const Together*>(motion.of); }

std::size_t pairs_of(std::size_t arguments) { return arguments * (arguments + 1) / 2; }

/// The place of a pair in a lower triangle by rows.
std::size_t pair_at(std::size_t a, std::size_t b) { return pairs_of(std::max(a, b)) + std::min(a, b); }

/// One part measured: `count` components with derivatives by its own arguments, as far as those of `asked` are.
struct MeasuredPart {
    std::size_t count;
    std::array<double, Quantity::most_components> value;
    std::array<double, Quantity::most_components * Reads::most> gradient;
    std::vector<double> hessian{};

    MeasuredPart(const Together& all, std::size_t part, const Motion& motion, std::span<const double> arguments,
                 const Measurement& asked) {
        const std::vector<std::size_t>& from = all.arguments[part];
        const std::size_t n = from.size();
        std::array<double, Reads::most> own;
        std::transform(from.begin(), from.end(), own.begin(), [&](std::size_t i) { return arguments[i]; });
        const Motion of_part = motion_for(all.parts[part], motion);
        count = all.parts[part].components(of_part);
        Measurement out{value, {}, {}};
        if (!asked.gradient.empty() || !asked.hessian.empty()) out.gradient = std::span(gradient).first(count * n);
        if (!asked.hessian.empty()) {
            hessian.resize(count * pairs_of(n));
            out.hessian = hessian;
        }
        all.parts[part].measure(of_part, std::span(own).first(n), out);
    }
};

std::size_t count_of_all(const Together& all, const Motion& motion) {
    return std::accumulate(all.parts.begin(), all.parts.end(), std::size_t{0},
                           [&](std::size_t sum, const Quantity& part) { return sum + count_components(part, motion); });
}

std::size_t count_of_greatest(const Motion& motion) {
    return std::min(count_of_all(together_of(motion), motion), Quantity::most_components);
}

/// Which components of all parts, one after the other, the whole has.
std::vector<bool> kept_components(const Together& all, const Motion& motion, std::span<const double> arguments) {
    std::vector<double> values;
    for (std::size_t p = 0; p < all.parts.size(); ++p) {
        const MeasuredPart part(all, p, motion, arguments, {});
        values.insert(values.end(), part.value.begin(), part.value.begin() + static_cast<std::ptrdiff_t>(part.count));
    }
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return !std::isnan(values[b]) && (std::isnan(values[a]) || values[a] > values[b]);
    });
    std::vector<bool> kept(values.size(), false);
    for (std::size_t i = 0; i < std::min(order.size(), Quantity::most_components); ++i)
        kept[order[i]] = true;
    return kept;
}

void measure_greatest(const Motion& motion, std::span<const double> arguments, const Measurement& out) {
    const Together& all = together_of(motion);
    const std::size_t n = arguments.size(), total = count_of_all(all, motion);
    const std::vector<bool> kept =
        total > Quantity::most_components ? kept_components(all, motion, arguments) : std::vector<bool>(total, true);
    std::fill(out.gradient.begin(), out.gradient.end(), 0.0);
    std::fill(out.hessian.begin(), out.hessian.end(), 0.0);
    std::size_t at = 0, to = 0;
    for (std::size_t p = 0; p < all.parts.size(); ++p) {
        const MeasuredPart part(all, p, motion, arguments, out);
        const std::vector<std::size_t>& from = all.arguments[p];
        for (std::size_t k = 0; k < part.count; ++k) {
            if (!kept[at++]) continue;
            out.value[to] = part.value[k];
            for (std::size_t i = 0; i < from.size(); ++i) {
                if (!out.gradient.empty()) out.gradient[to * n + from[i]] = part.gradient[k * from.size() + i];
                for (std::size_t j = 0; j <= i && !out.hessian.empty(); ++j)
                    out.hessian[to * pairs_of(n) + pair_at(from[i], from[j])] =
                        part.hessian[k * pairs_of(from.size()) + pair_at(i, j)];
            }
            ++to;
        }
    }
}

double weight_of(const Quantity& part, const Motion& motion) { return (*motion.asked)[part.of_target].weight; }

/// With r^2 = sum w q^2 / sum w, the weights shares of their sum: r dr = sum w q dq, and
/// r ddr = sum w (dq dq + q ddq) - dr dr.
void measure_root_mean(const Motion& motion, std::span<const double> arguments, const Measurement& out) {
    const Together& all = together_of(motion);
    const std::size_t n = arguments.size();
    const bool derivatives = !out.gradient.empty() || !out.hessian.empty();
    double weights = 0, square = 0;
    for (const Quantity& part : all.parts)
        weights += weight_of(part, motion);
    std::array<double, Reads::most> slope{};
    std::fill(out.hessian.begin(), out.hessian.end(), 0.0);
    for (std::size_t p = 0; p < all.parts.size(); ++p) {
        const MeasuredPart part(all, p, motion, arguments, out);
        const std::vector<std::size_t>& from = all.arguments[p];
        const double w = weight_of(all.parts[p], motion) / weights, q = part.value[0];
        square += w * q * q;
        for (std::size_t i = 0; derivatives && i < from.size(); ++i) {
            slope[from[i]] += w * q * part.gradient[i];
            for (std::size_t j = 0; j <= i && !out.hessian.empty(); ++j)
                out.hessian[pair_at(from[i], from[j])] +=
                    w * (part.gradient[i] * part.gradient[j] + q * part.hessian[pair_at(i, j)]);
        }
    }
    const double root = std::sqrt(square);
    out.value[0] = root;
    for (std::size_t i = 0; derivatives && i < n; ++i) {
        slope[i] /= root;
        if (!out.gradient.empty()) out.gradient[i] = slope[i];
        for (std::size_t j = 0; j <= i && !out.hessian.empty(); ++j) {
            double& entry = out.hessian[pair_at(i, j)];
            entry = (entry - slope[i] * slope[j]) / root;
        }
    }
}

/// Calls use(part, value) with each part measured again.
template <class Use>
void for_each_again(const Motion& motion, std::span<const Digits50> arguments, const Use& use) {
    const Together& all = together_of(motion);
    for (std::size_t p = 0; p < all.parts.size(); ++p) {
        std::vector<Digits50> own;
        for (const std::size_t i : all.arguments[p])
            own.push_back(arguments[i]);
        use(all.parts[p], all.parts[p].measure_again(motion_for(all.parts[p], motion), own));
    }
}

Digits50 greatest_again(const Motion& motion, std::span<const Digits50> arguments) {
    Digits50 greatest = 0;
    for_each_again(motion, arguments, [&](const Quantity&, const Digits50& value) {
        if (!(value <= greatest)) greatest = value;  // what is not a number stays
    });
    return greatest;
}

Digits50 root_mean_again(const Motion& motion, std::span<const Digits50> arguments) {
    Digits50 sum = 0, weights = 0;
    for_each_again(motion, arguments, [&](const Quantity& part, const Digits50& value) {
        sum += weight_of(part, motion) * value * value;
        weights += weight_of(part, motion);
    });
    return sqrt(Digits50(sum / weights));
}

/// Everything but how it is measured.
Quantity of_parts(std::string name, std::string meaning, std::vector<Quantity> parts) {
    Quantity whole;
    whole.name = std::move(name);
    whole.unit = parts.front().unit;
    whole.meaning = std::move(meaning);
    whole.section = parts.front().section;
    whole.defined = [](const Motion& motion) {
        const std::vector<Quantity>& all = together_of(motion).parts;
        return std::all_of(all.begin(), all.end(), [&](const Quantity& part) { return is_defined(part, motion); });
    };
    std::vector<std::size_t> reads;
    Together together{std::move(parts), {}};
    for (const Quantity& part : together.parts) {
        std::vector<std::size_t>& own = together.arguments.emplace_back();
        for (const std::size_t dimension : part.reads) {
            const auto known = std::find(reads.begin(), reads.end(), dimension);
            own.push_back(static_cast<std::size_t>(known - reads.begin()));
            if (known == reads.end()) reads.push_back(dimension);
        }
    }
    whole.reads = Reads(std::move(reads));
    whole.of = Model(std::move(together));
    return whole;
}

}  // namespace

Quantity greatest_together(std::string name, std::string meaning, std::vector<Quantity> parts) {
    Quantity whole = of_parts(std::move(name), std::move(meaning), std::move(parts));
    whole.reduce = Reduce::greatest;
    whole.components = count_of_greatest;
    whole.measure = measure_greatest;
    whole.measure_again = greatest_again;
    return whole;
}

Quantity root_mean_together(std::string name, std::string meaning, std::vector<Quantity> parts) {
    Quantity whole = of_parts(std::move(name), std::move(meaning), std::move(parts));
    whole.components = [](const Motion&) { return std::size_t{1}; };
    whole.measure = measure_root_mean;
    whole.measure_again = root_mean_again;
    return whole;
}

}  // namespace mechwright
