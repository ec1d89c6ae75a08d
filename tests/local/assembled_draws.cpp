// Draws that assemble at every target of a path, looked at eight side by side: the same as one by one.

#include "synthesis/search/assembled_draws.h"

#include <gtest/gtest.h>

#include <bit>
#include <string>

#include "synthesis/mechanism/linkage/targets/margins_in_lanes.h"
#include "synthesis/problem/reader.h"
#include "synthesis/search/draws.h"
#include "synthesis/target/path/fit.h"
#include "synthesis/target/path/rows/path_outputs.h"

namespace mechwright {
namespace {

constexpr std::array shipped_linkages_with_targets{
    "excavator-bucket",     "function-and-path",    "garage-door",           "hood-hinge-in-bay",
    "jansen-foot-and-knee", "six-bar-timed-points", "six-bar-path-and-poses"};

/// Calls use(program) for the first few variants of those of them whose guided points close in dyads.
template <class Use>
int for_linkages_in_lanes(const Use& use) {
    int seen = 0;
    for (const char* name : shipped_linkages_with_targets) {
        SCOPED_TRACE(name);
        const ReadProblem read = read_problem(std::string(MECHWRIGHT_SOURCE_DIR "/problems/linkage/") + name + ".toml");
        if (!has_margins_in_lanes(*read.problem.mechanism)) continue;
        const auto all = variants(read.problem);
        for (std::size_t v = 0; v < std::min<std::size_t>(all.size(), 3); ++v) {
            use(build_program(read.problem, all[v]));
            ++seen;
        }
    }
    return seen;
}

double margin_one_by_one(const Program& program, const Eigen::VectorXd& x, std::size_t target) {
    const std::vector<double> dimensions = dimensions_at(program, x);
    PathMiss miss{};
    miss_of_point(*program.problem->mechanism, program.form(program.problem->path->target_of(target)), dimensions,
                  path_angle(program, dimensions, x, target).angle, {0, 0}, miss);
    return miss.margin;
}

void expect_margins_alike(const Program& program, const std::vector<Eigen::VectorXd>& draws, std::size_t target,
                          InstructionSet set) {
    const PointGuidance& point = *program.problem->mechanism->point;
    std::array<Group, Reads::most> arguments{};
    std::array<double, Reads::most> room;
    Group angles{};
    std::size_t reads = 0;
    for (std::size_t lane = 0; lane < 8; ++lane) {
        const std::vector<double> dimensions = dimensions_at(program, draws[lane]);
        const auto own = point.reads.of(dimensions, room);
        reads = own.size();
        for (std::size_t i = 0; i < reads; ++i)
            arguments[i][lane] = own[i];
        angles[lane] = path_angle(program, dimensions, draws[lane], target).angle;
    }
    const Group margins = margins_in_lanes(set, program.form(program.problem->path->target_of(target)),
                                           std::span(arguments).first(reads), angles);
    for (std::size_t lane = 0; lane < 8; ++lane)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(margins[lane]),
                  std::bit_cast<std::uint64_t>(margin_one_by_one(program, draws[lane], target)))
            << "lane " << lane << " of set " << static_cast<int>(set);
}

TEST(AssembledDraws, HaveMarginsInLanesWithTheBitsOfOneByOne) {
    const int seen = for_linkages_in_lanes([](const Program& program) {
        const Draws draw(program, 5);
        for (std::uint64_t k = 0; k < 400; k += 8) {
            std::vector<Eigen::VectorXd> draws;
            for (std::uint64_t i = k; i < k + 8; ++i)
                draws.push_back(draw(i));
            for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
                if (is_available(set)) expect_margins_alike(program, draws, k % program.targets.size(), set);
        }
    });
    EXPECT_GE(seen, 6);
}

TEST(AssembledDraws, AreThoseThatAssembleOneByOne) {
    long assembled = 0;
    for_linkages_in_lanes([&](const Program& program) {
        const Draws draw(program, 6);
        std::vector<NumberedDraw> draws;
        for (std::uint64_t k = 0; k < 1000; ++k)
            draws.push_back({k, draw(k)});
        std::vector<std::uint64_t> one_by_one, together;
        for (const NumberedDraw& d : draws)
            if (Eigen::VectorXd x = d.x; fit_assembled(program, x)) one_by_one.push_back(d.number);
        keep_assembled(program, draws);
        for (const NumberedDraw& d : draws) {
            together.push_back(d.number);
            EXPECT_EQ(d.x, draw(d.number));
        }
        EXPECT_EQ(together, one_by_one);
        assembled += static_cast<long>(together.size());
    });
    EXPECT_GT(assembled, 50);
}

}  // namespace
}  // namespace mechwright
