#include "synthesis/study/folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>
#include <system_error>

#include "synthesis/document/versions.h"
#include "synthesis/problem/bytes.h"
#include "synthesis/report/files/write_file.h"
#include "synthesis/report/json_text.h"
#include "synthesis/study/points.h"

namespace mechwright {

namespace {

std::filesystem::path plan_file(const std::filesystem::path& folder) { return folder / "plan.json"; }

/// Copies a file that the problem file names to the same place below the folder.
std::optional<std::string> copy_named(const std::filesystem::path& from, const std::filesystem::path& folder,
                                      const std::string& name) {
    const std::filesystem::path relative = std::filesystem::path(name).lexically_normal();
    if (relative.is_absolute()) return {};  // the same on all machines, or nowhere
    if (relative.begin() != relative.end() && *relative.begin() == "..")
        return fmt::format(
            "'{}' lies outside the folder of the problem file: put it beside the problem file, so that "
            "the plan can take it along",
            name);
    const reading::Bytes read = reading::read_bytes((from / relative).string(), most_bytes_of_a_study, false);
    if (!read.failure.empty()) return fmt::format("'{}': {}", name, read.failure);
    if (relative.has_parent_path())
        if (auto fault = prepare_folder(folder / relative.parent_path())) return fault;
    return write_atomically(folder / relative, read.bytes);
}

}  // namespace

std::filesystem::path data_file(const std::filesystem::path& folder) { return folder / "study.sqlite"; }

std::filesystem::path planned_problem(const std::filesystem::path& folder) { return folder / "study.toml"; }

FolderLock::FolderLock(const std::filesystem::path& folder)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (folder_ < 0)
        fault_ = fmt::format("cannot open '{}': {}", folder.string(), std::generic_category().message(errno));
    else if (::flock(folder_, LOCK_EX | LOCK_NB) != 0)
        fault_ = fmt::format(
            "another process is running the study in '{}'; let it finish, or share the work with "
            "'mechwright study plan'",
            folder.string());
}

FolderLock::~FolderLock() {
    if (folder_ >= 0) ::close(folder_);
}

StudyPlanOrNot read_plan(const std::filesystem::path& folder) {
    if (!std::filesystem::exists(plan_file(folder))) return {};
    const reading::Bytes read = reading::read_bytes(plan_file(folder).string(), most_bytes_of_a_study, false);
    if (!read.failure.empty()) return {{}, plan_file(folder).string() + ": " + read.failure};
    try {
        const auto json = nlohmann::json::parse(read.bytes);
        StudyPlan plan{json.at("fingerprint"), json.at("points"), json.at("strands"), json.at("chunks")};
        if (plan.chunks >= 1 && plan.strands >= plan.chunks) return {plan, {}};
    } catch (const nlohmann::json::exception&) {
    }
    return {{}, plan_file(folder).string() + ": is damaged; plan the study again into a new folder"};
}

std::optional<std::string> write_plan(const std::filesystem::path& folder, const PreparedStudy& prepared,
                                      const StudyPlan& plan) {
    if (auto fault = prepare_folder(folder)) return fault;
    const std::filesystem::path from = std::filesystem::path(prepared.file).parent_path();
    for (const std::string& name : prepared.named_files)
        if (auto fault = copy_named(from, folder, name)) return fault;
    if (auto fault = write_atomically(planned_problem(folder), prepared.text)) return fault;
    nlohmann::ordered_json json{{"schema", 1},
                                {"title", prepared.base.title},
                                {"version", program_version()},
                                {"fingerprint", plan.fingerprint},
                                {"points", plan.points},
                                {"strands", plan.strands},
                                {"chunks", plan.chunks}};
    return write_atomically(plan_file(folder), json_text(json));
}

std::pair<std::uint64_t, std::uint64_t> strands_of_chunk(const StudyPlan& plan, std::uint64_t chunk) {
    return {plan.strands * (chunk - 1) / plan.chunks, plan.strands * chunk / plan.chunks};
}

std::filesystem::path part_file(const std::filesystem::path& folder, std::uint64_t chunk) {
    return folder / fmt::format("part-{:05}.sqlite", chunk);
}

std::filesystem::path partial_file(const std::filesystem::path& folder, std::uint64_t chunk) {
    return folder / fmt::format("part-{:05}.partial", chunk);
}

std::vector<std::uint64_t> missing_chunks(const std::filesystem::path& folder, const StudyPlan& plan) {
    std::vector<std::uint64_t> missing;
    for (std::uint64_t chunk = 1; chunk <= plan.chunks; ++chunk)
        if (!std::filesystem::exists(part_file(folder, chunk))) missing.push_back(chunk);
    return missing;
}

std::string as_ranges(const std::vector<std::uint64_t>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i;
        while (end + 1 < numbers.size() && numbers[end + 1] == numbers[end] + 1)
            ++end;
        text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[i]);
        if (end > i) text += fmt::format("-{}", numbers[end]);
        i = end + 1;
    }
    return text;
}

}  // namespace mechwright
