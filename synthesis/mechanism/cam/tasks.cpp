// The tasks of cams: one for each kind of follower.

#include "synthesis/mechanism/cam/tasks.h"

namespace mechwright {

namespace {

// The problem files, from the folder tasks.
constexpr char cam_roller[] = {
#include "task_cam-roller.inc"
};
constexpr char cam_knife[] = {
#include "task_cam-knife.inc"
};
constexpr char cam_flat[] = {
#include "task_cam-flat.inc"
};
constexpr char cam_oscillating_roller[] = {
#include "task_cam-oscillating-roller.inc"
};
constexpr char cam_oscillating_flat[] = {
#include "task_cam-oscillating-flat.inc"
};

Question segments(std::string_view preset) {
    return {"segments", "Segments of the motion, kind and angle in deg", preset, Answer::segments};
}

Question lift(std::string_view text, std::string_view preset, double most) {
    return {"lift", text, preset, Answer::number, 1e-6, most};
}

Question law() {
    return {"law",
            "Law of motion",
            "cycloidal",
            Answer::choice,
            0,
            0,
            {"cycloidal", "3-4-5", "4-5-6-7", "modified-sine", "modified-trapezoid", "harmonic", "parabolic",
             "double-harmonic", "modified-constant-velocity", "constant-velocity", "kloomok-muffley"}};
}

Question pressure(std::string_view preset) {
    return {"pressure-angle", "Greatest pressure angle, deg", preset, Answer::number, 1, 89};
}

Question roller() { return {"roller-radius", "Radius of the roller, mm", "5", Answer::number, 1e-6}; }

Question curvature() {
    return {"profile-radius", "Least radius of curvature of the cam, mm", "5", Answer::number, 1e-6};
}

Task roller_follower() {
    return {"cam",
            "roller",
            "the smallest cam for a roller on a straight guide",
            {segments("rise 120, dwell 60, return 120, dwell 60"), lift("Lift, mm", "20", 1e6), law(), roller(),
             pressure("30")},
            cam_roller};
}

Task knife() {
    return {"cam",
            "knife",
            "the smallest cam for a knife edge on a straight guide",
            {segments("rise 120, dwell 60, return 120, dwell 60"), lift("Lift, mm", "20", 1e6), law(), pressure("30")},
            cam_knife};
}

Task flat() {
    return {"cam",
            "flat",
            "the smallest cam for a flat face on a straight guide",
            {segments("rise 120, dwell 60, return 120, dwell 60"), lift("Lift, mm", "20", 1e6), law(), curvature()},
            cam_flat};
}

Task oscillating_roller() {
    return {"cam",
            "oscillating-roller",
            "the smallest cam for a roller on an arm",
            {segments("rise 120, dwell 60, return 120, dwell 60"),
             lift("Swing of the arm, deg", "25", 170),
             law(),
             {"arm-length", "Length of the arm, mm", "80", Answer::number, 1e-3},
             roller(),
             pressure("45")},
            cam_oscillating_roller};
}

Task oscillating_flat() {
    return {"cam",
            "oscillating-flat",
            "the smallest cam for a flat face that swings about a pivot",
            {segments("rise 120, dwell 60, return 120, dwell 60"),
             lift("Swing of the face, deg", "15", 85),
             law(),
             {"start-angle", "Angle of the face to the line of centres at the lowest position, deg", "40",
              Answer::number, 1, 85},
             curvature()},
            cam_oscillating_flat};
}

}  // namespace

std::vector<Task> cam_tasks(const CamKind& kind) {
    if (kind.contour != cam::ContourKind::none) return {};
    switch (kind.follower) {
        case CamFollower::roller: return {kind.oscillating ? oscillating_roller() : roller_follower()};
        case CamFollower::flat: return {kind.oscillating ? oscillating_flat() : flat()};
        default: return kind.oscillating ? std::vector<Task>{} : std::vector<Task>{knife()};
    }
}

}  // namespace mechwright
