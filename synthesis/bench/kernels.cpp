#include "synthesis/bench/sections.h"

namespace mechwright::bench {

namespace {
std::vector<Measurement> measurements(const Effort&) { return {}; }
std::string told(const Sheet&) { return {}; }
std::vector<Diagram> drawn(const Sheet&) { return {}; }
}  // namespace

Section kernels() {
    return {"kernels", "Kernels: what each order of motion costs", {"kernel", "order"}, measurements, told, drawn};
}

}  // namespace mechwright::bench
