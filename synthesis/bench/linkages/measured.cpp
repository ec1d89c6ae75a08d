#include "synthesis/bench/linkages/measured.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "analysis/linkage/motion/driven.h"
#include "analysis/numbers/lanes.h"
#include "synthesis/bench/digits.h"
#include "synthesis/bench/kernels/lanes.h"
#include "synthesis/bench/linkages/blocks.h"
#include "synthesis/bench/shipped.h"
#include "synthesis/bench/timing.h"
#include "synthesis/mechanism/linkage/targets/needed_guidance.h"
#include "synthesis/report/files/run_program.h"

namespace mechwright::bench {

namespace {

constexpr std::string_view coupler_point = "the built-in coupler point";

Row row_of(std::string what, double median, std::string_view unit, std::string_view with, double that,
           std::string_view aim) {
    return {std::move(what), median, std::string(unit), std::string(with), that, median / that, std::string(aim)};
}

/// A four-bar that is no special one.
const CouplerPointKernel::Input& usual_one() {
    static const auto inputs = CouplerPointKernel::usual();
    return inputs[1];
}

/// A linkage of a problem, with what a pin depends on.
struct OfProblem {
    Problem problem;
    LinkageModel model;
    std::vector<double> dimensions;
};

OfProblem linkage_of_problem(const Effort& effort, std::string_view name, std::string_view pin) {
    auto problem = shipped_problem(effort.problems, name);
    if (!problem) throw std::runtime_error(fmt::format("there is no problem {}", name));
    OfProblem made{*std::move(problem), {}, {}};
    made.model = linkage_of(made.problem.mechanism->model.data());
    for (const DimensionRange& range : made.problem.dimensions)
        made.dimensions.push_back(range.start.value_or((range.min + range.max) / 2));
    const auto at = std::find(made.model.pins.begin(), made.model.pins.end(), pin);
    if (at == made.model.pins.end()) throw std::runtime_error(fmt::format("{} has no point {}", name, pin));
    GuidedPoint guided{static_cast<std::size_t>(at - made.model.pins.begin())};
    guided.needed = linkage::needed_of(made.model.structure, made.model.order, made.model.numbers.size(), guided.pin,
                                       linkage::none, false);
    made.model.guided = {std::move(guided)};
    return made;
}

PointOfLinkage jansens_foot(const Effort& effort) {
    const OfProblem leg = linkage_of_problem(effort, "linkage/jansen-leg", "T");
    return {leg.model.structure, leg.model.order, numbers_of(leg.model, std::span<const double>(leg.dimensions)),
            leg.model.sides.front(), leg.model.guided.front().needed};
}

/// A piece that places a point at one crank angle after the other; the design is set once.
Piece point_piece(const PointOfLinkage& l) {
    std::vector<double> row(l.needed.size);
    linkage::set_design<double, double>(l.needed, l.numbers, l.sides, row);
    return piece([&l, row](std::size_t k) mutable {
        linkage::set_input<double>(l.needed, 0, 0.01 * static_cast<double>(k % 600), row);
        linkage::place_needed<double>(l.needed, row);
        return Vector<double>{row[l.needed.point], row[l.needed.point + 1]};
    });
}

}  // namespace

std::vector<Row> measured_one_by_one(const Effort& effort) {
    const PointOfLinkage four_bar = four_bar_linkage(usual_one().x), foot = jansens_foot(effort);
    linkage::Driven<double> whole(four_bar.structure, four_bar.order, std::span<const double>(four_bar.numbers),
                                  four_bar.sides);
    const auto timings =
        timed({piece([](std::size_t k) {
                   return CouplerPointKernel::ours<0>(usual_one().x, 0.01 * static_cast<double>(k % 600));
               }),
               point_piece(four_bar), piece([&](std::size_t k) {
                   whole.place(0.01 * static_cast<double>(k % 600));
                   return whole.pose.pins.back();
               }),
               point_piece(foot)},
              effort.pick(5, 21), effort.pick(0.1, 1.0));
    const double kernel = 1e9 * timings[0].median;
    return {row_of("four-bar as a linkage", 1e9 * timings[1].median, "ns", coupler_point, kernel, "at most 1.5"),
            row_of("the same, all links placed", 1e9 * timings[2].median, "ns", coupler_point, kernel, ""),
            row_of("Jansen's foot", 1e9 * timings[3].median, "ns", coupler_point, kernel, "at most 6")};
}

std::vector<Row> measured_blocks(const Effort& effort) {
    const PointOfLinkage four_bar = four_bar_linkage(usual_one().x), foot = jansens_foot(effort);
    AngleBlock block = whole_turn();
    std::vector<Piece> pieces;
    std::vector<std::string_view> names;
    const auto add = [&](std::string_view name, const BlockOf& by) {
        names.push_back(name);
        const auto repeat = [&block](auto call) {
            return Piece([&block, call](benchmark::State& state) {
                for (auto _ : state) {
                    call();
                    benchmark::DoNotOptimize(block.x.data());
                    benchmark::ClobberMemory();
                }
            });
        };
        pieces.push_back(repeat([&block, by] { by.built_in(usual_one().x, block); }));
        pieces.push_back(repeat([&block, &four_bar, by] { by.linkage(four_bar, block); }));
        pieces.push_back(repeat([&block, &foot, by] { by.linkage(foot, block); }));
    };
    for (const auto& [set, name] : lane_names)
        if (is_available(set)) add(name, block_in_lanes(set));
    const auto timings = timed(pieces, effort.pick(5, 21), effort.pick(0.1, 1.0));
    constexpr double each = 1e9 / AngleBlock::count;
    std::vector<Row> rows;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double kernel = each * timings[3 * i].median, linkage = each * timings[3 * i + 1].median;
        rows.push_back(row_of(fmt::format("four-bar as a linkage, {}", names[i]), linkage, "ns", coupler_point, kernel,
                              "at most 1.67 (60 % of its rate)"));
        rows.push_back(row_of(fmt::format("Jansen's foot, {}", names[i]), each * timings[3 * i + 2].median, "ns",
                              coupler_point, kernel, "at most 8"));
    }
    return rows;
}

