#pragma once
/// \file
/// Registry entries of disc cams: one for each kind of follower, all named "cam".

#include <array>
#include <string_view>

#include "analysis/cam/contour.h"
#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

inline constexpr std::array<std::string_view, 3> cam_follower_names{"knife", "roller", "flat"};
inline constexpr std::array<std::string_view, 2> cam_motion_names{"translating", "oscillating"};
inline constexpr std::array<std::string_view, 2> cam_rotation_names{"ccw", "cw"};

inline constexpr std::array<std::string_view, 3> cam_contour_names{"tangent", "circular-arc", "eccentric"};

/// The cam with a follower, without a motion of its own.
std::shared_ptr<const Mechanism> cam_mechanism(CamFollower follower, bool oscillating);

/// Cams of a specified contour with a translating follower; a knife edge has the entry of a roller. A tangent cam with
/// a flat follower has none: a straight flank cannot move a flat face.
std::shared_ptr<const Mechanism> contour_cam_mechanism(CamFollower follower, cam::ContourKind contour);

/// The same cam whose follower moves by a program.
std::shared_ptr<const Mechanism> with_program(const Mechanism& cam, std::shared_ptr<const MotionProgram> program);

/// Whether a mechanism is a cam, what kind of one, and its motion; null where it has none. Precondition of the kind: it
/// is a cam.
bool is_cam(const Mechanism& mechanism);
CamKind cam_kind(const Mechanism& mechanism);
const MotionProgram* program_of(const Mechanism& mechanism);

/// Where the angle, lift and coefficients of segments stand among the dimensions of a cam.
std::size_t cam_angle_dimension(const Mechanism& mechanism, std::size_t segment);
std::size_t cam_lift_dimension(const Mechanism& mechanism, std::size_t segment);
std::size_t cam_coefficient_dimension(const Mechanism& mechanism, std::size_t index);

/// Adds the cam angles at which segments and their analytic pieces end.
void cam_corners(const Mechanism& mechanism, const Motion& motion, std::span<const double> dimensions,
                 std::vector<double>& angles);

/// All entries, rollers first.
std::vector<std::shared_ptr<const Mechanism>> cam_mechanisms();

}  // namespace mechwright
