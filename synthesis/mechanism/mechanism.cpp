#include "synthesis/mechanism/mechanism.h"

#include <algorithm>
#include <numeric>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/four_bar/four_bar.h"
#include "synthesis/mechanism/quick_return/quick_return.h"

namespace mechwright {

std::span<const Mechanism* const> mechanisms() {
    static const std::vector<const Mechanism*> all = [] {
        std::vector<const Mechanism*> list{&four_bar_mechanism(), &slider_crank_mechanism(), &crank_shaper_mechanism(),
                                           &whitworth_mechanism(), &drag_link_mechanism()};
        const auto cams = cam_mechanisms();
        list.insert(list.end(), cams.begin(), cams.end());
        return list;
    }();
    return all;
}

const Mechanism* find_mechanism(std::string_view name) {
    const auto all = mechanisms();
    const auto at = std::find_if(all.begin(), all.end(), [&](const Mechanism* m) { return m->name == name; });
    return at == all.end() ? nullptr : *at;
}

namespace {

template <class Named>
int find_by_name(std::span<const Named> all, std::string_view name) {
    const auto at = std::find_if(all.begin(), all.end(), [&](const Named& x) { return x.name == name; });
    return at == all.end() ? -1 : static_cast<int>(at - all.begin());
}

/// Levenshtein's distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row[b.size()];
}

}  // namespace

int find_dimension(const Mechanism& mechanism, std::string_view name) {
    return find_by_name(mechanism.dimensions, name);
}

int find_quantity(const Mechanism& mechanism, std::string_view name) {
    return find_by_name(mechanism.quantities, name);
}

const Quantity& deviation_from(const Mechanism& mechanism, std::string_view section) {
    return *std::find_if(mechanism.quantities.begin(), mechanism.quantities.end(),
                         [&](const Quantity& q) { return q.section == section && q.reduce == Reduce::greatest; });
}

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates) {
    constexpr std::size_t longest_name = 64;  // names longer than any of ours are not misspelt ones
    if (name.size() > longest_name) return {};
    std::string_view best;
    std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
    for (const std::string_view candidate : candidates) {
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < least) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

}  // namespace mechwright
