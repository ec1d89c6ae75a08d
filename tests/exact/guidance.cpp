// Poses and points together: how many four-bars and slider-cranks there are, by monodromy, and that the four-bars that
// made the places are found.

#include <gtest/gtest.h>

#include <complex>
#include <random>

#include "analysis/four_bar.h"
#include "synthesis/exact/homotopy/certify.h"
#include "synthesis/exact/homotopy/guidance_linkages.h"
#include "tests/long_form.h"

namespace mechwright::homotopy {
namespace {

using S = GuidanceSystem;
using Number = std::complex<double>;

class Guidance : public ::testing::TestWithParam<GuidanceSystem> {
protected:
    GuidanceSystem system = GetParam();
};

std::string name_of_tested(const ::testing::TestParamInfo<GuidanceSystem>& tested) {
    return std::array{"Poses", "SliderCrank", "Inverted"}[static_cast<std::size_t>(tested.param.second)] +
           std::to_string(tested.param.poses);
}

INSTANTIATE_TEST_SUITE_P(Of, Guidance, ::testing::ValuesIn(every_system()), name_of_tested);

/// Newton's step of a linear system is right if the matrix holds the derivatives: against differences of the values.
TEST_P(Guidance, HasTheDerivativesOfItsEquations) {
    const StartSystem& start = start_system(system);
    GuidanceValues u = start.solutions[3];
    for (std::size_t i = 0; i < u.size(); ++i)
        u[i] = u[i] + Complex<double>{0.1, 0.05 * static_cast<double>(i)};
    const auto values = [&](const GuidanceValues& at, const GuidanceParameters& p) {
        Augmented<double, 8> a;
        system.linearise(at, p, static_cast<const GuidanceParameters*>(nullptr), a);
        std::array<Number, 8> f;
        for (std::size_t j = 0; j < 8; ++j)
            f[j] = {-a[j][8].re, -a[j][8].im};
        return f;
    };
    Augmented<double, 8> a, along_parameters;
    system.linearise(u, start.parameters, static_cast<const GuidanceParameters*>(nullptr), a);
    GuidanceParameters along = start.parameters;
    std::rotate(along.begin(), along.begin() + 1, along.end());
    system.linearise(u, start.parameters, &along, along_parameters);
    const double h = 1e-6;
    for (std::size_t i = 0; i <= 8; ++i) {
        GuidanceValues up = u, down = u;
        GuidanceParameters p_up = start.parameters, p_down = start.parameters;
        if (i < 8) {
            up[i].re += h;
            down[i].re -= h;
        } else {
            for (std::size_t k = 0; k < p_up.size(); ++k) {
                p_up[k] = p_up[k] + h * along[k];
                p_down[k] = p_down[k] - h * along[k];
            }
        }
        const auto f = values(up, p_up), g = values(down, p_down);
        for (std::size_t j = 0; j < 8; ++j) {
            const Number difference = (f[j] - g[j]) / (2 * h);
            const Complex<double>& entry = i < 8 ? a[j][i] : along_parameters[j][8];
            const Number exact = (i < 8 ? 1.0 : -1.0) * Number(entry.re, entry.im);
            EXPECT_LT(std::abs(difference - exact), 1e-5 * (1 + std::abs(exact))) << i << ' ' << j;
        }
    }
}

/// 60, 402, 2224 and 8652 ordered solutions have been remembered for these: 30, 201 and 1112 pairs, 1442 triplets; 558
/// slider-cranks through eight points, 279 pairs, have been printed (J. Mech. Des. 132, 081003, 2010).
/// Monodromy comes to a stop at these numbers, whatever the seed; the loops after the last new one are the evidence.
TEST_P(Guidance, HasAsManyOrbitsAsMonodromyFinds) {
    const std::size_t expected = orbits_of(system);
    if (!system.has_rocker() && system.poses <= 2 && !in_long_form()) GTEST_SKIP() << "of the long form";
    for (int seed = 21; seed < 21 + cases_to_try(1, 2); ++seed) {
        std::size_t known = 0;
        int loops_since_new = 0, loops = 0;
        const int most = system.poses <= 2 ? 18 : 30;
        make_start_system(system, static_cast<std::uint64_t>(seed), 2, most, 100000, [&](std::size_t now, int loop) {
            loops = loop;
            loops_since_new = now == known ? loops_since_new + 1 : 0;
            known = now;
        });
        EXPECT_EQ(known, expected) << seed;
        EXPECT_GE(loops_since_new, 2) << seed << " after " << loops;
    }
}

TEST_P(Guidance, HasAStartSystemThatIsReadAsItIsWritten) {
    const StartSystem& start = start_system(system);
    EXPECT_EQ(start.system, system);
    EXPECT_EQ(start.solutions.size(), orbits_of(system));
    const std::string text = to_text(start, 1);
    const ReadStart read = parse_start_system(text);
    ASSERT_TRUE(read.start) << read.fault;
    EXPECT_EQ(read.start->system, system);
    for (std::size_t k = 0; k < start.solutions.size(); k += 7)
        EXPECT_TRUE(is_same(orbit_of(system, start.solutions[k]), orbit_of(system, read.start->solutions[k])));
    EXPECT_NE(parse_start_system(text.substr(0, text.size() - 40)).fault.find("damaged"), std::string::npos);
}

struct Made {
    PathLinkage<double> linkage;
    std::vector<GuidedPlace> places;
};

/// Places of a random four-bar, so many of them poses, anywhere among the others.
std::optional<Made> made_from(std::mt19937_64& random, std::size_t poses) {
    std::uniform_real_distribution<double> between(0, 1);
    Made made;
    made.linkage = {{1, 0.2 + between(random), 0.2 + 2 * between(random), 0.2 + 2 * between(random)},
                    {2 * between(random) - 0.5, 2 * between(random) - 1},
                    {{between(random), between(random)}, 6 * between(random)},
                    Assembly::open};
    const double from = 6.28 * between(random), span = 2 + 4 * between(random);
    const std::size_t count = 10 - poses;
    std::vector<bool> is_pose(count, false);
    std::fill_n(is_pose.begin(), poses, true);
    std::shuffle(is_pose.begin(), is_pose.end(), random);
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = from + span * static_cast<double>(i) / static_cast<double>(count);
        const auto p = pose(made.linkage.links, angle, Assembly::open);
        if (!(p.margins.stretch > 1e-2 && p.margins.fold > 1e-2)) return {};
        const auto at = placed(position(made.linkage.links, made.linkage.point, p), made.linkage.placement);
        const double direction = std::atan2(p.coupler.y, p.coupler.x) + made.linkage.placement.tilt;
        made.places.push_back({{at.x, at.y}, is_pose[i] ? std::optional(direction) : std::nullopt});
    }
    return made;
}

TEST_P(Guidance, FindsTheFourBarThatMadeThePlaces) {
    if (!system.has_rocker()) GTEST_SKIP() << "see slider_crank_places.cpp";
    std::mt19937_64 random(29 + system.poses);
    const int wanted = system.poses <= 2 ? cases_to_try(2, 4) : cases_to_try(10, 30);
    int found_again = 0, complete = 0;
    for (int k = 0; k < wanted;) {
        const auto made = made_from(random, system.poses);
        if (!made) continue;
        ++k;
        const GuidanceTarget target = guidance_target(made->places);
        ASSERT_EQ(target.system.poses, system.poses);
        const GuidanceSolutions found = solve_guidance(start_system(system), target.parameters, 2);
        complete += found.complete();
        const auto exact = exact_parameters(target, made->places);
        bool generated = false;
        for (const GuidanceValues& solution : found.solutions) {
            if (!is_real(solution)) continue;
            const auto proof = certify(system, solution, exact);
            EXPECT_TRUE(proof && proof->real);
            for (const GuidanceValues& member : orbit_members(system, solution)) {
                const auto linkage = linkage_of(member, target);
                if (!linkage) continue;
                const FourBar<double>&a = linkage->linkage.links, &b = made->linkage.links;
                generated = generated || std::abs(a.ground - b.ground) + std::abs(a.crank - b.crank) +
                                                 std::abs(a.coupler - b.coupler) + std::abs(a.rocker - b.rocker) <
                                             1e-6;
            }
        }
        found_again += generated;
    }
    EXPECT_EQ(found_again, wanted);
    EXPECT_EQ(complete, wanted);
}

/// Everything that a ball encloses stays enclosed.
TEST(Balls, EncloseWhatTheirNumbersGive) {
    std::mt19937_64 random(31);
    std::uniform_real_distribution<double> between(-2, 2);
    for (int k = 0; k < 1000; ++k) {
        const double a = between(random), b = between(random), ra = 1e-3 * std::abs(between(random)),
                     rb = 1e-20 * std::abs(between(random));
        const Ball x(Digits50(a), ra), y(Digits50(b), rb);
        for (const double s : {-1.0, -0.3, 1.0})
            for (const double t : {-1.0, 0.5, 1.0}) {
                const Digits50 u = Digits50(a) + s * Digits50(ra), v = Digits50(b) + t * Digits50(rb);
                const auto encloses = [](const Ball& ball, const Digits50& value) {
                    return abs(value - ball.middle()) <= ball.radius();
                };
                EXPECT_TRUE(encloses(x + y, u + v));
                EXPECT_TRUE(encloses(x - y, u - v));
                EXPECT_TRUE(encloses(x * y, u * v));
                EXPECT_TRUE(encloses(-x, -u));
                EXPECT_GE(x.magnitude(), abs(u));
            }
    }
}

/// A point that is no solution has no certificate, and a solution that lies a little off is found from there.
TEST(Certificates, AreGivenToSolutionsAlone) {
    const GuidanceSystem system{3};
    const StartSystem& start = start_system(system);
    S::Parameters<Digits50> p;
    for (std::size_t i = 0; i < p.size(); ++i)
        p[i] = {Digits50(start.parameters[i].re), Digits50(start.parameters[i].im)};
    for (std::size_t k = 0; k < start.solutions.size(); k += 20) {
        const auto proof = certify(system, start.solutions[k], p);
        ASSERT_TRUE(proof);
        EXPECT_FALSE(proof->real);  // generic parameters have no real solutions
        EXPECT_LT(proof->radius, 1e-15);
        GuidanceValues off = start.solutions[k];
        off[3].re += 1e-6;
        const auto again = certify(system, off, p);
        ASSERT_TRUE(again);
        EXPECT_LT(abs(again->solution[3].re - proof->solution[3].re), 1e-38);
    }
    // Both dyads the same: the points' equations hold for any turn there, and their derivatives vanish.
    GuidanceValues same = start.solutions[0];
    for (std::size_t i = 0; i < 4; ++i)
        same[4 + i] = same[i];
    const auto none = certify(system, same, p);
    EXPECT_FALSE(none && norm(Complex<double>{none->solution[0].re.convert_to<double>() - same[0].re, 0}) < 1e-20);
}

}  // namespace
}  // namespace mechwright::homotopy
