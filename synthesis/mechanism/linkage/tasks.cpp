#include "synthesis/mechanism/linkage/tasks.h"

namespace mechwright {

namespace {

// The problem files, from the folder tasks.
constexpr char watt_one_file[] = {
#include "task_six-bar-watt-one.inc"
};
constexpr char watt_two_file[] = {
#include "task_six-bar-watt-two.inc"
};
constexpr char stephenson_one_file[] = {
#include "task_six-bar-stephenson-one.inc"
};
constexpr char dwell_file[] = {
#include "task_six-bar-dwell.inc"
};

Question crank() { return {"crank", "Length of the crank, mm", "20", Answer::number, 1e-3}; }

}  // namespace

std::vector<Task> linkage_tasks() {
    std::vector<Task> tasks;
    tasks.push_back({"linkage",
                     "watt-one",
                     "a six-bar of Watt's first kind, all dimensions known: curves of a floating link",
                     {crank()},
                     watt_one_file});
    tasks.push_back({"linkage",
                     "watt-two",
                     "a six-bar of Watt's second kind, two four-bars one after the other: an output that swings",
                     {crank(), {"swing", "Swing of the output, deg", "40", Answer::number, 1, 120}},
                     watt_two_file});
    tasks.push_back({"linkage",
                     "stephenson-one",
                     "a six-bar of Stephenson's first kind, all dimensions known: curves of a floating link",
                     {crank()},
                     stephenson_one_file});
    tasks.push_back({"linkage",
                     "dwell",
                     "a six-bar of Stephenson's third kind: an output that stands still for a while",
                     {crank(),
                      {"swing", "Least swing of the output, deg", "40", Answer::number, 1, 120},
                      {"from", "Crank angle at which it is to stand still, deg", "200", Answer::number, -360, 360},
                      {"to", "And up to which, deg", "260", Answer::number, -360, 720}},
                     dwell_file});
    return tasks;
}

}  // namespace mechwright
