#include "synthesis/document/claim.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "synthesis/document/claim_json.h"
#include "synthesis/document/fields.h"
#include "synthesis/document/kinds_in_documents.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/affine.h"
#include "synthesis/problem/allowed_values.h"
#include "synthesis/problem/linkage/of_kinds/measures_of_kind.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/units.h"
#include "synthesis/target/over_input/document.h"
#include "synthesis/target/path/document.h"
#include "synthesis/target/with_targets.h"

namespace mechwright {

namespace {

using namespace claims;
using namespace names;

constexpr std::size_t most_entries = 1000;  // requirements, terms of the objective
constexpr double loosest_tolerance = 1e-2;

std::optional<std::size_t> quantity_named(Reader& in, const Json* name, const std::string& place, const Claim& claim) {
    const std::string text = in.text(name, place);
    const int index = find_quantity(*claim.mechanism, text);
    if (index >= 0) return static_cast<std::size_t>(index);
    in.fail(fmt::format("{} names the quantity {}, which a {} does not have", place, reading::quoted(text),
                        claim.mechanism->name));
    return std::nullopt;
}

bool is_angle(const Claim& claim, std::size_t dimension) {
    return claim.mechanism->dimensions[dimension].kind == DimensionKind::angle;
}

/// The mechanism with what the targets of the document bring, and the numbers that it names though there are none.
std::shared_ptr<const Mechanism> mechanism_of(const Json& document, const std::string& name) {
    std::vector<std::string_view> names;
    const auto add_names = [&](const Json* object) {
        if (object && object->is_object())
            for (const auto& [key, value] : object->items())
                names.push_back(key);
    };
    add_names(&document);
    add_names(member(document, of_document("dimensions")));
    add_names(member(document, of_document("design")));
    const auto mechanism = find_mechanism(name);
    return mechanism ? with_targets(mechanism, names) : nullptr;
}

/// The names of all quantities that a document speaks of.
std::vector<std::string> quantities_in(const Json& document) {
    std::vector<std::string> names;
    const auto add = [&](const Json* object) {
        if (const Json* name = object && object->is_object() ? member(*object, of_requirement("quantity")) : nullptr)
            if (name->is_string()) names.push_back(name->get<std::string>());
    };
    const auto add_all = [&](const Json* list) {
        if (!list || !list->is_array()) return;
        for (const Json& one : *list)
            add(&one);
    };
    add_all(member(document, of_document("requirements")));
    if (const Json* objective = member(document, of_document("objective")); objective && objective->is_object()) {
        add(objective);
        add_all(member(*objective, of_objective("terms")));
    }
    if (const Json* quantities = member(document, of_document("quantities")); quantities && quantities->is_object())
        for (const auto& [name, value] : quantities->items())
            names.push_back(name);
    return names;
}

void read_units(Reader& in, const Json& document, Claim& claim) {
    const Json* units = member(document, of_document("units"));
    if (!units) return;
    if (const Json* angle = in.object(units, "units") ? member(*units, of_units("angle")) : nullptr) {
        const std::string unit = in.text(angle, "units.angle");
        claim.units.degrees = unit == "deg";
        if (unit != "deg" && unit != "rad") in.fail("units.angle is neither deg nor rad");
    }
    if (const Json* length = member(*units, of_units("length"))) claim.units.length = in.text(length, "units.length");
    if (const Json* force = member(*units, of_units("force"))) claim.units.force = in.text(force, "units.force");
    if (const Json* mass = member(*units, of_units("mass"))) {
        claim.units.mass = in.text(mass, "units.mass");
        const auto times = times_mass(claim.units.mass, claim.units.force, claim.units.length);
        if (!times) in.fail("units.mass does not go with units.force and units.length");
        claim.units.per_mass = times.value_or(1);
    }
}

/// What is measured of the signals, rooms and regions of a mechanism of the list.
void read_measures(Reader& in, const Json& document, Claim& claim) {
    MadeAgain made = with_measures_of(claim.mechanism, document, quantities_in(document), claim.units);
    if (!made.mechanism) return in.fail("signals, room and region " + made.defect);
    claim.mechanism = std::move(made.mechanism);
}

void read_head(Reader& in, const Json& document, Claim& claim) {
    if (in.number(member(document, of_document("schema")), "schema") != 1) in.fail("schema is not 1");
    const Json* problem = in.object(member(document, of_document("problem")), "problem");
    const std::string name = problem ? in.text(member(*problem, of_problem("mechanism")), "problem.mechanism") : "";
    if (const Json* sections = member(document, of_document("linkage"))) {
        MadeAgain made = mechanism_of_sections(*sections, quantities_in(document));
        if (!made.mechanism) return in.fail("linkage " + made.defect);
        claim.mechanism = std::move(made.mechanism);
        if (claim.mechanism->name != name) return in.fail("problem.mechanism is no linkage, and there is one");
    } else {
        claim.mechanism = mechanism_of(document, name);
    }
    if (!claim.mechanism) return in.fail(fmt::format("there is no mechanism {}", reading::quoted(name)));
    read_units(in, document, claim);
    read_measures(in, document, claim);
    if (!in.understood()) return;
    const std::vector<std::string> named = quantities_in(document);
    if (member(document, of_document("range_of_use")) ||
        std::any_of(named.begin(), named.end(), [](const std::string& one) { return one.ends_with(whole_suffix); }))
        claim.mechanism = with_whole_quantities(claim.mechanism);
    if (const Json* tolerance = member(document, of_document("tolerance"))) {
        claim.tolerance = in.number(tolerance, "tolerance");
        if (!(claim.tolerance > 0 && claim.tolerance <= loosest_tolerance))
            in.fail(fmt::format("tolerance is {}, not above 0 and at most {}", claim.tolerance, loosest_tolerance));
    }
}

double dimension_number(Reader& in, const Claim& claim, std::size_t i, const Json* json, const std::string& place) {
    return is_angle(claim, i) ? in.angle(json, place) : in.number(json, place);
}

ClaimedRange claimed_choices(Reader& in, const Claim& claim, std::size_t i, const Json& json,
                             const std::string& place) {
    ClaimedRange range{};
    if (!in.array(&json, place, most_choices)) return range;
    for (const Json& choice : json)
        range.choices.push_back(dimension_number(in, claim, i, &choice, place));
    if (range.choices.empty()) {
        in.fail(place + " is empty");
        return range;
    }
    std::sort(range.choices.begin(), range.choices.end());
    range.min = range.choices.front();
    range.max = range.choices.back();
    return range;
}

void read_given(Reader& in, const Json& document, Claim& claim) {
    claim.given.resize(claim.mechanism->dimensions.size());
    const Json* given = in.object(member(document, of_document("dimensions")), "dimensions");
    if (!given) return;
    for (const auto& [name, value] : given->items()) {
        const std::string place = "dimensions." + reading::quoted(name);
        const int index = find_dimension(*claim.mechanism, name);
        if (index < 0) return in.fail(fmt::format("a {} does not have {}", claim.mechanism->name, place));
        const auto i = static_cast<std::size_t>(index);
        if (value.is_object() && member(value, of_tie("of"))) {
            const int of = find_dimension(*claim.mechanism, in.text(member(value, of_tie("of")), place + ".of"));
            if (of < 0) return in.fail(fmt::format("{} is tied to a dimension that does not exist", place));
            const double times = in.number(member(value, of_tie("times")), place + ".times");
            claim.given[i] = ClaimedRange{0, 0, {0, {{static_cast<std::size_t>(of), times}}}};
        } else if (value.is_string()) {
            const ParsedAffine sum =
                parse_affine(value.get<std::string>(), [&](std::string_view other, std::string& fault) {
                    const int of = find_dimension(*claim.mechanism, other);
                    if (of < 0) fault = "it names a dimension that does not exist";
                    return of < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(of));
                });
            if (!sum.fault.empty() || sum.value.terms.empty())
                return in.fail(fmt::format("{} is no sum of dimensions: {}", place, sum.fault));
            claim.given[i] = ClaimedRange{0, 0, sum.value};
        } else if (value.is_object() && member(value, of_choices("choices"))) {
            claim.given[i] = claimed_choices(in, claim, i, *member(value, of_choices("choices")), place + ".choices");
        } else if (value.is_object()) {
            const double min = dimension_number(in, claim, i, member(value, of_range("min")), place + ".min");
            const double max = dimension_number(in, claim, i, member(value, of_range("max")), place + ".max");
            const Json* step = member(value, of_range("step"));
            claim.given[i] =
                ClaimedRange{min, max, {}, {}, step ? dimension_number(in, claim, i, step, place + ".step") : 0};
            if (step && !(claim.given[i]->step > 0 && min < max)) in.fail(place + ".step makes no values");
        } else {
            const double number = dimension_number(in, claim, i, &value, place);
            claim.given[i] = ClaimedRange{number, number, {}};
        }
    }
}

void read_design(Reader& in, const Json& document, Claim& claim) {
    const Mechanism& mechanism = *claim.mechanism;
    claim.design.assign(mechanism.dimensions.size(), 0.0);
    const Json* design = member(document, of_document("design"));
    if (!design) return in.fail("the document has no design");
    if (!in.object(design, "design")) return;
    const KindInDocuments* own = kind_in_documents(mechanism);
    const auto is_choice = [&](std::string_view name) {
        return own && std::find(own->choices.begin(), own->choices.end(), name) != own->choices.end();
    };
    for (const auto& [name, value] : design->items())
        if (name != "assembly" && name != "kind" && !is_choice(name) && find_dimension(mechanism, name) < 0)
            return in.fail(fmt::format("a {} does not have design.{}", mechanism.name, reading::quoted(name)));
    for (std::size_t i = 0; i < mechanism.dimensions.size(); ++i) {
        const Dimension& dimension = mechanism.dimensions[i];
        const std::string name(dimension.name);
        const Json* value = member(*design, name);
        if (value || dimension.required) claim.design[i] = dimension_number(in, claim, i, value, "design." + name);
    }
    if (const Json* kind = member(*design, of_design("kind"))) claim.kind = in.text(kind, "design.kind");
    const Json* assembly = member(*design, of_design("assembly"));
    if (!assembly || mechanism.assemblies.empty()) return;
    if (!mechanism.assembly_documents.empty()) {
        while (claim.assembly < mechanism.assemblies.size() &&
               Json::parse(mechanism.assembly_documents[claim.assembly]) != *assembly)
            ++claim.assembly;
        if (claim.assembly == mechanism.assemblies.size())
            in.fail("design.assembly does not say one side of each dyad, as the linkage allows");
        return;
    }
    const std::string name = in.text(assembly, "design.assembly");
    while (claim.assembly < mechanism.assemblies.size() && mechanism.assemblies[claim.assembly] != name)
        ++claim.assembly;
    if (claim.assembly == mechanism.assemblies.size())
        in.fail(fmt::format("a {} does not have the assembly {}", mechanism.name, reading::quoted(name)));
}

void read_circuit(Reader& in, const Json& document, Claim& claim) {
    if (!member(document, of_finding("circuit")) && !member(document, of_finding("branch"))) return;
    const auto count = [&](const char* name) {
        constexpr double most = 1e6;
        const double number = in.number(member(document, name), name);
        if (number >= 1 && number <= most && number == std::floor(number)) return static_cast<int>(number);
        in.fail(fmt::format("{} is no whole number from 1", name));
        return 0;
    };
    claim.circuit = CircuitAndBranch{count(of_finding("circuit")), count(of_finding("branch"))};
}

/// Whether inputs are angles, and not displacements.
bool is_angle(const Claim& claim) { return input_unit(*claim.mechanism) == Unit::angle; }

void read_crank_range(Reader& in, const Json& document, Claim& claim) {
    const Json* range = member(document, of_document("crank_range"));
    if (!range) return;
    const auto ends = in.numbers(range, "crank_range", 2, is_angle(claim));
    if (ends.size() != 2) return in.fail("crank_range is not [from, to]");
    claim.crank_range = Vector<double>{ends[0], ends[1]};
    if (!(ends[0] < ends[1])) in.fail("crank_range does not rise");
}

void read_range_of_use(Reader& in, const Json& document, Claim& claim) {
    const Json* json = member(document, of_document("range_of_use"));
    if (!json || !in.object(json, "range_of_use")) return;
    if (in.text(member(*json, of_use("from")), "range_of_use.from") != keys::use_begins[0] ||
        in.text(member(*json, of_use("to")), "range_of_use.to") != keys::use_ends[0])
        return in.fail("range_of_use is not from the first target to the last");
    const auto margin = [&](const char* name) {
        const std::string place = std::string("range_of_use.") + name;
        return is_angle(claim) ? in.angle(member(*json, name), place) : in.number(member(*json, name), place);
    };
    claim.use = RangeOfUse{margin(of_use("before")), margin(of_use("after"))};
    if (claim.use->before < 0 || claim.use->after < 0) in.fail("range_of_use ends before its targets do");
    if (claim.crank_range) in.fail("there are both a crank_range and a range_of_use");
    if (!member(document, of_document("path")) && !member(document, of_document("poses")))
        return in.fail("range_of_use has neither path nor poses beside it");
    const Json* used = member(document, of_finding("used_crank_angles"));
    if (!used) return;
    const auto ends = in.numbers(used, "used_crank_angles", 2, is_angle(claim));
    if (ends.size() != 2) return in.fail("used_crank_angles is not [from, to]");
    claim.used_angles = Vector<double>{ends[0], ends[1]};
}

void read_settings(Reader& in, const Json& document, Claim& claim) {
    const auto& settings = claim.mechanism->settings;
    for (std::size_t i = 0; i < settings.size(); ++i)
        claim.settings[i] = settings[i].preset;
    const Json* json = member(document, of_document("settings"));
    if (!json || !in.object(json, "settings")) return;
    for (const auto& [name, value] : json->items()) {
        const std::string place = "settings." + reading::quoted(name);
        const auto at =
            std::find_if(settings.begin(), settings.end(), [&](const Setting& s) { return s.name == name; });
        if (at == settings.end()) return in.fail(fmt::format("a {} does not have {}", claim.mechanism->name, place));
        const double number = in.number(&value, place);
        if (number != at->preset && !at->allows(number))
            in.fail(fmt::format("{} is {}, not between {} and {}", place, number, at->above, at->below));
        claim.settings[static_cast<std::size_t>(at - settings.begin())] =
            number * inner_per_file_unit(*at, claim.units);
    }
}

void read_requirements(Reader& in, const Json& document, Claim& claim) {
    const Json* list = member(document, of_document("requirements"));
    if (!list || !in.array(list, "requirements", most_entries)) return;
    for (std::size_t i = 0; i < list->size() && in.understood(); ++i) {
        const Json& one = (*list)[i];
        const std::string place = fmt::format("requirements[{}]", i);
        if (!in.object(&one, place)) return;
        const auto quantity = quantity_named(in, member(one, of_requirement("quantity")), place + ".quantity", claim);
        if (!quantity) return;
        const auto number = [&](const char* name) { return in.optional_number(member(one, name), place + "." + name); };
        ClaimedRequirement r{*quantity,
                             number(of_requirement("value")),
                             number(of_requirement("equal")),
                             number(of_requirement("min")),
                             number(of_requirement("max")),
                             number(of_requirement("violation")),
                             {}};
        if (const Json* active = member(one, of_requirement("active"))) r.active = in.flag(active, place + ".active");
        if (!r.equal && !r.min && !r.max) in.fail(place + " requires nothing: it has neither equal, min nor max");
        claim.requirements.push_back(r);
    }
}

std::optional<ClaimedTerm> read_term(Reader& in, const Json& json, const std::string& place, const Claim& claim) {
    const auto quantity = quantity_named(in, member(json, of_term("quantity")), place + ".quantity", claim);
    if (!quantity) return std::nullopt;
    const std::string sense = in.text(member(json, of_term("sense")), place + ".sense");
    if (sense != "maximize" && sense != "minimize") in.fail(place + ".sense is neither minimize nor maximize");
    const double weight = in.optional_number(member(json, of_term("weight")), place + ".weight").value_or(1);
    return ClaimedTerm{*quantity, sense == "maximize", weight,
                       in.optional_number(member(json, of_term("value")), place + ".value")};
}

void read_objective(Reader& in, const Json& document, Claim& claim) {
    const Json* json = member(document, of_document("objective"));
    if (!json || !in.object(json, "objective")) return;
    ClaimedObjective objective;
    objective.value = in.optional_number(member(*json, of_objective("value")), "objective.value");
    const Json* terms = member(*json, of_objective("terms"));
    if (!terms) {
        if (const auto term = read_term(in, *json, "objective", claim)) objective.terms.push_back(*term);
    } else if (in.array(terms, "objective.terms", most_entries)) {
        for (std::size_t i = 0; i < terms->size(); ++i) {
            const std::string place = fmt::format("objective.terms[{}]", i);
            if (!in.object(&(*terms)[i], place)) return;
            if (const auto term = read_term(in, (*terms)[i], place, claim)) objective.terms.push_back(*term);
        }
        const Json* reduce = member(*json, of_objective("reduce"));
        const std::string reduction = reduce ? in.text(reduce, "objective.reduce") : "sum";
        objective.worst = reduction == "max";
        if (reduction != "max" && reduction != "sum") in.fail("objective.reduce is neither sum nor max");
    }
    if (objective.terms.empty()) in.fail("objective has no terms");
    claim.objective = std::move(objective);
}

void read_wishes(Reader& in, const Json& document, Claim& claim) {
    const Json* list = member(document, of_document("wishes"));
    if (!list || !in.array(list, "wishes", most_entries)) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& json = (*list)[i];
        const std::string place = fmt::format("wishes[{}]", i);
        if (!in.object(&json, place)) return;
        const auto term = read_term(in, json, place, claim);
        const auto number = [&](std::string_view name) -> std::optional<double> {
            return in.optional_number(member(json, std::string(name)), fmt::format("{}.{}", place, name));
        };
        const double within = in.number(member(json, of_wish("within")), place + ".within");
        if (!term) return;
        claim.wishes.push_back(
            {term->quantity, term->maximize, within, number(of_wish("best")), number(of_wish("limit")), term->value});
    }
}

