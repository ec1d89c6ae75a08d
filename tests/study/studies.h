#pragma once
/// \file
/// Runs studies inside a test.

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "synthesis/study/data.h"
#include "synthesis/study/folder.h"
#include "synthesis/study/run.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {

inline PreparedStudy prepared(const std::string& file) {
    PreparedOrNot outcome = prepare_study(file);
    for (const Message& message : outcome.messages)
        ADD_FAILURE() << to_string(message);
    return std::move(outcome.prepared);
}

/// What all points of a study came to, as JSON.
inline nlohmann::ordered_json rows_of(const std::filesystem::path& data, const std::string& query = "") {
    std::string text;
    export_data(data, {query}, DataFormat::json, [&](std::string_view part) {
        text += part;
        return true;
    });
    return nlohmann::ordered_json::parse(text);
}

/// Runs a study from its file to its end, and gives its rows.
inline nlohmann::ordered_json run_to_end(const std::string& file, const std::filesystem::path& data, int jobs = 2) {
    const PreparedStudy study = prepared(file);
    StudyStore store(data, study, false);
    StudyRunOptions options;
    options.jobs = jobs;
    const StudyRun run = run_study(study, store, options);
    EXPECT_TRUE(run.complete) << run.fault;
    store.close();
    return rows_of(data);
}

/// A shipped study.
inline std::string shipped(const std::string& name) {
    return std::string(MECHWRIGHT_SOURCE_DIR) + "/problems/studies/" + name + ".toml";
}

/// The text of a file with one piece in the place of another.
inline std::string changed(const std::string& file, const std::vector<std::pair<std::string, std::string>>& changes) {
    std::string text = content_of(file);
    for (const auto& [from, to] : changes) {
        const std::size_t at = text.find(from);
        if (at == std::string::npos)
            ADD_FAILURE() << "no '" << from << "' in " << file;
        else
            text.replace(at, from.size(), to);
    }
    return text;
}

}  // namespace mechwright::testing
