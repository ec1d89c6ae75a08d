#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "synthesis/problem/linkage/closing.h"
#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

/// "a, b, c", at most ten of them.
std::string joined(std::vector<std::string> names) {
    const std::size_t count = names.size();
    if (count > 10) names.resize(10);
    return fmt::format("{}", fmt::join(names, ", ")) + (count > 10 ? fmt::format(" and {} more", count - 10) : "");
}

std::string plural(std::size_t n, std::string_view noun) { return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s"); }

std::string numbered(std::size_t index, const std::string& name, std::string_view noun) {
    return name.empty() ? fmt::format("{} {}", noun, index + 1) : fmt::format("{} '{}'", noun, name);
}

/// A joint as messages name it.
std::string name_of(const Linkage& made, const linkage::Equation& equation) {
    switch (equation.by) {
        case linkage::Joined::pin: return fmt::format("pin {}", made.pins[equation.index]);
        case linkage::Joined::slide: return numbered(equation.index, made.slides[equation.index], "slide");
        case linkage::Joined::slot:
            return fmt::format("slot of {}", made.pins[made.structure.slots[equation.index].pin]);
        case linkage::Joined::gear: return fmt::format("gear or belt {}", equation.index + 1);
        case linkage::Joined::rack: return fmt::format("rack {}", equation.index + 1);
        case linkage::Joined::drive: return fmt::format("drive {}", equation.index + 1);
    }
    return "";
}

std::vector<std::string> names_of(const Linkage& made, const std::vector<linkage::Equation>& equations) {
    std::vector<std::string> names;
    for (const linkage::Equation& equation : equations)
        if (std::string name = name_of(made, equation); std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(std::move(name));
    return names;
}

/// Points that are on one link only although nothing but a joint would need them, where a like name is elsewhere.
std::string alike(const Linkage& made) {
    std::string text;
    for (std::size_t i = 0; i < made.pins.size(); ++i) {
        const auto& points = made.structure.pins[i].points;
        if (points.size() != 1) continue;
        std::vector<std::string_view> others;
        const auto first = [&](std::size_t k) { return made.pins[k][0] | 0x20; };  // in lower case
        for (std::size_t k = 0; k < made.pins.size(); ++k)
            if (k != i && first(k) == first(i) && !linkage::is_on(made.structure.pins[k], points[0].link))
                others.push_back(made.pins[k]);
        const std::string_view nearest = nearest_name(made.pins[i], others);
        if (!nearest.empty())
            text += fmt::format(". The point '{}' is on '{}' only: did you mean '{}'?", made.pins[i],
                                made.links[points[0].link], nearest);
    }
    return text;
}

std::string count_of(const linkage::Structure& s) {
    std::size_t pins = 0;
    for (const linkage::Pin& pin : s.pins)
        pins += pin.points.empty() ? 0 : pin.points.size() - 1;
    std::string text = fmt::format("3 x {}", plural(s.links - 1, "moving link"));
    const auto less = [&](std::size_t times, std::size_t n, std::string_view noun) {
        if (n > 0) text += fmt::format(" - {} x {}", times, plural(n, noun));
    };
    less(2, pins, "pin");
    less(2, s.slides.size(), "slide");
    less(1, s.slots.size(), "slot");
    less(1, s.gears.size() + s.racks.size(), "gear or rack");
    return text;
}

/// Links that no joint ties to the frame, even through others.
std::vector<std::size_t> hanging(const linkage::Structure& s) {
    std::vector<bool> held(s.links, false);
    held[0] = true;
    const auto spread = [&held](std::size_t a, std::size_t b) {
        if (held[a] == held[b]) return false;
        held[a] = held[b] = true;
        return true;
    };
    for (bool more = true; more;) {
        more = false;
        for (const linkage::Pin& pin : s.pins)
            for (const linkage::Point& point : pin.points)
                more = spread(pin.points[0].link, point.link) || more;
        for (const linkage::Slide& slide : s.slides)
            more = spread(slide.link, slide.line.on) || more;
        for (const linkage::Slot& slot : s.slots)
            for (const linkage::Point& point : s.pins[slot.pin].points)
                more = spread(slot.line.on, point.link) || more;
    }
    std::vector<std::size_t> links;
    for (std::size_t i = 1; i < s.links; ++i)
        if (!held[i]) links.push_back(i);
    return links;
}

/// A link of two pins with nothing else, with the second let go: it only points there.
std::optional<linkage::Structure> let_go(const linkage::Structure& s, std::size_t link) {
    std::vector<std::size_t> pins;
    for (std::size_t i = 0; i < s.pins.size(); ++i)
        if (s.pins[i].points.size() > 1 && linkage::is_on(s.pins[i], link)) pins.push_back(i);
    const auto has = [link](const auto& joint) { return joint.line.on == link; };
    if (pins.size() != 2 || std::any_of(s.slots.begin(), s.slots.end(), has) ||
        std::any_of(s.slides.begin(), s.slides.end(), [&](const auto& j) { return has(j) || j.link == link; }) ||
        std::any_of(s.drives.begin(), s.drives.end(), [&](const auto& d) { return d.link == link || d.on == link; }) ||
        std::any_of(s.gears.begin(), s.gears.end(),
                    [&](const auto& g) { return g.first == link || g.second == link || g.carrier == link; }))
        return {};
    linkage::Structure less = s;
    linkage::Line line;
    line.on = link;
    line.through = linkage::coordinates_on(s.pins[pins[0]], link);
    line.towards = linkage::coordinates_on(s.pins[pins[1]], link);
    std::erase_if(less.pins[pins[1]].points, [link](const linkage::Point& p) { return p.link == link; });
    less.slots.push_back({pins[1], line, true});
    return less;
}

linkage::Mobility mobility_of(const linkage::Structure& s, const std::vector<double>& numbers) {
    return linkage::mobility<double>(s, 1, numbers);
}

/// Lets redundant links go, the last first, until the drives settle the rest. Returns whether they do then.
bool let_redundant_go(Linkage& made, const std::vector<double>& numbers) {
    linkage::Mobility now = made.mobility;
    constexpr int most = 6;  // equations too many, beyond which nobody means them to fit
    if (static_cast<int>(made.structure.drives.size()) - now.counted > most) return false;
    int tries = 10;  // each takes a rank
    for (std::size_t link = made.structure.links; link-- > 1 && !now.settled() && tries > 0;) {
        const auto less = let_go(made.structure, link);
        if (!less) continue;
        --tries;
        const linkage::Mobility then = mobility_of(*less, numbers);
        if (!then.free.empty() || then.conflicting.size() >= now.conflicting.size()) continue;
        made.structure = *less;
        made.redundant.push_back(link);
        now = then;
    }
    return now.settled();
}

/// Several designs of the file's ranges: one where all is given.
std::vector<std::vector<double>> some_dimensions(const Linkage& made) {
    std::vector<std::vector<double>> designs{usual_dimensions(made)};
    std::mt19937_64 draw(1);
    for (int i = 0; i < 3 && !made.given(); ++i) {
        std::vector<double> design = designs[0];
        for (std::size_t k = 0; k < design.size(); ++k) {
            const LinkageDimension& d = made.dimensions[k];
            // Near the usual one, so that it closes again.
            const double share = 0.05 * (static_cast<double>(draw() >> 11) * 0x1p-53 - 0.5);
            if (!d.tied) design[k] = std::clamp(design[k] + share * (d.max - d.min), d.min, d.max);
        }
        designs.push_back(design);
    }
    return designs;
}

/// The mobility with how it comes about; `more` is what else there is to be said of it.
void report_mobility(LinkageReading& reading, const std::string& more = "") {
    const Linkage& made = reading.made;
    const linkage::Mobility& m = made.mobility;
    const std::size_t drives = made.structure.drives.size();
    std::string text =
        fmt::format("the linkage has mobility {} ({} = {}", m.mobility, count_of(made.structure), m.counted);
    if (m.redundant == 1) text += ", and one of these equations follows from others";
    if (m.redundant > 1) text += fmt::format(", and {} of these equations follow from others", m.redundant);
    text += fmt::format(") and {}", plural(drives, "drive"));
    if (!m.free.empty()) {
        std::vector<std::string> names;
        for (const std::size_t link : m.free)
            names.push_back("'" + made.links[link] + "'");
        text += fmt::format("; with the drives at rest {} still move{}", joined(names), names.size() == 1 ? "s" : "");
    }
    if (!m.conflicting.empty())
        text += fmt::format("; these hold the same twice: {}", joined(names_of(made, m.conflicting)));
    text += more + alike(made);
    const int missing = m.mobility - static_cast<int>(drives);
    text += m.conflicting.empty() && missing > 0 ? fmt::format(". Add {}, or joints that hold what moves freely",
                                                               plural(static_cast<std::size_t>(missing), "drive"))
            : m.free.empty()                     ? ". Take away a joint, a link or a drive"
                             : ". Move a joint or a drive from what is held twice to what moves freely";
    add_error(reading.messages, place_of(reading.file, "links"), std::move(text));
}

/// Redundant links have to fit between their pins for all dimensions. Those that do not are joints too many.
void check_redundant(LinkageReading& reading, const linkage::Structure& whole) {
    Linkage& made = reading.made;
    std::vector<std::string> names;
    for (const std::size_t link : made.redundant)
        names.push_back("'" + made.links[link] + "'");
    double misfit = 0;
    for (const std::vector<double>& dimensions : some_dimensions(made)) {
        const double one = made.order.closed() ? redundant_misfit(made, numbers_of(made, dimensions)) : -1;
        if (one > 1e-12 || one < 0) misfit = one < 0 || misfit < 0 ? -1 : std::max(misfit, one);
    }
    if (misfit == 0) return;
    constexpr double nearly = 0.01;
    if (misfit > 0 && misfit < nearly)
        return add_error(
            reading.messages, reading.link_places[made.redundant.back()],
            fmt::format("the linkage has mobility {} and {}: {} {} redundant, which is right where it fits, and misses "
                        "its pin by {:.3g} of the linkage's size. Give it dimensions with which it fits over the whole "
                        "motion, or leave it out",
                        made.mobility.mobility, plural(made.structure.drives.size(), "drive"), joined(names),
                        names.size() == 1 ? "is" : "are", misfit));
    made.structure = whole;
    made.redundant.clear();
    report_mobility(reading, misfit < 0 ? ""
                                        : fmt::format("; {} would have to fit between its pins by its dimensions, "
                                                      "and misses by {:.3g} of the linkage's size",
                                                      joined(names), misfit));
}

/// A pin that two links share, other than one.
std::optional<std::size_t> pin_between(const linkage::Structure& s, std::size_t a, std::size_t b,
                                       std::size_t not_this) {
    for (std::size_t i = 0; i < s.pins.size(); ++i)
        if (i != not_this && linkage::is_on(s.pins[i], a) && linkage::is_on(s.pins[i], b)) return i;
    return {};
}

/// From one pin of a link to another, on that link.
Vector<double> between(const linkage::Structure& s, std::size_t link, std::size_t from, std::size_t to,
                       const std::vector<double>& numbers) {
    return linkage::place_of<double>(linkage::coordinates_on(s.pins[to], link), numbers) -
           linkage::place_of<double>(linkage::coordinates_on(s.pins[from], link), numbers);
}

/// Four links in a ring: the links of a dyad closed at C, `kept` from B and `other` from D, and those that hold B and D
/// and share A.
struct Ring {
    std::size_t kept, other, holds_b, holds_d, a, b, c, d;
};

/// The constant angle of the kept link to the one that is opposite, where the ring is a parallelogram for all of some
/// designs.
std::optional<double> angle_in_parallelogram(const Linkage& made, const Ring& ring) {
    constexpr double same = 1e-12;
    std::optional<double> angle;
    for (const std::vector<double>& dimensions : some_dimensions(made)) {
        const std::vector<double> numbers = numbers_of(made, dimensions);
        const auto& s = made.structure;
        const Vector<double> bc = between(s, ring.kept, ring.b, ring.c, numbers),
                             ad = between(s, ring.holds_d, ring.a, ring.d, numbers),
                             ab = between(s, ring.holds_b, ring.a, ring.b, numbers),
                             dc = between(s, ring.other, ring.d, ring.c, numbers);
        const double size = std::hypot(bc.x, bc.y) + std::hypot(ab.x, ab.y);
        if (std::abs(std::hypot(bc.x, bc.y) - std::hypot(ad.x, ad.y)) > same * size ||
            std::abs(std::hypot(ab.x, ab.y) - std::hypot(dc.x, dc.y)) > same * size)
            return {};
        const double now = std::atan2(cross(bc, ad), dot(bc, ad));
        if (angle && std::abs(std::sin((now - *angle) / 2)) > same) return {};
        angle = now;
    }
    return angle;
}

/// The ring that a dyad closes.
std::optional<Ring> ring_of(const linkage::Structure& s, std::size_t kept, std::size_t other,
                            const linkage::Group& group) {
    for (const auto& [b, d] : {std::pair(group.outer[0], group.outer[1]), {group.outer[1], group.outer[0]}}) {
        if (!linkage::is_on(s.pins[b], kept) || !linkage::is_on(s.pins[d], other)) continue;
        for (const linkage::Point& on_b : s.pins[b].points)
            for (const linkage::Point& on_d : s.pins[d].points) {
                if (on_b.link == kept || on_d.link == other || on_b.link == on_d.link) continue;
                if (const auto a = pin_between(s, on_b.link, on_d.link, linkage::none))
                    return Ring{kept, other, on_b.link, on_d.link, *a, b, group.pin, d};
            }
    }
    return {};
}

/// A parallelogram that redundant links keep one: its coupler stays parallel to the link opposite also where all four
/// lie in one line, and the other link of its dyad only points to it. Returns whether there was one.
bool keep_parallel(Linkage& made) {
    for (const linkage::Group& group : made.order.groups) {
        if (group.kind != linkage::Group::Kind::rrr) continue;
        for (const auto& [kept, other] :
             {std::pair(group.links[0], group.links[1]), {group.links[1], group.links[0]}}) {
            const auto ring = ring_of(made.structure, kept, other, group);
            const auto angle = ring ? angle_in_parallelogram(made, *ring) : std::nullopt;
            auto less = angle ? let_go(made.structure, other) : std::nullopt;
            if (!less) continue;
            Linkage then = made;
            const double unit = made.units.degrees ? 180 / std::numbers::pi : 1;
            then.numbers.push_back({Affine{0, {}}, Measure::ratio});
            then.numbers.push_back({Affine{*angle * unit, {}}, Measure::angle});
            less->gears.push_back(
                {ring->holds_d, kept, ring->holds_d, then.numbers.size() - 2, then.numbers.size() - 1, false, true});
            then.structure = *std::move(less);
            then.order = linkage::order_of(then.structure);
            then.redundant.push_back(other);
            then.kept_by_redundant.push_back(group.pin);
            bool fits = then.order.closed();
            for (const std::vector<double>& dimensions : some_dimensions(then)) {
                const double misfit = fits ? redundant_misfit(then, numbers_of(then, dimensions)) : -1;
                fits = misfit >= 0 && misfit <= 1e-12;
            }
            if (!fits) continue;
            made = std::move(then);
            return true;
        }
    }
    return false;
}

}  // namespace

void settle(LinkageReading& reading) {
    Linkage& made = reading.made;
    const std::vector<double> numbers = numbers_of(made, usual_dimensions(made));
    for (const double number : numbers)
        if (!std::isfinite(number) || std::abs(number) > 1e100)
            return add_error(reading.messages, "the numbers of this linkage are beyond what can be computed with");
    for (const std::size_t link : hanging(made.structure))
        add_error(
            reading.messages, reading.link_places[link],
            fmt::format("the link '{}' hangs free: no joint ties it to the frame{}", made.links[link], alike(made)));
    if (reading.messages.failed) return;
    made.mobility = mobility_of(made.structure, numbers);
    const linkage::Structure whole = made.structure;
    if (!made.mobility.settled()) {
        if (!made.mobility.free.empty() || !let_redundant_go(made, numbers)) {
            made.structure = whole;
            made.redundant.clear();
            return report_mobility(reading);
        }
    }
    made.order = linkage::order_of(made.structure);
    if (made.redundant.empty()) return;
    check_redundant(reading, whole);
    while (!made.redundant.empty() && keep_parallel(made)) {
    }
}

}  // namespace mechwright::reading
