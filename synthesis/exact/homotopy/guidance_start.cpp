#include "synthesis/exact/homotopy/guidance_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <complex>
#include <mutex>
#include <numbers>
#include <stdexcept>

#include "analysis/numbers/low_discrepancy.h"

namespace mechwright::homotopy {

namespace {

using Number = std::complex<double>;

// The text files of this folder as the build puts them here.
constexpr char nine_points[] = {
#include "nine_point_start.inc"
};
constexpr char two_poses[] = {
#include "two_pose_start.inc"
};
constexpr char three_poses[] = {
#include "three_pose_start.inc"
};
constexpr char four_poses[] = {
#include "four_pose_start.inc"
};
constexpr char slider_eight_points[] = {
#include "slider_eight_point_start.inc"
};
constexpr char slider_two_poses[] = {
#include "slider_two_pose_start.inc"
};
constexpr char slider_three_poses[] = {
#include "slider_three_pose_start.inc"
};
constexpr char slider_four_poses[] = {
#include "slider_four_pose_start.inc"
};
constexpr char inverted_eight_points[] = {
#include "block_eight_point_start.inc"
};
constexpr char inverted_two_poses[] = {
#include "block_two_pose_start.inc"
};
constexpr char inverted_three_poses[] = {
#include "block_three_pose_start.inc"
};
constexpr char inverted_four_poses[] = {
#include "block_four_pose_start.inc"
};

std::string first_line(const GuidanceSystem& system) {
    return fmt::format("mechwright start system: {}, version 1", name_of(system));
}

constexpr double same_within = 1e-8;

Number number(const Complex<double>& z) { return {z.re, z.im}; }
Complex<double> plain(const Number& z) { return {z.real(), z.imag()}; }

/// Those of the parameters that a system has, in their order.
std::vector<std::size_t> used_parameters(const GuidanceSystem& system) {
    std::vector<std::size_t> used;
    for (const auto& [first, count] : {std::pair{std::size_t{0}, system.displacements()},
                                       std::pair{GuidanceSystem::first_conjugate, system.displacements()},
                                       std::pair{GuidanceSystem::first_turn, system.poses - 1}})
        for (std::size_t i = 0; i < count; ++i)
            used.push_back(first + i);
    return used;
}

/// Normally distributed complex numbers, one after the other.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : seed_(mixed(seed)) {}

    Number next() {
        const double u = part(), v = part();
        return std::polar(std::sqrt(-2 * std::log(u)), 2 * std::numbers::pi * v);
    }

    GuidanceParameters parameters(const GuidanceSystem& system) {
        GuidanceParameters p{};
        for (const std::size_t i : used_parameters(system))
            p[i] = plain(next());
        return p;
    }

private:
    double part() { return std::ldexp(static_cast<double>(mixed(seed_ ^ mixed(count_++)) >> 11) + 0.5, -53); }

