// The tasks that `mechwright new` begins with Whitworth's drive.

#include "synthesis/mechanism/quick_return/questions.h"
#include "synthesis/mechanism/whitworth/whitworth.h"

namespace mechwright {

namespace {

using namespace quick_return;

// The problem files, from the folder tasks.
constexpr char stroke_file[] = {
#include "task_whitworth-stroke.inc"
};
constexpr char given_file[] = {
#include "task_whitworth-given.inc"
};

}  // namespace

std::vector<Task> whitworth_tasks() {
    return ram_tasks("whitworth", {uniform_while_working, {stroke(), time_ratio("2", 1.01)}, stroke_file},
                     {all_known,
                      {length_of("centre-distance", "Crank pivot to driven pivot, mm", "90"),
                       length_of("crank", "Length of the crank, longer than that, mm", "180"),
                       length_of("arm", "Driven pivot to rod pin, mm", "96"),
                       length_of("rod", "Length of the rod, mm", "490"),
                       {"slide-angle", "From the line of centres to the slide line, deg", "90"}},
                      given_file});
}

}  // namespace mechwright
