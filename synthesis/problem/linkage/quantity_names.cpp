#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "synthesis/problem/linkage/linkage.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"

namespace mechwright {

namespace {

using Word = std::string_view;

constexpr std::array<Word, 8> reductions{"least", "greatest", "range", "mean", "rms", "deviation", "at", "time-ratio"};
constexpr std::array<Word, 3> derivatives{"speed", "acceleration", "jerk"};

template <std::size_t n>
std::optional<std::size_t> index_in(const std::array<Word, n>& words, Word word) {
    const auto at = std::find(words.begin(), words.end(), word);
    if (at == words.end()) return {};
    return static_cast<std::size_t>(at - words.begin());
}

/// The text up to a full stop or a bracket, taken away from its beginning.
Word next_word(Word& rest) {
    const std::size_t end = std::min(rest.find_first_of(".("), rest.size());
    const Word word = rest.substr(0, end);
    rest.remove_prefix(end);
    return word;
}

/// "(10, 50)": one or two numbers with spaces around them.
std::optional<std::vector<double>> numbers_in_brackets(Word text) {
    if (!text.starts_with('(') || !text.ends_with(')')) return {};
    text.remove_prefix(1);
    std::vector<double> numbers;
    while (true) {
        while (text.starts_with(' '))
            text.remove_prefix(1);
        double number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc{} || !(std::abs(number) <= 1e9)) return {};
        numbers.push_back(number);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        while (text.starts_with(' '))
            text.remove_prefix(1);
        if (text == ")") return numbers;
        if (!text.starts_with(',')) return {};
        text.remove_prefix(1);
    }
}

/// What stands behind a signal's name: ".speed.greatest", ".at(60)", ".least(10, 50)".
std::optional<LinkageMeasure> with_reduction(const Linkage& linkage, LinkageMeasure made, Word rest,
                                             std::string& fault) {
    rest.remove_prefix(1);
    Word word = next_word(rest);
    if (const auto derivative = index_in(derivatives, word); derivative && rest.starts_with('.')) {
        made.asked.derivative = *derivative + 1;
        rest.remove_prefix(1);
        word = next_word(rest);
    }
    const auto reduction = index_in(reductions, word);
    if (!reduction) return fault = reading::remedy(word, reductions), std::nullopt;
    using Kind = LinkageMeasure::Kind;
    constexpr std::array<Kind, 8> kinds{Kind::least, Kind::greatest,  Kind::range, Kind::mean,
                                        Kind::rms,   Kind::deviation, Kind::at,    Kind::time_ratio};
    made.kind = kinds[*reduction];
    const bool at = made.kind == Kind::at;
    if (rest.empty() && !at) return made;
    if (made.kind == Kind::time_ratio) return fault = "it is of the whole cycle: write nothing behind it", std::nullopt;
    const auto numbers = numbers_in_brackets(rest);
    if (!numbers || numbers->size() != (at ? 1 : 2))
        return fault = at ? "say where, like at(60)" : "after it may stand a stretch, like (10, 50)", std::nullopt;
    const auto inside = [&](double input) {
        return linkage.structure.drives.front().of_slide ? input : reading::to_radians(linkage.units, input);
    };
    if (at)
        made.input = inside(numbers->front());
    else
        made.stretch = {inside(numbers->front()), inside(numbers->back())};
    return made;
}

/// What stands behind the name of a room or a region; absent where the name is of neither.
std::optional<LinkageMeasure> of_room(const Linkage& linkage, Word name, std::string& fault) {
    using Kind = LinkageMeasure::Kind;
    const std::size_t dot = std::min(name.find('.'), name.size());
    const Word owner = name.substr(0, dot), rest = name.substr(std::min(dot + 1, name.size()));
    constexpr std::array<Word, 3> of_rooms{"width", "height", "area"};
    constexpr std::array<Kind, 3> kinds{Kind::room_width, Kind::room_height, Kind::room_area};
    LinkageMeasure made;
    for (std::size_t i = 0; i < linkage.rooms.size(); ++i) {
        if (linkage.rooms[i].name != owner) continue;
        made.of_room = i;
        using Turn = LinkageRoom::Turn;
        const Turn turn = linkage.rooms[i].turn;
        if (turn != Turn::given) {
            const bool area = turn == Turn::least_area;
            if (rest == of_rooms[area ? 2 : 0]) return made.kind = area ? Kind::turned_area : Kind::turned_width, made;
            return fault = fmt::format(
                       "{} is no quantity of a room that is turned to its {}: write '{}.{}', or give its "
                       "'direction' as an angle",
                       reading::quoted(name), area ? "least area" : "least width", owner, of_rooms[area ? 2 : 0]),
                   std::nullopt;
        }
        if (const auto word = index_in(of_rooms, rest)) return made.kind = kinds[*word], made;
        if (rest == "self-distance" && has_path(linkage.structure, linkage.rooms[i]))
            return made.kind = Kind::self_distance, made;
        if (rest == "self-distance")
            return fault = fmt::format("{} is of the path of one point that moves: write of = [\"P\"] with this alone",
                                       reading::quoted(name)),
                   std::nullopt;
        const bool sweeps = has_blade(linkage.structure, linkage.rooms[i]), screened = !linkage.rooms[i].screen.empty();
        if (rest == "swept-area" && sweeps) return made.kind = Kind::swept_area, made;
        if (rest == "uncovered" && screened) return made.kind = Kind::uncovered, made;
        if (rest == "swept-area")
            return fault = fmt::format(
                       "{} is of the line between two points, of which one moves at least: write of = "
                       "[\"P\", \"Q\"] with these alone",
                       reading::quoted(name)),
                   std::nullopt;
        if (rest == "uncovered")
            return fault = fmt::format(
                       "{} is of the screen of a room: give '{}' one, like screen = [[0, 0], [9, 0], "
                       "[9, 5]]",
                       reading::quoted(name), owner),
                   std::nullopt;
        std::vector<Word> known{"width", "height", "area"};
        if (has_path(linkage.structure, linkage.rooms[i])) known.push_back("self-distance");
        if (sweeps) known.push_back("swept-area");
        if (screened) known.push_back("uncovered");
        return fault = fmt::format("{} is no quantity of a room: '{}' has {}", reading::quoted(name), owner,
                                   reading::listed(known)),
               std::nullopt;
    }
    for (std::size_t i = 0; i < linkage.regions.size(); ++i) {
        if (linkage.regions[i].name != owner) continue;
        made.of_room = i;
        if (rest == "margin") return made.kind = Kind::region_margin, made;
        return fault = fmt::format("{0} is no quantity of a region: write '{1}.margin'", reading::quoted(name), owner),
               std::nullopt;
    }
    return {};
}

}  // namespace

