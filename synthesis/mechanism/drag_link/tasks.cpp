// The tasks that `mechwright new` begins with the drag link.

#include "synthesis/mechanism/drag_link/drag_link.h"
#include "synthesis/mechanism/quick_return/questions.h"

namespace mechwright {

namespace {

using namespace quick_return;

// The problem files, from the folder tasks.
constexpr char stroke_file[] = {
#include "task_drag-link-stroke.inc"
};
constexpr char given_file[] = {
#include "task_drag-link-given.inc"
};

}  // namespace

std::vector<Task> drag_link_tasks() {
    return ram_tasks("drag-link", {uniform_while_working, {stroke(), time_ratio("2", 1.01)}, stroke_file},
                     {all_known,
                      {length_of("ground", "Length of the ground link, the shortest, mm", "60"),
                       length_of("crank", "Length of the crank, mm", "120"),
                       length_of("coupler", "Length of the coupler, mm", "100"),
                       length_of("follower", "Length of the follower, mm", "110"),
                       length_of("arm", "Follower pivot to rod pin, mm", "100"),
                       length_of("rod", "Length of the rod, mm", "300"),
                       {"slide-angle", "From the ground link to the slide line, deg", "0"}},
                      given_file});
}

}  // namespace mechwright
