// The range of motion as verification derives it: the same as that of the analysis for random designs of every kind,
// and documents whose values belong to a motion that is cut off or goes on are noticed.

#include "synthesis/verify/motion_again.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "tests/long_form.h"
#include "tests/verify/documents.h"

namespace mechwright {

namespace {

using namespace test;

std::vector<double> random_dimensions(const Mechanism& mechanism, std::mt19937& random) {
    std::uniform_real_distribution<double> part(0, 1);
    std::vector<double> d;
    for (const Dimension& dimension : mechanism.dimensions) {
        const double u = part(random);
        if (!dimension.required && dimension.kind != DimensionKind::length)
            d.push_back(0);
        else if (dimension.kind == DimensionKind::length)
            d.push_back(std::exp(3 + 1.2 * u));
        else
            d.push_back(dimension.kind == DimensionKind::angle ? 6 * u - 3 : 60 * u - 30);
    }
    return d;
}

struct Both {
    std::vector<double> dimensions;
    std::size_t assembly;
    Motion analysis;
    Motion again;
};

Both both_of(const Mechanism& mechanism, const std::vector<double>& d, std::size_t assembly) {
    const std::vector<Digits50> digits(d.begin(), d.end());
    Both both{d, assembly, motion_of(mechanism, d, assembly, nullptr),
              motion_again(mechanism, assembly, digits, std::nullopt)};
    for (std::size_t i = 0; i < mechanism.settings.size(); ++i)
        both.analysis.settings[i] = mechanism.settings[i].preset;
    return both;
}

constexpr std::array<const char*, 5> kinds{"four-bar", "slider-crank", "crank-shaper", "whitworth", "drag-link"};

TEST(MotionAgain, IsThatOfTheAnalysis) {
    std::mt19937 random(5);
    for (const char* kind : kinds) {
        const Mechanism& mechanism = *find_mechanism(kind);
        int limited = 0, full = 0, none = 0;
        for (int i = 0; i < cases_to_try(50, 200); ++i) {
            const auto d = random_dimensions(mechanism, random);
            const Both b = both_of(mechanism, d, mechanism.assemblies.empty() ? 0 : static_cast<std::size_t>(i) % 2);
            std::string place = kind;
            for (const double x : d)
                place += " " + std::to_string(x);
            ASSERT_EQ(b.again.full_turn, b.analysis.full_turn) << place;
            ASSERT_EQ(b.again.family, b.analysis.family) << place;
            const bool exists = b.analysis.from <= b.analysis.to;
            // What is narrower than its steps of a degree the analysis does not see.
            if (!exists && b.again.to - b.again.from < 0.02) continue;
            ASSERT_EQ(b.again.from <= b.again.to, exists) << place;
            ++(b.analysis.full_turn ? full : exists ? limited : none);
            if (!exists) continue;
            EXPECT_NEAR(b.again.from, b.analysis.from, 1e-9) << place;
            EXPECT_NEAR(b.again.to, b.analysis.to, 1e-9) << place;
        }
        EXPECT_GT(full, cases_to_try(2, 10)) << kind;
        EXPECT_GT(limited, cases_to_try(2, 10)) << kind;
    }
}

TEST(MotionAgain, OfChangePointsIsExact) {
    const Mechanism& mechanism = *find_mechanism("four-bar");
    for (const std::vector<double>& links : std::vector<std::vector<double>>{
             {3, 1, 3, 1}, {2, 2, 5, 5}, {5, 2, 2, 5}, {0.3, 0.1, 0.3, 0.1}, {1, 0.25, 1.5, 0.75}}) {
        std::vector<double> d(mechanism.dimensions.size(), 0.0);
        std::copy(links.begin(), links.end(), d.begin());
        const Both b = both_of(mechanism, d, 0);
        EXPECT_TRUE(b.again.full_turn);
        EXPECT_EQ(b.again.family, b.analysis.family);
        d[2] = std::nextafter(d[2], 100);  // longer than the rocker by so much that the crank just passes, or not
        const Both longer = both_of(mechanism, d, 0);
        EXPECT_EQ(longer.again.full_turn, longer.analysis.full_turn);
        EXPECT_NEAR(longer.again.from, longer.analysis.from, 1e-12);
    }
}

/// A document of a design whose quantities are measured over a motion.
Json document_over(const Mechanism& mechanism, const Both& b, const Motion& motion) {
    Json json{{"schema", 1}, {"problem", {{"mechanism", mechanism.name}}}, {"units", {{"angle", "rad"}}}};
    const std::vector<Digits50> digits(b.dimensions.begin(), b.dimensions.end());
    for (std::size_t i = 0; i < b.dimensions.size(); ++i)  // and no numbers of targets: there are none
        if (mechanism.dimensions[i].required || b.dimensions[i] != 0)
            json["dimensions"][std::string(mechanism.dimensions[i].name)] =
                json["design"][std::string(mechanism.dimensions[i].name)] = b.dimensions[i];
    if (!mechanism.assemblies.empty()) json["design"]["assembly"] = mechanism.assemblies[b.assembly];
    for (const Quantity& q : mechanism.quantities) {
        if (q.path != PathMeasure::none || !q.section.empty() || !q.defined(motion)) continue;
        const Digits50 value = measure_again(q, motion, digits);
        if (isfinite(value) && value < 1e6) json["quantities"][std::string(q.name)] = value.convert_to<double>();
    }
    return json;
}

/// Whether nothing that was measured differs by more than a millionth.
bool alike(const Json& a, const Json& b) {
    if (a.size() != b.size()) return false;
    for (const auto& [name, value] : a.items())
        if (!b.contains(name) || std::abs(value.get<double>() / b[name].get<double>() - 1) > 1e-6) return false;
    return true;
}

TEST(MotionAgain, NoticesAMotionThatIsCutOffOrGoesOn) {
    std::mt19937 random(6);
    for (const char* kind : kinds) {
        const Mechanism& mechanism = *find_mechanism(kind);
        int noticed = 0;
        const int wanted = cases_to_try(1, 3);
        for (int i = 0; i < 200 && noticed < wanted; ++i) {
            const Both b = both_of(mechanism, random_dimensions(mechanism, random), 0);
            if (b.analysis.full_turn || !(b.analysis.to - b.analysis.from > 1)) continue;
            if (!failures(document_over(mechanism, b, b.analysis)).empty()) continue;  // not a mechanism of its kind
            for (const double change : {-0.2, 0.2})
                for (const bool end : {false, true}) {
                    Motion other = b.analysis;
                    (end ? other.to : other.from) += change;
                    const Json wrong = document_over(mechanism, b, other),
                               right = document_over(mechanism, b, b.analysis);
                    if (alike(wrong["quantities"], right["quantities"])) continue;
                    EXPECT_FALSE(failures(wrong).empty()) << kind << ' ' << change;
                }
            ++noticed;
        }
        EXPECT_EQ(noticed, wanted) << kind;
    }
}

TEST(MotionAgain, NoticesATurnThatIsNone) {
    for (const char* kind : kinds) {
        const Mechanism& mechanism = *find_mechanism(kind);
        std::mt19937 random(7);
        int noticed = 0;
        for (int i = 0; i < 300 && noticed < 3; ++i) {
            const Both b = both_of(mechanism, random_dimensions(mechanism, random), 0);
            if (!b.analysis.full_turn) continue;
            if (!failures(document_over(mechanism, b, b.analysis)).empty()) continue;
            Motion other = b.analysis;
            other.full_turn = false;
            other.family = mechanism.families.size() - 1;
            other.from = 0.5;
            other.to = 2.5;
            EXPECT_FALSE(failures(document_over(mechanism, b, other)).empty()) << kind;
            ++noticed;
        }
        EXPECT_EQ(noticed, 3) << kind;
    }
}

}  // namespace

}  // namespace mechwright
