#include "synthesis/mechanism/cam/cam.h"

#include <algorithm>

#include "synthesis/mechanism/cam/check_cam.h"
#include "synthesis/mechanism/cam/curves.h"
#include "synthesis/mechanism/cam/drawing.h"
#include "synthesis/mechanism/cam/explained.h"
#include "synthesis/mechanism/cam/nearest_limit.h"
#include "synthesis/mechanism/cam/tasks.h"

namespace mechwright {

namespace {

using namespace cam;

Dimension prime_radius() {
    return {"prime-radius", DimensionKind::length, true, "least distance of the roller centre from the cam centre"};
}

Dimension base_radius() { return {"base-radius", DimensionKind::length, true, "least radius of the cam"}; }

Dimension pivot_distance() {
    return {"pivot-distance", DimensionKind::length, true, "distance of the follower's pivot from the cam centre"};
}

Dimension roller_radius() { return {"roller-radius", DimensionKind::length, true, "radius of the roller"}; }

Dimension no_roller() { return {"roller-radius", DimensionKind::coordinate, false, "a knife edge has none"}; }

/// Of the circles of a contour; those that a kind does not have stay 0 and are not read.
std::vector<Dimension> contour_dimensions(ContourKind contour, bool roller) {
    const bool nose = contour != ContourKind::eccentric, arc = contour == ContourKind::circular_arc;
    const Dimension none{"", DimensionKind::coordinate, false, "", true};
    std::vector<Dimension> all{
        base_radius(),
        nose ? Dimension{"nose-radius", DimensionKind::length, true, "radius of the nose"} : none,
        {"centre-distance", DimensionKind::length, true,
         nose ? "distance of the nose's centre from the cam centre" : "eccentricity of the circle"},
        arc ? Dimension{"flank-radius", DimensionKind::length, true, "radius of the flanks"} : none};
    if (roller) all.push_back(roller_radius());
    return all;
}

template <template <class> class F>
std::vector<Dimension> geometry_dimensions(bool knife, ContourKind contour) {
    if constexpr (is_contour<F>) return contour_dimensions(contour, Layout<F>::roller);
    const Dimension roller = knife ? no_roller() : roller_radius();
    if constexpr (std::is_same_v<F<double>, TranslatingRoller<double>>)
        return {prime_radius(),
                {"offset", DimensionKind::coordinate, false,
                 "distance of the guide from the cam centre, > 0 on the side that relieves the rise"},
                roller};
    else if constexpr (std::is_same_v<F<double>, OscillatingRoller<double>>)
        return {prime_radius(),
                pivot_distance(),
                {"arm-length", DimensionKind::length, true, "distance of the roller centre from the pivot"},
                roller};
    else if constexpr (std::is_same_v<F<double>, TranslatingFlat<double>>)
        return {base_radius()};
    else
        return {base_radius(),
                pivot_distance(),
                {"face-offset", DimensionKind::coordinate, false,
                 "distance of the face from the pivot, > 0 towards the cam"}};
}

/// As many as `load_count`.
std::vector<Dimension> load_dimensions() {
    return {
        {"spring-rate", DimensionKind::rate, false, "force of the spring per length"},
        {"precompression", DimensionKind::coordinate, false, "of the spring at the lowest position"},
        {"load", DimensionKind::force, false, "any other force on the follower towards the cam"},
        {"weight", DimensionKind::force, false, "of the follower, towards the cam"},
        {"guide-length", DimensionKind::coordinate, false, "length of the guide"},
        {"overhang", DimensionKind::coordinate, false, "of the follower's end over the near edge of the guide"},
        {"stem-diameter", DimensionKind::coordinate, false, "of the follower in its guide"},
    };
}

constexpr double unlimited = std::numeric_limits<double>::infinity();
std::vector<Setting> load_settings() {
    return {
        {"dynamics", "mass", 0, 0, unlimited, "of all that moves with the follower", false, true},
        {"dynamics", "speed", 0, 0, unlimited, "of the cam, in turns per minute"},
        {"dynamics", "friction", 0, 0, 1, "coefficient of friction in the guide", true},
    };
}

template <template <class> class F>
std::vector<Dimension> dimensions_of(bool knife, ContourKind contour) {
    std::vector<Dimension> all = geometry_dimensions<F>(knife, contour);
    if constexpr (Layout<F>::geometry > Layout<F>::shape)
        for (Dimension& load : load_dimensions())
            all.push_back(std::move(load));
    const DimensionKind lift = Layout<F>::oscillating ? DimensionKind::angle : DimensionKind::coordinate;
    const auto add = [&](std::size_t count, std::string_view name, DimensionKind kind, const char* meaning) {
        for (std::size_t i = 1; i <= count; ++i)
            all.push_back({fmt::format("{}-{}", name, i), kind, false, meaning, true});
    };
    add(MotionProgram::most_segments, "angle", DimensionKind::angle, "angle of a segment of the motion");
    add(MotionProgram::most_segments, "lift", lift, "lift of a segment of the motion");
    add(MotionProgram::most_coefficients, "coefficient", lift, "number of a polynomial of the motion");
    return all;
}

/// Linear conditions of the geometry, coefficients of the first dimensions.
template <template <class> class F, ContourKind contour>
std::vector<LinearCondition> conditions() {
    if constexpr (contour != ContourKind::none) {
        if (contour == ContourKind::eccentric) return {};
        std::vector<LinearCondition> all{{"the nose stands out of the base circle", {-1, 1, 1}},
                                         {"the nose is not inside out", {1, -1, 1}}};
        if (contour == ContourKind::circular_arc) {
            all.push_back({"the flanks are flatter than the base circle", {-1, 0, 0, 1}});
            all.push_back({"the flanks are flatter than the nose", {0, -1, 0, 1}});
            all.push_back({"the flanks reach the nose", {-1, -1, -1, 2}});
        }
        return all;
    }
    if constexpr (std::is_same_v<F<double>, TranslatingRoller<double>>)
        return {{"the guide reaches the cam on one side", {1, -1}},
                {"the guide reaches the cam on the other side", {1, 1}}};
    else if constexpr (std::is_same_v<F<double>, OscillatingRoller<double>>)
        return {{"the arm reaches the cam", {-1, 1, 1}},
                {"the arm is not too short", {1, -1, 1}},
                {"the arm is not too long", {1, 1, -1}}};
    else if constexpr (std::is_same_v<F<double>, OscillatingFlat<double>>)
        return {{"the pivot lies outside the cam", {-1, 1, -1}}, {"the face is on the cam's side", {1, 0, 1}}};
    else
        return {};
}

Motion whole_turn(Form form, std::span<const double>, const double*) {
    Motion motion;
    motion.assembly = form.assembly;
    motion.to = 2 * pi<double>();
    return motion;
}

/// There is nothing to derive: a cam turns.
Motion whole_turn_again(Form form, std::span<const Digits50>, const std::optional<Vector<Digits50>>&) {
    return whole_turn(form, {}, nullptr);
}

/// Where a cam angle lies in the motion program; past the end the last segment's end.
struct At {
    std::size_t segment, piece;
    double u;
};

template <template <class> class F>
At place_of(const Motion& motion, std::span<const double> d, double cam_angle) {
    const std::size_t n = program_of(motion).segments.size();
    std::size_t i = 0;
    double left = cam_angle;
    while (i + 1 < n && left >= d[slots<F>.angle(i)])
        left -= d[slots<F>.angle(i++)];
    const Segment<double> segment = placed_segment<F>(motion, d, i).segment;
    if (segment.law.form == SegmentLaw::Form::contour) {
        const auto angles = piece_angles(segment.contour);
        std::size_t piece = 0;
        while (piece + 1 < pieces(segment) && cam_angle > angles[piece + 1])
            ++piece;
        const double part = std::clamp((cam_angle - angles[piece]) / (angles[piece + 1] - angles[piece]), 0.0, 1.0);
        return {0, piece, (static_cast<double>(piece) + part) / static_cast<double>(pieces(segment))};
    }
    double u = std::clamp(left / segment.angle, 0.0, 1.0);
    std::size_t piece = 0;
    if (segment.law.form == SegmentLaw::Form::table && u < break_before(segment, 0)) u += 1;
    while (piece + 1 < pieces(segment) && u > break_before(segment, piece + 1))
        ++piece;
    return {i, piece, u};
}

template <template <class> class F>
void add_corners(const Motion& motion, std::span<const double> d, std::vector<double>& angles) {
    double begin = 0;
    for (std::size_t i = 0; i < program_of(motion).segments.size(); ++i) {
        const Segment<double> segment = placed_segment<F>(motion, d, i).segment;
        if (segment.law.form == SegmentLaw::Form::contour) {
            const auto ends = piece_angles(segment.contour);
            angles.insert(angles.end(), ends.begin(), ends.end());
            return;
        }
        for (std::size_t piece = 0; piece <= pieces(segment); ++piece)
            angles.push_back(begin + std::min(break_before(segment, piece), 1.0) * segment.angle);
        begin += segment.angle;
    }
}

std::vector<std::string> columns() {
    return {"cam-angle", "lift",      "velocity",  "acceleration",   "jerk",         "pressure-angle", "pitch-x",
            "pitch-y",   "profile-x", "profile-y", "profile-radius", "face-contact", "normal-x",       "normal-y"};
}

std::vector<Unit> column_units(bool oscillating) {
    const Unit lift = oscillating ? Unit::angle : Unit::length;
    return {Unit::angle,  lift,         lift,         lift,         lift,         Unit::angle, Unit::length,
            Unit::length, Unit::length, Unit::length, Unit::length, Unit::length, Unit::none,  Unit::none};
}

/// Points are those of the cam as it lies at cam angle 0. The pitch curve of a flat follower is the cam itself.
template <template <class> class F>
bool motion_row(const Motion& motion, std::span<const double> d, double cam_angle, std::span<double> row) {
    const At at = place_of<F>(motion, d, cam_angle);
    const PlacedSegment placed = placed_segment<F>(motion, d, at.segment);
    const Lift<double> lift = lift_at(placed.segment, at.piece, at.u, placed.start_lift);
    const auto f = follower_of<F, double>(d, motion.assembly);
    const double back = -f.sense * cam_angle;
    const Vector<double> turn{std::cos(back), std::sin(back)};
    double angle, radius, along = 0;
    Vector<double> pitch, profile, outward;
    if constexpr (Layout<F>::roller) {
        const auto p = pitch_point(f, lift);
        angle = pressure_angle(p);
        pitch = p.position;
        outward = normal(p);
        profile = contact_point(p, f.roller_radius);
        radius = 1 / curvature(p) - f.roller_radius;
    } else {
        const auto p = face_contact(f, lift);
        angle = p.pressure_angle;
        pitch = profile = p.position;
        outward = p.normal;
        radius = p.radius;
        along = p.along;
    }
    pitch = turned(pitch, turn);
    profile = turned(profile, turn);
    outward = turned(outward, turn);
    const std::array<double, 14> values{cam_angle, lift.s,    lift.v,    lift.a, lift.j, angle,     pitch.x,
                                        pitch.y,   profile.x, profile.y, radius, along,  outward.x, outward.y};
    std::copy(values.begin(), values.end(), row.begin());
    return true;
}

/// "translating roller follower", "circular flanks and a flat-faced follower".
std::string name_of(const CamKind& kind) {
    constexpr std::array<std::string_view, 3> followers{"knife-edge", "roller", "flat-faced"};
    constexpr std::array<std::string_view, 4> contours{"", "straight flanks", "circular flanks", "an eccentric circle"};
    const std::string_view follower = followers[static_cast<std::size_t>(kind.follower)];
    if (kind.contour != ContourKind::none)
        return fmt::format("{} and a {} follower", contours[static_cast<std::size_t>(kind.contour)], follower);
    return fmt::format("{} {} follower", kind.oscillating ? "oscillating" : "translating", follower);
}

std::optional<Objection> knife_has_no_roller(std::size_t roller, std::span<const double> least,
                                             std::span<const double> greatest) {
    if (least[roller] == 0 && greatest[roller] == 0) return std::nullopt;
    return Objection{roller, "a knife edge has no roller-radius: leave it out, or write follower = \"roller\""};
}

/// The smallest offset that the ranges allow against the greatest prime radius.
std::optional<Objection> offset_too_large(std::span<const double> least, std::span<const double> greatest) {
    const double offset = least[1] > 0 ? least[1] : greatest[1] < 0 ? -greatest[1] : 0;
    if (offset <= greatest[0]) return std::nullopt;
    return Objection{
        1, fmt::format("the offset is larger than the prime-radius, by {:.6g}: the guide would pass the cam by; "
                       "it must be {:.6g} at most",
                       offset - greatest[0], greatest[0])};
}

/// Circles of a contour that cannot meet, however the ranges are used.
std::optional<Objection> circles_apart(ContourKind contour, std::span<const double> least,
                                       std::span<const double> greatest) {
    if (contour == ContourKind::none || contour == ContourKind::eccentric) return std::nullopt;
    constexpr std::size_t base = 0, nose = 1, distance = 2, flank = 3;
    if (const double lift = greatest[distance] + greatest[nose] - least[base]; !(lift > 0))
        return Objection{distance,
                         fmt::format("the nose does not stand out of the base circle: centre-distance and nose-radius "
                                     "together must exceed base-radius, and fall short of it by {:.6g}",
                                     -lift)};
    if (contour == ContourKind::circular_arc)
        if (const double room = 2 * greatest[flank] - least[base] - least[nose] - least[distance]; !(room > 0))
            return Objection{
                flank, fmt::format("the flanks do not reach the nose: twice the flank-radius must exceed base-radius, "
                                   "nose-radius and centre-distance together, and falls short of them by {:.6g}",
                                   -room)};
    return std::nullopt;
}

template <template <class> class F, bool knife, ContourKind contour>
std::optional<Objection> objection(std::span<const double> least, std::span<const double> greatest) {
    if constexpr (Layout<F>::roller && knife)
        if (const auto no = knife_has_no_roller(Layout<F>::shape - 1, least, greatest)) return no;
    if constexpr (std::is_same_v<F<double>, TranslatingRoller<double>>) return offset_too_large(least, greatest);
    return circles_apart(contour, least, greatest);
}

std::string describe(Form form, std::span<const double>) {
    return "cam with " + name_of(static_cast<const CamModel*>(form.model)->kind);
}

template <template <class> class F, bool knife, ContourKind contour = ContourKind::none>
std::shared_ptr<const Mechanism> entry() {
    static const auto mechanism = [] {
        constexpr bool loaded = Layout<F>::geometry > Layout<F>::shape, oscillating = Layout<F>::oscillating;
        constexpr CamFollower follower = !Layout<F>::roller ? CamFollower::flat
                                         : knife            ? CamFollower::knife
                                                            : CamFollower::roller;
        const CamKind kind{follower, oscillating, contour};
        return std::make_shared<const Mechanism>(
            Mechanism{.name = "cam",
                      .meaning = "disc cam with " + name_of(kind),
                      .dimensions = dimensions_of<F>(knife, contour),
                      .assemblies = {},
                      .quantities = cam_quantities<F>(),
                      .families = {{"cam", true, conditions<F, contour>(), existence_margin<F>()}},
                      .settings = loaded ? load_settings() : std::vector<Setting>{},
                      .model = Model(CamModel{kind}),
                      .objection = objection<F, knife, contour>,
                      .motion = whole_turn,
                      .motion_again = whole_turn_again,
                      .describe = describe,
                      .nearest_limit = nearest_limit<F>,
                      .check_motion = check_cam<F>,
                      .table = {columns(), column_units(oscillating), motion_row<F>},
                      .explanations = cam_explanations,
                      .tasks = cam_tasks(kind),
                      .drawing = cam_drawing(),
                      .profile = CutProfile{mechwright::roller_radius, cam_corners, cam_curve}});
    }();
    return mechanism;
}

}  // namespace

std::shared_ptr<const Mechanism> cam_mechanism(CamFollower follower, bool oscillating) {
    switch (follower) {
        case CamFollower::knife:
            return oscillating ? entry<OscillatingRoller, true>() : entry<TranslatingRoller, true>();
        case CamFollower::flat: return oscillating ? entry<OscillatingFlat, false>() : entry<TranslatingFlat, false>();
        default: return oscillating ? entry<OscillatingRoller, false>() : entry<TranslatingRoller, false>();
    }
}

std::shared_ptr<const Mechanism> contour_cam_mechanism(CamFollower follower, ContourKind contour) {
    const bool flat = follower == CamFollower::flat;
    switch (contour) {
        case ContourKind::tangent: return flat ? nullptr : entry<ContourRoller, false, ContourKind::tangent>();
        case ContourKind::circular_arc:
            return flat ? entry<ContourFlat, false, ContourKind::circular_arc>()
                        : entry<ContourRoller, false, ContourKind::circular_arc>();
        case ContourKind::eccentric:
            return flat ? entry<ContourFlat, false, ContourKind::eccentric>()
                        : entry<ContourRoller, false, ContourKind::eccentric>();
        case ContourKind::none: break;
    }
    return nullptr;
}

std::shared_ptr<const Mechanism> with_program(const Mechanism& cam, std::shared_ptr<const MotionProgram> program) {
    Mechanism moved = cam;
    moved.model = Model(CamModel{cam_kind(cam), std::move(program)});
    return std::make_shared<const Mechanism>(std::move(moved));
}

std::vector<std::shared_ptr<const Mechanism>> cam_mechanisms() {
    using enum CamFollower;
    using enum ContourKind;
    return {cam_mechanism(roller, false),
            cam_mechanism(roller, true),
            cam_mechanism(knife, false),
            cam_mechanism(knife, true),
            cam_mechanism(flat, false),
            cam_mechanism(flat, true),
            contour_cam_mechanism(roller, tangent),
            contour_cam_mechanism(roller, circular_arc),
            contour_cam_mechanism(flat, circular_arc),
            contour_cam_mechanism(roller, eccentric),
            contour_cam_mechanism(flat, eccentric)};
}

bool is_cam(const Mechanism& mechanism) { return mechanism.model.as<CamModel>() != nullptr; }

CamKind cam_kind(const Mechanism& mechanism) { return mechanism.model.as<CamModel>()->kind; }

const MotionProgram* program_of(const Mechanism& mechanism) {
    const CamModel* model = mechanism.model.as<CamModel>();
    return model ? model->program.get() : nullptr;
}

namespace {

/// How many dimensions come before those of the segments.
std::size_t geometry_count(const Mechanism& mechanism) { return mechanism.dimensions.size() - ProgramSlots{0}.end(); }

}  // namespace

void cam_corners(const Mechanism& mechanism, const Motion& motion, std::span<const double> dimensions,
                 std::vector<double>& angles) {
    const CamKind kind = cam_kind(mechanism);
    const bool flat = kind.follower == CamFollower::flat;
    if (kind.contour != ContourKind::none)
        return flat ? add_corners<ContourFlat>(motion, dimensions, angles)
                    : add_corners<ContourRoller>(motion, dimensions, angles);
    if (flat)
        return kind.oscillating ? add_corners<OscillatingFlat>(motion, dimensions, angles)
                                : add_corners<TranslatingFlat>(motion, dimensions, angles);
    return kind.oscillating ? add_corners<OscillatingRoller>(motion, dimensions, angles)
                            : add_corners<TranslatingRoller>(motion, dimensions, angles);
}

std::size_t cam_angle_dimension(const Mechanism& mechanism, std::size_t segment) {
    return ProgramSlots{geometry_count(mechanism)}.angle(segment);
}

std::size_t cam_lift_dimension(const Mechanism& mechanism, std::size_t segment) {
    return ProgramSlots{geometry_count(mechanism)}.lift(segment);
}

std::size_t cam_coefficient_dimension(const Mechanism& mechanism, std::size_t index) {
    return ProgramSlots{geometry_count(mechanism)}.coefficient(index);
}

}  // namespace mechwright
