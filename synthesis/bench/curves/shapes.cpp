#include "synthesis/bench/curves/shapes.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "synthesis/bench/profiles/random_number.h"

namespace mechwright::bench {

namespace {

using std::numbers::pi;
using Points = std::vector<Vector<double>>;

double power(double v, double exponent) { return std::copysign(std::pow(std::abs(v), exponent), v); }

/// A closed curve by its angle, finely.
Points around(const std::function<Vector<double>(double)>& curve) {
    constexpr int fine = 2000;
    Points all;
    for (int k = 0; k <= fine; ++k)
        all.push_back(curve(2 * pi * k / fine));
    return all;
}

/// An open curve by its part from 0 to 1, finely.
Points along(const std::function<Vector<double>(double)>& curve) {
    constexpr int fine = 2000;
    Points all;
    for (int k = 0; k <= fine; ++k)
        all.push_back(curve(static_cast<double>(k) / fine));
    return all;
}

Points polygon(Points corners) {
    corners.push_back(corners.front());
    return corners;
}

/// Points at even distances along a way; the last of an open one is its end.
Points even(const Points& way, int count, bool closed) {
    std::vector<double> length{0};
    for (std::size_t k = 1; k < way.size(); ++k)
        length.push_back(length.back() + std::hypot(way[k].x - way[k - 1].x, way[k].y - way[k - 1].y));
    Points all;
    std::size_t k = 0;
    for (int i = 0; i < count; ++i) {
        const double at = length.back() * i / (closed ? count : count - 1);
        while (k + 2 < length.size() && length[k + 1] < at)
            ++k;
        const double part = (at - length[k]) / (length[k + 1] - length[k]);
        all.push_back(way[k] + part * (way[k + 1] - way[k]));
    }
    return all;
}

Points noisy(Points points, double size, std::uint64_t seed) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].x += size * (random_number(seed, 2 * i) - 0.5);
        points[i].y += size * (random_number(seed, 2 * i + 1) - 0.5);
    }
    return points;
}

Vector<double> heart(double t) {
    const double s = std::sin(t);
    return {10 * s * s * s, 0.625 * (13 * std::cos(t) - 5 * std::cos(2 * t) - 2 * std::cos(3 * t) - std::cos(4 * t))};
}

Vector<double> superellipse(double t, double width, double height, double exponent) {
    return {width * power(std::cos(t), 2 / exponent), height * power(std::sin(t), 2 / exponent)};
}

Vector<double> lobes(double t, double depth, int count) {
    const double r = 8 + depth * std::cos(count * t);
    return {r * std::cos(t), r * std::sin(t)};
}

Vector<double> eight(double t, double unequal) {
    return {10 * std::sin(t) * (1 + unequal * std::sin(t)), 6 * std::sin(2 * t) * (1 + 0.2 * std::cos(t))};
}

Vector<double> oval(double t, double width, double height) { return {width * std::cos(t), height * std::sin(t)}; }

const Points leg{{-12, 0}, {12, 0}, {9, 5}, {4, 8}, {-3, 9}, {-9, 5}};

