#include "synthesis/verify/alternation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "synthesis/document/claimed_problem.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/alternation/error_extremes.h"
#include "synthesis/program/result.h"
#include "synthesis/verify/error_again.h"
#include "synthesis/verify/slopes_again.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_listed = 40;  // extremes of a document

struct Error {
    const Claim& claim;
    InputTask task;
    Rebuilt design;
    ErrorAgain curve;
    std::vector<ExtremeAgain> extremes;
    Digits50 greatest = 0;

    Error(const Claim& c, const InputTask& t)
        : claim(c), task(t), design(rebuilt(c)), curve(design, t), extremes(curve.extremes()) {
        for (const ExtremeAgain& e : extremes)
            greatest = std::max<Digits50>(greatest, abs(e.error));
    }

    Unit unit() const { return task.unit(); }
    const char* place_name() const { return task.is_function() ? "x" : "crank_angle"; }
    const char* error_name() const { return task.is_function() ? "error" : "distance"; }
    /// What an error is off by rounding of the dimensions.
    Digits50 rounding() const {
        return 8 * std::numeric_limits<double>::epsilon() * (unit() == Unit::angle ? Digits50(1) : design.longest);
    }
    /// By how much two errors differ: half a turn is minus half a turn.
    Digits50 apart(const Digits50& a, const Digits50& b) const { return abs(curve.counted_on(a, b) - b); }
    /// The place as a document has it: x of a function, else the crank angle, or displacement.
    double place(double share) const {
        if (const FunctionTarget* f = task.asked.function.get()) return f->from + share * (f->to - f->from);
        const Digits50 input = design.dimensions[task.start] + design.dimensions[task.start + 1] * share;
        return in_document(input, input_unit(*claim.mechanism), claim.units).convert_to<double>();
    }
};

/// Why the list of extremes is not that of the design; empty if it is. Ripples that are nothing but rounding may be
/// listed or not.
std::string extremes_defect(const Json& stated, const Error& error) {
    constexpr double place_within = 1e-5, error_within = 1e-7;
    const char *where = error.place_name(), *what = error.error_name();
    const double span = std::abs(error.place(1) - error.place(0));
    const Digits50 room = error_within * error.greatest + error.rounding();
    if (!stated.is_array()) return "they are no list";
    std::vector<bool> listed(error.extremes.size(), false);
    double last = -std::numeric_limits<double>::infinity();
    for (const Json& one : stated) {
        if (!one.is_object() || !one.contains(where) || !one[where].is_number() || !one.contains(what) ||
            !one[what].is_number())
            return one.dump() + " is no extreme";
        const double place = one[where].get<double>();
        const Digits50 size = from_document(one[what].get<double>(), error.unit(), error.claim.units);
        bool known = false;
        for (std::size_t i = 0; i < error.extremes.size(); ++i) {
            const ExtremeAgain& e = error.extremes[i];
            if (std::abs(error.place(e.share) - place) > place_within * span || error.apart(e.error, size) > room)
                continue;
            known = listed[i] = true;
        }
        if (!known) return fmt::format("there is none at {} {} of {}", where, place, one[what].dump());
        const double along = error.place(1) > error.place(0) ? place : -place;
        if (!(along > last)) return "they are not in order";
        last = along;
    }
    for (std::size_t i = 0; i < listed.size() && stated.size() < most_listed; ++i) {
        const bool ripple =
            i > 0 && i + 1 < listed.size() && abs(error.extremes[i].error - error.extremes[i - 1].error) <= room;
        if (!listed[i] && !ripple)
            return fmt::format("that at {} {} is not stated", where, error.place(error.extremes[i].share));
    }
    return {};
}

/// Those that are as great as the greatest, the first of each run of one sign.
std::vector<ExtremeAgain> alternating(const Error& error) {
    std::vector<ExtremeAgain> kept;
    for (const ExtremeAgain& e : greatest_of(error.extremes, error.rounding()))
        if (kept.empty() || (kept.back().error > 0) != (e.error > 0)) kept.push_back(e);
    return kept;
}

