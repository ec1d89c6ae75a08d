// mechwright explain: every name of the registry has an explanation, and each says what it should.

#include <toml++/toml.h>

#include "synthesis/mechanism/explanations/explanations.h"
#include "synthesis/report/names.h"
#include "synthesis/report/section_words.h"
#include "tests/command_line/program.h"

namespace mechwright::testing {
namespace {

std::string explained(const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"explain"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run(all);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
}

TEST(Explanations, ThereIsAFormulaForEveryQuantityOfEveryMechanism) {
    for (const auto& mechanism : mechanisms())
        for (const Quantity& quantity : mechanism->quantities) {
            const Explanation* explanation = find_explanation(quantity.name);
            ASSERT_NE(explanation, nullptr) << quantity.name;
            const auto formula = formula_for(*explanation, *mechanism);
            ASSERT_TRUE(formula) << quantity.name << " of " << mechanism->meaning;
            EXPECT_FALSE(formula->text.empty() || formula->source.empty()) << quantity.name;
            EXPECT_FALSE(explanation->what.empty() || explanation->over.empty() || explanation->usual.empty())
                << quantity.name;
        }
}

TEST(Explanations, AreOfQuantitiesThatThereAreAndEachFormulaIsUsed) {
    for (const Explanation& explanation : explanations()) {
        std::vector<FormulaText> used;
        for (const auto& mechanism : mechanisms())
            if (find_quantity(*mechanism, explanation.name) >= 0) used.push_back(*formula_for(explanation, *mechanism));
        EXPECT_FALSE(used.empty()) << explanation.name;
        for (const Formula& formula : explanation.formulas)
            EXPECT_NE(std::find(used.begin(), used.end(), FormulaText{formula.text, formula.source}), used.end())
                << explanation.name << formula.of;
    }
    for (const auto& mechanism : mechanisms())
        for (const QuantityFormula& own : mechanism->formulas) {
            EXPECT_GE(find_quantity(*mechanism, own.quantity), 0) << own.quantity << " of " << mechanism->name;
            EXPECT_NE(find_explanation(own.quantity), nullptr) << own.quantity;
        }
}

TEST(Explanations, PointToNamesThatAreExplained) {
    const std::vector<std::string_view> known = explained_names();
    for (const Explanation& explanation : explanations()) {
        std::istringstream related{std::string(explanation.related)};
        for (std::string name; std::getline(related >> std::ws, name, ',');)
            EXPECT_NE(std::find(known.begin(), known.end(), name), known.end()) << explanation.name << ": " << name;
    }
}

TEST(Explain, SaysFormulaAndUsualValuesOfEveryQuantity) {
    for (const auto& mechanism : mechanisms())
        for (const Quantity& quantity : mechanism->quantities) {
            const std::string text = explained({std::string(quantity.name), std::string(mechanism->name)});
            for (const char* part : {"\n  of          ", "\n  formula     ", "\n  usual       ", "[[require]]"})
                expect_has(text, part);
        }
}

TEST(Explain, KnowsEveryNameAndFitsEightyColumns) {
    for (const std::string_view name : explained_names()) {
        const std::string text = explained({std::string(name)});
        EXPECT_EQ(text.rfind(std::string(name) + ": ", 0), 0u) << text;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);)
            EXPECT_LE(line.size(), 80u) << line;
    }
}

/// What the example in an explanation says can be said in a problem file.
TEST(Explain, ShowsTomlThatCanBeRead) {
    for (const Explanation& explanation : explanations()) {
        const std::string text = explained({std::string(explanation.name)});
        const std::string marker = "In a problem file:\n";
        const std::size_t from = text.find(marker) + marker.size();
        // A quantity that is a dimension too goes on with that.
        const toml::parse_result parsed =
            toml::parse(text.substr(from, text.find("\n" + std::string(explanation.name) + ": ", from) - from));
        const auto* requirements = parsed["require"].as_array();
        ASSERT_NE(requirements, nullptr) << text;
        const toml::table& required = *requirements->get(0)->as_table();
        EXPECT_EQ(required["quantity"].value<std::string>(), explanation.name);
        EXPECT_TRUE(required.contains("min") || required.contains("max") || required.contains("equal")) << text;
        EXPECT_EQ(parsed.contains("objective"), !explanation.objective.empty());
    }
}

