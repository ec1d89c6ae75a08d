#include "synthesis/mechanism/whitworth/whitworth.h"

#include <cmath>

#include "synthesis/mechanism/measure_by.h"
#include "synthesis/mechanism/quick_return/drive.h"
#include "synthesis/mechanism/quick_return/slotted_row.h"
#include "synthesis/mechanism/whitworth/again.h"
#include "synthesis/mechanism/whitworth/layout.h"

namespace mechwright {

namespace {

using namespace quick_return;

std::vector<Dimension> dimensions() {
    return {
        {"centre-distance", DimensionKind::length, true, "crank pivot to driven pivot"},
        {"crank", DimensionKind::length, true, "crank, crank pivot to crank pin; longer than the centre distance"},
        {"arm", DimensionKind::length, true, "arm, driven pivot to rod pin, opposite the slot"},
        {"rod", DimensionKind::length, true, "rod, rod pin to ram"},
        {"slide-angle", DimensionKind::angle, true,
         "from the line of centres (driven pivot to crank pivot) to the slide line through the driven pivot"},
    };
}

// Coefficients of centre-distance, crank, arm, rod.
std::vector<Family> families() {
    return {
        {"crank and slotted link turn fully",
         true,
         {{"the crank is longer than the centre distance", {-1, 1, 0, 0}},
          {"the arm turns past the rod", {0, 0, -1, 1}}},
         {}},
        {"limited crank range",
         false,
         {{"the crank is longer than the centre distance", {-1, 1, 0, 0}}},
         assembly_margin_quantity<Whitworth>()},
    };
}

std::string describe(Form, std::span<const double> d) {
    const Whitworth<double> m = drive_of<Whitworth>(d, 0);
    if (m.crank < m.centre_distance) return "no Whitworth drive: the crank is shorter than the centre distance";
    if (m.crank == m.centre_distance) return "no Whitworth drive: the crank is as long as the centre distance";
    return makes_two_strokes(m) ? "Whitworth drive" : "Whitworth drive, rod too short for a full turn";
}

std::optional<Objection> objection(std::span<const double> least, std::span<const double> greatest) {
    constexpr std::size_t centre_distance = 0, crank = 1;
    if (greatest[crank] > least[centre_distance]) return std::nullopt;
    return Objection{crank,
                     "the crank of a whitworth drive must be longer than its centre-distance; with a shorter one the "
                     "slotted lever swings, which is mechanism = \"crank-shaper\""};
}

std::vector<Quantity> quantities() {
    return ram_quantities<Whitworth, WhitworthAgain>(
        "centre distance, crank, arm and rod together",
        "least angle at the ram over the motion: 90 deg less the angle from slide line to rod",
        "greatest angle at the ram over the motion", "least angle at the ram over the motion");
}

}  // namespace

std::shared_ptr<const Mechanism> whitworth_mechanism() {
    static const auto mechanism = std::make_shared<const Mechanism>(
        Mechanism{.name = "whitworth",
                  .meaning = "a crank turns a slotted link fully, whose arm drives a ram through a rod",
                  .dimensions = dimensions(),
                  .assemblies = {},
                  .quantities = quantities(),
                  .families = families(),
                  .settings = settings(),
                  .objection = objection,
                  .rod_sloped_by_stroke = quick_return::Layout<Whitworth>::links[3],
                  .motion = motion_by_drive<Whitworth>,
                  .motion_again = WhitworthAgain::motion,
                  .ways_again = whitworth_ways,
                  .describe = describe,
                  .check_motion = WhitworthAgain::check_motion,
                  .table = {slotted_columns(), slotted_units(), slotted_row<Whitworth>},
                  .formulas = whitworth_formulas(),
                  .tasks = whitworth_tasks(),
                  .drawing = whitworth_drawing(),
                  .as_linkage = whitworth_as_linkage()});
    return mechanism;
}

}  // namespace mechwright
