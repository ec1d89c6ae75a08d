// [[drive.segment]]: the motion of a drive as segments of a turn of the first one, read as those of a cam are.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/read/segment.h"
#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/schema/keys.h"

namespace mechwright::reading {

namespace {

constexpr double rounding = 1e-12;
/// Radians, far below what can be made: what is narrower is no segment.
constexpr double narrowest = 1e-6;

/// Whether every dimension of a segment is a number, and its law one.
bool is_given(const Problem& cam, const SegmentPlan& plan, std::size_t index, std::size_t coefficients,
              const Section& section, Messages& messages) {
    const auto is_number = [&](std::size_t dimension, std::string_view key) {
        if (cam.dimensions[dimension].fixed()) return true;
        add_error(messages, place_of(section, key),
                  fmt::format("{} must be a number: the motion of a drive is not designed", name_of(section, key)));
        return false;
    };
    bool given = is_number(cam_angle_dimension(*cam.mechanism, index), "angle");
    if (plan.kind != cam::SegmentKind::dwell)
        given = is_number(cam_lift_dimension(*cam.mechanism, index), "lift") && given;
    std::size_t next = plan.first_coefficient;
    const auto are_numbers = [&](std::size_t count, std::string_view key) {
        for (std::size_t i = 0; i < count && given && next < coefficients; ++i)
            given = is_number(cam_coefficient_dimension(*cam.mechanism, next++), key);
    };
    are_numbers(plan.start_count, "start");
    are_numbers(plan.end_count, "end");
    are_numbers(plan.shape_count, "shape");
    if (plan.laws.size() <= 1) return given;
    add_error(messages, place_of(section, "law"),
              fmt::format("{} must be one law: the motion of a drive is not designed", name_of(section, "law")));
    return false;
}

/// The segments in a number type, of a cam whose dimensions are given.
template <class R>
std::shared_ptr<const linkage::DriveMotion<R>> motion_of(const Problem& cam, const MotionProgram& program) {
    std::vector<R> dimensions;
    for (const DimensionRange& range : cam.dimensions)
        dimensions.push_back(R(range.min));
    const cam::ProgramSlots slots{cam_angle_dimension(*cam.mechanism, 0)};
    std::vector<cam::Segment<R>> segments;
    for (std::size_t i = 0; i < program.segments.size(); ++i)
        segments.push_back(
            cam::segment_of(program, 0, i, cam::parameters_of(program, slots, std::span<const R>(dimensions), i)));
    return std::make_shared<const linkage::DriveMotion<R>>(linkage::drive_motion(std::move(segments)));
}

/// A motion with what its pieces are made of.
template <class R>
std::shared_ptr<const linkage::DriveMotion<R>> kept(std::shared_ptr<const linkage::DriveMotion<R>> motion,
                                                    std::shared_ptr<const MotionProgram> program) {
    struct Both {
        std::shared_ptr<const linkage::DriveMotion<R>> motion;
        std::shared_ptr<const MotionProgram> program;
    };
    const auto both = std::make_shared<const Both>(Both{std::move(motion), std::move(program)});
    return {both, both->motion.get()};
}

/// Whether the segments make up a turn, after which the input is where it was, or goes on in its one sense.
bool closes(const LinkageReading& reading, const linkage::DriveMotion<double>& motion, bool of_slide, FilePlace place,
            std::string_view title) {
    const bool degrees = reading.made.units.degrees;
    const auto shown = [&](double value, bool angle) {
        return fmt::format("{:.10g}{}", angle && degrees ? value * 180 / std::numbers::pi : value,
                           !angle    ? ""
                           : degrees ? " deg"
                                     : " rad");
    };
    const double angle = motion.begin.back() + motion.segments.back().angle, apart = angle - whole_turn;
    if (std::abs(apart) > rounding * whole_turn) {
        add_error(reading.messages, place,
                  fmt::format("the segments' angles of {} add up to {}, {} {} a full turn of the first drive", title,
                              shown(angle, true), shown(std::abs(apart), true), apart > 0 ? "more than" : "short of"));
        return false;
    }
    double greatest = 0;
    bool rises = false, falls = false;
    for (const auto& segment : motion.segments) {
        greatest = std::max(greatest, segment.lift);
        rises = rises || segment.kind == cam::SegmentKind::rise;
        falls = falls || segment.kind == cam::SegmentKind::fall;
    }
    if (std::abs(motion.net) <= rounding * greatest || (!of_slide && rises != falls)) return true;
    add_error(reading.messages, place,
              fmt::format("rises and returns of {} do not add up to zero: it ends a turn {} from where it began{}",
                          title, shown(motion.net, !of_slide),
                          of_slide ? "" : "; one that indexes has rises alone, or returns alone"));
    return false;
}

}  // namespace

void read_drive_motion(LinkageReading& reading, const Section& drive, const toml::node& node, bool of_slide,
                       LinkageDrive& made) {
    Messages& messages = reading.messages;
    const toml::array* list = node.as_array();
    if (list == nullptr || list->empty())
        return report_kind(node, name_of(drive, "segment"), "a list of sections, each headed [[drive.segment]]",
                           messages);
    if (list->size() > MotionProgram::most_segments)
        return add_error(
            messages, place_of(node),
            fmt::format("{} segments are too many: a motion can have {}", list->size(), MotionProgram::most_segments));
    Problem cam;
    cam.units = reading.made.units;
    cam.mechanism = cam_mechanism(CamFollower::knife, !of_slide);
    cam.dimensions.resize(cam.mechanism->dimensions.size());
    auto program = std::make_shared<MotionProgram>();
    std::size_t coefficients = 0;
    bool whole = true;
    for (const toml::node& entry : *list) {
        const std::size_t index = program->segments.size();
        const std::string title = fmt::format("segment {} of {}", index + 1, drive.title);
        if (!entry.is_table()) return report_kind(entry, title, "a section, headed [[drive.segment]]", messages);
        Section section{entry.as_table(), title, place_of(entry), keys::segment};
        if (section.table->contains("points_file")) {
            add_error(messages, place_of(section, "points_file"),
                      fmt::format("{}: the motion of a drive stands in the file itself, as 'points'",
                                  name_of(section, "points_file")));
            section.reported.push_back("points_file");
            whole = false;
        }
        ReadSegment read = read_segment(section, index, coefficients, cam, messages);
        if (read.plan.kind == cam::SegmentKind::cycle && list->size() > 1) {
            add_error(messages, place_of(entry),
                      "a segment of kind \"cycle\" is a whole turn: it must be the only one");
            read.whole = false;
        }
        if (read.plan.kind == cam::SegmentKind::cycle && !read.plan.table) read.whole = false;
        if (read.plan.kind != cam::SegmentKind::dwell && !read.plan.table && read.plan.laws.empty()) read.whole = false;
        read.whole = read.whole && is_given(cam, read.plan, index, coefficients, section, messages);
        if (const double angle = cam.dimensions[cam_angle_dimension(*cam.mechanism, index)].min;
            read.whole && !(angle >= narrowest)) {
            add_error(messages, place_of(section, "angle"),
                      fmt::format("{} must be a millionth of a radian or more", name_of(section, "angle")));
            read.whole = false;
        }
        whole = whole && read.whole;
        program->segments.push_back(std::move(read.plan));
    }
    if (!whole || messages.failed) return;
    auto motion = motion_of<double>(cam, *program);
    if (!closes(reading, *motion, of_slide, place_of(list->front()), drive.title)) return;
    made.motion_again = kept(motion_of<Digits50>(cam, *program), program);
    made.motion = kept(std::move(motion), std::move(program));
}

}  // namespace mechwright::reading
