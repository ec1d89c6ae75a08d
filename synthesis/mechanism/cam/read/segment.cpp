#include "synthesis/mechanism/cam/read/segment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

using cam::SegmentKind;

/// What a segment's keys and messages go by.
struct SegmentReader {
    Section section;
    std::size_t index;
    std::size_t& coefficients;  ///< used so far
    Problem& problem;
    Messages& messages;

    SegmentPlan plan{};
    bool whole = true;  ///< kind, angle and lift could be read

    const Mechanism& mechanism() const { return *problem.mechanism; }

    DimensionRange& dimension(std::size_t i) { return problem.dimensions[i]; }

    /// A positive number or range.
    std::optional<DimensionRange> read_positive(std::string_view key, DimensionKind kind) {
        const Dimension as{std::string(key), kind, false, ""};
        const toml::node* node = find(section, key);
        if (node == nullptr) {
            add_error(messages, section.place, fmt::format("{} is missing", name_of(section, key)));
            return {};
        }
        const auto range = to_dimension(*node, as, problem.units, messages);
        if (!range) return {};
        if (range->min >= 0 && range->max > 0 && (range->min > 0 || !range->fixed())) return range;
        const double shown =
            kind == DimensionKind::angle && problem.units.degrees ? range->min * 180 / std::numbers::pi : range->min;
        add_error(messages, place_of(*node),
                  fmt::format("{} must be greater than 0, not {}", name_of(section, key), shown));
        return {};
    }

    void read_kind() {
        if (!has(section, "kind"))
            add_error(messages, section.place,
                      fmt::format("{} is missing: known are {}", name_of(section, "kind"), listed(segment_kind_names)));
        const auto kind = read_choice(section, "kind", "kind of segment", messages);
        plan.kind = kind ? static_cast<SegmentKind>(*kind) : SegmentKind::dwell;
        whole = kind.has_value();
    }

    std::optional<std::size_t> to_law(const toml::node& node) {
        std::vector<std::string_view> names;
        for (const NamedLaw& law : cam_laws())
            names.push_back(law.name);
        for (const NamedLaw& law : cam_law_aliases())
            names.push_back(law.name);
        const auto chosen = to_choice(node, name_of(section, "law"), "law", names, messages);
        if (!chosen || *chosen < cam_laws().size()) return chosen;
        const cam::SegmentLaw& meant = cam_law_aliases()[*chosen - cam_laws().size()].law;
        const auto at = std::find_if(cam_laws().begin(), cam_laws().end(), [&](const NamedLaw& law) {
            return law.law.form == meant.form && law.law.law == meant.law && law.law.to_rest == meant.to_rest;
        });
        return static_cast<std::size_t>(at - cam_laws().begin());
    }

    void read_laws() {
        const toml::node* node = find(section, "law");
        if (node == nullptr)
            return add_error(
                messages, section.place,
                fmt::format("{} is missing: name a law of motion, \"cycloidal\" for one", name_of(section, "law")));
        const toml::array* list = node->as_array();
        if (list == nullptr) {
            if (const auto law = to_law(*node)) plan.laws.push_back(*law);
            return;
        }
        if (list->empty()) add_error(messages, place_of(*node), name_of(section, "law") + " is an empty list");
        for (const toml::node& one : *list)
            if (const auto law = to_law(one);
                law && std::find(plan.laws.begin(), plan.laws.end(), *law) == plan.laws.end())
                plan.laws.push_back(*law);
    }

    bool has_form(cam::SegmentLaw::Form form) const {
        return std::any_of(plan.laws.begin(), plan.laws.end(),
                           [&](std::size_t law) { return cam_laws()[law].law.form == form; });
    }