/// How the errors at some extremes, with the signs that make them positive, change with each free dimension.
std::vector<RowAgain> slopes(const Error& error, const std::vector<ExtremeAgain>& at) {
    std::vector<RowAgain> rows = slopes_again(error.design, [&](const std::vector<Digits50>& dimensions) {
        std::vector<Digits50> values;
        for (const ExtremeAgain& e : at)
            values.push_back(error.curve.counted_on(error.curve.at(e.share, dimensions), e.error));
        return values;
    });
    for (std::size_t i = 0; i < at.size(); ++i)
        for (Digits50& slope : rows[i])
            if (at[i].error < 0) slope = -slope;
    return rows;
}

/// How many free dimensions the error depends on independently, which they are, and between which numbers that lies
/// where the dependence is so weak, next to singular positions, that rounding decides.
struct FreeDimensions {
    std::size_t count = 0, least = 0, most = 0;
    std::vector<std::size_t> columns{};
};

FreeDimensions free_dimensions(const Error& error) {
    constexpr std::size_t most = 16;
    std::vector<ExtremeAgain> at = error.extremes;
    std::sort(at.begin(), at.end(),
              [](const ExtremeAgain& a, const ExtremeAgain& b) { return abs(a.error) > abs(b.error); });
    at.resize(std::min(at.size(), most));
    std::vector<RowAgain> rows = slopes(error, at);
    scale_columns(rows);
    constexpr double independent_beyond = 1e-7, doubtful = 30;
    FreeDimensions free;
    free.columns = independent_columns(rows, independent_beyond);
    free.count = free.columns.size();
    free.least = independent_columns(rows, independent_beyond * doubtful).size();
    free.most = independent_columns(rows, independent_beyond / doubtful).size();
    return free;
}

Check check_balance(const Error& error, const std::vector<ExtremeAgain>& equal,
                    const std::vector<std::size_t>& columns) {
    std::vector<RowAgain> rows = in_columns(slopes(error, equal), columns);
    scale_columns(rows);
    const std::size_t needed = columns.size() + 1;
    for (std::size_t first = 0; first + needed <= rows.size(); ++first)
        if (balances({rows.begin() + static_cast<std::ptrdiff_t>(first),
                      rows.begin() + static_cast<std::ptrdiff_t>(first + needed)},
                     std::vector<bool>(needed, false)))
            return {"alternation shows that no design near is better", true,
                    fmt::format("{} extremes balance in {} free dimensions, with positive weights", needed,
                                columns.size())};
    return {"alternation shows that no design near is better", false, "the extremes do not balance"};
}

}  // namespace

std::vector<Check> check_alternation(const Json& stated, const Claim& claim, const InputTask& task) {
    const std::string called = task.asked.name.empty() ? "" : fmt::format(" of '{}'", task.asked.name);
    Check check{fmt::format("extremes of the error{} are as stated", called), false, {}};
    const Error error(claim, task);
    if (!all_passed(error.design.of_motion)) return {};
    const Json extremes = stated.value("extremes", Json());
    constexpr double zero_within = 1e-11;
    if (error.greatest < zero_within) {
        // Of errors that are nothing but rounding neither places nor their number mean anything.
        const char* what = error.error_name();
        check.passed = extremes.is_array() && std::all_of(extremes.begin(), extremes.end(), [&](const Json& e) {
                           return e.is_object() && e.contains(what) && e[what].is_number() &&
                                  std::abs(e[what].get<double>()) <= 1e-10;
                       });
        check.detail = check.passed ? "the error is nothing but rounding" : "the error is rounding, and not stated so";
        return {check};
    }
    check.detail = extremes_defect(extremes, error);
    const auto equal = alternating(error);
    const FreeDimensions free = free_dimensions(error);
    const auto count = [&](const char* name, std::size_t least, std::size_t most) {
        const Json number = stated.value(name, Json());
        if (check.detail.empty() && !(number.is_number() && number >= least && number <= most))
            check.detail = fmt::format("{} is stated as {}, it is {}", name, number.dump(), most);
    };
    count("alternating", equal.size(), equal.size());
    count("free", free.least, free.most);
    check.passed = check.detail.empty();
    if (!check.passed) return {check};
    check.detail =
        fmt::format("{} extremes derived again in fifty digits, {} of them alternate", extremes.size(), equal.size());
    if (free.count == 0 || equal.size() <= free.most || !asks_for_least_error(claimed_design(claim).problem, task))
        return {check};
    return {check, check_balance(error, equal, free.columns)};
}

}  // namespace mechwright
