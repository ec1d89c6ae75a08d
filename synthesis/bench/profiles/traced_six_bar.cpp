#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/bench/profiles/random_number.h"
#include "synthesis/bench/profiles/random_six_bar.h"
#include "synthesis/bench/profiles/traced_path.h"

namespace mechwright::bench {

namespace {

/// The random numbers of the k-th six-bar, one after another.
class Numbers {
public:
    explicit Numbers(std::uint64_t k) : k_(k) {}
    double between(double low, double high) { return low + (high - low) * random_number(k_, ++drawn_); }
    double length(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    Complex place(double low, double high) {
        const double along = between(low, high);
        return {along, between(-100, 100)};
    }
    double side() { return between(-1, 1) < 0 ? -1 : 1; }

private:
    std::uint64_t k_, drawn_ = 0;
};

SixBar random_six_bar(bool watt, Numbers& numbers) {
    for (;;) {
        const SixBar made{watt,
                          numbers.length(40, 160),
                          numbers.length(15, 60),
                          numbers.length(40, 160),
                          numbers.length(40, 160),
                          numbers.length(40, 200),
                          numbers.length(40, 200),
                          numbers.place(-100, 150),
                          numbers.place(-100, 150),
                          numbers.place(-100, 200),
                          numbers.side(),
                          numbers.side()};
        if (made.turns()) return made;
    }
}

std::string side_word(double side) { return side > 0 ? "left" : "right"; }

/// All but the path.
std::string beginning_of(const SixBar& six_bar) {
    std::string text = "schema = 1\nmechanism = \"linkage\"\n[dimensions]\n";
    for (const char* name : {"ground", "crank", "coupler", "rocker", "rod", "last"})
        text += fmt::format("{} = {{ min = 5, max = 400 }}\n", name);
    for (const char* name : {"e-x", "e-y", "f-x", "f-y", "p-x", "p-y"})
        text += fmt::format("{} = {{ min = -400, max = 400 }}\n", name);
    const std::string f = ", F = [\"f-x\", \"f-y\"]";
    return text + fmt::format(R"([placement]
origin-x = {{ min = -400, max = 400 }}
origin-y = {{ min = -400, max = 400 }}
tilt = {{ min = -180, max = 180 }}
[links]
frame = {{ A = [0, 0], D = ["ground", 0]{} }}
crank = {{ A = [0, 0], B = ["crank", 0] }}
coupler = {{ B = [0, 0], C = ["coupler", 0], E = ["e-x", "e-y"] }}
rocker = {{ D = [0, 0], C = ["rocker", 0]{} }}
rod = {{ E = [0, 0], G = ["rod", 0], P = ["p-x", "p-y"] }}
last = {{ F = [0, 0], G = ["last", 0] }}
[drive]
link = "crank"
[assembly]
C = {{ side = "{}", from = "B", to = "D" }}
G = {{ side = "{}", from = "E", to = "F" }}
)",
                              six_bar.watt ? "" : f, six_bar.watt ? f : "", side_word(six_bar.side_c),
                              side_word(six_bar.side_g));
}

}  // namespace

TracedPath traced_six_bar(std::uint64_t k, bool watt, int count, bool timed) {
    Numbers numbers(2 * k + (watt ? 0 : 1));
    const SixBar six_bar = random_six_bar(watt, numbers);
    const double x = numbers.between(-100, 100);
    const Complex origin(x, numbers.between(-100, 100));
    const double start = numbers.between(0, turn), tilt = numbers.between(-3, 3);
    TracedPath path;
    Complex first;
    std::string points, angles;
    for (int i = 0; i < count; ++i) {
        const Complex at = origin + std::polar(1.0, tilt) * *six_bar.point(start + turn * i / count);
        if (i == 0) first = at;
        path.size = std::max(path.size, std::abs(at - first));
        points += fmt::format("[{:.17g}, {:.17g}], ", at.real(), at.imag());
        angles += fmt::format("{:.17g}, ", 360.0 * i / count);
    }
    path.text =
        beginning_of(six_bar) + "[path]\npoint = \"P\"\nclosed = true\npoints = [" + points + "]\n" +
        (timed ? "timing = \"prescribed\"\ncrank_angles = [" + angles + "]\ncrank-start = { min = 0, max = 360 }\n"
               : "timing = \"free\"\n") +
        "[objective]\nminimize = \"path-rms\"\n";
    return path;
}

}  // namespace mechwright::bench
