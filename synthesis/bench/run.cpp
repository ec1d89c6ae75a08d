#include "synthesis/bench/run.h"

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/bench/pages/readme.h"
#include "synthesis/bench/record.h"
#include "synthesis/report/csv/csv_text.h"
#include "synthesis/report/files/gnuplot.h"
#include "synthesis/report/files/write_file.h"

namespace mechwright::bench {

namespace {

struct Planned {
    const Section* section;
    std::vector<Measurement> measurements;
};

bool chosen(const Section& section, const std::vector<std::string>& only) {
    return only.empty() || std::find(only.begin(), only.end(), section.name) != only.end();
}

std::vector<Planned> plan(const Effort& effort) {
    std::vector<Planned> all;
    for (const Section& section : sections())
        all.push_back({&section, section.measurements(effort)});
    return all;
}

std::string csv_of(const Cell& cell) {
    if (cell.is_null()) return {};
    if (cell.is_string()) return csv_field(cell.get<std::string>());
    return cell.is_number_float() ? csv_number(cell.get<double>()) : cell.dump();
}

std::string csv_of(const Sheet& sheet) {
    std::string text;
    for (std::size_t i = 0; i < sheet.columns.size(); ++i)
        text += (i > 0 ? "," : "") + csv_field(sheet.columns[i]);
    for (const Row& row : sheet.rows) {
        text += '\n';
        for (std::size_t i = 0; i < row.size(); ++i)
            text += (i > 0 ? "," : "") + csv_of(row[i]);
    }
    return text + '\n';
}

/// The record to go on with: what the folder has of the same program, machine and effort. What it has of others is only
/// replaced where that is asked for; else the fault is said.
Record begun(const BenchRun& run, const std::filesystem::path& file, const std::vector<Planned>& planned,
             std::string& fault) {
    Record fresh{surroundings(run.effort.full), {}};
    auto kept = read_record(file);
    if (!kept) return fresh;
    if (kept->surroundings != fresh.surroundings) {
        if (!run.anew)
            fault = fmt::format(
                "{} holds measurements of another run ({}, {}, {}): name another --out, or replace them "
                "by --anew",
                file.string(), kept->surroundings.program, kept->surroundings.processor,
                kept->surroundings.full ? "full" : "quick");
        return fresh;
    }
    if (run.anew)
        for (const Planned& p : planned)
            if (chosen(*p.section, run.only)) kept->sections.erase(std::string(p.section->name));
    return *std::move(kept);
}

/// Measures what is missing; what went wrong, or nothing.
std::string measure(const BenchRun& run, const std::vector<Planned>& planned, const std::filesystem::path& file,
                    Record& record, int& done) {
    int total = 0;
    for (const Planned& p : planned)
        if (chosen(*p.section, run.only)) total += static_cast<int>(p.measurements.size());
    for (const Planned& p : planned) {
        if (!chosen(*p.section, run.only)) continue;
        for (const Measurement& measurement : p.measurements) {
            if (run.effort.stopped()) return {};
            const int before = done++;
            if (record.has(p.section->name, measurement.name)) continue;
            if (run.progress) run.progress(p.section->name, measurement.name, before, total);
            std::vector<Row> rows = measurement.measure(run.effort);
            if (run.effort.stopped()) return {};
            record.sections[std::string(p.section->name)].emplace_back(measurement.name, std::move(rows));
            if (const auto fault = write_record(file, record)) return *fault;
        }
    }
    return {};
}

/// The tables, the diagrams and the report of all that is in the record.
std::optional<std::string> write_report(const std::filesystem::path& folder, const std::vector<Planned>& planned,
                                        const Record& record) {
    std::vector<Chapter> chapters;
    for (const Planned& p : planned) {
        const Sheet sheet = sheet_of(record, *p.section, p.measurements);
        if (sheet.rows.empty()) continue;
        const std::string name(p.section->name);
        if (const auto fault = write_atomically(folder / "bench" / (name + ".csv"), csv_of(sheet))) return fault;
        Chapter chapter{p.section, p.section->chapter(sheet), {}};
        for (const Diagram& diagram : p.section->diagrams(sheet)) {
            const std::string picture =
                gnuplot_picture(gnuplot_script(diagram), {Picture::Format::svg, 800, 420, true});
            if (const auto fault = write_atomically(folder / "bench" / (diagram.name + ".svg"), picture)) return fault;
            chapter.diagrams.push_back({diagram.name, diagram.title});
        }
        chapters.push_back(std::move(chapter));
    }
    return write_atomically(folder / "README.md", readme(record.surroundings, chapters, folder));
}

int taken_over(const Record& record, const std::vector<Planned>& planned, const BenchRun& run) {
    int count = 0;
    for (const Planned& p : planned)
        if (chosen(*p.section, run.only))
            for (const Measurement& measurement : p.measurements)
                count += record.has(p.section->name, measurement.name);
    return count;
}

}  // namespace

BenchOutcome run_bench(const BenchRun& run) {
    const std::filesystem::path data = run.folder / "bench";
    if (const auto fault = prepare_folder(data)) return {*fault, false, 0};
    const std::filesystem::path file = data / "measured.json";
    const std::vector<Planned> planned = plan(run.effort);
    BenchOutcome outcome;
    Record record = begun(run, file, planned, outcome.fault);
    if (!outcome.fault.empty()) return outcome;
    outcome.taken_over = taken_over(record, planned, run);
    int done = 0;
    outcome.fault = measure(run, planned, file, record, done);
    if (!outcome.fault.empty() || run.effort.stopped()) return outcome;
    if (const auto fault = write_report(run.folder, planned, record)) outcome.fault = *fault;
    outcome.finished = outcome.fault.empty();
    return outcome;
}

}  // namespace mechwright::bench
