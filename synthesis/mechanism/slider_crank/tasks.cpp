// The tasks that `mechwright new` begins with the slider-crank.

#include "synthesis/mechanism/quick_return/questions.h"
#include "synthesis/mechanism/slider_crank/slider_crank.h"

namespace mechwright {

namespace {

using namespace quick_return;

// The problem files, from the folder tasks.
constexpr char stroke_file[] = {
#include "task_slider-crank-stroke.inc"
};
constexpr char given_file[] = {
#include "task_slider-crank-given.inc"
};

}  // namespace

std::vector<Task> slider_crank_tasks() {
    return ram_tasks("slider-crank",
                     {"a ram of given stroke and time ratio, with the best transmission angle",
                      {stroke(), time_ratio("1.2", 1)},
                      stroke_file},
                     {all_known,
                      {length_of("crank", "Length of the crank, mm", "50"),
                       length_of("rod", "Length of the rod, mm", "150"),
                       {"offset", "Distance of the slide line from the crank pivot, mm", "20"}},
                      given_file});
}

}  // namespace mechwright
