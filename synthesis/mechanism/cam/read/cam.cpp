#include "synthesis/mechanism/cam/read/cam.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/mechanism/cam/read/schema.h"
#include "synthesis/mechanism/cam/read/segment.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"

namespace mechwright::reading {

namespace {

using cam::ContourKind;

constexpr std::size_t most_law_choices = 256;

double in_angle_unit(const Units& units, double angle) {
    return units.degrees ? angle * 180 / std::numbers::pi : angle;
}

/// Least and greatest sum of some dimensions with signs.
struct Sum {
    double least = 0, greatest = 0;
    void add(const DimensionRange& range, int sign) {
        least += sign > 0 ? range.min : -range.max;
        greatest += sign > 0 ? range.max : -range.min;
    }
    bool fixed() const { return least == greatest; }
};

/// A requirement that the file does not write down: that the motion closes.
void require_closure(Problem& problem, std::string_view quantity, double value) {
    const int index = find_quantity(*problem.mechanism, quantity);
    problem.requirements.push_back({static_cast<std::size_t>(index), value, {}, {}});
}

void check_turn(Problem& problem, FilePlace place, Messages& messages) {
    Sum sum;
    for (std::size_t i = 0; i < program_of(*problem.mechanism)->segments.size(); ++i)
        sum.add(problem.dimensions[cam_angle_dimension(*problem.mechanism, i)], 1);
    const double same_within = 1e-12 * whole_turn;
    const char* unit = problem.units.degrees ? " deg" : " rad";
    const auto angle_text = [&](double angle) {
        return fmt::format("{:.10g}{}", in_angle_unit(problem.units, angle), unit);
    };
    if (sum.least > whole_turn + same_within)
        add_error(
            messages, place,
            fmt::format("the segments' angles add up to {}{}, {} more than a full turn", sum.fixed() ? "" : "at least ",
                        angle_text(sum.least), angle_text(sum.least - whole_turn)));
    else if (sum.greatest < whole_turn - same_within)
        add_error(
            messages, place,
            fmt::format("the segments' angles add up to {}{}, {} short of a full turn", sum.fixed() ? "" : "at most ",
                        angle_text(sum.greatest), angle_text(whole_turn - sum.greatest)));
    else if (!sum.fixed())
        require_closure(problem, "turn", whole_turn);
}

void check_lifts(Problem& problem, const std::vector<FilePlace>& places, Messages& messages) {
    const bool angular = cam_kind(*problem.mechanism).oscillating;
    const auto lift_text = [&](double lift) {
        return fmt::format("{:.10g}", angular ? in_angle_unit(problem.units, lift) : lift);
    };
    Sum sum;
    double highest = 0;
    for (std::size_t i = 0; i < program_of(*problem.mechanism)->segments.size(); ++i) {
        const int sign = cam::lift_sign(program_of(*problem.mechanism)->segments[i].kind);
        if (sign != 0) sum.add(problem.dimensions[cam_lift_dimension(*problem.mechanism, i)], sign);
        highest = std::max(highest, sum.greatest);
        if (sum.greatest < -1e-12 * std::max(highest, -sum.greatest))
            return add_error(
                messages, places[i],
                fmt::format("this return ends {} below the lowest position: let the first segment begin there",
                            lift_text(-sum.greatest)));
    }
    const double same_within = 1e-12 * highest;
    if (sum.least > same_within || sum.greatest < -same_within)
        add_error(messages, places.back(),
                  fmt::format("rises and returns do not add up to zero: the follower ends {} from where it began",
                              lift_text(sum.least > same_within ? sum.least : sum.greatest)));
    else if (!sum.fixed())
        require_closure(problem, "lift-balance", 0);
}

/// The senses of rotation that [cam] allows, as assemblies.
std::vector<std::size_t> rotations_of(const Section& file) {
    const auto word = file.table->at_path("cam.rotation").value_or<std::string_view>("ccw");
    if (word == keys::rotations.back()) return {0, 1};
    return {word == cam_rotation_names.back() ? std::size_t{1} : std::size_t{0}};
}

void set_contour(const Section& file, Problem& problem, ContourKind contour) {
    if (problem.dimensions.empty()) return;
    problem.mechanism = with_program(*problem.mechanism, contour_program(contour));
    problem.dimensions[cam_angle_dimension(*problem.mechanism, 0)] = {whole_turn, whole_turn, {}, true};
    problem.assemblies = rotations_of(file);
}

/// A word of [cam], or of a misspelt one, which is reported, that which is meant: the rest of the file is read by it.
std::optional<std::size_t> read_or_guess(Section& section, std::string_view key, Messages& messages) {
    const auto chosen = read_choice(section, key, key, messages);
    const auto word = section.table->at_path(key).value_exact<std::string_view>();
    if (chosen || !word) return chosen;
    const auto& words = find_key(section.known, key)->words;
    const auto meant = std::find(words.begin(), words.end(), nearest_name(*word, words));
    if (meant == words.end()) return {};
    return static_cast<std::size_t>(meant - words.begin());
}

void read_cam(Section& file, Problem& problem, Messages& messages) {
    std::optional<Section> section = read_section(file, "cam", messages);
    if (!section) {
        if (!has(file, "cam"))
            add_error(messages, file.place,
                      "the section [cam] is missing: a cam needs follower = \"knife\", \"roller\" or \"flat\"");
        return;
    }
    if (!has(*section, "follower"))
        add_error(messages, section->place, "'follower' in [cam] is missing: known are knife, roller, flat");
    const auto follower = read_or_guess(*section, "follower", messages);
    const auto motion = read_or_guess(*section, "motion", messages);
    read_choice(*section, "rotation", "rotation", messages);
    const auto contour = read_or_guess(*section, "contour", messages);
    report_unknown_keys(*section, messages);
    const bool known = follower && (motion || !has(*section, "motion")) && (contour || !has(*section, "contour"));
    problem.mechanism = nullptr;
    if (!known) return;
    const auto kind = static_cast<CamFollower>(*follower);
    if (!contour) {
        problem.mechanism = cam_mechanism(kind, motion.value_or(0) == 1);
        return;
    }
    problem.mechanism = contour_cam_mechanism(kind, static_cast<ContourKind>(*contour + 1));
    if (problem.mechanism == nullptr)
        return add_error(messages, place_of(*section, "follower"),
                         "straight flanks cannot move a flat follower: a tangent cam needs follower = \"roller\"");
    if (motion == 1u)
        add_error(messages, place_of(*section, "motion"),
                  "cams of a specified contour have translating followers: leave 'motion' or 'contour' out");
}

void read_segments(Section& file, Problem& problem, Messages& messages) {
    const toml::node* node = find(file, "segment");
    if (const ContourKind contour = cam_kind(*problem.mechanism).contour; contour != ContourKind::none) {
        if (node != nullptr)
            add_error(messages, key_place(file, "segment"),
                      "the motion follows from the contour: leave [[segment]] or 'contour' in [cam] out");
        return set_contour(file, problem, contour);
    }
    if (node == nullptr)
        return add_error(messages, file.place,
                         "a cam needs its motion: sections headed [[segment]] that make up a full turn");
    const toml::array* list = node->as_array();
    if (list == nullptr || list->empty())
        return report_kind(*node, "'segment'", "a list of sections, each headed [[segment]] in double brackets",
                           messages);
    if (list->size() > MotionProgram::most_segments)
        return add_error(
            messages, place_of(*node),
            fmt::format("{} segments are too many: a cam can have {}", list->size(), MotionProgram::most_segments));
    auto program = std::make_shared<MotionProgram>();
    std::size_t coefficients = 0;
    std::vector<FilePlace> places;
    bool whole = true;
    for (const toml::node& entry : *list) {
        const std::string title = fmt::format("segment {}", places.size() + 1);
        places.push_back(place_of(entry));
        if (!entry.is_table()) return report_kind(entry, title, "a section, headed [[segment]]", messages);
        ReadSegment read = read_segment({entry.as_table(), title, places.back(), keys::segment}, places.size() - 1,
                                        coefficients, problem, messages);
        whole = whole && read.whole;
        if (read.plan.kind == cam::SegmentKind::cycle && list->size() > 1) {
            add_error(messages, places.back(), "a segment of kind \"cycle\" is a whole turn: it must be the only one");
            whole = false;
        }
        program->segments.push_back(std::move(read.plan));
    }
    problem.mechanism = with_program(*problem.mechanism, program);
    if (!whole) return;
    check_turn(problem, places.front(), messages);
    check_lifts(problem, places, messages);
    const std::size_t choices = law_choices(*program);
    if (choices > most_law_choices)
        return add_error(
            messages, places.front(),
            fmt::format("the lists of laws make {} combinations: at most {} can be tried", choices, most_law_choices));
    problem.assemblies.clear();
    for (std::size_t choice = 0; choice < choices; ++choice)
        for (const std::size_t rotation : rotations_of(file))
            problem.assemblies.push_back(2 * choice + rotation);
}

}  // namespace

KindWithSections cam_sections() {
    static constexpr std::array<std::string_view, 2> sections{"cam", "segment"};
    return {"cam", sections, read_cam, read_segments, complete_cam_schema, is_cam_of, limit_cam_files};
}

}  // namespace mechwright::reading
