// Quantities of cams. In the formulas s is the lift, v, a and j its derivatives by the cam angle in radians.

#include "synthesis/mechanism/cam/explained.h"

namespace mechwright {

namespace {

constexpr std::string_view whole_turn = "the whole turn of the cam, continuously";
constexpr std::string_view no_contact = "where an oscillating flat face turns with the cam somewhere";
constexpr std::string_view unless_dynamics = "unless [dynamics] says mass and speed";
constexpr std::string_view pressure_related =
    "pressure-angle-rise, pressure-angle-return, pressure-angle-max, prime-radius, offset, jamming-angle";

std::vector<Formula> pressure_formulas() {
    return {{"oscillating flat-faced",
             "tan of it = face-offset / k, k = pivot-distance cos(p) / (1 + v) the way along the face from the pivot's "
             "foot to the contact, p = start-angle + s (v with a minus where cam and rising face turn alike)",
             "angle between the normal of the face and the way of the contact"},
            {"flat-faced", "0: the face is square to its guide", "definition"},
            {"oscillating",
             "tan of it = (arm-length (1 + v) - pivot-distance cos(p)) / (pivot-distance sin(p)), p = start-angle + s "
             "(v with a minus where cam and rising arm turn alike)",
             "tangent of the pitch curve in the frame of the arm"},
            {"translating", "tan of it = (v - offset) / (sqrt(prime-radius^2 - offset^2) + s)",
             "Theory of Machines, equation (6-31), with an offset"},
            {"", "tan of it = v / (base-radius + roller-radius + s)", "Theory of Machines, equation (6-31)"}};
}

std::vector<Formula> pitch_formulas(std::string_view oscillating, std::string_view translating) {
    return {{"oscillating", oscillating, "curvature of the pitch curve, differentiated by the cam angle"},
            {"", translating, "Theory of Machines, equation (6-32), with an offset"}};
}

std::vector<Explanation> of_size() {
    return {
        {.name = "prime-radius",
         .what =
             "The size of a cam for a roller or a knife edge: the distance of the roller's centre from the cam's at "
             "the lowest position. Larger cams have smaller pressure angles and rounder profiles.",
         .over = "none: it is a dimension",
         .formulas = {{"", "the dimension prime-radius: base radius of the cam + roller-radius", "definition"}},
         .usual = "as small as pressure angle and curvature let it be; where these alone are limited the smallest "
                  "comes in closed form, proven.",
         .undefined = "",
         .require = "max = 60",
         .objective = "minimize",
         .related = "pressure-angle-max, profile-radius-min, offset, cam-size"},
        {.name = "base-radius",
         .what = "The size of a cam: its least radius.",
         .over = "none: it is a dimension",
         .formulas = {{"", "the dimension base-radius", "definition"}},
         .usual = "under a flat face as small as profile-radius-min lets it be.",
         .undefined = "",
         .require = "max = 60",
         .objective = "minimize",
         .related = "profile-radius-min, cam-size, face-length"},
        {.name = "offset",
         .what = "How far the guide of the follower passes the cam's centre. On the side that relieves the rise (> 0) "
                 "it takes from the pressure angle of the rise what it adds to that of the return.",
         .over = "none: it is a dimension",
         .formulas = {{"", "the dimension offset; at most as long as prime-radius", "definition"}},
         .usual = "0, unless rise and return have different limits or lengths: with equal ones it gains nothing.",
         .undefined = "",
         .require = "max = 10",
         .objective = "",
         .related = "prime-radius, pressure-angle-rise, pressure-angle-return"},
        {.name = "pivot-distance",
         .what = "How far the pivot of an oscillating follower is from the cam's centre.",
         .over = "none: it is a dimension",
         .formulas = {{"", "the dimension pivot-distance", "definition"}},
         .usual = "as the space allows; the closest is found with its proof where pressure angles are limited.",
         .undefined = "",
         .require = "max = 120",
         .objective = "minimize",
         .related = "prime-radius, base-radius, start-angle"},
        {.name = "start-angle",
         .what = "How the arm or face of an oscillating follower stands at its lowest position.",
         .over = "the lowest position",
         .formulas = {{"flat-faced", "asin((base-radius + face-offset) / pivot-distance)",
                       "the face touches the base circle"},
                      {"", "acos((pivot-distance^2 + arm-length^2 - prime-radius^2) / (2 pivot-distance arm-length))",
                       "law of cosines in the triangle of the centres"}},
         .usual =
             "20 to 60 deg. A flat face at too small an angle has no cam at all: its profile would be hollow; nor "
             "has one whose start-angle and lift together reach 90 deg: the contact passes over its pivot, and the "
             "cam cannot drive it.",
         .undefined = "",
         .require = "equal = 40",
         .objective = "",
         .related = "pivot-distance, pressure-angle-max, profile-radius-min"},
        {.name = "cam-size",
         .what = "The space that a cam needs: its greatest radius.",
         .over = whole_turn,
         .formulas = {{"", "greatest distance of the contact from the cam's centre", "definition"}},
         .usual = "as small as pressure angle and curvature let it be.",
         .undefined = no_contact,
         .require = "max = 80",
         .objective = "minimize",
         .related = "prime-radius, base-radius"},
        {.name = "face-length",
         .what = "How long a flat face must be: the contact wanders along it.",
         .over = whole_turn,
         .formulas = {{"oscillating",
                       "greatest less least k = pivot-distance cos(p) / (1 + v), p = start-angle + s (v with a minus "
                       "where cam and rising face turn alike)",
                       "contact of the face with its envelope"},
                      {"", "greatest v less least v", "the contact stands at v from the guide"}},
         .usual = "add a few millimetres on each side to what it says.",
         .undefined = no_contact,
         .require = "max = 40",
         .objective = "minimize",
         .related = "velocity-max, base-radius"},
    };
}

std::vector<Explanation> of_contours() {
    constexpr std::string_view flanked = "for eccentric circles, which have no flanks";
    return {
        {.name = "lift",
         .what = "The way of the follower on a cam of a specified contour.",
         .over = "from the base circle to the top of the nose",
         .formulas = {{"eccentric", "2 centre-distance", "definition"},
                      {"", "nose-radius + centre-distance - base-radius", "radius at the nose less that of the base"}},
         .usual = "the task says it.",
         .undefined = "",
         .require = "equal = 6",
         .objective = "maximize",
         .related = "action-angle, flank-angle, base-radius"},
        {.name = "action-angle",
         .what = "The cam angle over which the follower is off the base circle: of a valve, how long it is open.",
         .over = "from the base circle to the base circle",
         .formulas = {{"straight flanks", "2 acos((base-radius - nose-radius) / centre-distance)",
                       "common tangent of base circle and nose"},
                      {"",
                       "2 acos((q^2 - p^2 - centre-distance^2) / (2 p centre-distance)), p = flank-radius - "
                       "base-radius, q = flank-radius - nose-radius",
                       "law of cosines in the triangle of the three centres"}},
         .usual = "110 to 160 deg of the cam for valves of engines.",
         .undefined = flanked,
         .require = "equal = 150",
         .objective = "",
         .related = "lift, flank-angle"},
        {.name = "flank-angle",
         .what =
             "The cam angle, from the end of the base circle, at which the contact passes from flank to nose: until "
             "then the follower is pushed, after it the spring must hold it.",
         .over = "the rise",
         .formulas = {{"straight flanks",
                       "atan(centre-distance sin(e) / (base-radius + roller-radius)), e half the action-angle",
                       "the normal at the end of the flank passes through the nose's centre"},
                      {"flat-faced",
                       "g = asin(centre-distance sin(e) / (flank-radius - nose-radius)), e half the action-angle",
                       "law of sines in the triangle of the three centres"},
                      {"",
                       "the angle at the cam's centre of the triangle with sides flank-radius + roller-radius and "
                       "flank-radius - base-radius, with g between them: sin g = centre-distance sin(e) / "
                       "(flank-radius - nose-radius), e half the action-angle",
                       "law of sines in the triangle of the three centres"}},
         .usual = "a fifth to a third of half the action angle.",
         .undefined = flanked,
         .require = "equal = 25",
         .objective = "",
         .related = "action-angle, lift, acceleration-max"},
    };
}

std::vector<Explanation> of_pressure() {
    constexpr std::string_view usual =
        "at most 30 deg for translating followers (Theory of Machines, chapter 6), at most 45 deg for oscillating ones "
        "in practice; less for fast cams and where friction in the guide counts.";
    constexpr std::string_view what =
        "The angle between the direction in which the cam pushes and that in which the follower can go. What is not "
        "along it presses sideways on guide or pivot.";
    return {
        {.name = "pressure-angle-rise",
         .what = what,
         .over = "all rises, continuously; a cycle counts whole",
         .formulas = pressure_formulas(),
         .usual = usual,
         .undefined = "for motions without a rise, and where an oscillating face turns with the cam somewhere",
         .require = "max = 30",
         .objective = "minimize",
         .related = pressure_related},
        {.name = "pressure-angle-return",
         .what = what,
         .over = "all returns, continuously; a cycle counts whole",
         .formulas = pressure_formulas(),
         .usual = "at most 45 deg where a spring alone drives the return, else as on the rise: 30 deg for translating "
                  "followers (Theory of Machines, chapter 6), 45 deg for oscillating ones in practice.",
         .undefined = "for motions without a return, and where an oscillating face turns with the cam somewhere",
         .require = "max = 45",
         .objective = "minimize",
         .related = pressure_related},
        {.name = "pressure-angle-max",
         .what = what,
         .over = "the whole turn of the cam, dwells too: with an offset they have a pressure angle",
         .formulas = pressure_formulas(),
         .usual = usual,
         .undefined = no_contact,
         .require = "max = 30",
         .objective = "minimize",
         .related = pressure_related},
    };
}

std::vector<Explanation> of_curvature() {
    constexpr std::string_view oscillating =
        "(x^2 + y^2)^(3/2) / (x (x - arm-length a) + y (arm-length (1 + v)^2 - pivot-distance cos p)), x = "
        "pivot-distance sin(p), y = arm-length (1 + v) - pivot-distance cos(p), p = start-angle + s (v with a minus "
        "where cam and rising arm turn alike)";
    constexpr std::string_view translating =
        "(x^2 + y^2)^(3/2) / (x (x - a) + y (y + v)), x = sqrt(prime-radius^2 - offset^2) + s, y = v - offset (of "
        "contours the prime radius is base-radius + roller-radius, the offset 0)";
    constexpr std::string_view flat_oscillating =
        "pivot-distance (sin(p) (1 + 2 v) / (1 + v)^2 + cos(p) a / (1 + v)^3) - face-offset, p = start-angle + s (v "
        "with a minus where cam and rising face turn alike)";
    return {
        {.name = "pitch-radius-min",
         .what = "The least radius of curvature of the way of the roller's centre, as the cam sees it, where that is "
                 "convex. A roller of that radius makes a cusp.",
         .over = whole_turn,
         .formulas = pitch_formulas(oscillating, translating),
         .usual = "at least 1.4 times the roller-radius: the roller at most 0.7 of it (Theory of Machines, chapter 6).",
         .undefined = "",
         .require = "min = 15",
         .objective = "maximize",
         .related = "profile-radius-min, undercut-margin, prime-radius"},
        {.name = "profile-radius-min",
         .what = "The least radius of curvature of the cam itself, where it is convex. Small radii wear; below 0 the "
                 "cam is undercut and the follower does not do what it should.",
         .over = whole_turn,
         .formulas = {{"oscillating flat-faced", flat_oscillating, "support function of the face"},
                      {"flat-faced", "base-radius + s + a", "Theory of Machines, equation (6-29)"},
                      {"", "pitch-radius-min - roller-radius", "the cam is the parallel curve of the pitch curve"}},
         .usual = "some millimetres: what contact stress allows. Under a flat face it must be > 0, hollows are "
                  "impossible.",
         .undefined = no_contact,
         .require = "min = 5",
         .objective = "maximize",
         .related = "undercut-margin, pitch-radius-min, prime-radius, base-radius"},
        {.name = "undercut-margin",
         .what = "How far a cam is from a cusp, as a number without unit.",
         .over = whole_turn,
         .formulas = {{"flat-faced", "profile-radius-min / base-radius", "definition"},
                      {"", "1 - roller-radius / (radius of curvature of the pitch curve), least where that is convex",
                       "definition"}},
         .usual = "at least 0.3: the roller at most 0.7 of the least radius of the pitch curve (Theory of Machines, "
                  "chapter 6). A knife edge has 1.",
         .undefined = no_contact,
         .require = "min = 0.3",
         .objective = "maximize",
         .related = "pitch-radius-min, profile-radius-min"},
    };
}

std::vector<Explanation> of_motion() {
    constexpr std::string_view joints = "the joints of segments, the end of the turn with its beginning too";
    constexpr std::string_view to_the_law = "Theory of Machines, chapter 6";
    return {
        {.name = "velocity-max",
         .what = "The greatest velocity of the follower for a cam of unit angular velocity.",
         .over = whole_turn,
         .formulas = {{"",
                       "greatest |v|; of one segment C lift / angle (angle in radians), C = 1.571 harmonic, 2 "
                       "cycloidal, 1.875 3-4-5, 1.760 modified-sine",
                       to_the_law}},
         .usual = "small where the cam drives a heavy load: torque goes with it.",
         .undefined = "",
         .require = "max = 30",
         .objective = "minimize",
         .related = "acceleration-max, jerk-max, face-length"},
        {.name = "acceleration-max",
         .what = "The greatest acceleration of the follower for a cam of unit angular velocity: times mass and square "
                 "of the angular velocity, the force of inertia.",
         .over = "the whole turn of the cam, continuously; jumps of the velocity, where it is beyond all bounds, are "
                 "not counted",
         .formulas = {{"",
                       "greatest |a|; of one segment C lift / angle^2 (angle in radians), C = 4 parabolic, 4.888 "
                       "modified-trapezoid, 4.935 harmonic, 5.528 modified-sine, 5.774 3-4-5, 6.283 cycloidal",
                       to_the_law}},
         .usual = "as small as a motion without jumps lets it be.",
         .undefined = "",
         .require = "max = 80",
         .objective = "minimize",
         .related = "velocity-jump, acceleration-jump, jerk-max"},
        {.name = "jerk-max",
         .what = "The greatest jerk of the follower for a cam of unit angular velocity: what makes it vibrate.",
         .over = "the whole turn of the cam, continuously; jumps of the acceleration are not counted",
         .formulas = {{"",
                       "greatest |j|; of one segment C lift / angle^3 (angle in radians), C = 39.48 cycloidal, "
                       "52.50 4-5-6-7, 60 3-4-5, 61.43 modified-trapezoid, 69.47 modified-sine",
                       to_the_law}},
         .usual = "finite at least: ask for acceleration-jump = 0 with it.",
         .undefined = "",
         .require = "max = 500",
         .objective = "minimize",
         .related = "acceleration-jump, acceleration-max"},
        {.name = "velocity-jump",
         .what = "How much the velocity of the follower jumps, for a cam of unit angular velocity: a blow.",
         .over = joints,
         .formulas = {{"", "greatest |v after - v before|", "definition"}},
         .usual = "0. constant-velocity against a dwell has one.",
         .undefined = "",
         .require = "max = 0",
         .objective = "minimize",
         .related = "acceleration-jump, jerk-jump, velocity-max"},
        {.name = "acceleration-jump",
         .what = "How much the acceleration of the follower jumps, for a cam of unit angular velocity: infinite jerk.",
         .over = joints,
         .formulas = {{"", "greatest |a after - a before|", "definition"}},
         .usual = "0 for all but slow cams. harmonic and parabolic against a dwell have one.",
         .undefined = "",
         .require = "max = 0",
         .objective = "minimize",
         .related = "velocity-jump, jerk-jump, jerk-max"},
        {.name = "jerk-jump",
         .what = "How much the jerk of the follower jumps, for a cam of unit angular velocity.",
         .over = joints,
         .formulas = {{"", "greatest |j after - j before|", "definition"}},
         .usual = "0 for very fast cams only, as 4-5-6-7 has it against a dwell.",
         .undefined = "",
         .require = "max = 50",
         .objective = "minimize",
         .related = "acceleration-jump, jerk-max"},
        {.name = "turn",
         .what = "Whether the segments make a full turn, where their angles are ranges.",
         .over = "all segments",
         .formulas = {{"", "sum of the angles of all segments", "definition"}},
         .usual = "360 deg: it is required without being said.",
         .undefined = "",
         .require = "equal = 360",
         .objective = "",
         .related = "lift-balance"},
        {.name = "lift-balance",
         .what = "Whether the follower comes back to where it began, where the lifts are ranges.",
         .over = "all segments",
         .formulas = {{"", "sum of the lifts of all rises less that of all returns", "definition"}},
         .usual = "0: it is required without being said.",
         .undefined = "",
         .require = "equal = 0",
         .objective = "",
         .related = "turn"},
    };
}

std::vector<Explanation> of_forces() {
    return {
        {.name = "spring-rate",
         .what = "How stiff the spring is that holds the follower to the cam.",
         .over = "none: it is a dimension",
         .formulas = {{"", "the dimension spring-rate, force per length", "definition"}},
         .usual = "as soft as contact-force-min lets it be.",
         .undefined = "",
         .require = "max = 10",
         .objective = "minimize",
         .related = "precompression, contact-force-min, jump-speed"},
        {.name = "precompression",
         .what = "By how much the spring is compressed at the follower's lowest position.",
         .over = "none: it is a dimension",
         .formulas = {{"", "the dimension precompression", "definition"}},
         .usual = "as little as contact-force-min lets it be.",
         .undefined = "",
         .require = "max = 30",
         .objective = "minimize",
         .related = "spring-rate, contact-force-min, jump-speed"},
        {.name = "contact-force-min",
         .what = "The least force with which the follower is held to the cam. Below 0 it leaves the cam and comes back "
                 "with a blow.",
         .over = whole_turn,
         .formulas = {{"",
                       "least of weight + load + spring-rate (precompression + s) + mass w^2 a, w the angular velocity "
                       "of the cam in radians per second",
                       "Newton's law along the guide"}},
         .usual = "above 0 with something in hand for vibration: a third of the force of inertia.",
         .undefined = unless_dynamics,
         .require = "min = 20",
         .objective = "maximize",
         .related = "contact-force-max, jump-speed, spring-rate, precompression"},
        {.name = "contact-force-max",
         .what = "The greatest force between cam and follower: what the surface and the bearings must bear.",
         .over = whole_turn,
         .formulas =
             {{"flat-faced",
               "greatest of F = weight + load + spring-rate (precompression + s) + mass w^2 a, w the angular velocity "
               "of the cam in radians per second",
               "Newton's law along the guide"},
              {"",
               "greatest of F / (cos p - f (2 overhang + guide-length - f stem-diameter) / guide-length |sin p|), F = "
               "weight + load + spring-rate (precompression + s) + mass w^2 a, p the pressure angle, f the friction, w "
               "the angular velocity of the cam; without guide-length or friction F / cos p",
               "Newton's law along the guide, moments about the two edges of the guide"}},
         .usual = "what contact stress allows.",
         .undefined = unless_dynamics,
         .require = "max = 500",
         .objective = "minimize",
         .related = "contact-force-min, drive-torque-max, jamming-angle"},
        {.name = "drive-torque-max",
         .what = "The greatest torque that the cam's shaft must give, or hold back.",
         .over = whole_turn,
         .formulas = {{"", "greatest |N v cos p|, N the contact force, p the pressure angle",
                       "the normal passes the axis at the distance v cos p"}},
         .usual = "what the drive has.",
         .undefined = unless_dynamics,
         .require = "max = 5000",
         .objective = "minimize",
         .related = "contact-force-max, velocity-max"},
        {.name = "jump-speed",
         .what = "The speed, in turns per minute, at which the follower leaves the cam.",
         .over = whole_turn,
         .formulas = {{"",
                       "30 / pi sqrt(least of (weight + load + spring-rate (precompression + s)) / (-mass a) where a < "
                       "0)",
                       "contact force zero"}},
         .usual = "well above the speed at which the cam runs, 1.3 times or more.",
         .undefined = "unless [dynamics] says the mass",
         .require = "min = 1800",
         .objective = "maximize",
         .related = "contact-force-min, spring-rate, precompression, acceleration-max"},
        {.name = "jamming-angle",
         .what = "The pressure angle at which no force moves the follower any more: friction in its guide holds it.",
         .over = "none: it depends on guide and friction alone",
         .formulas = {{"", "atan(guide-length / (f (2 overhang + guide-length - f stem-diameter))), f the friction",
                       "moments about the two edges of the guide"}},
         .usual = "far above the pressure angles: twice as much.",
         .undefined = "unless [dynamics] says friction",
         .require = "min = 60",
         .objective = "maximize",
         .related = "pressure-angle-max, contact-force-max"},
    };
}

}  // namespace

std::vector<Explanation> cam_explanations() {
    std::vector<Explanation> all;
    for (const auto& part : {of_size(), of_contours(), of_pressure(), of_curvature(), of_motion(), of_forces()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace mechwright