    /// The next coefficient of the mechanism; false where there is none left.
    bool add_coefficient(std::string_view key, const toml::node* node) {
        if (coefficients == MotionProgram::most_coefficients) {
            add_error(messages, node != nullptr ? place_of(*node) : section.place,
                      fmt::format("polynomials and splines have more than {} numbers together", coefficients));
            return false;
        }
        const bool angular = cam_kind(mechanism()).oscillating;
        const std::string name = fmt::format("{} of {}", key, section.title);
        const Dimension as{name, angular ? DimensionKind::angle : DimensionKind::coordinate, false, ""};
        const auto range = node != nullptr ? to_dimension(*node, as, problem.units, messages) : std::nullopt;
        if (range) dimension(cam_coefficient_dimension(mechanism(), coefficients)) = *range;
        ++coefficients;
        return true;
    }

    /// Numbers or ranges of a list.
    std::size_t read_list(std::string_view key, const toml::array& list, std::size_t most) {
        if (list.size() > most) {
            add_error(
                messages, place_of(*section.table->get(key)),
                fmt::format("{} has {} entries; it can have {} at most", name_of(section, key), list.size(), most));
            return 0;
        }
        for (const toml::node& entry : list)
            if (!add_coefficient(key, &entry)) return 0;
        return list.size();
    }

    /// The ends of a polynomial in the words of VDI 2143: R (rest) has neither velocity nor acceleration, G (constant
    /// velocity) no acceleration, U (turning point) no velocity, B (motion) both.
    std::size_t read_named_end(std::string_view key, const toml::node& node) {
        constexpr std::array<std::string_view, 3> names{"velocity", "acceleration", "jerk"};
        if (node.is_string()) {
            constexpr auto known = keys::ends_of_polynomials;
            const auto kind = to_choice(node, name_of(section, key), "kind of end", known, messages);
            if (kind && *kind > 0)
                add_error(messages, place_of(node),
                          fmt::format("an end of kind {} needs its {}: write {} = {{ {}{}{} }}", known[*kind],
                                      *kind == 1   ? "velocity"
                                      : *kind == 2 ? "acceleration"
                                                   : "velocity and acceleration",
                                      key, *kind != 2 ? "velocity = ..." : "", *kind == 3 ? ", " : "",
                                      *kind != 1 ? "acceleration = ..." : ""));
            add_coefficient(key, nullptr);
            add_coefficient(key, nullptr);
            return 2;
        }
        Section end{node.as_table(), fmt::format("{} of {}", key, section.title), place_of(node),
                    keys::end_of_polynomial};
        const std::size_t count = find(end, names[2]) != nullptr ? 3 : 2;
        for (std::size_t i = 0; i < count; ++i)
            add_coefficient(key, find(end, names[i]));
        report_unknown_keys(end, messages);
        return count;
    }

    /// Derivatives of the lift at an end of a polynomial, from the first on; at rest if nothing is said.
    std::size_t read_end(std::string_view key, bool polynomial) {
        const toml::node* node = find(section, key);
        if (node == nullptr)
            return polynomial && add_coefficient(key, nullptr) && add_coefficient(key, nullptr) ? 2 : 0;
        if (const toml::array* list = node->as_array()) return read_list(key, *list, MotionProgram::most_ends);
        if (node->is_string() || node->is_table()) return read_named_end(key, *node);
        report_kind(*node, name_of(section, key),
                    "a list of numbers or ranges, or { velocity = ..., acceleration = ... }", messages);
        return 0;
    }

    std::size_t read_shape() {
        const toml::node* node = find(section, "shape");
        if (node == nullptr) return 0;
        if (const toml::array* list = node->as_array()) return read_list("shape", *list, MotionProgram::most_shape);
        report_kind(*node, name_of(section, "shape"), "a list of numbers or ranges", messages);
        return 0;
    }

    void read_polynomial() {
        plan.first_coefficient = coefficients;
        const bool polynomial = has_form(cam::SegmentLaw::Form::polynomial);
        plan.start_count = read_end("start", polynomial);
        plan.end_count = read_end("end", polynomial);
        plan.shape_count = read_shape();
        for (const std::string_view key : {"start", "end", "shape"})
            if (has(section, key) && !polynomial && (key != "shape" || !has_form(cam::SegmentLaw::Form::spline)))
                add_error(messages, key_place(section, key),
                          fmt::format("{} needs law = \"polynomial\"{}", name_of(section, key),
                                      key == "shape" ? " or \"spline\"" : ""));
    }

