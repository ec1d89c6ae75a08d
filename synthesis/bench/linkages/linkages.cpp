#include <fmt/format.h>

#include <cmath>

#include "synthesis/bench/linkages/measured.h"
#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/sections.h"

namespace mechwright::bench {

namespace {

std::vector<Measurement> linkages_measurements(const Effort&) {
    return {{"a point, one by one", measured_one_by_one},
            {"a point, in lanes", measured_blocks},
            {"value with gradient", measured_gradients},
            {"digits", measured_digits},
            {"a whole run", measured_analysis}};
}

std::string number_text(double number, const std::string& unit) {
    return std::isnan(number) ? "" : significant(number) + " " + unit;
}

std::string linkages_chapter(const Sheet& sheet) {
    MarkdownTable table{{"measurement", "what", "median", "compared with", "that", "ratio", "aim"}, {}};
    for (const Row& row : sheet.rows) {
        const std::string unit = sheet.text(row, "unit"), aim = sheet.text(row, "aim");
        const double ratio = sheet.number(row, "ratio");
        table.rows.push_back({sheet.text(row, "measurement"), sheet.text(row, "what"),
                              number_text(sheet.number(row, "median"), unit), sheet.text(row, "compared with"),
                              number_text(sheet.number(row, "that"), unit),
                              std::isnan(ratio) ? "" : fmt::format("{:.2f}", ratio), aim});
    }
    return "A four-bar described as links and joints against the built-in kernel of the same design, Jansen's foot "
           "against the coupler point of a four-bar, first derivatives by all dimensions against the value alone, and "
           "a whole run of `analyse` against `--version`. Points are placed by the steps that they need. Digits are "
           "the least over "
           "the usual and the hard positions of the kernel, and errors are in times the change of the exact point "
           "where one "
           "of its inputs is perturbed by four units of the last place.\n\n" +
           to_markdown(table);
}

std::vector<Diagram> linkages_diagrams(const Sheet&) { return {}; }

}  // namespace

Section linkages() {
    return {"linkages",
            "Linkages that files describe",
            {"measurement", "what", "median", "unit", "compared with", "that", "ratio", "aim"},
            linkages_measurements,
            linkages_chapter,
            linkages_diagrams};
}

}  // namespace mechwright::bench
