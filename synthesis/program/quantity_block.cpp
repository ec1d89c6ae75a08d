#include "synthesis/program/quantity_block.h"

#include <span>

#include "synthesis/target/path/rows/stretch.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

void set_arguments(const Program& program, const QuantityBlock& block, std::span<const double> dimensions,
                   const VectorXd& x, BlockArguments& arguments) {
    const Reads& reads = block.quantity->reads;
    // In place of an input range that has numbers of its own the stretch is given, which holds it.
    const bool has_numbers = block.along_stretch && program.problem->mechanism->input->start != no_dimension;
    for (std::size_t i = 0; i < reads.size() - (has_numbers ? 2 : 0); ++i)
        add_dimension(program, dimensions, reads[i], arguments);
    if (block.along_stretch) add_stretch(program, dimensions, x, arguments);
}

}  // namespace

void add_dimension(const Program& program, std::span<const double> dimensions, std::size_t dimension,
                   BlockArguments& arguments) {
    const std::size_t i = arguments.count++;
    arguments.value[i] = dimensions[dimension];
    arguments.source[i] = program.follows[dimension];
}

bool evaluate_block(const Program& program, const QuantityBlock& block, const VectorXd& x, bool derivatives,
                    Outputs& out) {
    BlockArguments arguments;
    set_arguments(program, block, out.dimensions, x, arguments);
    const std::size_t n = arguments.count;
    std::array<double, Quantity::most_components> value;
    std::array<double, Quantity::most_components * Reads::most> gradient;
    Measurement measurement{value, {}, {}};
    if (derivatives) measurement.gradient = gradient;
    block.quantity->measure(block.motion, std::span(arguments.value).first(n), measurement);
    const auto first = static_cast<Index>(block.first), count = static_cast<Index>(block.count);
    for (std::size_t k = 0; k < block.count; ++k)
        out.value[first + static_cast<Index>(k)] = value[k];
    for (std::size_t i = 0; derivatives && i < n; ++i)
        for (const LinearTerm& term : arguments.source[i]) {
            double* column = &out.jacobian(first, static_cast<Index>(term.index));
            for (std::size_t k = 0; k < block.count; ++k)
                column[k] += term.factor * gradient[k * n + i];
        }
    return out.value.segment(first, count).allFinite() &&
           (!derivatives || out.jacobian.middleRows(first, count).allFinite());
}

void add_block_hessian(const Program& program, const QuantityBlock& block, const VectorXd& x, LagrangianHessian& out) {
    BlockArguments arguments;
    set_arguments(program, block, out.dimensions, x, arguments);
    const std::size_t n = arguments.count, pairs = n * (n + 1) / 2, count = block.count;
    out.components.resize(count * (1 + n + pairs));
    const std::span<double> all = out.components;
    const std::span<double> second = all.subspan(count * (1 + n));
    block.quantity->measure(block.motion, std::span(arguments.value).first(n),
                            {all.first(count), all.subspan(count, count * n), second});
    for (std::size_t k = 0; k < count; ++k) {
        const double w = out.weights[static_cast<Index>(block.first + k)];
        if (w == 0) continue;
        for (std::size_t i = 0, at = k * pairs; i < n; ++i)
            for (std::size_t j = 0; j <= i; ++j, ++at)
                for (const LinearTerm& a : arguments.source[i])
                    for (const LinearTerm& b : arguments.source[j]) {
                        const double part = w * a.factor * b.factor * second[at];
                        out.value(static_cast<Index>(a.index), static_cast<Index>(b.index)) += part;
                        if (i != j) out.value(static_cast<Index>(b.index), static_cast<Index>(a.index)) += part;
                    }
    }
}

}  // namespace mechwright