std::vector<Shape> closed_shapes() {
    std::vector<Shape> all;
    const auto add = [&](const std::string& name, const Points& way, int count) {
        all.push_back({name, even(way, count, true), true});
    };
    add("heart", around(heart), 40);
    add("heart, 12 points", around(heart), 12);
    add("heart, 100 points", around(heart), 100);
    add("teardrop", around([](double t) -> Vector<double> {
            return {10 * std::cos(t), 7 * std::sin(t) * std::pow(std::sin(t / 2), 1.5)};
        }),
        40);
    add("rounded square", around([](double t) { return superellipse(t, 10, 10, 4); }), 40);
    add("rounded square, 24 points", around([](double t) { return superellipse(t, 10, 10, 4); }), 24);
    add("rounded rectangle", around([](double t) { return superellipse(t, 12, 6, 4); }), 40);
    add("sharp square", around([](double t) { return superellipse(t, 10, 10, 20); }), 40);
    add("diamond", around([](double t) { return superellipse(t, 12, 8, 1); }), 40);
    add("star of four", around([](double t) { return superellipse(t, 11, 11, 0.8); }), 40);
    add("foot", polygon(leg), 40);
    add("foot, 200 points", polygon(leg), 200);
    add("bean", around([](double t) -> Vector<double> {
            return {(8 + 3 * std::cos(2 * t) - 2 * std::sin(t)) * std::cos(t),
                    (6 + 2 * std::cos(2 * t) + 2.5 * std::sin(t)) * std::sin(t)};
        }),
        40);
    add("trapezoid", polygon({{-12, -6}, {12, -6}, {7, 6}, {-7, 6}}), 40);
    add("letter L", polygon({{-10, -10}, {10, -10}, {10, -4}, {-3, -4}, {-3, 10}, {-10, 10}}), 40);
    add("letter T", polygon({{-3, -10}, {3, -10}, {3, 4}, {10, 4}, {10, 10}, {-10, 10}, {-10, 4}, {-3, 4}}), 40);
    add("letter D", around([](double t) -> Vector<double> {
            return {std::cos(t) > 0 ? 10 * std::cos(t) : std::cos(t), 10 * std::sin(t)};
        }),
        40);
    add("crescent", around([](double t) -> Vector<double> {
            return {10 * std::cos(t), (std::sin(t) < 0 ? 10 : 4) * std::sin(t)};
        }),
        40);
    add("boomerang", polygon({{-12, -6}, {0, 2}, {12, -6}, {2, 8}, {-2, 8}}), 40);
    add("airfoil", around([](double t) -> Vector<double> {
            const double s = std::sin(t);
            return {10 * std::cos(t), 1.4 * s * (1.9 - std::cos(t)) + 1.2 * s * s};
        }),
        40);
    add("airfoil, 60 points", around([](double t) -> Vector<double> {
            const double s = std::sin(t);
            return {12 * std::cos(t), 0.9 * s * (1.8 - std::cos(t)) + 0.8 * s * s};
        }),
        60);
    add("triangle", polygon({{-10, -7}, {10, -7}, {0, 11}}), 40);
    add("low triangle", polygon({{-12, -3}, {12, -3}, {5, 5}}), 40);
    add("arrow", polygon({{-12, -3}, {2, -3}, {2, -8}, {12, 0}, {2, 8}, {2, 3}, {-12, 3}}), 40);
    add("house", polygon({{-8, -8}, {8, -8}, {8, 3}, {0, 10}, {-8, 3}}), 40);
    add("cross",
        polygon({{-3, -10},
                 {3, -10},
                 {3, -3},
                 {10, -3},
                 {10, 3},
                 {3, 3},
                 {3, 10},
                 {-3, 10},
                 {-3, 3},
                 {-10, 3},
                 {-10, -3},
                 {-3, -3}}),
        48);
    add("stadium", around([](double t) -> Vector<double> {
            return {(std::cos(t) > 0 ? 5 : -5) + 5 * std::cos(t), 5 * std::sin(t)};
        }),
        40);
    add("flat oval", around([](double t) { return oval(t, 12, 4); }), 40);
    add("very flat oval", around([](double t) { return oval(t, 12, 1.5); }), 40);
    add("egg", around([](double t) -> Vector<double> {
            return {10 * std::cos(t), (6 + 1.5 * std::cos(t)) * std::sin(t)};
        }),
        40);
    add("three lobes", around([](double t) { return lobes(t, 3, 3); }), 40);
    add("four lobes", around([](double t) { return lobes(t, 2, 4); }), 40);
    add("five lobes", around([](double t) { return lobes(t, 1.5, 5); }), 60);
    add("eight", around([](double t) { return eight(t, 0); }), 40);
    add("eight, unequal loops", around([](double t) { return eight(t, 0.3); }), 40);
    add("eight, very unequal loops", around([](double t) { return eight(t, 0.6); }), 40);
    add("snail", around([](double t) -> Vector<double> {
            const double r = 4 + 7 * std::cos(t);
            return {r * std::cos(t), r * std::sin(t)};
        }),
        40);
    add("lens", around([](double t) -> Vector<double> { return {12 * std::cos(t), 5 * power(std::sin(t), 2)}; }), 40);
    add("kidney", around([](double t) -> Vector<double> {
            return {5 * (1.5 * std::cos(t) - 0.5 * std::cos(3 * t)), 5 * (1.5 * std::sin(t) - 0.5 * std::sin(3 * t))};
        }),
        40);
    all.push_back({"noisy oval", noisy(even(around([](double t) { return oval(t, 10, 6); }), 40, true), 0.6, 1), true});
    all.push_back({"noisy circle", noisy(even(around([](double t) { return oval(t, 8, 8); }), 24, true), 1, 2), true});
    all.push_back({"noisy heart", noisy(even(around(heart), 40, true), 0.5, 3), true});
    return all;
}

