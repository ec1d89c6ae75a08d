#include "synthesis/report/text/explained.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "synthesis/mechanism/explanations/explanations.h"
#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/text.h"
#include "synthesis/report/names.h"
#include "synthesis/report/section_words.h"
#include "synthesis/report/signal_words.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

constexpr std::string_view over_whole =
    "the whole motion, in a problem that judges a part of it: [motion] from and to, or full_turn of a line";

using Mechanisms = std::vector<std::shared_ptr<const Mechanism>>;

/// "  label      text", folded; nothing for an empty text.
std::string line(std::string_view label, std::string_view text) {
    return text.empty() ? "" : folded(fmt::format("  {:<12}", label), text);
}

/// Where several mechanisms share a name: that name for all of them, else what each is ("cam with ...").
std::string listed_mechanisms(const Mechanisms& some) {
    const Mechanisms all = mechanisms();
    const auto count = [](const Mechanisms& among, const std::string& name) {
        return std::count_if(among.begin(), among.end(), [&](const auto& m) { return m->name == name; });
    };
    std::vector<std::string> names;
    for (const auto& mechanism : some) {
        const std::string& name = mechanism->name;
        if (count(some, name) < count(all, name))
            names.emplace_back(mechanism->meaning.substr(mechanism->meaning.find(name)));
        else if (names.empty() || names.back() != name)
            names.emplace_back(name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Each formula with the mechanisms for which it holds, where there are several.
std::string formulas_of(const Explanation& explanation, const Mechanisms& some) {
    std::string text;
    std::vector<FormulaText> used;
    for (const auto& mechanism : some)
        if (const auto formula = formula_for(explanation, *mechanism);
            formula && std::find(used.begin(), used.end(), *formula) == used.end())
            used.push_back(*formula);
    for (const FormulaText& formula : used) {
        std::string of;
        if (used.size() > 1) {
            Mechanisms holders = some;
            std::erase_if(holders, [&](const auto& m) { return formula_for(explanation, *m) != formula; });
            of = listed_mechanisms(holders) + ": ";
        }
        text += line(text.empty() ? "formula" : "", of + std::string(formula.text));
        text += line("", "[" + std::string(formula.source) + "]");
    }
    return text;
}

std::string snippet_of(const Explanation& explanation, std::string_view name) {
    const std::size_t equals = explanation.require.find(" = ");
    std::string text = fmt::format("\nIn a problem file:\n\n  [[require]]\n  quantity = \"{}\"\n  {:<8} = {}\n", name,
                                   explanation.require.substr(0, equals), explanation.require.substr(equals + 3));
    if (!explanation.objective.empty())
        text += fmt::format("\n  [objective]\n  {} = \"{}\"\n", explanation.objective, name);
    return text;
}

/// What else to look at: related names that several explanations share, without the one that is explained.
std::string others(std::string_view related, std::string_view name) {
    std::string list;
    while (!related.empty()) {
        const std::size_t comma = std::min(related.find(", "), related.size());
        const std::string_view one = related.substr(0, comma);
        if (one != name) list += (list.empty() ? "" : ", ") + std::string(one);
        related.remove_prefix(std::min(comma + 2, related.size()));
    }
    return list;
}

/// Whether a mechanism has the quantity, and over the whole motion where that is asked for.
bool has_quantity(const Mechanism& mechanism, std::string_view name, bool whole) {
    const int index = find_quantity(mechanism, name);
    return index >= 0 &&
           (!whole || (mechanism.input && mechanism.quantities[static_cast<std::size_t>(index)].of_motion));
}

std::string as_quantity(std::string_view asked, const Mechanisms& of, bool colour) {
    const std::string_view name = without_whole(asked);
    const bool whole = name != asked;
    Mechanisms with;
    std::copy_if(of.begin(), of.end(), std::back_inserter(with),
                 [&](const auto& m) { return has_quantity(*m, name, whole); });
    const Explanation* explanation = find_explanation(name);
    if (with.empty() || explanation == nullptr) return {};
    std::vector<std::string_view> units;
    for (const auto& mechanism : with) {
        const std::string_view unit =
            name_of(mechanism->quantities[static_cast<std::size_t>(find_quantity(*mechanism, name))].unit);
        if (std::find(units.begin(), units.end(), unit) == units.end()) units.push_back(unit);
    }
    return emphasised(asked, Emphasis::strong, colour) + fmt::format(": quantity, {}\n\n", fmt::join(units, " or ")) +
           folded("", explanation->what) + "\n" + line("of", listed_mechanisms(with)) +
           line("over", whole ? over_whole : explanation->over) + formulas_of(*explanation, with) +
           line("usual", explanation->usual) + line("undefined", explanation->undefined) +
           line("see also", others(explanation->related, name)) + snippet_of(*explanation, asked);
}

std::string kind_of(const Dimension& dimension) {
    const std::string also = dimension.required ? "" : "; 0 if left out";
    switch (dimension.kind) {
        case DimensionKind::length: return "length > 0" + also;
        case DimensionKind::coordinate: return "length of either sign" + also;
        case DimensionKind::angle: return "angle" + also;
        case DimensionKind::force: return "force" + also;
        case DimensionKind::rate: return "force over length" + also;
        case DimensionKind::number: return "number" + also;
    }
    return "";
}

std::string place_of(const Dimension& dimension) {
    if (dimension.of_segment) return "said by the [[segment]]s of the motion; results name it so";
    if (dimension.of_target) return "said in [function], [line] or [arc]; results name it so";
    return "said in [dimensions]: a number, or { min = ..., max = ... } to be designed";
}

/// How to see where the dimensions of mechanisms are; nothing for those that have no figure.
std::string figures_of(const Mechanisms& some) {
    std::vector<std::string> commands;
    for (const auto& mechanism : some) {
        if (!mechanism->drawing || mechanism->drawing->figure == nullptr) continue;
        std::string command = "mechwright draw --figure " + mechanism->name;
        if (std::find(commands.begin(), commands.end(), command) == commands.end())
            commands.push_back(std::move(command));
    }
    return line("figure", fmt::format("{}", fmt::join(commands, ", ")));
}

/// The meanings that a name has, each with the mechanisms that mean it.
struct Meaning {
    const Dimension* dimension;
    Mechanisms of;
};

std::vector<Meaning> meanings_of(std::string_view name, const Mechanisms& of) {
    std::vector<Meaning> meanings;
    for (const auto& mechanism : of) {
        const int index = find_dimension(*mechanism, name);
        if (index < 0) continue;
        const Dimension* dimension = &mechanism->dimensions[static_cast<std::size_t>(index)];
        const auto same = std::find_if(meanings.begin(), meanings.end(), [&](const Meaning& m) {
            return m.dimension->meaning == dimension->meaning && m.dimension->kind == dimension->kind;
        });
        if (same == meanings.end())
            meanings.push_back({dimension, {mechanism}});
        else
            same->of.push_back(mechanism);
    }
    return meanings;
}

std::string as_dimension(std::string_view name, const Mechanisms& of, bool colour) {
    std::string text;
    for (const Meaning& meaning : meanings_of(name, of)) {
        text += text.empty() ? emphasised(name, Emphasis::strong, colour) + ": dimension\n\n" : "\n";
        text += line("of", listed_mechanisms(meaning.of)) + line("is", meaning.dimension->meaning) +
                line("kind", kind_of(*meaning.dimension)) + line("where", place_of(*meaning.dimension)) +
                figures_of(meaning.of);
    }
    return text;
}

std::string as_setting(std::string_view name, const Mechanisms& of, bool colour) {
    std::string text;
    for (const auto& mechanism : of)
        for (const Setting& setting : mechanism->settings)
            if (setting.name == name && text.empty())
                text = emphasised(name, Emphasis::strong, colour) + ": setting\n\n" + line("is", setting.meaning) +
                       line("where", fmt::format("{} in [{}], {} if left out", name, setting.section, setting.preset));
    return text;
}

template <class Named>
std::string names_of(const Named& all) {
    std::vector<std::string_view> names;
    for (const auto& one : all)
        names.push_back(one.name);
    return reading::listed(names);
}

std::string as_mechanism(std::string_view name, const Mechanisms& of, bool colour) {
    std::string text;
    for (const auto& mechanism : of) {
        if (mechanism->name != name) continue;
        std::vector<Dimension> own;
        std::copy_if(mechanism->dimensions.begin(), mechanism->dimensions.end(), std::back_inserter(own),
                     [](const Dimension& d) { return !d.of_segment && !d.name.empty(); });
        if (!text.empty()) text += "\n";
        text += folded(emphasised(name, Emphasis::strong, colour) + ": ", mechanism->meaning) + "\n" +
                line("dimensions", names_of(own)) +
                line("assemblies", reading::listed(std::vector<std::string_view>(mechanism->assemblies.begin(),
                                                                                 mechanism->assemblies.end()))) +
                line("quantities", names_of(mechanism->quantities)) + line("settings", names_of(mechanism->settings)) +
                figures_of({mechanism});
    }
    return text.empty()
               ? text
               : text + fmt::format("\nA problem file to begin with: mechwright new --mechanism {} ...\n", name);
}

Explained unknown(std::string_view what, std::string_view name, std::span<const std::string_view> known) {
    const std::string_view nearest = nearest_name(name, known);
    return {{},
            fmt::format("unknown {} {}; {}", what, reading::quoted(name),
                        nearest.empty() ? "'mechwright quantities' lists what there is"
                                        : fmt::format("did you mean '{}'?", nearest))};
}

/// Why there is nothing to say of a name.
Explained not_explained(const std::string& name, const std::string& mechanism) {
    const std::vector<std::string> sections = section_names();
    std::vector<std::string_view> known = explained_names();
    const bool is_known = std::find(known.begin(), known.end(), name) != known.end();
    known.insert(known.end(), sections.begin(), sections.end());
    if (!is_known) return unknown("name", name, known);
    return {{}, fmt::format("a {0} has no {1}; 'mechwright quantities {0}' lists what it has", mechanism, name)};
}

}  // namespace

Explained explained(const std::string& name, const std::string& mechanism, bool colour) {
    Mechanisms of = mechanisms();
    std::erase_if(of, [&](const auto& m) { return !mechanism.empty() && m->name != mechanism; });
    if (of.empty()) return unknown("mechanism", mechanism, mechanism_names());
    std::vector<std::string> parts;
    for (const auto& part : {as_quantity, as_dimension, as_setting, as_mechanism})
        parts.push_back(part(name, of, colour));
    const bool of_links = std::any_of(of.begin(), of.end(), [](const auto& m) { return m->as_linkage.has_value(); });
    if (of_links) parts.push_back(explained_room(name));
    if (mechanism.empty()) {
        parts.push_back(explained_signal(name));
        parts.push_back(explained_section(name, colour));
    }
    std::string text;
    for (const std::string& part : parts)
        if (!part.empty()) text += (text.empty() ? "" : "\n") + part;
    return text.empty() ? not_explained(name, mechanism) : Explained{text, {}};
}

}  // namespace mechwright
