// The tasks that `mechwright new` begins with the crank shaper.

#include "synthesis/mechanism/crank_shaper/crank_shaper.h"
#include "synthesis/mechanism/quick_return/questions.h"

namespace mechwright {

namespace {

using namespace quick_return;

// The problem files, from the folder tasks.
constexpr char stroke_file[] = {
#include "task_crank-shaper-stroke.inc"
};
constexpr char given_file[] = {
#include "task_crank-shaper-given.inc"
};

}  // namespace

std::vector<Task> crank_shaper_tasks() {
    return ram_tasks(
        "crank-shaper", {uniform_while_working, {stroke(), time_ratio("2", 1.01)}, stroke_file},
        {all_known,
         {length_of("centre-distance", "Crank pivot to lever pivot, mm", "300"),
          length_of("crank", "Length of the crank, shorter than that, mm", "150"),
          length_of("lever", "Lever pivot to rod pin, mm", "200"), length_of("rod", "Length of the rod, mm", "300"),
          length_of("ram-distance", "Lever pivot to ram line, mm", "187")},
         given_file});
}

}  // namespace mechwright
