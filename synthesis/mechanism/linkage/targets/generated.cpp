#include "synthesis/mechanism/linkage/targets/generated.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "synthesis/mechanism/linkage/again/output_again.h"
#include "synthesis/mechanism/linkage/targets/function.h"
#include "synthesis/target/function/formulas_again.h"

namespace mechwright {

namespace {

using Kind = LinkageMeasure::Kind;

/// A linkage of given dimensions over the input range of a function.
class Generating {
public:
    Generating(const FunctionTarget& function, Form form, std::span<const double> arguments)
        : arguments_(arguments),
          measure_(measuring::error_measure(linkage_of(form.model), form.over_input, Kind::function_greatest)),
          motion_(motion(function, form, arguments, measure_)),
          over_(motion_, true),
          plain_(measuring::measured<double, orders>(over_, arguments, measure_.signals)) {
        const auto dimensions = over_.dimensions_of(arguments);
        if (!measuring::closes_at_samples(over_, dimensions)) return;
        course_ = measuring::course_of(over_, dimensions, plain_, measure_.signals);
        if (measuring::needs_turns(over_, measure_.signals)) {
            if (course_.turns.empty() || course_.turns.to() < course_.travel.to) return;
            plain_.start_at(course_);
        }
        closes_ = true;
    }

    /// The error where it can be greatest, or at the samples, along the motion; empty where the linkage does not close.
    std::vector<measuring::Term> errors() {
        if (!closes_) return {};
        const double turns = measuring::whole_turns_of_error(over_, plain_, course_, arguments_);
        plain_.ask(over_.wanted_of(arguments_, turns, motion_.function->series));
        return motion_.function->parts.empty()
                   ? measuring::extremes_of_error(over_, plain_, course_)
                   : measuring::errors_at_samples(over_, plain_, course_, arguments_, turns);
    }

private:
    /// Derivatives of the pose: two for extremes, two more for signals that are accelerations.
    static constexpr std::size_t orders = 4;

    static Motion motion(const FunctionTarget& function, Form form, std::span<const double> arguments,
                         const LinkageMeasure& measure) {
        const auto scales = arguments.last(4);
        Motion made;
        made.assembly = form.assembly;
        made.model = form.model;
        made.of = &measure;
        made.full_turn = false;
        const double unit = linkage_of(form.model).unit_of_input();
        made.from = unit * std::min(scales[0], scales[0] + scales[1]);
        made.to = unit * std::max(scales[0], scales[0] + scales[1]);
        made.function = &function;
        return made;
    }
    std::span<const double> arguments_;
    LinkageMeasure measure_;
    Motion motion_;
    measuring::Over over_;
    linkage::Measured<double, orders> plain_;
    measuring::Course course_{};
    bool closes_ = false;
};

std::vector<ErrorExtreme> extremes(const FunctionTarget& function, Form form, std::span<const double> arguments) {
    const std::vector<measuring::Term> errors = Generating(function, form, arguments).errors();
    const auto scales = arguments.last(4);
    const double input = linkage_of(form.model).input_per_argument();
    std::vector<ErrorExtreme> all;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const measuring::Extreme& place = errors[i].place;
        if (!std::isfinite(place.value)) return {};
        if (function.parts.empty())
            all.push_back({(place.at - input * scales[0]) / (input * scales[1]), 0, place.value, place.stationary});
        else
            all.push_back({function.parts[i].x, function.parts[i].y, place.value, false});
    }
    if (function.parts.empty() && scales[1] < 0) std::reverse(all.begin(), all.end());
    return all;
}

/// No closed form says which dimensions come close to a function.
bool fit(const FunctionTarget&, std::span<double>, std::span<double, 4>, bool, bool) { return false; }

}  // namespace

FunctionGeneration linkage_function(const LinkageModel& model, std::size_t over_input, std::size_t dimensions) {
    const NamedSignal& output = model.signal_names[model.over_input[over_input].of];
    const bool angle = output.unit == Unit::angle;
    FunctionGeneration made;
    made.output = {angle ? DimensionKind::angle : DimensionKind::coordinate,
                   "'" + output.name + "' at the start of a function's range",
                   "way of '" + output.name + "' over the range of a function"};
    const auto add = [&](const char* name, const char* what, Kind kind, auto measure_again) {
        Quantity quantity = mechwright::over_input(
            linkage_quantity(name, output.unit, what, measuring::error_measure(model, over_input, kind), dimensions));
        quantity.defined = [](const Motion& motion) { return motion.function != nullptr; };
        quantity.measure_again = measure_again;
        quantity.worst_first = false;
        quantity.section = "function";
        quantity.of_motion = false;
        made.quantities.push_back(std::move(quantity));
    };
    add("function-max", "greatest difference of the output from the function", Kind::function_greatest,
        function_max_again<LinkageOutputAgain>);
    add("function-rms", "root mean square difference of the output from the function", Kind::function_rms,
        function_rms_again<LinkageOutputAgain>);
    made.fit = fit;
    made.extremes = extremes;
    return made;
}

}  // namespace mechwright
