#include "synthesis/problem/toml/in_order.h"

#include <algorithm>

#include "synthesis/problem/messages.h"

namespace mechwright::reading {

std::vector<std::pair<std::string_view, const toml::node*>> in_order(const toml::table& table) {
    struct KeyAt {
        FilePlace place;
        std::string_view key;
        const toml::node* node;
    };
    std::vector<KeyAt> entries;
    for (const auto& [key, node] : table)
        entries.push_back({{static_cast<int>(key.source().begin.line), static_cast<int>(key.source().begin.column)},
                           key.str(),
                           &node});
    std::stable_sort(entries.begin(), entries.end(), [](const KeyAt& a, const KeyAt& b) { return a.place < b.place; });
    std::vector<std::pair<std::string_view, const toml::node*>> ordered;
    for (const KeyAt& entry : entries)
        ordered.emplace_back(entry.key, entry.node);
    return ordered;
}

}  // namespace mechwright::reading
