#include "synthesis/problem/schema/keys.h"

#include <algorithm>
#include <deque>
#include <map>
#include <mutex>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright::keys {

namespace {

struct FileKeys {
    std::vector<Key> all{file.begin(), file.end()};
    std::deque<std::vector<Key>> settings;  ///< of the sections after those

    FileKeys() {
        for (const auto& mechanism : mechanisms())
            for (const Setting& setting : mechanism->settings)
                add(setting);
        for (std::size_t i = 0; i < settings.size(); ++i)
            all[file.size() + i].below = settings[i];
    }

    void add(const Setting& setting) {
        auto at = std::find_if(all.begin(), all.end(), [&](const Key& key) { return key.name == setting.section; });
        if (at == all.end()) {
            at = all.insert(all.end(), {setting.section, Shape::table, "How the mechanism is judged."});
            settings.emplace_back();
        }
        std::vector<Key>& keys = settings[static_cast<std::size_t>(at - all.begin()) - file.size()];
        if (find_key(keys, setting.name) == nullptr)
            keys.push_back({setting.name, Shape::number, setting.meaning, false, {}, {}, limits_of(setting)});
    }

    static Limits limits_of(const Setting& setting) {
        return {.least = setting.above, .most = setting.below, .above = !setting.or_above, .below = true};
    }
};

}  // namespace

std::span<const Key> of_file() {
    // Mechanisms are added, never taken away: lists of fewer stay as they are for whoever reads them.
    static std::mutex guard;
    static std::map<std::size_t, const FileKeys> by_number;
    const std::lock_guard lock(guard);
    return by_number.try_emplace(mechanisms().size()).first->second.all;
}

}  // namespace mechwright::keys
