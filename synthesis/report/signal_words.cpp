#include "synthesis/report/signal_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

struct SignalWord {
    std::string_view word;
    std::string_view example;  ///< as a file says it
    std::string_view meaning;
};

/// The keys that say what a signal is; what is made of signals; and their derivatives.
constexpr std::array<SignalWord, 14> kinds{{
    {"angle", "{ angle = \"rocker\", to = \"coupler\", near = 0 }",
     "turn of a link against the frame or another link, continuous along the motion; at its start within half a turn "
     "of "
     "'near'"},
    {"x", "{ x = \"P\", on = \"coupler\" }", "coordinate of a point in the drawing, or in the frame of a link"},
    {"y", "{ y = \"P\" }", "the same across"},
    {"along", "{ along = 30, point = \"P\" }", "coordinate of a point in a direction"},
    {"distance", "{ distance = [\"P\", \"Q\"] }", "distance of two points"},
    {"from-line", "{ from-line = [\"D\", \"F\"], point = \"P\" }",
     "distance of a point from the line through two others, positive to its left"},
    {"slide", "{ slide = \"block\" }", "displacement of a slide, by its name or its number"},
    {"speed-of", "{ speed-of = \"P\" }",
     "magnitude of a point's velocity: per radian of the drive, per second where it has a speed"},
    {"acceleration-of", "{ acceleration-of = \"P\" }", "magnitude of a point's acceleration"},
    {"curvature-of", "{ curvature-of = \"P\" }",
     "of a point's path, 1 over its radius of curvature: (x' y'' - y' x'') / (x'^2 + y'^2)^(3/2), positive where the "
     "path bends to the left of the direction in which it is passed and 0 where it is straight (do Carmo, Differential "
     "Geometry of Curves and Surfaces, section 1-5); none where the point comes to rest, as at a cusp"},
    {"transmission-angle", "{ transmission-angle = \"C\" }", "of the dyad that is closed at a pin, in (0, 180) deg"},
    {"sum", "{ sum = { swing = 1, other = -0.5 } }", "of other signals of one unit, times numbers"},
    {"ratio", "{ ratio = [\"a\", \"b\"] }", "of one signal to another"},
    {"signals", "[signals]", "what is measured along the motion of a mechanism of links, each with a name of its own"},
}};

constexpr std::array<SignalWord, 8> reductions{{
    {"least", "NAME.least", "least value over the continuous motion"},
    {"greatest", "NAME.greatest", "greatest value over the continuous motion"},
    {"range", "NAME.range", "greatest less least value"},
    {"mean", "NAME.mean", "mean over the drive's input: its integral over the motion, divided by the motion's length"},
    {"rms", "NAME.rms", "root of the mean of its square"},
    {"deviation", "NAME.deviation", "half of its range: how far it is off the middle value at most"},
    {"at", "NAME.at(60)", "value at one crank angle, or displacement of a driven slide"},
    {"time-ratio", "NAME.time-ratio",
     "of the two parts of a full cycle between its least and its greatest value, the longer over the shorter"},
}};

constexpr std::array<SignalWord, 3> derivatives{{
    {"speed", "NAME.speed.greatest",
     "its first derivative: by the crank angle in radians, by seconds where the drive has a speed, by the displacement "
     "of a driven slide"},
    {"acceleration", "NAME.acceleration.least", "its second derivative"},
    {"jerk", "NAME.jerk.rms", "its third derivative"},
}};

const SignalWord* find_word(std::span<const SignalWord> words, std::string_view word) {
    const auto at = std::find_if(words.begin(), words.end(), [&](const SignalWord& w) { return w.word == word; });
    return at == words.end() ? nullptr : &*at;
}

std::string listed(std::span<const SignalWord> words) {
    std::string text;
    for (const SignalWord& one : words)
        text +=
            folded(fmt::format("  {:<24}  ", one.example.starts_with("NAME") ? one.example : one.word), one.meaning);
    return text;
}

std::string explained_word(const SignalWord& word, std::string_view what) {
    return fmt::format("{}: {}\n\n", word.word, what) + folded("", word.meaning) +
           fmt::format("\n  {}\n", word.example);
}

