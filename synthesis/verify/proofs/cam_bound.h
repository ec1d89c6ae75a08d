#pragma once
/// \file
/// Lower bounds on the size of cams from certificates, for verification: in fifty digits, by formulas of its own.

#include <span>

#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/mechanism/mechanism.h"
#include "synthesis/program/proof.h"

namespace mechwright {

/// What limits the size of a cam beside its motion.
struct CamLimits {
    Digits50 least_offset, greatest_offset;  ///< of a translating roller
    Digits50 radius;                         ///< least one of curvature, under a flat face
    Digits50 start_angle;                    ///< of an oscillating flat face
    Digits50 least_distance;                 ///< of its pivot
};

/// The dimension of the certificate has no value below this for any cam of the part's assembly. `dimensions` give the
/// motion, arm length and face offset; 0 where the certificate shows nothing.
Digits50 cam_bound(const Mechanism& mechanism, const MotionProgram& program, std::span<const Digits50> dimensions,
                   const CamLimits& limits, std::size_t dimension, const HalfPlaneCertificate::Part& part);
Digits50 cam_bound(const Mechanism& mechanism, const MotionProgram& program, std::span<const Digits50> dimensions,
                   const CamLimits& limits, std::size_t dimension, const CurvatureCertificate::Part& part);

}  // namespace mechwright
