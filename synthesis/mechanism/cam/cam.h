#pragma once
/// \file
/// Registry entries of disc cams: one for each kind of follower, all named "cam".

#include <array>
#include <string_view>

#include "analysis/cam/contour.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

enum class CamFollower { knife, roller, flat };

inline constexpr std::array<std::string_view, 3> cam_follower_names{"knife", "roller", "flat"};
inline constexpr std::array<std::string_view, 2> cam_motion_names{"translating", "oscillating"};
inline constexpr std::array<std::string_view, 2> cam_rotation_names{"ccw", "cw"};

inline constexpr std::array<std::string_view, 3> cam_contour_names{"tangent", "circular-arc", "eccentric"};

const Mechanism& cam_mechanism(CamFollower follower, bool oscillating);

/// Cams of a specified contour with a translating follower; a knife edge has the entry of a roller. A tangent cam with
/// a flat follower has none: a straight flank cannot move a flat face.
const Mechanism* contour_cam_mechanism(CamFollower follower, cam::ContourKind contour);

/// What kind of follower an entry is of. Precondition: it is one of the entries above.
struct CamKind {
    CamFollower follower;
    bool oscillating;
    cam::ContourKind contour = cam::ContourKind::none;
};
CamKind cam_kind(const Mechanism& mechanism);

/// Whether an entry is a cam.
bool is_cam(const Mechanism& mechanism);

/// Where the angle, lift and coefficients of segments stand among the dimensions of a cam.
std::size_t cam_angle_dimension(const Mechanism& mechanism, std::size_t segment);
std::size_t cam_lift_dimension(const Mechanism& mechanism, std::size_t segment);
std::size_t cam_coefficient_dimension(const Mechanism& mechanism, std::size_t index);

/// Adds the cam angles at which segments and their analytic pieces end.
void cam_corners(const Mechanism& mechanism, const Motion& motion, std::span<const double> dimensions,
                 std::vector<double>& angles);

/// All entries, rollers first.
std::span<const Mechanism* const> cam_mechanisms();

}  // namespace mechwright