    std::uint64_t seed_;
    std::uint64_t count_ = 0;
};

/// Displacements, with their conjugates, at which both dyads of a linkage have turned by T: two equations
/// (d + alpha)(d' + alpha') = rho, of which one is linear less the other; that of a ram is linear.
std::array<Number, 2> displacement(SecondDyad second, const GuidanceValues& u, const Number& turn) {
    using S = GuidanceSystem;
    const auto at = [&u](S::Unknown i) { return number(u[i]); };
    const Number alpha = at(S::x) * turn - at(S::a), alpha_c = at(S::x_conjugate) / turn - at(S::a_conjugate);
    const Number beta = at(S::y) * turn - at(S::b), beta_c = at(S::y_conjugate) / turn - at(S::b_conjugate);
    const Number rho = (at(S::x) - at(S::a)) * (at(S::x_conjugate) - at(S::a_conjugate));
    const Number sigma = (at(S::y) - at(S::b)) * (at(S::y_conjugate) - at(S::b_conjugate));
    const Number k = alpha * alpha_c - rho;
    Number along = alpha_c - beta_c, across = alpha - beta, rest = k - (beta * beta_c - sigma);
    const Number y = at(S::y), yc = at(S::y_conjugate), b = at(S::b), bc = at(S::b_conjugate);
    if (second == SecondDyad::ram) {
        along = bc;
        across = b;
        rest = y * (turn - 1.0) * bc + yc * (1.0 / turn - 1.0) * b;
    } else if (second == SecondDyad::block) {
        along = yc / turn;
        across = y * turn;
        rest = y * (1.0 - turn) * bc + yc * (1.0 - 1.0 / turn) * b;
    }
    const Number p = -along / across, q = -rest / across;  // d' = p d + q
    const Number half = 0.5 * (q + alpha_c + alpha * p);
    const Number d = (-half + std::sqrt(half * half - p * (alpha * q + k))) / p;
    return {d, p * d + q};
}

/// A random linkage, and parameters that it solves.
StartSystem random_linkage(const GuidanceSystem& system, RandomNumbers& random) {
    StartSystem start;
    start.system = system;
    GuidanceValues u;
    for (Complex<double>& z : u)
        z = plain(random.next());
    if (system.second == SecondDyad::ram) u[GuidanceSystem::b_conjugate] = inverse(u[GuidanceSystem::b]);
    if (system.second == SecondDyad::block) u[GuidanceSystem::y_conjugate] = inverse(u[GuidanceSystem::y]);
    for (std::size_t j = 0; j < system.displacements(); ++j) {
        const Number turn = std::exp(random.next());
        const auto [d, conjugate] = displacement(system.second, u, turn);
        start.parameters[j] = plain(d);
        start.parameters[GuidanceSystem::first_conjugate + j] = plain(conjugate);
        if (j + 1 < system.poses) start.parameters[GuidanceSystem::first_turn + j] = plain(turn);
    }
    start.solutions = {u};
    return start;
}

std::vector<GuidanceValues> reached_ends(const std::vector<GuidancePath>& paths) {
    std::vector<GuidanceValues> ends;
    for (const GuidancePath& path : paths)
        if (path.end == PathEnd::reached) ends.push_back(path.point);
    return ends;
}

}  // namespace

std::string_view evidence_of(const GuidanceSystem& system) {
    if (system.poses == 1 && system.second != SecondDyad::block) return "the literature";
    const bool traced =
        system.second == SecondDyad::ram ? system.poses >= 3 : system == GuidanceSystem{4, SecondDyad::block};
    return traced ? "monodromy and a trace test" : "monodromy";
}

std::vector<GuidanceSystem> every_system() {
    std::vector<GuidanceSystem> all;
    for (const SecondDyad second : {SecondDyad::rocker, SecondDyad::ram, SecondDyad::block})
        for (std::size_t poses = 1; poses <= GuidanceSystem::most_poses; ++poses)
            all.push_back({poses, second});
    return all;
}

std::string name_of(const GuidanceSystem& system) {
    constexpr std::array<std::string_view, 3> kinds{"", "slider-crank-", "inverted-slider-crank-"};
    const std::string name(kinds[static_cast<std::size_t>(system.second)]);
    const std::size_t points = system.displacements() + 1 - system.poses;
    if (system.poses == 1) return name + (system.has_rocker() ? "nine-point" : "eight-point");
    return name + fmt::format("{}-poses-{}-point{}", system.poses, points, points == 1 ? "" : "s");
}

std::optional<GuidanceSystem> find_system(std::string_view name) {
    for (const GuidanceSystem& system : every_system())
        if (name_of(system) == name) return system;
    return {};
}

OrbitKey orbit_of(const GuidanceSystem& system, const GuidanceValues& u) {
    using S = GuidanceSystem;
    constexpr double last_digits = 1e-14;
    OrbitKey key;
    if (system.second == SecondDyad::block) {
        key.pivots = u[S::a] + u[S::x] + u[S::b];
        key.conjugates = u[S::a_conjugate] + u[S::x_conjugate] + u[S::b_conjugate];
        return key;
    }
    if (system.second == SecondDyad::ram) {
        // The two cognates have the pivot a, and x and a - x as their crank pins.
        const auto of = [&](S::Unknown x, S::Unknown a) {
            return system.poses > 1 ? u[a] + u[x] : u[a] + u[x] * (u[a] - u[x]);
        };
        key.pivots = of(S::x, S::a);
        key.conjugates = of(S::x_conjugate, S::a_conjugate);
        return key;
    }
    if (system.poses > 1) {
        key.pivots = u[S::a] + u[S::b];
        key.conjugates = u[S::a_conjugate] + u[S::b_conjugate];
        return key;
    }
    // The third pivot: a + k (b - a), k = (point - x)/(y - x), the point at the origin.
    const auto sum = [&](S::Unknown i, S::Unknown j, S::Unknown fixed, S::Unknown other) {
        const Number x = number(u[i]), y = number(u[j]), a = number(u[fixed]), b = number(u[other]);
        const Number k = x / (x - y);
        const double doubt = std::abs(k * (b - a)) * (1 + (std::abs(x) + std::abs(y)) / std::abs(x - y));
        key.rounding = std::max(key.rounding, last_digits * doubt);
        return plain(2.0 * a + b + k * (b - a));
    };
    key.pivots = sum(S::x, S::y, S::a, S::b);
    key.conjugates = sum(S::x_conjugate, S::y_conjugate, S::a_conjugate, S::b_conjugate);
    return key;
}

