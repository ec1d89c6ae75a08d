#include "synthesis/target/over_input/numbers.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "synthesis/mechanism/input.h"
#include "synthesis/target/over_input/together.h"

namespace mechwright {

namespace {

/// Numbers of one of several targets.
std::size_t add_numbers(Mechanism& m, const InputTarget& target, std::vector<Dimension> numbers) {
    const std::size_t first = m.dimensions.size();
    for (Dimension& number : numbers) {
        number.name = target.name + "." + number.name;
        number.meaning += " of '" + target.name + "'";
        m.dimensions.push_back(std::move(number));
    }
    return first;
}

/// The same quantities by the target's name. They read `own` numbers from its input range on.
void make_its_own(std::vector<Quantity>& quantities, const InputTarget& target, std::size_t number, std::size_t own) {
    for (Quantity& quantity : quantities) {
        quantity.name = target.name + "." + quantity.name;
        quantity.meaning += " of '" + target.name + "'";
        quantity.of_target = number;
        quantity.reads = quantity.reads.and_then(target.start, own);
    }
}

std::vector<Quantity>& quantities_of(InputTarget& target) {
    return target.function ? target.function->quantities : target.shape->quantities;
}

/// What is said of all targets of a sort, where it is said of each: the name without that of a target.
struct OfAll {
    std::string_view name;
    const char* meaning;
    Quantity (*of)(std::string name, std::string meaning, std::vector<Quantity> parts);
};

constexpr std::array<OfAll, 4> of_all{
    {{"function-max", "greatest difference of any output from its function", greatest_together},
     {"function-rms", "root of the weighted mean of the squares of what all functions have", root_mean_together},
     {"line-deviation", "greatest distance of any point from the line that it follows", greatest_together},
     {"arc-deviation", "greatest distance of any point from the arc that it follows", greatest_together}}};

}  // namespace

void add_numbers_over_input(Mechanism& m) {
    const DimensionKind input = kind_of_input(m);
    const std::string word(input_word(m));
    for (std::size_t i = 0; i < m.over_input.size(); ++i) {
        InputTarget& target = m.over_input[i];
        std::vector<Dimension> own{number_of_target("input-start", input, word + " at the start of the range"),
                                   number_of_target("input-range", input, word + " over the range")};
        if (target.function) {
            const OutputScale& output = target.function->output;
            own.push_back(number_of_target("output-start", output.kind, output.start));
            own.push_back(number_of_target("output-range", output.kind, output.range));
        } else {
            own.insert(own.end(), target.shape->numbers.begin(), target.shape->numbers.end());
            target.shape->place = m.dimensions.size() + 2;
        }
        const std::size_t count = own.size();
        target.start = add_numbers(m, target, std::move(own));
        make_its_own(quantities_of(target), target, i, count);
    }
}

std::vector<Quantity> quantities_over_input(const Mechanism& m) {
    std::vector<Quantity> each, all;
    for (const InputTarget& target : m.over_input)
        for (const Quantity& quantity : target.function ? target.function->quantities : target.shape->quantities)
            each.push_back(quantity);
    for (const OfAll& together : of_all) {
        std::vector<Quantity> parts;
        std::copy_if(each.begin(), each.end(), std::back_inserter(parts),
                     [&](const Quantity& q) { return std::string_view(q.name).ends_with(together.name); });
        const bool alike =
            std::all_of(parts.begin(), parts.end(), [&](const Quantity& q) { return q.unit == parts.front().unit; });
        if (!parts.empty() && alike)
            all.push_back(together.of(std::string(together.name), together.meaning, std::move(parts)));
    }
    all.insert(all.end(), each.begin(), each.end());
    return all;
}

}  // namespace mechwright
