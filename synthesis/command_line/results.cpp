#include "synthesis/command_line/results.h"

#include <algorithm>
#include <filesystem>

#include "synthesis/report/files/write_file.h"

namespace mechwright {

namespace fs = std::filesystem;

std::vector<std::string> result_names(const std::vector<std::string>& files) {
    std::vector<std::string> stems;
    for (const std::string& file : files)
        stems.push_back(fs::path(file).stem().string());
    std::vector<std::string> names;
    const auto taken = [&](const std::vector<std::string>& list, const std::string& name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    for (const std::string& stem : stems) {
        std::string name = stem;
        for (int i = 2; taken(names, name) || (name != stem && taken(stems, name)); ++i)
            name = stem + "-" + std::to_string(i);
        names.push_back(name);
    }
    return names;
}

std::optional<std::string> prepare_results(const std::string& folder, const std::vector<std::string>& names,
                                           const std::vector<std::string>& table_endings) {
    if (auto fault = prepare_folder(folder)) return fault;
    std::vector<std::string> endings{".json"};
    endings.insert(endings.end(), table_endings.begin(), table_endings.end());
    for (const std::string& name : names)
        for (const std::string& ending : endings) {
            const fs::path path = fs::path(folder) / (name + ending);
            std::error_code ignored;
            if (fs::is_directory(path, ignored)) return "cannot write '" + path.string() + "': it is a folder";
        }
    return std::nullopt;
}

std::optional<std::string> write_result(const std::string& folder, const std::string& name, const ResultText& text) {
    const fs::path path = fs::path(folder) / name;
    if (auto fault = write_atomically(path.string() + ".json", text.document)) return fault;
    for (const ResultTable& table : text.tables)
        if (auto fault = write_atomically(path.string() + table.ending, table.text)) return fault;
    return std::nullopt;
}

}  // namespace mechwright
