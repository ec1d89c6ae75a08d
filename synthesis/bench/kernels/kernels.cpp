#include <fmt/format.h>

#include "synthesis/bench/kernels/chapter.h"
#include "synthesis/bench/kernels/lanes.h"
#include "synthesis/bench/kernels/measured_kernel.h"
#include "synthesis/bench/kernels/screening.h"
#include "synthesis/bench/sections.h"

namespace mechwright::bench {

Row kernel_row(std::string_view order, std::string_view form, const KernelNumbers& n) {
    using kernel_detail::cell_of;
    constexpr double ns = 1e9;
    return {std::string(order),
            std::string(form),
            ns * n.timing.median,
            ns * n.timing.lower,
            ns * n.timing.upper,
            n.instructions ? Cell(*n.instructions) : Cell(),
            n.mix.all.sums_and_products,
            n.mix.all.quotients,
            n.mix.all.roots,
            n.mix.all.sines,
            n.mix.all.angles,
            cell_of(ns * n.least),
            n.instructions ? Cell(ns * n.instruction * static_cast<double>(*n.instructions)) : Cell(),
            cell_of(ns * n.chain),
            cell_of(n.usual_median),
            cell_of(n.usual_least),
            cell_of(n.hard_median),
            cell_of(n.hard_least)};
}

namespace {

template <class Kernel>
Measurement measurement() {
    return {std::string(Kernel::name), measured_kernel<Kernel>};
}

std::vector<Measurement> kernels_measurements(const Effort&) {
    return {measurement<CouplerPointKernel>(),         measurement<SliderCrankKernel>(),
            measurement<CrankShaperKernel>(),          measurement<RollerKernel>(),
            {std::string(lanes_name), measured_lanes}, {std::string(screening_name), measured_screening}};
}

}  // namespace

Section kernels() {
    return {"kernels",
            "Kernels: what each order of motion costs, and how many digits it keeps",
            {"kernel", "order", "form", "ns", "ns lower quartile", "ns upper quartile", "instructions",
             "sums and products", "quotients", "roots", "sines and cosines", "angles", "ns by operations",
             "ns by instructions", "ns of the longest chain", "digits usual median", "digits usual least",
             "digits hard median", "digits hard least"},
            kernels_measurements,
            kernel_chapter,
            kernel_diagrams};
}

}  // namespace mechwright::bench
