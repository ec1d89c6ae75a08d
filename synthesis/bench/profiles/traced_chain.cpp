#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "synthesis/bench/profiles/random_number.h"
#include "synthesis/bench/profiles/random_six_bar.h"
#include "synthesis/bench/profiles/traced_path.h"

namespace mechwright::bench {

namespace {

/// A dyad that hangs on a point of the link before it and on a pivot of the frame, and the point of its first link that
/// the next hangs on.
struct ChainedDyad {
    double rod, last;
    Complex pivot, point;
};

/// A four-bar and dyads one after the other: 4, 6, 8, ... links.
struct Chain {
    double ground, crank, coupler, rocker;
    Complex on_coupler;
    std::vector<ChainedDyad> dyads;

    std::optional<Complex> point(double angle) const {
        const Complex b = std::polar(crank, angle);
        const auto c = meeting(b, ground, coupler, rocker, 1);
        if (!c) return {};
        Complex at = b + on_coupler * (*c - b) / coupler;
        for (const ChainedDyad& dyad : dyads) {
            const auto g = meeting(at, dyad.pivot, dyad.rod, dyad.last, 1);
            if (!g) return {};
            at += dyad.point * (*g - at) / dyad.rod;
        }
        return at;
    }
    bool turns() const {
        constexpr int steps = 180;
        for (int i = 0; i < steps; ++i)
            if (!point(turn * i / steps)) return false;
        return true;
    }
};

/// The k-th that turns: dyad by dyad, each drawn again until it does.
Chain random_chain(std::uint64_t k, int links) {
    std::uint64_t drawn = 0;
    const auto between = [&](double low, double high) {
        return low + (high - low) * random_number(k, 10'000 + ++drawn);
    };
    const auto place = [&] {
        const double along = between(-100, 150);
        return Complex(along, between(-100, 100));
    };
    Chain made{};
    do {
        made = {between(60, 140), between(15, 40), between(60, 140), between(60, 140), place(), {}};
    } while (!made.turns());
    while (static_cast<int>(made.dyads.size()) < (links - 4) / 2) {
        made.dyads.push_back({between(40, 200), between(40, 200), place(), place()});
        if (!made.turns()) made.dyads.pop_back();
    }
    return made;
}

/// The dimensions of a problem file as ranges: wide ones, or so narrow about what is known that their middles are it.
struct Ranges {
    bool about_known;
    std::string text{};

    void add(std::string_view name, double known, double low, double high) {
        if (about_known) {
            low = known - 1;
            high = known + 1;
        }
        text += fmt::format("{} = {{ min = {:.17g}, max = {:.17g} }}\n", name, low, high);
    }
    void add_length(std::string_view name, double known) { add(name, known, 5, 400); }
    void add_place(const std::string& name, const Complex& known) {
        add(name + "-x", known.real(), -400, 400);
        add(name + "-y", known.imag(), -400, 400);
    }
};

std::string place_on(const std::string& name) { return fmt::format("[\"{0}-x\", \"{0}-y\"]", name); }

/// Pivots of so many dyads are to be found, those of further ones given: programs have no more than 29 dimensions.
constexpr std::size_t open_pivots = 2;

/// All but the path. The point that the next dyad hangs on is P0 on the coupler, P1, P2, ... on the rods.
std::string beginning_of(const Chain& chain, double tilt, bool about_known) {
    const std::vector<ChainedDyad>& dyads = chain.dyads;
    std::string links, sides, pivots;
    Ranges dimensions{about_known}, placement{about_known};
    dimensions.add_length("ground", chain.ground);
    dimensions.add_length("crank", chain.crank);
    dimensions.add_length("coupler", chain.coupler);
    dimensions.add_length("rocker", chain.rocker);
    dimensions.add_place("p0", chain.on_coupler);
    placement.add_place("origin", 0);
    placement.add("tilt", tilt * 360 / turn, -180, 180);
    for (std::size_t i = 1; i <= dyads.size(); ++i) {
        const std::string rod = fmt::format("rod{}", i), last = fmt::format("last{}", i), f = fmt::format("f{}", i),
                          p = fmt::format("p{}", i);
        const Complex& given = dyads[i - 1].pivot;
        const bool is_open = i <= open_pivots;
        dimensions.add_length(rod, dyads[i - 1].rod);
        dimensions.add_length(last, dyads[i - 1].last);
        dimensions.add_place(p, dyads[i - 1].point);
        if (is_open) dimensions.add_place(f, given);
        pivots += fmt::format(", F{} = {}", i,
                              is_open ? place_on(f) : fmt::format("[{:.17g}, {:.17g}]", given.real(), given.imag()));
        links +=
            fmt::format("rod{0} = {{ P{1} = [0, 0], G{0} = [\"{2}\", 0], P{0} = {3} }}\n", i, i - 1, rod, place_on(p)) +
            fmt::format("last{0} = {{ F{0} = [0, 0], G{0} = [\"{1}\", 0] }}\n", i, last);
        sides += fmt::format("G{0} = {{ side = \"left\", from = \"P{1}\", to = \"F{0}\" }}\n", i, i - 1);
    }
    return "schema = 1\nmechanism = \"linkage\"\n[dimensions]\n" + dimensions.text + "[placement]\n" + placement.text +
           "[links]\nframe = { A = [0, 0], D = [\"ground\", 0]" + pivots +
           " }\ncrank = { A = [0, 0], B = [\"crank\", 0] }\n" +
           "coupler = { B = [0, 0], C = [\"coupler\", 0], P0 = " + place_on("p0") +
           " }\nrocker = { D = [0, 0], C = [\"rocker\", 0] }\n" + links + "[drive]\nlink = \"crank\"\n[assembly]\n" +
           "C = { side = \"left\", from = \"B\", to = \"D\" }\n" + sides;
}

}  // namespace

TracedPath traced_chain(std::uint64_t k, int links, int count, bool about_known) {
    const Chain chain = random_chain(k, links);
    const double start = turn * random_number(k, 1), tilt = 6 * random_number(k, 2) - 3;
    TracedPath path;
    Complex first;
    std::string points, angles;
    for (int i = 0; i < count; ++i) {
        const Complex at = std::polar(1.0, tilt) * *chain.point(start + turn * i / count);
        if (i == 0) first = at;
        path.size = std::max(path.size, std::abs(at - first));
        points += fmt::format("[{:.17g}, {:.17g}], ", at.real(), at.imag());
        angles += fmt::format("{:.17g}, ", 360.0 * i / count);
    }
    Ranges first_angle{about_known};
    first_angle.add("crank-start", start * 360 / turn, 0, 360);
    path.text = beginning_of(chain, tilt, about_known) +
                fmt::format(
                    "[path]\npoint = \"P{}\"\nclosed = true\npoints = [{}]\ntiming = \"prescribed\"\n"
                    "crank_angles = [{}]\n",
                    chain.dyads.size(), points, angles) +
                first_angle.text + "[objective]\nminimize = \"path-rms\"\n";
    return path;
}

}  // namespace mechwright::bench
