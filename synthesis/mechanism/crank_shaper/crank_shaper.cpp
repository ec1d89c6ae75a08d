#include "synthesis/mechanism/crank_shaper/crank_shaper.h"

#include <cmath>

#include "synthesis/mechanism/crank_shaper/again.h"
#include "synthesis/mechanism/crank_shaper/layout.h"
#include "synthesis/mechanism/measure_by.h"
#include "synthesis/mechanism/quick_return/drive.h"
#include "synthesis/mechanism/quick_return/slotted_row.h"

namespace mechwright {

namespace {

using namespace quick_return;

std::vector<Dimension> dimensions() {
    return {
        {"centre-distance", DimensionKind::length, true, "crank pivot to lever pivot"},
        {"crank", DimensionKind::length, true, "crank, crank pivot to crank pin; shorter than the centre distance"},
        {"lever", DimensionKind::length, true, "slotted lever, its pivot to the rod pin"},
        {"rod", DimensionKind::length, true, "rod, rod pin to ram"},
        {"ram-distance", DimensionKind::length, true,
         "lever pivot to the ram line, which is square to the line of centres"},
    };
}

// Coefficients of centre-distance, crank, lever, rod, ram-distance.
std::vector<Family> families() {
    return {
        {"crank turns, lever swings",
         true,
         {{"the crank is shorter than the centre distance", {1, -1, 0, 0, 0}},
          {"the rod reaches the ram line from the upright lever", {0, 0, -1, 1, 1}}},
         assembly_margin_quantity<CrankShaper>()},
        {"limited crank range",
         false,
         {{"the crank is shorter than the centre distance", {1, -1, 0, 0, 0}}},
         assembly_margin_quantity<CrankShaper>()},
    };
}

std::string describe(Form, std::span<const double> d) {
    const CrankShaper<double> m = drive_of<CrankShaper>(d, 0);
    if (m.crank > m.centre_distance) return "no crank shaper: the crank is longer than the centre distance";
    if (m.crank == m.centre_distance) return "no crank shaper: the crank is as long as the centre distance";
    if (makes_two_strokes(m)) return "crank shaper";
    return assembled_range(m).full_turn ? "crank shaper, lever and rod fall into line within a stroke"
                                        : "crank shaper, rod too short for a full turn";
}

std::optional<Objection> objection(std::span<const double> least, std::span<const double> greatest) {
    constexpr std::size_t centre_distance = 0, crank = 1;
    if (least[crank] < greatest[centre_distance]) return std::nullopt;
    return Objection{
        crank,
        "the crank of a crank-shaper must be shorter than its centre-distance; with a longer one the slotted "
        "link turns fully, which is mechanism = \"whitworth\""};
}

std::vector<Quantity> quantities() {
    return ram_quantities<CrankShaper, CrankShaperAgain>(
        "centre distance, crank, lever and rod together",
        "least angle at the ram over the motion: 90 deg less the angle from ram line to rod",
        "greatest angle at the ram over the motion", "least angle at the ram over the motion");
}

}  // namespace

std::shared_ptr<const Mechanism> crank_shaper_mechanism() {
    static const auto mechanism = std::make_shared<const Mechanism>(
        Mechanism{.name = "crank-shaper",
                  .meaning = "a crank swings a slotted lever, which drives a ram through a rod",
                  .dimensions = dimensions(),
                  .assemblies = {},
                  .quantities = quantities(),
                  .families = families(),
                  .settings = settings(),
                  .objection = objection,
                  .motion = motion_by_drive<CrankShaper>,
                  .motion_again = CrankShaperAgain::motion,
                  .ways_again = crank_shaper_ways,
                  .describe = describe,
                  .check_motion = CrankShaperAgain::check_motion,
                  .table = {slotted_columns(), slotted_units(), slotted_row<CrankShaper>},
                  .formulas = crank_shaper_formulas(),
                  .tasks = crank_shaper_tasks(),
                  .drawing = crank_shaper_drawing(),
                  .as_linkage = crank_shaper_as_linkage()});
    return mechanism;
}

}  // namespace mechwright
