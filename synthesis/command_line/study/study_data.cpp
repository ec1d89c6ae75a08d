// study status, export and charts: what a study has come to.

#include <fmt/format.h>

#include <memory>

#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/study/study.h"
#include "synthesis/report/files/gnuplot.h"
#include "synthesis/report/files/write_file.h"
#include "synthesis/study/charts.h"
#include "synthesis/study/data.h"
#include "synthesis/study/folder.h"

namespace mechwright {

namespace {

struct DataOptions {
    std::string folder;
    bool csv = false;
    bool json = false;
    std::string query;
    std::optional<double> time_limit;
};

struct ChartOptions {
    std::string folder;
    std::string out;
    bool png = false;
};

/// How to run the chunks that are missing, with GNU parallel and with Slurm.
std::string lines_for(const std::vector<std::uint64_t>& missing, const std::string& folder) {
    std::string chunks;
    for (const std::uint64_t chunk : missing)
        chunks += fmt::format(" {}", chunk);
    const bool first_ones = missing.back() == missing.size();
    const std::string list = first_ones ? fmt::format("$(seq {})", missing.size()) : chunks.substr(1);
    return fmt::format(
        "With GNU parallel:\n"
        "  parallel mechwright study run {0} --jobs 1 --chunk {{}} ::: {1}\n"
        "With Slurm:\n"
        "  sbatch --array={2} --wrap 'mechwright study run {0} --jobs 1'\n"
        "Then:\n"
        "  mechwright study merge {0}\n",
        folder, list, as_ranges(missing));
}

int status(const DataOptions& options, Console& console) {
    const StudyPlanOrNot read = read_plan(options.folder);
    if (!read.fault.empty()) throw StoreFault(read.fault);
    const bool merged = std::filesystem::exists(data_file(options.folder));
    if (!read.plan || merged) {
        print(console, standing_text(data_file(options.folder)));
        return exit_code::solved;
    }
    const auto missing = missing_chunks(options.folder, *read.plan);
    std::string text = fmt::format("{} points in {} chunks, {} complete\n", read.plan->points, read.plan->chunks,
                                   read.plan->chunks - missing.size());
    if (missing.empty())
        text += fmt::format("Join them:\n  mechwright study merge {}\n", options.folder);
    else
        text += fmt::format("Missing: {}\n", as_ranges(missing)) + lines_for(missing, options.folder);
    print(console, text);
    return exit_code::solved;
}

int export_all(const DataOptions& options, Console& console) {
    const std::filesystem::path data = data_file(options.folder);
    const StudyStanding standing = standing_of_study(data);
    if (standing.done < standing.points)
        console.err << fmt::format("the study is not complete: {} of {} points", standing.done, standing.points)
                    << std::endl;
    try {
        StudyQuery query{options.query};
        query.time_limit = options.time_limit.value_or(query.time_limit);
        const bool whole =
            export_data(data, query, options.json ? DataFormat::json : DataFormat::csv, [&](std::string_view text) {
                print(console, text);
                return console.out_error == 0;
            });
        if (!whole) {
            complain(console, fmt::format("--sql: stopped after {:g} s; --time-limit gives it more", query.time_limit));
            return exit_code::limit;
        }
    } catch (const SqlFault& fault) {
        complain(console, fmt::format("--sql: {}; the table is called points, and names with dots and hyphens stand in "
                                      "double quotes",
                                      fault.what()));
        return exit_code::wrong_usage;
    }
    return exit_code::solved;
}

/// Writes a picture and the script that it was drawn from; what was written is added to `names`.
void draw(const ChartScript& chart, const std::filesystem::path& folder, bool png, std::vector<std::string>& names) {
    const auto write = [&](const std::string& name, std::string_view bytes) {
        if (const auto fault = write_atomically(folder / name, bytes)) throw StoreFault(*fault);
        names.push_back(name);
    };
    const std::string script = chart.name + ".gnuplot";
    write(script, chart.script);
    write(chart.name + ".svg", gnuplot_picture(chart.script, {}));
    if (png) write(chart.name + ".png", gnuplot_picture(chart.script, {.format = Picture::Format::png}));
}

int charts(const ChartOptions& options, Console& console) {
    const std::filesystem::path data = data_file(options.folder);
    const Problem problem = parse_problem(problem_text(data), "study.toml").problem;
    const std::filesystem::path folder =
        options.out.empty() ? std::filesystem::path(options.folder) / "charts" : std::filesystem::path(options.out);
    if (problem.mechanism == nullptr || !problem.study) throw StoreFault(data.string() + ": holds no study");
    if (const auto fault = prepare_folder(folder)) throw StoreFault(*fault);
    std::vector<std::string> names;
    int code = exit_code::solved;
    for (const StudyChart& chart : charts_of(problem)) {
        try {
            for (const ChartScript& script : chart_scripts(data, problem, chart))
                draw(script, folder, options.png, names);
        } catch (const ChartFault& fault) {
            complain(console, fault.what());
            code = exit_code::no_access;
        }
    }
    for (const std::string& name : names)
        print(console, (folder / name).string() + "\n");
    return code;
}

}  // namespace

std::vector<Command> add_study_data(CLI::App& study) {
    const auto looking = std::make_shared<DataOptions>();
    CLI::App* looked = study.add_subcommand("status", "How far a study is, and how to run what is missing");
    looked->add_option("DIR", looking->folder, "Folder of the study")->required()->option_text(" ");

    const auto exporting = std::make_shared<DataOptions>();
    CLI::App* exported = study.add_subcommand("export", "Print the data of a study");
    exported->add_option("DIR", exporting->folder, "Folder of the study")->required()->option_text(" ");
    CLI::Option* csv = exported->add_flag("--csv", exporting->csv, "As comma-separated values (the default)");
    exported->add_flag("--json", exporting->json, "As a list of JSON objects")->excludes(csv);
    exported->add_option("--sql", exporting->query, "What this query gives, and not all points")
        ->type_name("QUERY")
        ->check(not_empty);
    add_positive_number(*exported, "--time-limit", exporting->time_limit, "Seconds for the query (60)");

    const auto drawing = std::make_shared<ChartOptions>();
    CLI::App* pictured = study.add_subcommand("charts", "Draw the charts of a study (with gnuplot)");
    pictured->add_option("DIR", drawing->folder, "Folder of the study")->required()->option_text(" ");
    pictured->add_option("--out", drawing->out, "Folder for the pictures (DIR/charts)")
        ->type_name("DIR")
        ->check(not_empty);
    pictured->add_flag("--png", drawing->png, "As PNG too, beside SVG");

    const auto run = [](auto work, auto options) {
        return [work, options](Console& console) { return guarded(console, [&] { return work(*options, console); }); };
    };
    return {{looked, run(status, looking)}, {exported, run(export_all, exporting)}, {pictured, run(charts, drawing)}};
}

}  // namespace mechwright