std::vector<Shape> open_shapes() {
    std::vector<Shape> all;
    const auto add = [&](const std::string& name, const Points& way, int count) {
        all.push_back({name, even(way, count, false), false});
    };
    const auto arc = [](double radius, double from, double to) {
        return along([=](double u) -> Vector<double> {
            const double t = from + u * (to - from);
            return {radius * std::cos(t), radius * std::sin(t)};
        });
    };
    add("letter S", along([](double u) -> Vector<double> { return {8 * std::sin(2 * pi * u), 20 * u - 10}; }), 30);
    add("letter C", arc(9, 0.25 * pi, 1.75 * pi), 30);
    add("letter U", {{-6, 10}, {-6, -4}, {-4, -8}, {0, -10}, {4, -8}, {6, -4}, {6, 10}}, 30);
    add("letter V", {{-8, 10}, {0, -10}, {8, 10}}, 24);
    add("letter Z", {{-8, 8}, {8, 8}, {-8, -8}, {8, -8}}, 30);
    add("letter W", {{-10, 8}, {-5, -8}, {0, 4}, {5, -8}, {10, 8}}, 40);
    add("letter J", {{6, 10}, {6, -5}, {3, -9}, {-2, -9}, {-6, -5}}, 24);
    add("letter N", {{-7, -9}, {-7, 9}, {7, -9}, {7, 9}}, 30);
    add("hook", along([](double u) -> Vector<double> {
            return u < 0.5
                       ? Vector<double>{24 * u - 12, 0}
                       : Vector<double>{5 * std::sin(pi * (2 * u - 1) * 1.4), 5 - 5 * std::cos(pi * (2 * u - 1) * 1.4)};
        }),
        30);
    add("spiral", along([](double u) -> Vector<double> {
            const double t = 3 * pi * u, r = 2 + 8 * u;
            return {r * std::cos(t), r * std::sin(t)};
        }),
        40);
    add("hairpin", {{-12, 1}, {8, 1.2}, {10, 0.6}, {10, -0.6}, {8, -1.2}, {-12, -1}}, 30);
    add("step", {{-12, -4}, {-1, -4}, {1, 4}, {12, 4}}, 30);
    add("parabola", along([](double u) -> Vector<double> {
            const double x = 20 * u - 10;
            return {x, x * x / 10};
        }),
        24);
    add("wave", along([](double u) -> Vector<double> { return {24 * u - 12, 4 * std::sin(4 * pi * u)}; }), 40);
    add("right angle", {{-10, -10}, {10, -10}, {10, 10}}, 24);
    add("straight line", {{-10, -2}, {10, 2}}, 12);
    add("question mark", {{-5, 5}, {-3, 9}, {2, 10}, {5, 7}, {4, 3}, {0, 0}, {0, -10}}, 30);
    return all;
}

/// Some of them again, with limits.
std::vector<Shape> limited(const std::vector<Shape>& from) {
    std::vector<Shape> all;
    const auto add = [&](std::string_view name, double longest, const std::string& requirement,
                         const std::string& how) {
        for (const Shape& s : from)
            if (s.name == name) all.push_back({s.name + how, s.points, s.closed, longest, requirement});
    };
    for (const char* name : {"heart", "rounded square", "foot", "crescent", "letter S", "letter U"})
        add(name, 40, "", ", lengths to 40");
    for (const char* name : {"heart", "foot", "bean"})
        add(name, 200, "[[require]]\nquantity = \"transmission-angle-worst\"\nmin = 30\n", ", transmission from 30");
    for (const char* name : {"rounded square", "letter U"})
        add(name, 200, "[[require]]\nquantity = \"link-ratio\"\nmax = 4\n", ", links to 4 times each other");
    return all;
}

}  // namespace

std::vector<Shape> shapes() {
    std::vector<Shape> all = closed_shapes();
    const std::vector<Shape> open = open_shapes();
    all.insert(all.end(), open.begin(), open.end());
    const std::vector<Shape> with_limits = limited(all);
    all.insert(all.end(), with_limits.begin(), with_limits.end());
    return all;
}

std::string problem_text(const Shape& shape, int seed) {
    std::string points;
    for (const Vector<double>& p : shape.points)
        points += fmt::format("{}[{:.4f}, {:.4f}]", points.empty() ? "" : ", ", p.x, p.y);
    std::string text = "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\n";
    for (const char* length : {"ground", "crank", "coupler", "rocker"})
        text += fmt::format("{} = {{ min = 1, max = {} }}\n", length, shape.longest);
    for (const char* coordinate : {"point-along", "point-across", "origin-x", "origin-y"})
        text += fmt::format("{0} = {{ min = -{1}, max = {1} }}\n", coordinate, shape.longest);
    return text + fmt::format(
                      "tilt = {{ min = 0, max = 360 }}\nassembly = \"either\"\n[path]\npoints = [{}]\n"
                      "timing = \"none\"\nclosed = {}\n{}[objective]\nminimize = \"path-rms\"\n[solver]\n"
                      "seed = {}\n",
                      points, shape.closed, shape.requirement, seed);
}

}  // namespace mechwright::bench
