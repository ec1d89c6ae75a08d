#pragma once
/// \file
/// What `mechwright bench` measures: sections, each of which fills one table, has one chapter in
/// results/README.md with its diagrams. Both come from the table alone.

#include <atomic>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/bench/pages/diagram.h"

namespace mechwright::bench {

/// How much is measured, and with what.
struct Effort {
    bool full = false;  ///< else a look of two minutes at everything
    int jobs = 1;
    std::filesystem::path problems;           ///< the folder of the problems that come with the program
    std::filesystem::path program;            ///< mechwright itself, for what is measured of whole runs
    const std::atomic<bool>* stop = nullptr;  ///< set from outside: end soon, what is not finished does not count

    bool stopped() const { return stop != nullptr && *stop; }
    /// One number for the quick look and one for the full measurement.
    template <class T>
    T pick(T quick, T thorough) const {
        return full ? thorough : quick;
    }
};

/// Numbers, texts, or null for what there is not.
using Cell = nlohmann::ordered_json;
using Row = std::vector<Cell>;

/// What is measured in one go, and not again by a run that goes on.
struct Measurement {
    std::string name;  ///< unique in its section; the first cell of each of its rows
    /// The rows without their first cell. Not kept where `effort.stopped()` afterwards.
    std::function<std::vector<Row>(const Effort&)> measure;
};

/// The table of a section.
struct Sheet {
    std::vector<std::string> columns;
    std::vector<Row> rows;

    const Cell& cell(const Row& row, std::string_view column) const;
    /// NaN where there is none.
    double number(const Row& row, std::string_view column) const;
    /// Empty where there is none.
    std::string text(const Row& row, std::string_view column) const;
    /// The rows in which a column holds this text.
    std::vector<Row> where(std::string_view column, std::string_view text) const;
    /// The texts that a column holds, each once, in the order of their rows.
    std::vector<std::string> distinct(std::string_view column) const;
};

struct Section {
    std::string_view name;                  ///< of its files, and for --only
    std::string_view title;                 ///< of its chapter
    std::vector<std::string_view> columns;  ///< the first is the name of the measurement
    std::vector<Measurement> (*measurements)(const Effort&);
    std::string (*chapter)(const Sheet&);  ///< Markdown: tables, and what they say
    std::vector<Diagram> (*diagrams)(const Sheet&);
};

/// All sections in the order of their chapters.
std::span<const Section> sections();

}  // namespace mechwright::bench