bool is_same(const OrbitKey& p, const OrbitKey& q) {
    const double doubt = p.rounding + q.rounding;
    const auto close = [doubt](const Complex<double>& a, const Complex<double>& b) {
        return std::sqrt(norm(a - b)) <= same_within * (1 + std::sqrt(norm(a))) + doubt;
    };
    return close(p.pivots, q.pivots) && close(p.conjugates, q.conjugates);
}

std::optional<std::size_t> SeenOrbits::find_or_keep(const OrbitKey& key, std::size_t number) {
    const auto before = [](const Entry& entry, double value) { return entry.key.pivots.re < value; };
    most_rounding_ = std::max(most_rounding_, key.rounding);
    const double width = same_within * (1 + std::sqrt(norm(key.pivots))) + key.rounding + most_rounding_;
    auto at = std::lower_bound(keys_.begin(), keys_.end(), key.pivots.re - width, before);
    for (; at != keys_.end() && at->key.pivots.re <= key.pivots.re + width; ++at)
        if (is_same(at->key, key)) return at->number;
    const auto place = std::lower_bound(keys_.begin(), keys_.end(), key.pivots.re, before);
    keys_.insert(place, {key, number});
    return {};
}

StartSystem make_start_system(const GuidanceSystem& system, std::uint64_t seed, int jobs, int most_loops,
                              std::size_t expected, const std::function<void(std::size_t known, int loops)>& progress) {
    RandomNumbers random(seed);
    StartSystem start = random_linkage(system, random);
    SeenOrbits seen;
    seen.find_or_keep(orbit_of(system, start.solutions[0]), 0);
    for (int loop = 0; loop < most_loops && start.solutions.size() < expected; ++loop) {
        const GuidanceParameters second = random.parameters(system), third = random.parameters(system);
        const std::array<GuidanceParameters, 4> corners{start.parameters, second, third, start.parameters};
        std::vector<GuidanceValues> carried = start.solutions;
        for (std::size_t side = 0; side < 3; ++side)
            carried = reached_ends(track(system, carried, corners[side], corners[side + 1], {}, jobs));
        for (GuidanceValues& solution : carried) {
            if (refine(system, solution, start.parameters) > 1e-12) continue;
            if (!seen.find_or_keep(orbit_of(system, solution), start.solutions.size()))
                start.solutions.push_back(solution);
        }
        if (progress) progress(start.solutions.size(), loop + 1);
    }
    return start;
}

std::string to_text(const StartSystem& start, std::uint64_t seed) {
    std::string text = fmt::format("// {}\n// made by: mechwright start-system {} --seed {}\n",
                                   first_line(start.system), name_of(start.system), seed);
    text += "// parameters: displacements, conjugates, turns; then, for each solution, x, x', a, a', y, y', b, b'\n";
    for (const std::size_t i : used_parameters(start.system))
        text += fmt::format("{:.17g},{:.17g},\n", start.parameters[i].re, start.parameters[i].im);
    for (const GuidanceValues& solution : start.solutions) {
        for (const Complex<double>& z : solution)
            text += fmt::format("{:.9g},{:.9g},", z.re, z.im);
        text += '\n';
    }
    return text;
}

