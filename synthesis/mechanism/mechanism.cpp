#include "synthesis/mechanism/mechanism.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <numeric>
#include <stdexcept>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/crank_shaper/crank_shaper.h"
#include "synthesis/mechanism/drag_link/drag_link.h"
#include "synthesis/mechanism/four_bar/four_bar.h"
#include "synthesis/mechanism/slider_crank/slider_crank.h"
#include "synthesis/mechanism/whitworth/whitworth.h"
#include "synthesis/target/with_targets.h"

namespace mechwright {

namespace {

using Shared = std::shared_ptr<const Mechanism>;

std::vector<Shared> fixed_kinds() {
    std::vector<Shared> kinds{four_bar_mechanism(), slider_crank_mechanism(), crank_shaper_mechanism(),
                              whitworth_mechanism(), drag_link_mechanism()};
    for (Shared& kind : kinds)
        kind = with_all_targets(std::move(kind));
    const auto cams = cam_mechanisms();
    kinds.insert(kinds.end(), cams.begin(), cams.end());
    return kinds;
}

/// The list of all mechanisms, and what guards it.
struct Listed {
    std::mutex guard;
    std::vector<Shared> all = fixed_kinds();
};

Listed& listed() {
    static Listed list;
    return list;
}

bool can_read(const Mechanism& m, const Reads& reads, std::size_t most) {
    return reads.size() <= most &&
           std::all_of(reads.begin(), reads.end(), [&](std::size_t i) { return i < m.dimensions.size(); });
}

bool is_among(std::string_view name, const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

double margin_of(const LinearCondition& c, std::span<const double> dimensions) {
    return std::inner_product(c.coefficients.begin(), c.coefficients.end(), dimensions.begin(), 0.0);
}

std::string why_not_whole(const Mechanism& m) {
    if (m.name.empty() || m.meaning.empty()) return "it has no name or no meaning";
    if (m.dimensions.empty() || m.families.empty()) return "it has no dimensions or no families of motion";
    if (m.settings.size() > Setting::most) return "it has too many settings";
    if (!m.motion || !m.motion_again || !m.describe || !m.check_motion)
        return "its motion cannot be told twice, described or checked";
    if (!m.table.row || m.table.columns.empty() || m.table.columns.size() != m.table.units.size())
        return "its motion has no table";
    for (const Quantity& q : m.quantities) {
        const bool measured = q.defined && q.components && q.measure && q.measure_again;
        if (q.path == PathMeasure::none && !measured) return "its quantity " + q.name + " cannot be measured twice";
        if (!can_read(m, q.reads, Reads::most)) return "its quantity " + q.name + " reads dimensions it has not";
    }
    if (m.drawing && (!m.drawing->bodies || !m.drawing->place || !m.drawing->pivots || !m.drawing->limits))
        return "its drawing lacks bodies, places, pivots or limits";
    if (m.as_linkage && (m.as_linkage->sections.empty() || m.as_linkage->assemblies.size() != m.assemblies.size()))
        return "as a linkage it has no links, or not the same assemblies";
    if (m.as_linkage && m.model.data() && m.made_from.empty()) return "its model would give way to that of its linkage";
    if (m.point && (!m.point->miss || !m.point->point || !can_read(m, m.point->reads, PointGuidance::most_reads)))
        return "its guided point cannot be placed";
    if (m.body && (!m.point || !m.body->miss || !can_read(m, m.body->reads, PointGuidance::most_reads)))
        return "its guided body has no pose or no point";
    if (m.input && (!m.input->margin.measure || !can_read(m, m.input->reads, PointGuidance::most_reads - 1)))
        return "its input range has no margin of assembly";
    if ((m.function || m.line || m.arc) && !m.input) return "it generates or follows without an input range";
    if (m.function && (!m.function->fit || !m.function->extremes)) return "its function cannot be fitted or judged";
    for (const auto* shape : {&m.line, &m.arc})
        if (*shape && (!m.point || !(*shape)->extremes || !(*shape)->fit)) return "what it follows cannot be judged";
    for (const auto& [target, can] : {std::pair{"path", m.point.has_value()},
                                      {"poses", m.body.has_value()},
                                      {"function", m.function.has_value()},
                                      {"line", m.line.has_value()},
                                      {"arc", m.arc.has_value()},
                                      {"instant", !m.at_instant.empty()}})
        if (is_among(target, m.targets) != can)
            return std::string(can ? "it has no numbers for [" : "it can do nothing for [") + target + "]";
    return {};
}

std::vector<Shared> mechanisms() {
    Listed& list = listed();
    const std::lock_guard lock(list.guard);
    return list.all;
}

Shared add_mechanism(Mechanism mechanism) {
    if (const std::string why = why_not_whole(mechanism); !why.empty())
        throw std::invalid_argument("mechanism '" + mechanism.name + "': " + why);
    Listed& list = listed();
    const std::lock_guard lock(list.guard);
    for (const Shared& known : list.all)
        if (known->name == mechanism.name)
            throw std::invalid_argument("there is a mechanism '" + mechanism.name + "' already");
    return list.all.emplace_back(with_all_targets(std::make_shared<const Mechanism>(std::move(mechanism))));
}

Shared find_mechanism(std::string_view name) {
    const auto all = mechanisms();
    const auto at = std::find_if(all.begin(), all.end(), [&](const Shared& m) { return m->name == name; });
    return at == all.end() ? nullptr : *at;
}

Reads::Reads(std::size_t count) : dimensions_(count) { std::iota(dimensions_.begin(), dimensions_.end(), 0); }

Reads::Reads(std::vector<std::size_t> dimensions) : dimensions_(std::move(dimensions)) {
    for (std::size_t i = 0; i < size(); ++i)
        are_the_first_ = are_the_first_ && dimensions_[i] == i;
}

Reads Reads::and_then(std::size_t first, std::size_t count) const {
    std::vector<std::size_t> all = dimensions_;
    for (std::size_t i = 0; i < count; ++i)
        all.push_back(first + i);
    return all;
}

std::span<const double> Reads::of(std::span<const double> dimensions, std::span<double, most> room) const {
    if (are_the_first_) return dimensions.first(size());
    for (std::size_t i = 0; i < size(); ++i)
        room[i] = dimensions[dimensions_[i]];
    return room.first(size());
}

std::vector<Digits50> Reads::of(std::span<const Digits50> dimensions) const {
    std::vector<Digits50> arguments;
    for (const std::size_t i : dimensions_)
        arguments.push_back(dimensions[i]);
    return arguments;
}

Motion motion_for(const Quantity& quantity, Motion motion) {
    motion.of = quantity.of.data();
    const bool of_one = motion.asked != nullptr && quantity.of_target < motion.asked->size();
    if (of_one && quantity.path == PathMeasure::none) {
        const AskedOverInput& one = (*motion.asked)[quantity.of_target];
        motion.function = one.function.get();
        motion.followed = one.followed;
    }
    return motion;
}

bool is_defined(const Quantity& quantity, const Motion& motion) {
    return quantity.defined(motion_for(quantity, motion));
}

std::size_t count_components(const Quantity& quantity, const Motion& motion) {
    return quantity.components(motion_for(quantity, motion));
}

void measure(const Quantity& quantity, const Motion& motion, std::span<const double> dimensions,
             const Measurement& out) {
    std::array<double, Reads::most> room;
    quantity.measure(motion_for(quantity, motion), quantity.reads.of(dimensions, room), out);
}

Digits50 measure_again(const Quantity& quantity, const Motion& motion, std::span<const Digits50> dimensions) {
    return quantity.measure_again(motion_for(quantity, motion), quantity.reads.of(dimensions));
}

void miss_of_point(const Mechanism& mechanism, const Form& form, std::span<const double> dimensions, double crank_angle,
                   const Vector<double>& target, PathMiss& out) {
    std::array<double, Reads::most> room;
    const PointGuidance& point = *mechanism.point;
    point.miss(form, point.reads.of(dimensions, room), crank_angle, target, out);
}

void miss_of_body(const Mechanism& mechanism, const Form& form, std::span<const double> dimensions, double crank_angle,
                  const Vector<double>& target, const Vector<double>& facing, PoseMiss& out) {
    std::array<double, Reads::most> room;
    const BodyGuidance& body = *mechanism.body_of(form.guided);
    body.miss(form, body.reads.of(dimensions, room), crank_angle, target, facing, out);
}

Vector<Digits50> point_again(const Mechanism& mechanism, const Form& form, std::span<const Digits50> dimensions,
                             const Digits50& crank_angle) {
    const PointGuidance& point = *mechanism.point;
    return point.point(form, point.reads.of(dimensions), crank_angle);
}

Motion motion_of(const Mechanism& mechanism, std::span<const double> dimensions, std::size_t assembly,
                 const double* crank_range) {
    Motion motion = mechanism.motion(mechanism.form(assembly), dimensions, crank_range);
    motion.model = mechanism.model.data();
    return motion;
}

namespace {

template <class Named>
int find_by_name(const std::vector<Named>& all, std::string_view name) {
    const auto at = std::find_if(all.begin(), all.end(), [&](const Named& x) { return x.name == name; });
    return at == all.end() ? -1 : static_cast<int>(at - all.begin());
}

/// Levenshtein's distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row[b.size()];
}

}  // namespace

int find_dimension(const Mechanism& mechanism, std::string_view name) {
    return find_by_name(mechanism.dimensions, name);
}

int find_quantity(const Mechanism& mechanism, std::string_view name) {
    return find_by_name(mechanism.quantities, name);
}

const Quantity& deviation_from(const Mechanism& mechanism, std::string_view section) {
    return *std::find_if(mechanism.quantities.begin(), mechanism.quantities.end(),
                         [&](const Quantity& q) { return q.section == section && q.reduce == Reduce::greatest; });
}

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates) {
    constexpr std::size_t longest_name = 64;  // names longer than any of ours are not misspelt ones
    if (name.size() > longest_name) return {};
    std::string_view best;
    std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
    for (const std::string_view candidate : candidates) {
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < least) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

}  // namespace mechwright
