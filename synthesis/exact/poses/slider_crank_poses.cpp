#include "synthesis/exact/poses/slider_crank_poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/exact/poses/pose_targets.h"

namespace mechwright {

namespace {

using Complex = std::complex<double>;

/// The slider-crank of a crank dyad and a ram, as a design without what is seen along the places; nothing where a link
/// has no length. `ahead` is the direction of the slide in which the ram lies ahead of the crank pin.
struct Found {
    Design design;
    Complex ahead;
};

std::optional<Found> slider_crank_of(const Problem& problem, const DrawingPlace& place, const Dyad& crank,
                                     const SliderDyad& ram) {
    const PathRoles& roles = problem.mechanism->point->roles;
    const double size = place.size;
    const Complex rod = ram.moving - crank.moving;
    const double crank_length = size * std::abs(crank.moving - crank.fixed), rod_length = size * std::abs(rod);
    if (!(std::min(crank_length, rod_length) > 1e-9 * (crank_length + rod_length))) return {};
    const Complex along = Complex(0, 1) * ram.normal;
    const Complex ahead = (std::conj(along) * rod).real() > 0 ? along : -along;
    const Complex point = -crank.moving / (rod / std::abs(rod));
    const Complex origin = place.origin + size * crank.fixed;
    Found found{{}, ahead};
    auto& d = found.design.dimensions;
    for (const DimensionRange& range : problem.dimensions)
        d.push_back(range.min);
    d[0] = crank_length;
    d[1] = rod_length;
    d[2] = size * (std::conj(ahead) * (ram.moving - crank.fixed)).imag();
    d[roles.along] = size * point.real();
    d[roles.across] = size * point.imag();
    d[roles.origin_x] = origin.real();
    d[roles.origin_y] = origin.imag();
    d[roles.tilt] = std::arg(ahead);
    const auto& directions = problem.path->directions;
    const auto first = std::find_if(directions.begin(), directions.end(), [](double a) { return !std::isnan(a); });
    if (first != directions.end()) d[roles.body] = *first - std::arg(rod);
    return found;
}

}  // namespace

std::optional<ExactDesign> slider_crank_design(const Problem& problem, const DrawingPlace& place, const Dyad& crank,
                                               const SliderDyad& ram, std::span<const Displacement> displacements) {
    auto found = slider_crank_of(problem, place, crank, ram);
    if (!found) return {};
    std::vector<double> angles;
    bool always_ahead = true;
    for (const auto& [shift, turn] : displacements) {
        const Complex pin = shift + crank.moving * turn;
        angles.push_back(std::arg((pin - crank.fixed) / found->ahead));
        always_ahead = always_ahead && (std::conj(found->ahead) * ((ram.moving - crank.moving) * turn)).real() > 0;
    }
    if (!always_ahead) return excluded_design(std::move(found->design), "branch: the ram would have to change sides");
    const PathTarget& path = *problem.path;
    if (!path.prescribed_timing) return exact_design(problem, std::move(found->design), angles);
    const double start = angles.front() - path.crank_angles.front();
    found->design.dimensions[problem.mechanism->point->roles.start] = start;
    move_angles_into_ranges(problem, found->design);
    for (const double angle : path.crank_angles)
        found->design.path_angles.push_back(found->design.dimensions[problem.mechanism->point->roles.start] + angle);
    return exact_design(problem, std::move(found->design));
}

namespace {

/// The dyad of a ram; that of a block as the fixed pivot seen from the body, whose places lie on the body's line.
std::optional<Dyad> second_through(homotopy::SecondDyad kind, std::span<const Displacement> displacements,
                                   std::span<const double> numbers) {
    if (kind == homotopy::SecondDyad::ram) {
        const auto ram = slider_through(displacements, numbers);
        return ram ? std::optional(Dyad{ram->normal, ram->moving}) : std::nullopt;
    }
    std::vector<Displacement> seen;
    for (const auto& [shift, turn] : displacements)
        seen.push_back({-shift / turn, 1.0 / turn});
    const auto block = slider_through(seen, numbers);
    return block ? std::optional(Dyad{block->moving, block->normal}) : std::nullopt;
}

}  // namespace

std::optional<ExactDesign> slider_crank_of_poses(const PoseTargets& g, std::span<const double> numbers) {
    const std::size_t of_crank = numbers_of_dyad(g.places());
    const homotopy::SecondDyad kind = *second_dyad(*g.problem);
    const auto second = second_through(kind, g.displacements, numbers.subspan(of_crank));
    std::optional<ExactDesign> best;
    if (!second) return best;
    std::vector<Displacement> displacements{{0, 1}};
    displacements.insert(displacements.end(), g.displacements.begin(), g.displacements.end());
    for (const Dyad& crank : dyads_of(g.displacements, numbers.first(of_crank), crank_pivot_ranges(g)))
        if (auto design = exact_design(*g.problem, {crank, kind, *second}, displacements, g.place))
            keep_better(*g.problem, best, *std::move(design));
    return best;
}

std::string why_no_slider_crank_poses(const Problem& problem) {
    const PathTarget& path = *problem.path;
    if (path.prescribed_timing) return "it needs poses that are met at any crank angle: timing = \"free\"";
    if (const std::string why = why_no_parts(problem); !why.empty()) return why;
    if (path.points.size() >= 2 && path.points.size() <= 4) return why_no_family(problem);
    if (path.points.size() < 2) return "it needs from two to four poses, and there is one";
    return fmt::format(
        "it finds slider-cranks through up to four poses, and there are {}: through more none passes in general; "
        "least-squares finds the closest",
        path.points.size());
}

ExactDesigns slider_crank_pose_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    const PoseTargets g = pose_targets(problem);
    const DesignFamily family{numbers_of_slider_crank(g.places()),
                              [&](std::span<const double> numbers) { return slider_crank_of_poses(g, numbers); }};
    return search_family(problem, family, options, end);
}

}  // namespace mechwright
