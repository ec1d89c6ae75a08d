#include "synthesis/exact/guided_parts.h"

#include "synthesis/exact/chains/chain_design.h"
#include "synthesis/exact/geared/geared_five_bar.h"
#include "synthesis/exact/poses/slider_crank_poses.h"
#include "synthesis/mechanism/four_bar/four_bar.h"
#include "synthesis/mechanism/slider_crank/slider_crank.h"

namespace mechwright {

namespace {

using homotopy::SecondDyad;

const LinkageModel* linkage_model(const Problem& problem) { return problem.mechanism->model.as<LinkageModel>(); }

/// Why the dyads of a coupler do not say the design of a geared five-bar; empty if they do.
std::string why_no_like_parts(const Problem& problem, const GearedFiveBar& bars) {
    if (const std::string why = why_no_geared_design(problem, bars); !why.empty()) return why;
    if (is_five_bar_like_four_bar(problem)) return {};
    return "through points at any crank angles it finds geared five-bars whose cranks turn alike (ratio = 1): for "
           "other "
           "ratios there are too many to follow; give the crank angles (timing = \"prescribed\"), or use another "
           "method";
}

ExactDesign geared_of_parts(const Problem& problem, const GearedFiveBar& bars, const GuidedParts& parts,
                            std::span<const Displacement> displacements, const DrawingPlace& place) {
    std::vector<double> turned;
    for (const Displacement& displacement : displacements)
        turned.push_back(std::arg(displacement.turn));
    return geared_design(problem, bars, {parts.crank, parts.second, displacements, turned}, place);
}

}  // namespace

bool is_linkage(const Problem& problem) { return linkage_model(problem) != nullptr; }

std::optional<SecondDyad> second_dyad(const Problem& problem) {
    if (is_four_bar(*problem.mechanism)) return SecondDyad::rocker;
    if (is_slider_crank(*problem.mechanism)) return SecondDyad::ram;
    if (is_five_bar_like_four_bar(problem)) return SecondDyad::rocker;
    const LinkageModel* model = linkage_model(problem);
    const auto chains = model ? guided_chains(*model) : std::nullopt;
    return chains ? std::optional(chains->second) : std::nullopt;
}

std::string why_no_parts(const Problem& problem) {
    if (has_ties(problem)) return "dimensions are tied to others";
    const LinkageModel* model = linkage_model(problem);
    if (!model) return second_dyad(problem) ? "" : "it guides by four-bars, slider-cranks and linkages alone";
    if (const auto bars = geared_five_bar(problem)) return why_no_like_parts(problem, *bars);
    const auto chains = guided_chains(*model);
    if (!chains)
        return "it guides links that hang on the crank, or a rocker where something else drives, and on one more link, "
               "slide or slot to the frame, with one point or body for a target";
    return why_no_chain_design(problem, *chains);
}

std::size_t conditions_of(const Problem& problem) { return second_dyad(problem) == SecondDyad::rocker ? 10 : 9; }

std::string why_no_family(const Problem& problem) {
    if (is_five_bar_like_four_bar(problem)) return why_no_geared_family(problem, 0);
    const LinkageModel* model = linkage_model(problem);
    return model ? why_no_chain_family(problem, *guided_chains(*model), conditions_of(problem) - 1) : "";
}

std::optional<std::vector<std::size_t>> dimensions_of_drive(const Problem& problem) {
    const LinkageModel* model = linkage_model(problem);
    const auto chains = model ? guided_chains(*model) : std::nullopt;
    if (!chains || chains->by_crank) return {};
    return dimensions_beside_chains(problem, *chains);
}

void claim_no_more_than_seen(const Problem& problem, ExactDesigns& out) {
    if (!out.designs.empty() || !dimensions_of_drive(problem)) return;
    out.proof = nullptr;
    out.note =
        "all that the guided body can hang on is known, but the drive was not seen to take any of it through the "
        "targets in their order; its motion was looked at in samples, so that this is no proof";
}

std::optional<ExactDesign> exact_design(const Problem& problem, const GuidedParts& parts,
                                        std::span<const Displacement> displacements, const DrawingPlace& place) {
    if (is_five_bar_like_four_bar(problem))
        return geared_of_parts(problem, *geared_five_bar(problem), parts, displacements, place);
    if (const LinkageModel* model = linkage_model(problem))
        return chain_design(problem, *guided_chains(*model), parts, displacements, place);
    if (parts.kind == SecondDyad::ram)
        return slider_crank_design(problem, place, parts.crank, {parts.second.moving, parts.second.fixed},
                                   displacements);
    const auto linkage = linkage_of(parts.crank, parts.second, displacements, place);
    return linkage ? std::optional(exact_design(problem, *linkage)) : std::nullopt;
}

}  // namespace mechwright
