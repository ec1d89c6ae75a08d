#include "synthesis/exact/geared/geared_five_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "synthesis/exact/chains/guided_chains.h"
#include "synthesis/exact/geared/geared_rows.h"
#include "synthesis/problem/problem.h"

namespace mechwright {

namespace {

using Point = std::complex<double>;

constexpr std::size_t frame = 0;
/// The pivots (four coordinates), the two cranks, the two rods and how the gears are put together.
constexpr std::size_t dimensions_of_all = 9;

/// A crank with the rod that joins it to a pin.
std::optional<GearedCrank> crank_to(const linkage::Structure& s, std::size_t link, std::size_t point) {
    const auto pivot = one_pin_of(s, frame, link);
    if (!pivot) return {};
    for (const linkage::Point& on : s.pins[point].points) {
        const auto pin = one_pin_of(s, link, on.link);
        if (on.link != frame && on.link != link && pin && *pin != *pivot && *pin != point)
            return GearedCrank{link, *pivot, *pin, on.link};
    }
    return {};
}

/// A five-bar that stands in for any other: rows of its readings have what all have in common.
constexpr std::array<Point, 5> some_pins{Point{0.31, 0.23}, {0.83, 1.07}, {1.71, 1.39}, {2.13, -0.41}, {1.1, 2.3}};

}  // namespace

std::optional<GearedFiveBar> geared_five_bar(const Problem& problem) {
    const LinkageModel* model = problem.mechanism->model.as<LinkageModel>();
    if (!model || model->guided.size() != 1) return {};
    const GuidedPoint& guided = model->guided.front();
    const linkage::Structure& s = model->structure;
    if (guided.is_body || guided.follows || s.drives.size() != 1) return {};
    const linkage::Drive& drive = s.drives.front();
    if (drive.of_slide || drive.on != frame || s.pins[guided.pin].points.size() != 2) return {};
    const auto driving = crank_to(s, drive.link, guided.pin);
    for (std::size_t i = 0; driving && i < s.gears.size(); ++i) {
        const linkage::Gear& gear = s.gears[i];
        if (gear.carrier != frame || (gear.first != drive.link && gear.second != drive.link)) continue;
        const bool drives_first = gear.first == drive.link;
        const auto driven = crank_to(s, drives_first ? gear.second : gear.first, guided.pin);
        if (driven && driven->rod != driving->rod) return GearedFiveBar{guided.pin, *driving, *driven, i, drives_first};
    }
    return {};
}

std::optional<double> ratio_of_gears(const Problem& problem, const GearedFiveBar& bars) {
    const LinkageModel& model = *problem.mechanism->model.as<LinkageModel>();
    const LinkNumbers numbers{problem.dimensions, model};
    const auto ratio = numbers.constant(numbers.number(model.structure.gears[bars.gear].ratio));
    return ratio && *ratio != 0 ? ratio : std::nullopt;
}

std::optional<double> speed_of_driven(const Problem& problem, const GearedFiveBar& bars) {
    const auto ratio = ratio_of_gears(problem, bars);
    if (!ratio) return {};
    return bars.drives_first ? *ratio : 1 / *ratio;
}

bool is_five_bar_like_four_bar(const Problem& problem) {
    if (!problem.path || problem.path->prescribed_timing) return false;
    const auto bars = geared_five_bar(problem);
    return bars && speed_of_driven(problem, *bars) == 1.0;
}

std::string why_no_geared_design(const Problem& problem, const GearedFiveBar& bars) {
    const LinkageModel& model = *problem.mechanism->model.as<LinkageModel>();
    if (!speed_of_driven(problem, bars)) return "the ratio of the gears is to be found: give it";
    if (!model.scale.terms.empty()) return "the scale of the linkage is to be found: give it";
    const LinkageDrive& drive = model.drives.front();
    if (drive.ratio != 1 || drive.phase != 0 || drive.motion) return "its drive has a motion of its own";
    const auto reading = reading_of(problem, bars, some_pins);
    if (!reading)
        return "it needs links whose frames show in their points: one pin at given coordinates, like [0, 0], and "
               "another beside or above it, like [\"length\", 0]";
    const auto beside = dimensions_unsaid(*problem.mechanism, problem.dimensions, reading->rows);
    if (!beside.empty())
        return fmt::format(
            "'{}' does not say where the pins of the geared five-bar are, or how its gears are put "
            "together: give it",
            problem.mechanism->dimensions[beside.front()].name);
    if (undetermined_lengths(*problem.mechanism, problem.dimensions, reading->rows) > 0)
        return "the places of the links' pins leave some of the dimensions open: give one of those that stand together";
    return {};
}

std::size_t given_coordinates(const Problem& problem, const GearedCrank& crank) {
    const PivotRanges ranges = pivot_ranges(problem, crank, {0, 1});
    return (ranges.first_min == ranges.first_max ? 1U : 0U) + (ranges.second_min == ranges.second_max ? 1U : 0U);
}

std::string why_no_geared_family(const Problem& problem, std::size_t given_of_pivots) {
    const std::size_t open = open_dimensions(*problem.mechanism, problem.dimensions).size();
    if (open + given_of_pivots == dimensions_of_all) return {};
    return fmt::format(
        "a family of geared five-bars passes so few points, and the file leaves {} of the {} numbers open that say its "
        "pivots, cranks, rods and the phase of its gears: give all of them ranges, or use another method",
        open, dimensions_of_all - given_of_pivots);
}

}  // namespace mechwright
