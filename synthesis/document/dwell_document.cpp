#include "synthesis/document/dwell_document.h"

#include "synthesis/document/fields.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/alternation/dwell_alternation.h"

namespace mechwright {

void put_dwells(nlohmann::ordered_json& json, const Problem& problem, const Design& design) {
    using namespace names;
    using Json = nlohmann::ordered_json;
    Json dwells = Json::array();
    const Unit of_input = input_unit(*problem.mechanism);
    for (const DwellAlternation& dwell : dwell_alternations(problem, design)) {
        const Unit unit = dwell.quantity->unit;
        Json extremes = Json::array();
        for (const DwellExtreme& e : dwell.extremes)
            extremes.push_back({{of_dwell_extreme("input"), in_file_unit(e.input, of_input, problem.units)},
                                {of_dwell_extreme("value"), in_file_unit(e.value, unit, problem.units)},
                                {of_dwell_extreme("off"), in_file_unit(e.value - dwell.middle, unit, problem.units)}});
        dwells.push_back({{of_dwell("quantity"), dwell.quantity->name},
                          {of_dwell("middle"), in_file_unit(dwell.middle, unit, problem.units)},
                          {of_dwell("extremes"), std::move(extremes)},
                          {of_dwell("alternating"), dwell.alternating},
                          {of_dwell("free"), dwell.free},
                          {of_dwell("held"), dwell.held},
                          {of_dwell("balanced"), dwell.balanced}});
    }
    if (!dwells.empty()) json[of_finding("dwells")] = std::move(dwells);
}

}  // namespace mechwright
