#include "synthesis/program/left_open.h"

namespace mechwright {

std::string why_not_analysable(const Problem& problem) {
    std::string open;
    const auto add = [&](std::string_view name) { open += (open.empty() ? "" : ", ") + std::string(name); };
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i)
        if (!problem.dimensions[i].fixed()) add(problem.mechanism->dimensions[i].name);
    if (problem.assemblies.size() > 1) add("assembly");
    if (open.empty() && problem.use && !problem.path->prescribed_timing)
        return "to be analysed over its range of use, a mechanism needs the crank angles at which its targets are met: "
               "timing = \"prescribed\" with crank_angles; 'mechwright solve' finds them";
    if (open.empty()) return open;
    return "to be analysed, a mechanism needs one value for each dimension; still open: " + open;
}

}  // namespace mechwright