/// The words behind the signal's name; empty where one is none.
std::string explained_parts(std::string_view parts) {
    std::string text;
    while (!parts.empty()) {
        parts.remove_prefix(1);
        const std::size_t end = std::min(parts.find_first_of(".("), parts.size());
        const std::string_view word = parts.substr(0, end);
        const SignalWord* known = find_word(derivatives, word);
        const bool last = known == nullptr;
        if (last) known = find_word(reductions, word);
        if (known == nullptr) return {};
        text += folded(fmt::format("  {:<12}", word), known->meaning);
        parts.remove_prefix(end);
        if (!last && !parts.starts_with('.')) return {};
        if (!last) continue;
        if (parts.starts_with('(') && parts.ends_with(')') && word != "at")
            text +=
                folded(fmt::format("  {:<12}", "stretch"),
                       fmt::format("{}: from the first to the second crank angle, or displacement; a crank angle that "
                                   "is less than the first is reached through a full turn",
                                   parts));
        else if (!parts.empty() && word != "at")
            return {};
        return text;
    }
    return {};
}

constexpr std::array<SignalWord, 7> of_rooms{{
    {"width", "NAME.width",
     "of the box that the parts of the [[room]] NAME need over the motion, in its direction; with direction = "
     "\"least-width\" the least of all directions: where a side of the box lies on two places, or the slope by the "
     "direction vanishes"},
    {"height", "NAME.height", "of this box, across its direction"},
    {"area", "NAME.area",
     "of this box: its width times its height; with direction = \"least-area\" the least of all directions (Freeman "
     "and "
     "Shapira, Communications of the ACM 18 (1975), 409-413)"},
    {"self-distance", "NAME.self-distance",
     "of the path of the only point of the [[room]] NAME: the least length of all chords that stand square to the path "
     "at "
     "both ends, as across the neck of an hourglass, or at one where the other is an end of the path; 0 where the path "
     "crosses or retraces itself (Litherland, Simon, Durumeric and Rawdon, Topology and its Applications 91 (1999), "
     "233-244)"},
    {"swept-area", "NAME.swept-area",
     "of the straight line between the two points of the [[room]] NAME, as a wiper's blade: the area of all places "
     "over "
     "which it passes, each counted once. Its border is made of paths of the points, the envelope of the line, where "
     "its "
     "points move along it (Bottema and Roth, Theoretical Kinematics, chapter 8), and the line where it turns back"},
    {"uncovered", "NAME.uncovered",
     "of this line: the area of the polygon `screen` of the room over which it does not pass"},
    {"margin", "NAME.margin",
     "least distance over the motion from the border of the [[region]] NAME, in or out of which parts keep; negative "
     "where they do not: by how much they are beyond a border, or what overlaps has to be moved at least"},
}};

}  // namespace

std::string words_of_signals() {
    return "What can be made of a signal NAME, over the motion or a stretch of it, like\nNAME.least(10, 50):\n" +
           listed(reductions) + "Of its derivatives in the same way:\n" + listed(derivatives);
}

std::string explained_room(std::string_view name) {
    const std::size_t dot = name.find('.');
    if (dot == std::string_view::npos || dot == 0) return {};
    const SignalWord* word = find_word(of_rooms, without_whole(name).substr(dot + 1));
    return word ? explained_word({name, word->example, word->meaning}, "of a room or region") : std::string();
}

std::string explained_signal(std::string_view name) {
    if (name == "signals")
        return "signals: what is measured along the motion of a mechanism of links\n\n" +
               listed(std::span(kinds).first(kinds.size() - 1)) + "\n" + words_of_signals();
    const std::size_t dot = name.find('.');
    if (dot != std::string_view::npos && dot > 0) {
        const std::string parts = explained_parts(name.substr(dot));
        if (parts.empty()) return {};
        return fmt::format("{}: quantity of a linkage's signal\n\n", name) +
               folded("  signal      ", fmt::format("'{}', as [signals] of the file says", name.substr(0, dot))) +
               parts;
    }
    if (const SignalWord* word = find_word(kinds, name)) return explained_word(*word, "a signal of a linkage");
    if (const SignalWord* word = find_word(reductions, name))
        return explained_word(*word, "made of a linkage's signal");
    if (const SignalWord* word = find_word(derivatives, name)) return explained_word(*word, "of a linkage's signal");
    return {};
}

}  // namespace mechwright
