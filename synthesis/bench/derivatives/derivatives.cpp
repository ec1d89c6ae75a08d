#include <fmt/format.h>

#include "synthesis/bench/derivatives/methods.h"
#include "synthesis/bench/digits.h"
#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/timing.h"

namespace mechwright::bench {

namespace {

constexpr int first_power = 2, last_power = 50;  // steps from 2^-2 to 2^-50 of a dimension

constexpr const char* value_alone = "value alone";
constexpr const char* forward = "forward differences";
constexpr const char* central = "central differences";
constexpr const char* extrapolated = "Ridders' extrapolation";
constexpr const char* dual = "dual numbers";
constexpr const char* loop = "implicit function theorem";
constexpr const char* rounded_dimensions = "rounding of the dimensions";

/// Greatest over the places.
template <class Measure, class Method>
double worst_error(const std::array<ExactGradient<Measure::size>, gradient_places>& exact, const Method& gradient_at) {
    double worst = 0;
    for (std::size_t k = 0; k < gradient_places; ++k)
        worst = std::max(worst, gradient_error(gradient_at(Measure::dimensions(k), k), exact[k]));
    return worst;
}

template <class Measure>
std::vector<Row> errors() {
    using Dimensions = std::array<double, Measure::size>;
    std::array<ExactGradient<Measure::size>, gradient_places> exact;
    double rounded = 0;
    for (std::size_t k = 0; k < gradient_places; ++k) {
        std::array<Digits50, Measure::size> x;
        std::ranges::copy(Measure::dimensions(k), x.begin());
        exact[k] = exact_gradient<Measure>(x, k);
        rounded = std::max(rounded, rounding_of_dimensions<Measure>(x, k, exact[k]));
    }
    const auto error = [&](const auto& method) {
        return worst_error<Measure>(exact, [&](const Dimensions& x, std::size_t k) { return method(x, k).gradient; });
    };
    std::vector<Row> rows;
    const auto add = [&](const char* method, Cell step, double worst) {
        rows.push_back({method, std::move(step), worst, nullptr, nullptr, nullptr});
    };
    for (int power = first_power; power <= last_power; ++power) {
        const double part = std::ldexp(1.0, -power);
        add(forward, part,
            error([&](const Dimensions& x, std::size_t k) { return by_forward_differences<Measure>(x, k, part); }));
        add(central, part,
            error([&](const Dimensions& x, std::size_t k) { return by_central_differences<Measure>(x, k, part); }));
    }
    add(extrapolated, nullptr, error(by_extrapolation<Measure>));
    add(dual, nullptr, error(by_dual_numbers<Measure>));
    add(loop, nullptr, error(Measure::by_loop));
    add(rounded_dimensions, nullptr, rounded);
    return rows;
}

/// Which step differences take does not change their time.
template <class Measure>
std::vector<Row> times(const Effort& effort) {
    std::array<std::array<double, Measure::size>, gradient_places> dimensions;
    for (std::size_t k = 0; k < gradient_places; ++k)
        dimensions[k] = Measure::dimensions(k);
    const auto over_places = [&](auto method) {
        return piece([=](std::size_t k) { return method(dimensions[k % gradient_places], k % gradient_places); });
    };
    const std::array names{value_alone, forward, central, extrapolated, dual, loop};
    constexpr double part = 1.0 / (1 << 20);
    const auto timings = timed(
        {over_places(Measure::template value<double>),
         over_places([](const auto& x, std::size_t k) { return by_forward_differences<Measure>(x, k, part); }),
         over_places([](const auto& x, std::size_t k) { return by_central_differences<Measure>(x, k, part); }),
         over_places(by_extrapolation<Measure>), over_places(by_dual_numbers<Measure>), over_places(Measure::by_loop)},
        effort.pick(5, 15), effort.pick(0.05, 0.5));
    std::vector<Row> rows;
    for (std::size_t i = 0; i < names.size(); ++i)
        rows.push_back({names[i], nullptr, nullptr, timings[i].median, timings[i].lower, timings[i].upper});
    return rows;
}

template <class Measure>
Measurement measured() {
    return {std::string(Measure::name), [](const Effort& effort) {
                std::vector<Row> rows = errors<Measure>();
                std::ranges::move(times<Measure>(effort), std::back_inserter(rows));
                return rows;
            }};
}

std::vector<Measurement> derivatives_measurements(const Effort&) {
    return {measured<CouplerPointMiss>(), measured<AngleNearToggle>(), measured<RamVelocity>(),
            measured<CamPressureAngle>()};
}

/// One way to the gradient of one measure, at its best step.
struct Way {
    double error = std::numeric_limits<double>::quiet_NaN();
    double step = std::numeric_limits<double>::quiet_NaN();
    double seconds = std::numeric_limits<double>::quiet_NaN();
};

Way way(const Sheet& sheet, const std::string& measure, const char* method) {
    Way best;
    for (const Row& row : sheet.where("measure", measure)) {
        if (sheet.text(row, "method") != method) continue;
        const double error = sheet.number(row, "error");
        if (error < best.error || std::isnan(best.error)) {
            if (!std::isnan(error)) best.step = sheet.number(row, "step");
            best.error = error;
        }
        if (const double seconds = sheet.number(row, "seconds"); !std::isnan(seconds)) best.seconds = seconds;
    }
    return best;
}

std::string power_text(double step) {
    return std::isnan(step) ? "" : fmt::format("2^{}", static_cast<int>(std::log2(step)));
}

MarkdownTable table(const Sheet& sheet) {
    MarkdownTable table{{"gradient of", "by", "digits", "error", "best step", "time", "over the value alone"}, {}};
    for (const std::string& measure : sheet.distinct("measure")) {
        const double alone = way(sheet, measure, value_alone).seconds;
        for (const char* method : {value_alone, forward, central, extrapolated, dual, loop, rounded_dimensions}) {
            const Way w = way(sheet, measure, method);
            const std::string digits = std::isnan(w.error) ? "" : significant(digits_left(w.error));
            table.rows.push_back({measure, method, digits, significant(w.error, 2), power_text(w.step),
                                  time_text(w.seconds), ratio_text(w.seconds / alone)});
        }
    }
    return table;
}

/// The least and the greatest of something over the measures, as "3 to 5".
template <class Function>
std::string span_of(const std::vector<std::string>& measures, const Function& number, const char* unit = "") {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const std::string& measure : measures) {
        least = std::min(least, number(measure));
        greatest = std::max(greatest, number(measure));
    }
    return fmt::format("{} to {}{}", significant(least, 2), significant(greatest, 2), unit);
}

/// What the best single step for all measures leaves of each, in digits.
struct CommonStep {
    double step = 0;
    double digits = -1;
};

CommonStep common_step(const Sheet& sheet, const char* method) {
    CommonStep best;
    for (int power = first_power; power <= last_power; ++power) {
        double worst = 0;
        for (const Row& row : sheet.where("method", method))
            if (sheet.number(row, "step") == std::ldexp(1.0, -power))
                worst = std::max(worst, sheet.number(row, "error"));
        if (digits_left(worst) > best.digits) best = {std::ldexp(1.0, -power), digits_left(worst)};
    }
    return best;
}

std::string derivatives_chapter(const Sheet& sheet) {
    const auto measures = sheet.distinct("measure");
    const auto digits = [&](const char* method) {
        return span_of(measures, [&](const std::string& m) { return digits_left(way(sheet, m, method).error); });
    };
    const auto ratio = [&](const char* method) {
        return span_of(measures, [&](const std::string& m) {
            return way(sheet, m, method).seconds / way(sheet, m, value_alone).seconds;
        });
    };
    const CommonStep common = common_step(sheet, central);
    return fmt::format(
               "Gradients by all dimensions at {} crank angles each; the greatest error of any, against differences in "
               "fifty digits. Times are of value and gradient together. The first steps of Ridders' "
               "extrapolation are a hundredth of each dimension; next to a toggle they cross it.\n\n",
               gradient_places) +
           to_markdown(table(sheet)) +
           fmt::format(
               "\nEven with the best step for each measure, which nobody knows beforehand, forward differences keep {} "
               "digits and central ones {}; dual numbers keep {}, the implicit function theorem {}. With one step for "
               "all of them central differences keep {} digits at the worst, with steps of {} of each dimension. "
               "Value and gradient together take {} times the value alone by dual numbers and {} by the implicit "
               "function theorem; {} by forward and {} by central differences. \"{}\" is what the gradient changes by "
               "when a dimension is off by half a unit of its last place: what the data themselves leave open.\n",
               digits(forward), digits(central), digits(dual), digits(loop), significant(common.digits, 2),
               power_text(common.step), ratio(dual), ratio(loop), ratio(forward), ratio(central), rounded_dimensions);
}

/// Steps over which a horizontal line is drawn.
std::vector<std::pair<double, double>> level(double error) {
    return {{std::ldexp(1.0, -last_power), error}, {std::ldexp(1.0, -first_power), error}};
}

Diagram diagram(const Sheet& sheet, const std::string& measure, std::size_t number) {
    Diagram d;
    d.name = fmt::format("derivatives-{}", number);
    d.title = "Error of the gradient: " + measure;
    d.x = "step over dimension";
    d.y = "relative error";
    d.log_x = d.log_y = true;
    for (const char* method : {forward, central}) {
        Curve curve{method, {}};
        for (const Row& row : sheet.where("measure", measure))
            if (sheet.text(row, "method") == method)
                curve.points.emplace_back(sheet.number(row, "step"), sheet.number(row, "error"));
        d.curves.push_back(std::move(curve));
    }
    for (const char* method : {extrapolated, dual, loop, rounded_dimensions})
        d.curves.push_back({method, level(way(sheet, measure, method).error)});
    return d;
}

std::vector<Diagram> derivatives_diagrams(const Sheet& sheet) {
    std::vector<Diagram> diagrams;
    for (const std::string& measure : sheet.distinct("measure"))
        diagrams.push_back(diagram(sheet, measure, diagrams.size() + 1));
    return diagrams;
}

}  // namespace

Section derivatives() {
    return {"derivatives",
            "Derivatives: differences, dual numbers, implicit functions",
            {"measure", "method", "step", "error", "seconds", "lower", "upper"},
            derivatives_measurements,
            derivatives_chapter,
            derivatives_diagrams};
}

}  // namespace mechwright::bench