    /// Angles must rise within one turn, and the lift come back to where it began.
    void read_table() {
        PointList list = read_points(section, problem, messages);
        if (!list.whole) return;
        std::vector<double> angles, lifts;
        const bool angular = cam_kind(mechanism()).oscillating;
        for (const auto& p : list.points) {
            angles.push_back(to_radians(problem.units, p.x));
            lifts.push_back(angular ? to_radians(problem.units, p.y) : p.y);
        }
        const auto fail = [&](std::size_t i, std::string text) {
            add_point_error(list, list.places[i], std::move(text), messages);
        };
        for (std::size_t i = 0; i < angles.size(); ++i) {
            if (angles[i] < 0 || angles[i] > full_turn_radians())
                return fail(i, fmt::format("cam angle {} lies outside one turn", list.points[i].x));
            if (i > 0 && !(angles[i] > angles[i - 1]))
                return fail(i, fmt::format("cam angle {} does not rise above {} before it", list.points[i].x,
                                           list.points[i - 1].x));
        }
        const double first = lifts.front(), last = lifts.back();
        const auto [least, greatest] = std::minmax_element(lifts.begin(), lifts.end());
        if (std::abs(angles.back() - angles.front() - whole_turn) < 1e-12 * whole_turn) {
            if (std::abs(last - first) > 1e-12 * (*greatest - *least))
                return fail(
                    angles.size() - 1,
                    fmt::format(
                        "the table is not periodic: it begins at lift {} and ends a turn later at {}, {:.6g} away",
                        list.points.front().y, list.points.back().y, list.points.back().y - list.points.front().y));
            angles.pop_back();
            lifts.pop_back();
        }
        if (angles.size() < 4) return fail(0, "a table needs four different points or more");
        if (!(*greatest > *least)) return fail(0, "the lift does not change");
        if (*least < 0) return fail(static_cast<std::size_t>(least - lifts.begin()), "a lift must not be negative");
        plan.table = lift_table(std::move(angles), std::move(lifts));
        dimension(cam_lift_dimension(mechanism(), index)) = {plan.table->range, plan.table->range, {}, true};
    }

    static double full_turn_radians() { return whole_turn * (1 + 1e-12); }

    void read() {
        read_kind();
        auto& angle = dimension(cam_angle_dimension(mechanism(), index));
        if (plan.kind == SegmentKind::cycle && whole) {
            angle = {whole_turn, whole_turn, {}, true};
            read_table();
            report_unknown_keys(section, messages);
            return;
        }
        const auto read_angle = read_positive("angle", DimensionKind::angle);
        if (read_angle) angle = *read_angle;
        whole = whole && read_angle;
        if (plan.kind != SegmentKind::dwell) {
            const bool angular = cam_kind(mechanism()).oscillating;
            const auto lift = read_positive("lift", angular ? DimensionKind::angle : DimensionKind::coordinate);
            if (lift) dimension(cam_lift_dimension(mechanism(), index)) = *lift;
            whole = whole && lift;
            read_laws();
            read_polynomial();
        } else if (whole) {
            for (const std::string_view key : {"lift", "law"})
                if (has(section, key)) {
                    section.reported.push_back(key);
                    add_error(messages, key_place(section, key),
                              fmt::format("{}: a dwell has none", name_of(section, key)));
                }
        }
        for (const std::string_view key : {"lift", "law", "start", "end", "shape", "points", "points_file"})
            find(section, key);
        report_unknown_keys(section, messages);
    }
};

}  // namespace

ReadSegment read_segment(Section section, std::size_t index, std::size_t& coefficients, Problem& problem,
                         Messages& messages) {
    SegmentReader reader{std::move(section), index, coefficients, problem, messages};
    reader.read();
    return {std::move(reader.plan), reader.whole};
}

}  // namespace mechwright::reading
