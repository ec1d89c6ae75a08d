#include "synthesis/target/function/numbers.h"

#include "synthesis/mechanism/input.h"

namespace mechwright {

void add_input_range(Mechanism& m) {
    InputRange& input = *m.input;
    input.start = m.dimensions.size();
    input.margin.reads = input.reads.and_then(input.start, 2);
    for (Quantity& q : input.quantities)
        q.reads = q.reads.and_then(input.start, 2);
    const DimensionKind kind = kind_of_input(m);
    const std::string word(input_word(m));
    m.dimensions.push_back(
        number_of_target("input-start", kind, word + " at the start of a function's, line's or arc's range"));
    m.dimensions.push_back(number_of_target("input-range", kind, word + " over the range of a function, line or arc"));
}

void add_output_range(Mechanism& m) {
    const OutputScale& output = m.function->output;
    m.dimensions.push_back(number_of_target("output-start", output.kind, output.start));
    m.dimensions.push_back(number_of_target("output-range", output.kind, output.range));
    for (Quantity& q : m.function->quantities)
        q.reads = q.reads.and_then(m.input->start, 4);
}

}  // namespace mechwright