std::optional<LinkageMeasure> to_linkage_quantity(const Linkage& linkage, Word name, std::string& fault) {
    using Kind = LinkageMeasure::Kind;
    constexpr std::array<Kind, 5> kinds{Kind::transmission_angle_worst, Kind::total_length, Kind::link_ratio,
                                        Kind::full_turn_margin, Kind::joint_distance_least};
    LinkageMeasure made;
    if (const auto ready = index_in(ready_made_quantities, name)) return made.kind = kinds[*ready], made;
    std::string of_no_room;
    const auto room = of_room(linkage, name, of_no_room);
    if (!of_no_room.empty()) fault = of_no_room;
    if (room || !of_no_room.empty()) return room;
    const Word signal = name.substr(0, name.find('.'));
    std::vector<Word> known;
    for (std::size_t i = 0; i < linkage.signals.size(); ++i) {
        known.push_back(linkage.signals[i].name);
        if (known.back() != signal) continue;
        if (signal == name)
            return fault = fmt::format("'{0}' is a signal; say what of it, like {0}.greatest", name), std::nullopt;
        made.asked.signal = i;
        if (linkage.structure.drives.empty()) return made;
        const auto whole = with_reduction(linkage, made, name.substr(signal.size()), fault);
        if (!whole) fault = fmt::format("{} is no quantity of a signal; {}", reading::quoted(name), fault);
        return whole;
    }
    if (signal == name) {
        known.insert(known.begin(), ready_made_quantities.begin(), ready_made_quantities.end());
        fault = fmt::format("there is no quantity {}; {}", reading::quoted(name), reading::remedy(name, known));
    } else {
        fault = fmt::format("there is no signal {}; {}", reading::quoted(signal),
                            known.empty() ? "signals stand in [signals]" : reading::remedy(signal, known));
    }
    return {};
}

}  // namespace mechwright
