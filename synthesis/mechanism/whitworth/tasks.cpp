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

Task with_stroke() {
    return {"whitworth",
            "stroke",
            "a ram of given stroke and time ratio, as uniform as possible while it works",
            {stroke(), time_ratio("2", 1.01)},
            stroke_file};
}

Task given() {
    return {"whitworth",
            "given",
            "all dimensions known: what does it do",
            {length_of("centre-distance", "Crank pivot to driven pivot, mm", "90"),
             length_of("crank", "Length of the crank, longer than that, mm", "180"),
             length_of("arm", "Driven pivot to rod pin, mm", "96"),
             length_of("rod", "Length of the rod, mm", "490"),
             {"slide-angle", "From the line of centres to the slide line, deg", "90"}},
            given_file};
}

}  // namespace

std::vector<Task> whitworth_tasks() { return {with_stroke(), given()}; }

}  // namespace mechwright
