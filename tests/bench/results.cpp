// What results/ says that does not depend on the machine, measured again: the answers to problems that are quick to
// solve, and the counts and errors of measurements that take no time.

#include <gtest/gtest.h>

#include <cmath>

#include "synthesis/bench/record.h"
#include "synthesis/bench/sections.h"
#include "tests/long_form.h"

namespace mechwright::bench {
namespace {

Effort thorough() {
    Effort effort;
    effort.full = true;
    effort.problems = MECHWRIGHT_SOURCE_DIR "/problems";
    return effort;
}

const Record& kept() {
    static const Record record = read_record(MECHWRIGHT_SOURCE_DIR "/results/bench/measured.json").value();
    return record;
}

/// What is kept of one measurement, and the same measured now.
struct Twice {
    Sheet kept;
    Sheet now;

    void expect_same_text(std::string_view column) const {
        for (std::size_t i = 0; i < kept.rows.size(); ++i)
            EXPECT_EQ(kept.cell(kept.rows[i], column), now.cell(now.rows[i], column)) << where(i) << column;
    }

    void expect_same_number(std::string_view column, double within) const {
        for (std::size_t i = 0; i < kept.rows.size(); ++i) {
            const double before = kept.number(kept.rows[i], column), after = now.number(now.rows[i], column);
            EXPECT_EQ(std::isnan(before), std::isnan(after)) << where(i) << column;
            if (std::isnan(before)) continue;
            EXPECT_NEAR(after, before, within * (1 + std::abs(before))) << where(i) << column;
        }
    }

    std::string where(std::size_t row) const {
        return kept.rows[row][0].get<std::string>() + ", row " + std::to_string(row) + ", ";
    }
};

double seconds_of(const Sheet& sheet) {
    double sum = 0;
    for (const Row& row : sheet.rows)
        if (const double seconds = sheet.number(row, "seconds"); seconds > 0) sum += seconds;
    return sum;
}

/// Every so manieth of the measurements that took less than so many seconds.
std::vector<Twice> measured_again(const Section& section, double seconds, int every) {
    const Effort effort = thorough();
    std::vector<Twice> all;
    int quick = 0;
    for (const Measurement& measurement : section.measurements(effort)) {
        const Sheet before = sheet_of(kept(), section, {measurement});
        if (before.rows.empty() || seconds_of(before) > seconds || quick++ % every != 0) continue;
        Record again;
        again.sections[std::string(section.name)].emplace_back(measurement.name, measurement.measure(effort));
        all.push_back({before, sheet_of(again, section, {measurement})});
        EXPECT_EQ(all.back().kept.rows.size(), all.back().now.rows.size()) << measurement.name;
        if (all.back().kept.rows.size() != all.back().now.rows.size()) all.pop_back();
    }
    EXPECT_FALSE(all.empty());
    return all;
}

TEST(Results, AreTheAnswersOfTheProgram) {
    for (const Twice& twice : measured_again(agreement(), 0.2, cases_to_try(5, 1))) {
        for (const std::string_view column : {"method", "answer", "status", "verified", "proved"})
            twice.expect_same_text(column);
        twice.expect_same_number("value", 1e-9);
    }
}

TEST(Results, HaveTheCountsOfTheProgram) {
    for (const Twice& twice : measured_again(exact(), cases_to_try(1, 4), cases_to_try(8, 1)))
        for (const std::string_view column : {"piece", "way", "tolerance", "solutions", "distinct"})
            twice.expect_same_text(column);
}

}  // namespace
}  // namespace mechwright::bench