TEST(Explain, GivesEachMechanismItsOwnFormula) {
    expect_has(explained({"stroke", "whitworth"}), "  formula     2 arm over a full turn\n");
    expect_has(explained({"stroke", "crank-shaper"}),
               "  formula     2 lever crank / centre-distance over a full turn\n");
    const std::string all = explained({"stroke"});
    for (const char* part : {"whitworth: 2 arm", "crank-shaper: 2 lever", "slider-crank: sqrt", "drag-link: sqrt"})
        expect_has(all, part);
    // A drag link contains a four-bar, and yet is none.
    expect_has(explained({"transmission-angle-worst", "drag-link"}), "at the ram");
    expect_has_not(explained({"transmission-angle-worst", "four-bar"}), "ram");
    expect_has(explained({"pressure-angle-max", "cam"}), "cam with translating flat-faced follower");
}

TEST(Explain, KnowsDimensionsSettingsAndMechanisms) {
    const std::string crank = explained({"crank", "whitworth"});
    for (const char* part : {"crank: dimension", "longer than the centre distance", "length > 0"})
        expect_has(crank, part);
    expect_has(explained({"working-share"}), "0.6 if left out");
    const std::string four_bar = explained({"four-bar"});
    for (const char* part : {"dimensions  ground, crank", "assemblies  open, crossed", "quantities  time-ratio"})
        expect_has(four_bar, part);
    for (const char* name : {"four-bar", "body-angle", "input-start"})
        expect_has(explained({name}), "mechwright draw --figure four-bar");
    const std::string both = explained({"prime-radius"});
    expect_has(both, "prime-radius: quantity, length");
    expect_has(both, "prime-radius: dimension");
}

TEST(Explain, TellsWhatSignalsAreAndWhatIsMadeOfThem) {
    const Outcome quantity = run({"explain", "foot.speed.greatest(10, 50)"});
    EXPECT_EQ(quantity.exit_code, 0);
    for (const char* part : {"'foot', as [signals]", "first derivative", "greatest value", "through a full turn"})
        expect_has(quantity.out, part);
    for (const char* word : {"angle", "from-line", "curvature-of", "deviation", "jerk", "signals", "time-ratio"}) {
        const Outcome one = run({"explain", word});
        EXPECT_EQ(one.exit_code, 0) << one.err;
        expect_has(one.out, "signal");
    }
    for (const char* wrong : {"foot.sped.greatest", "foot.speed", "foot.greatest.least", "foot."})
        EXPECT_EQ(run({"explain", wrong}).exit_code, 2) << wrong;
}

TEST(Explain, TellsWhatRoomsAndRegionsAreMeasuredBy) {
    for (const char* name : {"bay.margin", "drive.width", "drive.area.whole"}) {
        EXPECT_EQ(explained({name}), explained({name, "four-bar"}));
        expect_has(explained({name}), "of a room or region");
    }
    EXPECT_EQ(run({"explain", "bay.margin", "cam"}).exit_code, 2);
}

TEST(Explain, KnowsSectionsAndKeysOfProblemFiles) {
    const std::string path = explained({"path"});
    for (const char* part :
         {"[path]: section of a problem file",
          "  timing        \"free\", \"prescribed\" or \"none\": free:", "  points        [[x, y], ...]: Points"})
        expect_has(path, part);
    expect_has(explained({"require"}), "[[require]]: section");
    expect_has(explained({"function.input"}), "  start  number, { min, max } or sum of dimensions, needed: ");
    const std::string timing = explained({"timing"});
    for (const char* part : {"timing: key of a problem file", "in [path] ", "in [poses] "})
        expect_has(timing, part);
    expect_has_not(explained({"path.timing"}), "[poses]");
    expect_has(explained({"time_limit"}), "number above 0 to 1e+09");
    expect_has(explained({"title"}), "the file ");
    for (const std::string& name : section_names()) {
        std::istringstream lines(explained_section(name, false));
        for (std::string line; std::getline(lines, line);)
            EXPECT_LE(line.size(), 80u) << line;
    }
    expect_has(run({"explain", "timming"}).err, "did you mean 'timing'?");
    expect_has(run({"schema", "result", "--markdown"}).err, "leave it out");
}

TEST(Explain, AnswersUnknownNamesWithTheNearest) {
    const auto refused = [](const std::vector<std::string>& arguments, const std::string& why) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        expect_has(outcome.err, why);
    };
    refused({"explain", "swin"}, "unknown name 'swin'; did you mean 'swing'?");
    refused({"explain", "quite-another-thing"}, "'mechwright quantities' lists what there is");
    refused({"explain", "swing", "for-bar"}, "unknown mechanism 'for-bar'; did you mean 'four-bar'?");
    refused({"explain", "swing", "cam"}, "a cam has no swing");
    refused({"explain"}, "QUANTITY is required");
}

}  // namespace
}  // namespace mechwright::testing