void read_quantities(Reader& in, const Json& document, Claim& claim) {
    const Json* json = member(document, of_document("quantities"));
    if (!json || !in.object(json, "quantities")) return;
    for (const auto& [name, value] : json->items()) {
        const std::string place = "quantities." + reading::quoted(name);
        const int index = find_quantity(*claim.mechanism, name);
        if (index < 0) return in.fail(fmt::format("a {} does not have {}", claim.mechanism->name, place));
        claim.quantities.emplace_back(static_cast<std::size_t>(index), in.number(&value, place));
    }
}

}  // namespace

ReadClaim read_claim(const Json& document) {
    Reader in;
    Claim claim;
    if (!document.is_object()) return {{}, "it is not a JSON object"};
    if (const Json* instant = member(document, of_document("instant"))) claim.has_instant = in.flag(instant, "instant");
    read_head(in, document, claim);
    if (const KindInDocuments* own = in.understood() ? kind_in_documents(*claim.mechanism) : nullptr)
        own->read(in, document, claim);
    for (const auto read :
         {read_given, read_design, read_circuit, read_crank_range, read_range_of_use, read_settings, read_over_input,
          read_requirements, read_objective, read_wishes, read_quantities, read_path})
        if (in.understood()) read(in, document, claim);
    return {std::move(claim), in.defect};
}

}  // namespace mechwright
