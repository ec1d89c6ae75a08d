#pragma once
/// \file
/// The quantities of cams as measures at a place: `value` is what counts, `search` what is to be greatest there if that
/// is something else. A quantity looks in the segments of the kinds it names, for the greatest values of sign * search.

#include <cmath>

#include "synthesis/mechanism/cam/measured_program.h"

namespace mechwright::cam {

inline bool in_rises(SegmentKind kind) { return kind == SegmentKind::rise || kind == SegmentKind::cycle; }
inline bool in_returns(SegmentKind kind) { return kind == SegmentKind::fall || kind == SegmentKind::cycle; }
inline bool anywhere(SegmentKind) { return true; }

struct PressureAngle {
    template <template <class> class Follower, class T>
    static T value(const Follower<T>& f, const Lift<T>& lift) {
        if constexpr (Layout<Follower>::roller)
            return pressure_angle(pitch_point(f, lift));
        else
            return face_contact(f, lift).pressure_angle;
    }
};

/// Curvature of the pitch curve, and its radius; where it is hollow the radius counts as very great.
struct PitchRadius {
    template <template <class> class Follower, class T>
    static T search(const Follower<T>& f, const Lift<T>& lift) {
        return curvature(pitch_point(f, lift));
    }
    template <template <class> class Follower, class T>
    static T value(const Follower<T>& f, const Lift<T>& lift) {
        const auto p = pitch_point(f, lift);
        const T k = curvature(p), flattest = T(1e-6) / p.across;
        return T(1) / (k > flattest ? k : flattest);
    }
};

/// Of the cam itself. Under a flat face the radius is what is found, signed.
struct ProfileRadius {
    template <template <class> class Follower, class T>
    static T search(const Follower<T>& f, const Lift<T>& lift) {
        if constexpr (Layout<Follower>::roller)
            return curvature(pitch_point(f, lift));
        else
            return -face_contact(f, lift).radius;
    }
    template <template <class> class Follower, class T>
    static T value(const Follower<T>& f, const Lift<T>& lift) {
        if constexpr (Layout<Follower>::roller)
            return PitchRadius::value(f, lift) - f.roller_radius;
        else
            return face_contact(f, lift).radius;
    }
};

/// 1 - roller radius times curvature; under a flat face the radius of curvature over the base radius.
struct UndercutMargin {
    template <template <class> class Follower, class T>
    static T search(const Follower<T>& f, const Lift<T>& lift) {
        return -value(f, lift);
    }
    template <template <class> class Follower, class T>
    static T value(const Follower<T>& f, const Lift<T>& lift) {
        if constexpr (Layout<Follower>::roller)
            return T(1) - f.roller_radius * curvature(pitch_point(f, lift));
        else
            return face_contact(f, lift).radius / f.base_radius;
    }
};

/// Distance of the contact from the cam centre.
struct ContactDistance {
    template <template <class> class Follower, class T>
    static T value(const Follower<T>& f, const Lift<T>& lift) {
        if constexpr (Layout<Follower>::roller) {
            const auto p = contact_point(pitch_point(f, lift), f.roller_radius);
            return hypotenuse(p.x, p.y);
        } else {
            const auto p = face_contact(f, lift).position;
            return hypotenuse(p.x, p.y);
        }
    }
};

/// Where along the face the contact is.
struct ContactAlongFace {
    template <template <class> class Follower, class T>
    static T value(const Follower<T>& f, const Lift<T>& lift) {
        return face_contact(f, lift).along;
    }
};

/// How far the follower is from a position in which the cam cannot hold it: the roller centre across its direction of
/// motion from the cam's instant centre; under a face the turning of face against cam.
struct FollowMargin {
    template <template <class> class Follower, class T>
    static T search(const Follower<T>& f, const Lift<T>& lift) {
        return -value(f, lift);
    }
    template <template <class> class Follower, class T>
    static T value(const Follower<T>& f, const Lift<T>& lift) {
        if constexpr (Layout<Follower>::roller)
            return pitch_point(f, lift).across;
        else
            return f.base_radius * face_contact(f, lift).margin;
    }
};

/// How far an oscillating face is from a position in which its contact passes over its pivot and the cam cannot turn
/// it.
struct LeverMargin {
    template <template <class> class Follower, class T>
    static T search(const Follower<T>& f, const Lift<T>& lift) {
        return -value(f, lift);
    }
    template <template <class> class Follower, class T>
    static T value(const Follower<T>& f, const Lift<T>& lift) {
        return foot_along_face(f, lift);
    }
};

/// Angle of the arm or face to the line of centres at the lowest position.
struct StartAngle {
    template <template <class> class Follower, class T>
    static T value(const Follower<T>& f, const Lift<T>&) {
        if constexpr (Layout<Follower>::roller)
            return angle(arm_start(f));
        else
            return face_start(f);
    }
};

/// Force along the guide.
struct AxialForce {
    template <template <class> class Follower, class T>
    static T search(const Follower<T>&, const Lift<T>& lift, const FollowerLoad<T>& load) {
        return -axial_force(load, lift);
    }
    template <template <class> class Follower, class T>
    static T value(const Follower<T>&, const Lift<T>& lift, const FollowerLoad<T>& load) {
        return axial_force(load, lift);
    }
};

/// Force between cam and follower, friction in the guide counted.
struct ContactForce {
    template <template <class> class Follower, class T>
    static T value(const Follower<T>& f, const Lift<T>& lift, const FollowerLoad<T>& load) {
        if constexpr (Layout<Follower>::roller) {
            const auto p = pitch_point(f, lift);
            const T speed = hypotenuse(p.across, p.along);
            return axial_force(load, lift) / effective_cosine(load, T(p.across / speed), T(p.along / speed));
        } else {
            return axial_force(load, lift);
        }
    }
};

/// Of the contact force about the cam's axis: the normal passes the axis at the distance v cos(pressure angle).
struct DriveTorque {
    template <template <class> class Follower, class T>
    static T value(const Follower<T>& f, const Lift<T>& lift, const FollowerLoad<T>& load) {
        const T force = ContactForce::value(f, lift, load);
        if constexpr (Layout<Follower>::roller) {
            const auto p = pitch_point(f, lift);
            return force * lift.v * p.across / hypotenuse(p.across, p.along);
        } else {
            return force * lift.v;
        }
    }
};

/// Speed in turns per minute at which the follower leaves the cam. Where it is not lifted: very great.
struct JumpSpeed {
    template <template <class> class Follower, class T>
    static T search(const Follower<T>&, const Lift<T>& lift, const FollowerLoad<T>& load) {
        return lifting_tendency(load, lift);
    }
    template <template <class> class Follower, class T>
    static T value(const Follower<T>&, const Lift<T>& lift, const FollowerLoad<T>& load) {
        using std::sqrt;
        const T tendency = lifting_tendency(load, lift), least(1e-12);
        return T(30 / pi<double>()) / sqrt(tendency > least ? tendency : least);
    }
};

struct JammingAngle {
    template <template <class> class Follower, class T>
    static T value(const Follower<T>&, const Lift<T>&, const FollowerLoad<T>& load) {
        return jamming_angle(load);
    }
};

/// A derivative of the lift.
template <int order>
struct LiftDerivative {
    template <template <class> class Follower, class T>
    static T value(const Follower<T>&, const Lift<T>& lift) {
        return of(lift);
    }
    template <class T>
    static T of(const Lift<T>& lift) {
        return order == 1 ? lift.v : order == 2 ? lift.a : lift.j;
    }
};
using Velocity = LiftDerivative<1>;
using Acceleration = LiftDerivative<2>;
using Jerk = LiftDerivative<3>;

}  // namespace mechwright::cam