namespace {

/// All numbers between commas, comment lines passed over; nothing where anything else stands there.
std::optional<std::vector<double>> numbers_in(std::string_view text) {
    std::vector<double> numbers;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.starts_with("//")) continue;
        while (!line.empty()) {
            double value = 0;
            const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), value);
            if (error != std::errc{} || !std::isfinite(value)) return {};
            if (stop == line.data() + line.size() || *stop != ',') return {};
            numbers.push_back(value);
            line.remove_prefix(static_cast<std::size_t>(stop - line.data()) + 1);
        }
    }
    return numbers;
}

/// What is wrong with the solutions; they are refined on the way.
std::string fault_of(StartSystem& start) {
    SeenOrbits seen;
    for (std::size_t i = 0; i < start.solutions.size(); ++i) {
        GuidanceValues& solution = start.solutions[i];
        const GuidanceValues before = solution;
        if (refine(start.system, solution, start.parameters) > 1e-12) return fmt::format("solution {} is none", i + 1);
        double moved = 0, size = 0;
        for (std::size_t k = 0; k < solution.size(); ++k) {
            moved = std::max(moved, norm(solution[k] - before[k]));
            size = std::max(size, norm(solution[k]));
        }
        if (moved > 1e-8 * size) return fmt::format("solution {} is none", i + 1);
        if (const auto same = seen.find_or_keep(orbit_of(start.system, solution), i))
            return fmt::format("solutions {} and {} are the same", *same + 1, i + 1);
    }
    return {};
}

}  // namespace

ReadStart parse_start_system(std::string_view text) {
    const std::vector<GuidanceSystem> all = every_system();
    const auto named = std::find_if(all.begin(), all.end(), [&](const GuidanceSystem& one) {
        return text.starts_with("// " + first_line(one) + "\n");
    });
    if (named == all.end())
        return {{},
                fmt::format("its first line is not '// {}' or that of another system: it is no start system, or one of "
                            "another version",
                            first_line({}))};
    const GuidanceSystem& system = *named;
    const auto numbers = numbers_in(text);
    if (!numbers) return {{}, "it is damaged: something in it is no number"};
    const std::vector<std::size_t> used = used_parameters(system);
    const std::size_t solutions = orbits_of(system);
    const std::size_t expected = 2 * (used.size() + solutions * GuidanceSystem::size);
    if (numbers->size() != expected)
        return {{}, fmt::format("it is damaged: it has {} numbers and not {}", numbers->size(), expected)};
    StartSystem start;
    start.system = system;
    const auto at = [&numbers](std::size_t i) { return Complex<double>{(*numbers)[2 * i], (*numbers)[2 * i + 1]}; };
    for (std::size_t i = 0; i < used.size(); ++i)
        start.parameters[used[i]] = at(i);
    start.solutions.resize(solutions);
    for (std::size_t k = 0; k < solutions; ++k)
        for (std::size_t i = 0; i < GuidanceSystem::size; ++i)
            start.solutions[k][i] = at(used.size() + k * GuidanceSystem::size + i);
    if (const std::string fault = fault_of(start); !fault.empty()) return {{}, "it is damaged: " + fault};
    return {std::move(start), {}};
}

namespace {

StartSystem shipped(std::string_view text) {
    ReadStart read = parse_start_system(text);
    if (!read.start) throw std::logic_error("the start system of the program: " + read.fault);
    return *std::move(read.start);
}

/// Each is read when it is needed first. One of these for each text: a system of 1 to 4 poses.
template <const auto&... texts>
const StartSystem& start_of(std::size_t poses) {
    static std::array<std::once_flag, GuidanceSystem::most_poses> once;
    static std::array<StartSystem, GuidanceSystem::most_poses> all;
    const std::array<std::string_view, GuidanceSystem::most_poses> known{std::string_view(texts)...};
    std::call_once(once[poses - 1], [&] { all[poses - 1] = shipped(known[poses - 1]); });
    return all[poses - 1];
}

}  // namespace

const StartSystem& start_system(const GuidanceSystem& system) {
    if (system.second == SecondDyad::ram)
        return start_of<slider_eight_points, slider_two_poses, slider_three_poses, slider_four_poses>(system.poses);
    if (system.second == SecondDyad::block)
        return start_of<inverted_eight_points, inverted_two_poses, inverted_three_poses, inverted_four_poses>(
            system.poses);
    return start_of<nine_points, two_poses, three_poses, four_poses>(system.poses);
}

}  // namespace mechwright::homotopy
