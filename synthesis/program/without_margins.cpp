#include "synthesis/program/without_margins.h"

#include <algorithm>

namespace mechwright {

namespace {

/// A row that is no requirement of the problem and reads outputs alone: no condition on dimensions, no bound on a
/// worst.
bool is_margin(const Row& row) { return !row.requirement && !row.form.outputs.empty() && row.form.variables.empty(); }

bool is_of(const QuantityBlock& block, const LinearForm& form) {
    return std::any_of(form.outputs.begin(), form.outputs.end(), [&](const LinearTerm& t) {
        return t.index >= block.first && t.index < block.first + block.count;
    });
}

}  // namespace

bool has_margins_of_motion(const Program& program) {
    const Family& family = program.problem->mechanism->families[program.variant.family];
    return family.assembly_margin.has_value() && std::any_of(program.rows.begin(), program.rows.end(), is_margin);
}

Program without_margins(Program program) {
    std::erase_if(program.rows, is_margin);
    const auto is_used = [&](const QuantityBlock& block) {
        return is_of(block, program.objective) || std::any_of(program.rows.begin(), program.rows.end(),
                                                              [&](const Row& row) { return is_of(block, row.form); });
    };
    std::erase_if(program.blocks, [&](const QuantityBlock& block) { return !is_used(block); });
    return program;
}

}  // namespace mechwright