std::vector<Row> measured_gradients(const Effort& effort) {
    std::vector<Row> rows;
    for (const auto& [name, file, pin] : {std::array{"four-bar", "linkage/lambda-line", "P"},
                                          std::array{"six-bar", "linkage/six-bar-timed-points", "T"},
                                          std::array{"Jansen's foot", "linkage/jansen-leg", "T"}}) {
        const OfProblem of = linkage_of_problem(effort, file, pin);
        std::vector<double> arguments = of.dimensions;
        arguments.push_back(1);
        const auto at = [&](std::size_t k) {
            arguments.back() = 0.01 * static_cast<double>(k % 600);
            return NeededGuidance<double>(of.model, Form{}, arguments, false);
        };
        const auto timings = timed({piece([&](std::size_t k) {
                                        const auto guided = at(k);
                                        return guided.coordinate(0) + guided.coordinate(1);
                                    }),
                                    piece([&](std::size_t k) {
                                        auto guided = at(k);
                                        double sum = guided.coordinate(0) + guided.coordinate(1);
                                        for (const std::size_t c : {0, 1})
                                            sum += guided.gradient(c).front();
                                        return sum;
                                    })},
                                   effort.pick(5, 21), effort.pick(0.1, 1.0));
        rows.push_back(row_of(fmt::format("{}, {} dimensions", name, of.dimensions.size()), 1e9 * timings[1].median,
                              "ns", "value alone", 1e9 * timings[0].median, "at most 4"));
    }
    return rows;
}

std::vector<Row> measured_digits(const Effort&) {
    // Over all inputs: the least digits, and the greatest error in times the greatest change where one of the numbers
    // or the crank angle is perturbed by four units of the last place, up or down.
    double built_in = 16, linkage = 16, times_change = 0;
    const auto error = [](const auto& point, const Vector<Digits50>& exact) {
        const Digits50 x = Digits50(point.x) - exact.x, y = Digits50(point.y) - exact.y;
        return static_cast<double>(Digits50(sqrt((x * x + y * y) / (exact.x * exact.x + exact.y * exact.y))));
    };
    auto inputs = CouplerPointKernel::usual();
    for (const auto& hard : CouplerPointKernel::hard_ones())
        inputs.push_back(hard);
    constexpr double units = 4 * std::numeric_limits<double>::epsilon();
    for (const auto& in : inputs) {
        const PointOfLinkage l = four_bar_linkage(in.x);
        const std::vector<Digits50> numbers(l.numbers.begin(), l.numbers.end());
        const Vector<Digits50> exact = point_of<Digits50>(l, numbers, Digits50(in.at));
        built_in = std::min(built_in, digits_left(error(CouplerPointKernel::ours<0>(in.x, in.at), exact)));
        const double own = error(point_of<double>(l, l.numbers, in.at), exact);
        linkage = std::min(linkage, digits_left(own));
        double change = 0;
        for (std::size_t i = 0; i <= numbers.size(); ++i)
            for (const double by : {1 - units, 1 + units}) {
                std::vector<Digits50> moved = numbers;
                Digits50 at = in.at;
                (i < numbers.size() ? moved[i] : at) *= Digits50(by);
                change = std::max(change, error(point_of<Digits50>(l, moved, at), exact));
            }
        times_change = std::max(times_change, own / change);
    }
    return {row_of("least of the four-bar as a linkage", linkage, "digits", "the built-in four-bar", built_in, ""),
            row_of("its error where that is greatest", times_change, "times", "inputs perturbed by four units", 1,
                   "at most 1")};
}

std::vector<Row> measured_analysis(const Effort& effort) {
    // Jansen's leg with one more dyad on its foot.
    std::ifstream in(effort.problems / "linkage/jansen-leg.toml");
    std::string text(std::istreambuf_iterator<char>(in), {});
    const auto insert = [&](std::string_view before, std::string_view what) {
        const auto at = text.find(before);
        if (at == std::string::npos) throw std::runtime_error("jansen-leg.toml is another one");
        text.insert(at, what);
    };
    insert("[drive]", "lever = { Z = [0, 0], S = [90, 0] }\nlast-rod = { T = [0, 0], S = [90, 0] }\n\n");
    insert("[signals]", "S = { side = \"right\", from = \"Z\", to = \"T\" }\n\n");
    insert(", C = [\"a\"", ", Z = [-20, -150]");
    const auto file = std::filesystem::temp_directory_path() / "mechwright-ten-bar.toml";
    std::ofstream(file) << text;
    const auto run = [&](std::vector<std::string> words) {
        words.insert(words.begin(), effort.program.string());
        if (!run_program(words, "").succeeded()) throw std::runtime_error("mechwright fails");
        return 1e3 * timed([&] { run_program(words, ""); }, effort.pick(11, 51)).median;
    };
    const double analysed = run({"analyse", file.string()}), version = run({"--version"});
    std::filesystem::remove(file);
    return {row_of("`analyse` of a ten-bar", analysed, "ms", "`--version`", version, "at most 3")};
}

}  // namespace mechwright::bench
