// report: results as a page for a browser.

#include "synthesis/command_line/commands/report.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/study/study.h"
#include "synthesis/document/result_file.h"
#include "synthesis/report/files/gnuplot.h"
#include "synthesis/report/files/write_file.h"
#include "synthesis/study/folder.h"
#include "synthesis/study/study_page.h"

namespace mechwright {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct ReportOptions {
    std::string place;
    std::string out;
    bool quiet = false;
    std::optional<std::uint64_t> designs;
};

/// Reads a file with a result or a list of them; what is wrong is reported and becomes a line of the page.
int take_file(const std::string& file, Console& console, NamedDocuments& results, std::vector<ResultLine>& faults) {
    auto [json, fault, unreadable] = read_result_file(file);
    const Json list = json.is_array() ? std::move(json) : Json::array({std::move(json)});
    for (std::size_t i = 0; fault.empty() && i < list.size(); ++i) {
        const std::string why = why_not_a_result(list[i]);
        if (!why.empty())
            fault = "not a result document: " + why;
        else
            results.emplace_back(list.size() == 1 ? file : fmt::format("{} ({} of {})", file, i + 1, list.size()),
                                 list[i]);
    }
    if (fault.empty()) return exit_code::solved;
    complain(console, file + ": " + fault);
    faults.push_back({file, "", fault});
    return unreadable ? exit_code::no_access : exit_code::invalid_file;
}

std::vector<std::string> files_in(const fs::path& folder) {
    std::vector<std::string> files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (entry.path().extension() == ".json" && !entry.is_directory(error)) files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

std::string place_for_page(const ReportOptions& options, const fs::path& folder) {
    return options.out.empty() ? (folder / "report.html").string() : options.out;
}

int report_results(const ReportOptions& options, const fs::path& folder, const std::vector<std::string>& files,
                   Console& console) {
    NamedDocuments results;
    std::vector<ResultLine> faults;
    int code = exit_code::solved;
    for (const std::string& file : files)
        code = exit_code::worse(code, take_file(file, console, results, faults));
    if (results.empty()) {
        if (faults.empty())
            complain(console,
                     options.place + ": holds no result (*.json), and no study; solve --out DIR writes results");
        return exit_code::worse(code, exit_code::invalid_file);
    }
    Page page = page_on_results(results);
    page.lines.insert(page.lines.end(), faults.begin(), faults.end());
    return exit_code::worse(code, write_page(std::move(page), place_for_page(options, folder), options.quiet, console));
}

int report_study(const ReportOptions& options, Console& console) {
    return guarded(console, [&] {
        constexpr std::uint64_t default_designs = 400;
        const fs::path data = data_file(options.place);
        try {
            return write_page(study_page(data, options.designs.value_or(default_designs)),
                              place_for_page(options, options.place), options.quiet, console);
        } catch (const ChartFault& fault) {
            complain(console, fault.what());
        } catch (const fs::filesystem_error& fault) {
            complain(console, fault.what());
        }
        return exit_code::no_access;
    });
}

int report(const ReportOptions& options, Console& console) {
    const fs::path place = options.place;
    std::error_code error;
    const fs::file_status status = fs::status(place, error);
    if (!fs::exists(status)) {
        complain(console, options.place + ": there is no such file or folder");
        return exit_code::no_access;
    }
    if (!fs::is_directory(status)) return report_results(options, place.parent_path(), {options.place}, console);
    if (fs::exists(data_file(place), error)) return report_study(options, console);
    return report_results(options, place, files_in(place), console);
}

}  // namespace

NamedDocuments other_results(const fs::path& folder, const std::vector<std::string>& but) {
    NamedDocuments results;
    for (const std::string& file : files_in(folder)) {
        if (std::find(but.begin(), but.end(), fs::path(file).stem().string()) != but.end()) continue;
        ReadJson read = read_result_file(file);
        if (read.fault.empty() && why_not_a_result(read.json).empty()) results.emplace_back(file, std::move(read.json));
    }
    return results;
}

namespace {

/// A file as somebody finds it who has the page: the folder that has both may be anywhere.
std::string from_page(const std::string& file, const std::string& page) {
    std::error_code error;
    if (!fs::exists(file, error)) return file;
    const fs::path near = fs::proximate(file, fs::absolute(page, error).parent_path(), error);
    return error || near.empty() ? file : near.generic_string();
}

}  // namespace

int write_page(Page page, const std::string& out, bool quiet, Console& console) {
    for (ResultToShow& result : page.results)
        result.file = from_page(result.file, out);
    for (ResultLine& line : page.lines)
        if (!line.title.empty() || !line.standing.empty()) line.file = from_page(line.file, out);
    std::string text;
    try {
        text = page_text(page);
    } catch (const ChartFault& fault) {
        complain(console, std::string(fault.what()) + "; the page has no plots for browsers without scripts");
        page.static_plots = false;
        text = page_text(page);
    }
    if (const auto fault = write_atomically(out, text)) {
        complain(console, *fault);
        return exit_code::no_access;
    }
    if (!quiet) console.err << "wrote " << out << std::endl;
    return exit_code::solved;
}

Command add_report(CLI::App& program) {
    const auto options = std::make_shared<ReportOptions>();
    CLI::App* command = program.add_subcommand("report", "Make one page of results, for a browser");
    command->add_option("DIR", options->place, "Folder of results or of a study, or one result")
        ->required()
        ->option_text(" ");
    command->add_option("--out", options->out, "Page to write (report.html beside the results)")
        ->type_name("FILE")
        ->check(not_empty);
    add_whole_number(*command, "--designs", options->designs, 1, 100'000, "Of a study: designs in the page (400)");
    command->add_flag("--quiet", options->quiet, "Nothing but errors on standard error");
    return {command, [options](Console& console) { return report(*options, console); }};
}

}  // namespace mechwright
