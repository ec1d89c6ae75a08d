// The tasks of mechanisms that drive a ram.

#include "synthesis/mechanism/quick_return/tasks.h"

namespace mechwright {

namespace {

// The problem files, from the folder tasks.
constexpr char slider_crank_stroke[] = {
#include "task_slider-crank-stroke.inc"
};
constexpr char crank_shaper_stroke[] = {
#include "task_crank-shaper-stroke.inc"
};
constexpr char whitworth_stroke[] = {
#include "task_whitworth-stroke.inc"
};
constexpr char drag_link_stroke[] = {
#include "task_drag-link-stroke.inc"
};
constexpr char slider_crank_given[] = {
#include "task_slider-crank-given.inc"
};
constexpr char crank_shaper_given[] = {
#include "task_crank-shaper-given.inc"
};
constexpr char whitworth_given[] = {
#include "task_whitworth-given.inc"
};
constexpr char drag_link_given[] = {
#include "task_drag-link-given.inc"
};

Question stroke() { return {"stroke", "Stroke of the ram, mm", "200", Answer::number, 1e-3}; }

Question time_ratio(std::string_view preset, double least) {
    return {"time-ratio", "Time of the slow stroke over that of the fast one", preset, Answer::number, least, 5};
}

Question length_of(std::string_view name, std::string_view text, std::string_view preset) {
    return {name, text, preset, Answer::number, 1e-9};
}

Task slider_crank() {
    return {"slider-crank",
            "stroke",
            "a ram of given stroke and time ratio, with the best transmission angle",
            {stroke(), time_ratio("1.2", 1)},
            slider_crank_stroke};
}

Task crank_shaper() {
    return {"crank-shaper",
            "stroke",
            "a ram of given stroke and time ratio, as uniform as possible while it works",
            {stroke(), time_ratio("2", 1.01)},
            crank_shaper_stroke};
}

Task whitworth() {
    return {"whitworth",
            "stroke",
            "a ram of given stroke and time ratio, as uniform as possible while it works",
            {stroke(), time_ratio("2", 1.01)},
            whitworth_stroke};
}

Task drag_link() {
    return {"drag-link",
            "stroke",
            "a ram of given stroke and time ratio, as uniform as possible while it works",
            {stroke(), time_ratio("2", 1.01)},
            drag_link_stroke};
}

Task given_slider_crank() {
    return {"slider-crank",
            "given",
            "all dimensions known: what does it do",
            {length_of("crank", "Length of the crank, mm", "50"),
             length_of("rod", "Length of the rod, mm", "150"),
             {"offset", "Distance of the slide line from the crank pivot, mm", "20"}},
            slider_crank_given};
}

Task given_crank_shaper() {
    return {"crank-shaper",
            "given",
            "all dimensions known: what does it do",
            {length_of("centre-distance", "Crank pivot to lever pivot, mm", "300"),
             length_of("crank", "Length of the crank, shorter than that, mm", "150"),
             length_of("lever", "Lever pivot to rod pin, mm", "200"), length_of("rod", "Length of the rod, mm", "300"),
             length_of("ram-distance", "Lever pivot to ram line, mm", "187")},
            crank_shaper_given};
}

Task given_whitworth() {
    return {"whitworth",
            "given",
            "all dimensions known: what does it do",
            {length_of("centre-distance", "Crank pivot to driven pivot, mm", "90"),
             length_of("crank", "Length of the crank, longer than that, mm", "180"),
             length_of("arm", "Driven pivot to rod pin, mm", "96"),
             length_of("rod", "Length of the rod, mm", "490"),
             {"slide-angle", "From the line of centres to the slide line, deg", "90"}},
            whitworth_given};
}

Task given_drag_link() {
    return {"drag-link",
            "given",
            "all dimensions known: what does it do",
            {length_of("ground", "Length of the ground link, the shortest, mm", "60"),
             length_of("crank", "Length of the crank, mm", "120"),
             length_of("coupler", "Length of the coupler, mm", "100"),
             length_of("follower", "Length of the follower, mm", "110"),
             length_of("arm", "Follower pivot to rod pin, mm", "100"),
             length_of("rod", "Length of the rod, mm", "300"),
             {"slide-angle", "From the ground link to the slide line, deg", "0"}},
            drag_link_given};
}

}  // namespace

std::vector<Task> slider_crank_tasks() { return {slider_crank(), given_slider_crank()}; }
std::vector<Task> crank_shaper_tasks() { return {crank_shaper(), given_crank_shaper()}; }
std::vector<Task> whitworth_tasks() { return {whitworth(), given_whitworth()}; }
std::vector<Task> drag_link_tasks() { return {drag_link(), given_drag_link()}; }

}  // namespace mechwright
