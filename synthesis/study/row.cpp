#include "synthesis/study/row.h"

#include <algorithm>
#include <cmath>

#include "synthesis/document/document.h"
#include "synthesis/problem/study/value_path.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/study/points.h"

namespace mechwright {

namespace {

Cell number(double value) {
    if (!std::isfinite(value)) return {};
    return value;
}

/// The value of a quantity or a dimension in the file's unit.
Cell in_unit(const std::optional<double>& value, Unit unit, const Units& units) {
    if (!value) return {};
    return number(in_file_unit(*value, unit, units));
}

Cell cell_of(const StudyAxis& axis, const AxisValue& value) {
    if (value.as_in_file) return {};
    if (axis.range) return value.number;
    const toml::node& node = axis.values[value.index];
    if (const auto n = node.value<double>(); n && node.is_number()) return *n;
    return axis.labels[value.index];
}

struct RowMaker {
    const PreparedStudy& prepared;
    StudyRow row{};

    template <class Value>
    void add(Value&& value) {
        row.cells.emplace_back(std::forward<Value>(value));
    }
    void add_nothing() { row.cells.emplace_back(); }

    void add_given() {
        const Study& study = *prepared.study;
        const std::vector<AxisValue> values = point_values(study, row.point);
        for (std::size_t i = 0; i < values.size(); ++i)
            add(cell_of(study.axes[i], values[i]));
        for (const FollowingValue& following : study.following)
            add(number(number_of(following, study, values)));
    }

    void add_outcome(std::string_view status, Cell start, Cell differed, const Problem* problem,
                     const Solution* solution, Cell proved) {
        add(std::string(status));
        add(std::move(start));
        add(std::move(differed));
        const double nothing = std::nan("");
        add(number(problem != nullptr && problem->objective && solution != nullptr ? solution->objective : nothing));
        add(number(solution != nullptr ? solution->violation : nothing));
        add(std::move(proved));
    }

    void add_design(const Problem* problem, const Design* design) {
        for (const std::string& name : prepared.columns.dimensions) {
            const int i = design != nullptr ? find_dimension(*problem->mechanism, name) : -1;
            const auto at = static_cast<std::size_t>(std::max(i, 0));
            if (i < 0)
                add_nothing();
            else
                add(in_unit(design->dimensions[at], unit_of(problem->mechanism->dimensions[at].kind), problem->units));
        }
        if (design != nullptr && !problem->mechanism->assemblies.empty())
            add(std::string(problem->mechanism->assemblies[design->assembly]));
        else
            add_nothing();
    }

    void add_quantities(const Problem* problem, const Design* design) {
        for (const std::string& name : prepared.columns.quantities) {
            const int i = design != nullptr ? find_quantity(*problem->mechanism, name) : -1;
            const auto at = static_cast<std::size_t>(std::max(i, 0));
            if (i < 0)
                add_nothing();
            else
                add(in_unit(quantity_value(*problem, at, *design), problem->mechanism->quantities[at].unit,
                            problem->units));
        }
    }
};

bool all_given(const Problem& problem) {
    return std::all_of(problem.dimensions.begin(), problem.dimensions.end(),
                       [](const DimensionRange& range) { return range.fixed() || range.tied(); });
}

bool assembles(const Problem& problem, const Design& design) {
    const Motion motion = motion_of(problem, design);
    if (!(motion.from <= motion.to)) return false;
    const auto checks = problem.mechanism->check_motion;
    if (checks == nullptr) return true;
    const std::vector<Digits50> dimensions(design.dimensions.begin(), design.dimensions.end());
    return all_passed(checks(motion, dimensions));
}

std::string_view status_of(const Problem& problem, const Result& result) {
    const bool judged = result.status == Status::infeasible || result.status == Status::unverified;
    if (judged && result.best && all_given(problem) && !assembles(problem, result.best->design)) return "not-assembled";
    return name_of(result.status);
}

/// The note of a result, or which check of its verification failed first.
Cell note_of(const Result& result) {
    if (!result.note.empty()) return result.note;
    if (result.status != Status::unverified) return {};
    const auto failed = std::find_if(result.verification.begin(), result.verification.end(),
                                     [](const Check& check) { return !check.passed; });
    if (failed == result.verification.end()) return {};
    return failed->name + ": " + failed->detail;
}

}  // namespace

std::string_view name_of(Start start) {
    switch (start) {
        case Start::own: return "own";
        case Start::neighbour: return "neighbour";
        case Start::both: return "both";
    }
    return "";
}

StudyRow row_of(const PreparedStudy& prepared, std::uint64_t point, const Problem& problem, const Result& result,
                Start start, bool differed) {
    RowMaker maker{prepared, {point, {}, {}}};
    const Solution* best = result.best ? &*result.best : nullptr;
    const Design* design = best != nullptr ? &best->design : nullptr;
    maker.add_given();
    Cell both_ways;
    if (start == Start::both) both_ways = std::int64_t{differed};
    maker.add_outcome(status_of(problem, result), std::string(name_of(start)), std::move(both_ways), &problem, best,
                      std::int64_t{result.search.complete()});
    maker.add_design(&problem, design);
    maker.add_quantities(&problem, design);
    maker.add(note_of(result));
    if (design != nullptr) maker.row.design = *design;
    return maker.row;
}

StudyRow invalid_row(const PreparedStudy& prepared, std::uint64_t point, const std::string& why) {
    RowMaker maker{prepared, {point, {}, {}}};
    maker.add_given();
    maker.add_outcome("invalid", {}, {}, nullptr, nullptr, {});
    maker.add_design(nullptr, nullptr);
    maker.add_quantities(nullptr, nullptr);
    maker.add(why);
    return maker.row;
}

StudyRow evaluated_row(const PreparedStudy& prepared, std::uint64_t point, const Problem& problem,
                       const Solution& solution) {
    RowMaker maker{prepared, {point, {}, {}}};
    const Motion motion = motion_of(problem, solution.design);
    maker.add_given();
    maker.add_outcome(motion.from <= motion.to ? "evaluated" : "not-assembled", {}, {}, &problem, &solution, {});
    maker.add_design(&problem, &solution.design);
    maker.add_quantities(&problem, &solution.design);
    maker.add_nothing();
    return maker.row;
}

}  // namespace mechwright
