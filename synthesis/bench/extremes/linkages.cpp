#include <numbers>

#include "analysis/four_bar.h"
#include "synthesis/bench/extremes/cases.h"
#include "synthesis/bench/extremes/given_design.h"

namespace mechwright::bench {

namespace {

constexpr std::size_t mechanisms = 16;
constexpr double turn = 2 * std::numbers::pi;

constexpr std::string_view four_bar_text = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100
crank = 30
coupler = 90
rocker = 80
)";

constexpr std::string_view line_text = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 2
crank = 1
coupler = 2.5
rocker = 2.5
point-along = 5
[line]
start = 90
range = 180
angle = 0
offset = 4
)";

FourBar<double> links_of(std::span<const double> dimensions) {
    return {dimensions[0], dimensions[1], dimensions[2], dimensions[3]};
}

/// The crank is the shortest link; three margins make the others.
std::vector<double> crank_rocker(std::vector<double> dimensions, std::size_t k) {
    const double crank = 0.2 + random_number(k, 0), p = random_number(k, 1), q = random_number(k, 2),
                 s = random_number(k, 3);
    const std::array<double, 4> links{crank + (q + s) / 2, crank, crank + (p + s) / 2, crank + (p + q) / 2};
    std::ranges::copy(links, dimensions.begin());
    return dimensions;
}

std::size_t quantity_of(const Problem& problem, std::string_view name) {
    return static_cast<std::size_t>(find_quantity(*problem.mechanism, name));
}

ExtremeCase case_of(std::string_view name, std::vector<GivenDesign> designs, std::string_view quantity,
                    std::function<double(const GivenDesign&, std::size_t mechanism, int samples)> sampled) {
    const auto all = std::make_shared<const std::vector<GivenDesign>>(std::move(designs));
    const std::size_t index = quantity_of(*all->front().problem, quantity);
    return {name, all->size(), [=](std::size_t k, int samples) { return sampled((*all)[k], k, samples); },
            [=](std::size_t k) { return (*all)[k].quantity(index); },
            [=](std::size_t k) { return (*all)[k].quantity_again(index); }};
}

/// The crank starts anywhere: where it happens to be on the ground line, the samples would hit the extreme.
double sampled_over_turn(const GivenDesign& design, std::size_t k, int samples) {
    const FourBar<double> m = links_of(design.dimensions);
    const double start = turn * random_number(k, 4);
    double least = std::numbers::pi;
    for (int i = 0; i < samples; ++i)
        least = std::min(least, transmission_angle(m, half_turn(start + turn * i / samples)));
    return least;
}

ExtremeCase over_turn() {
    const auto problem = problem_of(four_bar_text);
    std::vector<GivenDesign> designs;
    for (std::size_t k = 0; k < mechanisms; ++k)
        designs.emplace_back(problem, crank_rocker(dimensions_of(*problem), k));
    return case_of("transmission angle, full turn", std::move(designs), "transmission-angle-min", sampled_over_turn);
}

double sampled_over_range(const GivenDesign& design, std::size_t, int samples) {
    const FourBar<double> m = links_of(design.dimensions);
    const double step = (design.motion.to - design.motion.from) / samples;
    double least = std::numbers::pi;
    for (int i = 0; i <= samples; ++i)
        least = std::min(least, transmission_angle(m, half_turn(design.motion.from + step * i)));
    return least;
}

/// Ranges about the crank angle 0, where the angle is least.
ExtremeCase over_range() {
    std::vector<GivenDesign> designs;
    for (std::size_t k = 0; k < mechanisms; ++k) {
        Problem problem = *problem_of(four_bar_text);
        problem.crank_range = Vector<double>{-0.2 - random_number(k, 5), 0.2 + random_number(k, 6)};
        auto dimensions = crank_rocker(dimensions_of(problem), k);
        designs.emplace_back(std::make_shared<const Problem>(std::move(problem)), std::move(dimensions));
    }
    return case_of("transmission angle, limited range", std::move(designs), "transmission-angle-min",
                   sampled_over_range);
}

double sampled_deviation(const GivenDesign& design, std::size_t, int samples) {
    const FourBar<double> m = links_of(design.dimensions);
    const auto& line = *design.problem->mechanism->line;
    const double along = design.dimensions[design.problem->mechanism->point->roles.along];
    const Vector<double> direction{std::cos(design.dimensions[line.place]), std::sin(design.dimensions[line.place])};
    const double offset = design.dimensions[line.place + 1];
    const std::size_t input = design.problem->mechanism->input->start;
    const double start = design.dimensions[input], step = design.dimensions[input + 1] / samples;
    double greatest = 0;
    for (int i = 0; i <= samples; ++i) {
        const auto p = pose(m, start + step * i, Assembly::open);
        const double distance = cross(direction, position(m, CouplerPoint<double>{along, 0.0}, p)) - offset;
        greatest = std::max(greatest, std::abs(distance));
    }
    return greatest;
}

/// Lambda linkages that are more or less straight, each against a line close to it. Neither their stretch nor their
/// band is symmetric: else samples would hit an extreme in the middle, or one as great as another that they miss.
ExtremeCase straightness() {
    const auto problem = problem_of(line_text);
    std::vector<GivenDesign> designs;
    for (std::size_t k = 0; k < mechanisms; ++k) {
        std::vector<double> dimensions = dimensions_of(*problem);
        dimensions[0] += 0.3 * random_number(k, 0);
        dimensions[2] = dimensions[3] = 2.5 + 0.3 * random_number(k, 1);
        dimensions[problem->mechanism->point->roles.along] = 2 * dimensions[2];
        dimensions[problem->mechanism->input->start] += 0.3 * random_number(k, 2);
        const FollowedShape& line = *problem->mechanism->line;
        std::array<double, Reads::most> room;
        line.fit(problem->mechanism->form(0), deviation_from(*problem->mechanism, line.name).reads.of(dimensions, room),
                 std::span(dimensions).subspan(line.place, line.numbers.size()), {true, true, false});
        dimensions[line.place + 1] += 0.004 * (random_number(k, 3) - 0.5);
        designs.emplace_back(problem, std::move(dimensions));
    }
    return case_of("deviation from a line", std::move(designs), "line-deviation", sampled_deviation);
}

}  // namespace

std::vector<ExtremeCase> linkage_extremes() { return {over_turn(), over_range(), straightness()}; }

}  // namespace mechwright::bench
