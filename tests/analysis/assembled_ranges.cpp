// The crank angles at which drives assemble that cannot turn fully, however few they are.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "analysis/quick_return.h"
#include "tests/analysis/random_linkages.h"

namespace mechwright {

namespace {

bool is_assembled(const DragLink<double>& m, double crank_angle) {
    const auto p = pose_at(m, crank_angle);
    return p.input.assembled() && p.output.assembled();
}

/// A drag link whose rod is longer by `spare` than it has to be at one of the crank angles at which its four-bar, that
/// does not turn fully, assembles; or nothing.
std::optional<DragLink<double>> barely_assembled(test::Random& random) {
    const auto length = [&] { return random.log_between(10, 100); };
    const FourBar<double> links{length(), length(), length(), length()};
    DragLink<double> m{links, length(), random.angle(), 1e4, random.angle(), random.between(-10, 10)};
    const double spare = random.log_between(1e-6, 10);
    const CrankRange<double> input = assembled_range(m.links);
    if (input.full_turn || input.from > input.to) return std::nullopt;
    double least = m.rod;
    for (double share = 0; share <= 1; share += 1.0 / 256)
        least = std::min(least, m.rod - detail::rod_margin(m, input.from + share * (input.to - input.from)));
    m.rod = least + spare;
    if (!(m.rod > 0)) return std::nullopt;
    return m;
}

TEST(AssembledRange, OfADragLinkIsFoundHoweverNarrow) {
    test::Random random(7);
    int narrow = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto m = barely_assembled(random);
        if (!m) continue;
        const CrankRange<double> range = assembled_range(*m);
        const double width = range.to - range.from;
        ASSERT_GT(width, 0) << i;
        narrow += width < 3e-4 ? 1 : 0;
        EXPECT_TRUE(is_assembled(*m, range.from + 0.5 * width)) << i;
        const double beyond = 1e-6 * width + 1e-14;
        EXPECT_FALSE(is_assembled(*m, range.from - beyond)) << i;
        EXPECT_FALSE(is_assembled(*m, range.to + beyond)) << i;
    }
    EXPECT_GT(narrow, 100);
}

/// Where the rod reaches the slide only while its end is next to a turning point.
TEST(AssembledRange, OfASliderCrankCanBeNarrow) {
    for (const double half : {0.1, 1e-3, 1e-6}) {
        SCOPED_TRACE(half);
        // The height of the crank pin over a slide that lies high is least too great at a right angle.
        const double missing = 40 * 2 * std::pow(std::sin(half / 2), 2);
        const SliderCrank<double> m{40, 10 + missing, 50};
        const CrankRange<double> range = assembled_range(m);
        EXPECT_NEAR(range.from, std::numbers::pi / 2 - half, 1e-9 * half + 1e-15 / half);
        EXPECT_NEAR(range.to, std::numbers::pi / 2 + half, 1e-9 * half + 1e-15 / half);
    }
}

}  // namespace

}  // namespace mechwright
