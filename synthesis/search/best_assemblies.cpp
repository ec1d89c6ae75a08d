#include "synthesis/search/best_assemblies.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace mechwright {

bool has_many_assemblies(const std::vector<Program>& programs, std::size_t most) {
    std::set<std::size_t> assemblies;
    for (const Program& program : programs)
        assemblies.insert(program.variant.assembly);
    return assemblies.size() > most;
}

std::vector<std::size_t> in_best_assemblies(const std::vector<Program>& programs, std::vector<AssemblyMerit> merits,
                                            std::size_t most) {
    std::vector<std::size_t> chosen(programs.size());
    std::iota(chosen.begin(), chosen.end(), 0);
    if (merits.empty() || !has_many_assemblies(programs, most)) return chosen;
    std::stable_sort(merits.begin(), merits.end(),
                     [](const AssemblyMerit& a, const AssemblyMerit& b) { return a.merit < b.merit; });
    std::set<std::size_t> kept;
    for (const AssemblyMerit& one : merits)
        if (kept.size() < most) kept.insert(one.assembly);
    std::erase_if(chosen, [&](std::size_t i) { return !kept.contains(programs[i].variant.assembly); });
    return chosen;
}

}  // namespace mechwright
