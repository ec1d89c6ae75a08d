#pragma once
/// \file
/// How freely a linkage moves: by count and by the rank of the derivatives of its joints' equations.
///
/// Each moving link has three velocities: of its origin along x and y, and its turning. A joint takes equations away
/// (pin 2, slide 2, slot 1, gear, belt, rack and drive 1 each). Counting them is not enough: they may depend on each
/// other. Their rank at a random pose, whose links are as long as the pose wants, says what holds for almost all
/// dimensions; the null vectors on both sides say which links move and which joints are too many (derivation).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "analysis/geometry/vector.h"
#include "analysis/linkage/structure/structure.h"
#include "analysis/numbers/scalar.h"

namespace mechwright::linkage {

enum class Joined : unsigned char { pin, slide, slot, gear, rack, drive };

/// What an equation is of: the joint number `index` of its kind; of a pin the link that it joins to the pin's first.
struct Equation {
    Joined by = Joined::pin;
    std::size_t index = 0;
    std::size_t link = 0;
};

/// Where everything is at one instant, as far as velocities depend on it.
template <class T>
struct Instant {
    std::vector<Vector<T>> origins;  ///< of links
    std::vector<Vector<T>> pins;
    std::vector<Vector<T>> slides;  ///< directions of their lines, unit vectors
    std::vector<Vector<T>> slots;   ///< the same
    std::vector<T> ratios;          ///< of gears
    std::vector<T> radii;           ///< of racks
};

/// The equations of all joints for the velocities, a row for each.
template <class T>
struct VelocityEquations {
    std::vector<Equation> equations;
    std::size_t unknowns = 0;  ///< 3 for each moving link: x, y, turning
    std::vector<T> rows;       ///< `unknowns` numbers for each equation

    std::span<T> row(std::size_t i) { return std::span(rows).subspan(i * unknowns, unknowns); }
    std::span<const T> row(std::size_t i) const { return std::span(rows).subspan(i * unknowns, unknowns); }
};

namespace detail {

template <class T>
struct RowMaker {
    VelocityEquations<T>& made;
    const Instant<T>& at;

    std::span<T> add(const Equation& equation) {
        made.equations.push_back(equation);
        made.rows.resize(made.rows.size() + made.unknowns, T(0));
        return made.row(made.equations.size() - 1);
    }
    /// The velocity along `direction` of the place `where` carried by a link, times `factor`.
    void carried(std::span<T> row, std::size_t link, const Vector<T>& where, const Vector<T>& direction,
                 const T& factor) const {
        if (link == 0) return;
        const std::size_t first = 3 * (link - 1);
        row[first] += factor * direction.x;
        row[first + 1] += factor * direction.y;
        row[first + 2] += factor * cross(where - at.origins[link], direction);
    }
    void turning(std::span<T> row, std::size_t link, const T& factor) const {
        if (link != 0) row[3 * (link - 1) + 2] += factor;
    }
    /// The velocity of a place of one link against another link.
    void against(std::span<T> row, std::size_t link, std::size_t other, const Vector<T>& where,
                 const Vector<T>& direction) const {
        carried(row, link, where, direction, T(1));
        carried(row, other, where, direction, T(-1));
    }
};

}  // namespace detail

template <class T>
VelocityEquations<T> velocity_equations(const Structure& s, const Instant<T>& at) {
    VelocityEquations<T> made;
    made.unknowns = 3 * (s.links - 1);
    detail::RowMaker<T> rows{made, at};
    const Vector<T> right{T(1), T(0)}, up{T(0), T(1)};
    for (std::size_t i = 0; i < s.pins.size(); ++i)
        for (std::size_t k = 1; k < s.pins[i].points.size(); ++k)
            for (const Vector<T>& direction : {right, up})
                rows.against(rows.add({Joined::pin, i, s.pins[i].points[k].link}), s.pins[i].points[0].link,
                             s.pins[i].points[k].link, at.pins[i], direction);
    for (std::size_t i = 0; i < s.slides.size(); ++i) {
        const Slide& slide = s.slides[i];
        const auto turn = rows.add({Joined::slide, i, slide.link});
        rows.turning(turn, slide.link, T(1));
        rows.turning(turn, slide.line.on, T(-1));
        rows.against(rows.add({Joined::slide, i, slide.link}), slide.link, slide.line.on, at.origins[slide.link],
                     left_of(at.slides[i]));
    }
    for (std::size_t i = 0; i < s.slots.size(); ++i)
        rows.against(rows.add({Joined::slot, i, s.slots[i].line.on}), s.pins[s.slots[i].pin].points[0].link,
                     s.slots[i].line.on, at.pins[s.slots[i].pin], left_of(at.slots[i]));
    for (std::size_t i = 0; i < s.gears.size(); ++i) {
        const auto row = rows.add({Joined::gear, i, s.gears[i].second});
        rows.turning(row, s.gears[i].second, T(1));
        rows.turning(row, s.gears[i].first, -at.ratios[i]);
        rows.turning(row, s.gears[i].carrier, at.ratios[i] - T(1));
    }
    for (std::size_t i = 0; i < s.racks.size(); ++i) {
        const Slide& slide = s.slides[s.racks[i].slide];
        const auto row = rows.add({Joined::rack, i, s.racks[i].wheel});
        rows.against(row, slide.link, slide.line.on, at.origins[slide.link], at.slides[s.racks[i].slide]);
        rows.turning(row, s.racks[i].wheel, -at.radii[i]);
        rows.turning(row, s.racks[i].carrier, at.radii[i]);
    }
    for (std::size_t i = 0; i < s.drives.size(); ++i) {
        const Drive& drive = s.drives[i];
        const auto row = rows.add({Joined::drive, i, drive.of_slide ? s.slides[drive.slide].link : drive.link});
        if (drive.of_slide) {
            const Slide& slide = s.slides[drive.slide];
            rows.against(row, slide.link, slide.line.on, at.origins[slide.link], at.slides[drive.slide]);
        } else {
            rows.turning(row, drive.link, T(1));
            rows.turning(row, drive.on, T(-1));
        }
    }
    return made;
}

/// A random pose in a square of side 2; the same seed, the same pose in every number type. Ratios and radii are those
/// of `numbers` where these are not empty.
template <class T>
Instant<T> random_instant(const Structure& s, std::uint64_t seed, std::span<const double> numbers) {
    std::mt19937_64 draw(seed);
    const auto number = [&] { return T(static_cast<double>(draw() >> 11) * 0x1p-52 - 1); };
    const auto place = [&] {
        const T x = number();
        return Vector<T>{x, number()};
    };
    const auto direction = [&] {
        using std::sqrt;
        const Vector<T> v = place();
        return (T(1) / sqrt(dot(v, v))) * v;
    };
    Instant<T> at;
    for (std::size_t i = 0; i < s.links; ++i)
        at.origins.push_back(place());
    for (std::size_t i = 0; i < s.pins.size(); ++i)
        at.pins.push_back(place());
    for (std::size_t i = 0; i < s.slides.size(); ++i)
        at.slides.push_back(direction());
    for (std::size_t i = 0; i < s.slots.size(); ++i)
        at.slots.push_back(direction());
    for (const Gear& gear : s.gears)
        at.ratios.push_back(numbers.empty() ? number() : T(numbers[gear.ratio]));
    for (const Rack& rack : s.racks)
        at.radii.push_back(numbers.empty() ? number() : T(numbers[rack.radius]));
    return at;
}

/// A matrix reduced by full pivoting: which unknowns follow from which.
template <class T>
struct Reduced {
    std::size_t rank = 0;
    std::vector<std::size_t> columns;  ///< the first `rank` are determined by the rest
    std::vector<std::size_t> rows;     ///< the first `rank` are independent, the rest depend on them
    std::vector<bool> moving;          ///< unknowns that are not zero in every solution
    std::vector<bool> dependent;       ///< rows of which some combination vanishes
};

namespace detail {

template <class T>
struct Elimination {
    std::size_t rank = 0;
    std::vector<std::size_t> columns, rows;
    std::vector<T> entries;  ///< of the reduced matrix: the identity in the pivots' columns
};

/// Gauss-Jordan elimination. A pivot below `threshold` times the greatest entry of its row at the start is zero.
template <class T>
Elimination<T> eliminate(std::vector<T> a, std::size_t rows, std::size_t columns, const T& threshold) {
    using std::abs;
    Elimination<T> e;
    for (std::size_t i = 0; i < rows; ++i)
        e.rows.push_back(i);
    for (std::size_t j = 0; j < columns; ++j)
        e.columns.push_back(j);
    const auto entry = [&](std::size_t i, std::size_t j) -> T& { return a[e.rows[i] * columns + e.columns[j]]; };
    for (std::size_t i = 0; i < rows; ++i) {
        T greatest(0);
        for (std::size_t j = 0; j < columns; ++j)
            greatest = std::max<T>(greatest, abs(entry(i, j)));
        for (std::size_t j = 0; j < columns && greatest > T(0); ++j)
            entry(i, j) /= greatest;
    }
    while (e.rank < std::min(rows, columns)) {
        std::size_t row = e.rank, column = e.rank;
        for (std::size_t i = e.rank; i < rows; ++i)
            for (std::size_t j = e.rank; j < columns; ++j)
                if (abs(entry(i, j)) > abs(entry(row, column))) row = i, column = j;
        if (!(abs(entry(row, column)) > threshold)) break;
        std::swap(e.rows[e.rank], e.rows[row]);
        std::swap(e.columns[e.rank], e.columns[column]);
        const T inverse = T(1) / entry(e.rank, e.rank);
        for (std::size_t j = e.rank; j < columns; ++j)
            entry(e.rank, j) *= inverse;
        for (std::size_t i = 0; i < rows; ++i) {
            const T factor = entry(i, e.rank);
            if (i == e.rank || factor == T(0)) continue;
            for (std::size_t j = e.rank; j < columns; ++j)
                entry(i, j) -= factor * entry(e.rank, j);
        }
        ++e.rank;
    }
    e.entries = std::move(a);
    return e;
}

/// Which columns are not zero in every null vector.
template <class T>
std::vector<bool> in_null_vectors(const Elimination<T>& e, const T& threshold) {
    using std::abs;
    const std::size_t columns = e.columns.size();
    std::vector<bool> in(columns, false);
    for (std::size_t j = e.rank; j < columns; ++j) {
        in[e.columns[j]] = true;
        for (std::size_t i = 0; i < e.rank; ++i)
            if (abs(e.entries[e.rows[i] * columns + e.columns[j]]) > threshold) in[e.columns[i]] = true;
    }
    return in;
}

/// What counts as zero beside 1, after elimination: far above rounding, far below what random poses give.
template <class T>
T rank_threshold() {
    using std::pow;
    return plain_doubles<T> ? T(1e-9) : T(pow(std::numeric_limits<T>::epsilon(), 0.6));
}

}  // namespace detail

/// Rank and null vectors of some equations.
template <class T>
Reduced<T> reduced(const VelocityEquations<T>& of) {
    const T threshold = detail::rank_threshold<T>();
    const std::size_t rows = of.equations.size(), columns = of.unknowns;
    const auto plain = detail::eliminate(of.rows, rows, columns, threshold);
    std::vector<T> turned(of.rows.size());
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j)
            turned[j * rows + i] = of.rows[i * columns + j];
    const auto across = detail::eliminate(std::move(turned), columns, rows, threshold);
    return {plain.rank, plain.columns, plain.rows, detail::in_null_vectors(plain, threshold),
            detail::in_null_vectors(across, threshold)};
}

/// How freely a linkage moves, for almost all dimensions.
struct Mobility {
    int counted = 0;                      ///< 3 for each moving link, less the equations of the joints
    int mobility = 0;                     ///< the same less the rank of these equations
    std::size_t redundant = 0;            ///< equations of joints that follow from others
    std::vector<Equation> dependent{};    ///< the equations of joints that depend on each other
    std::vector<std::size_t> free{};      ///< links that move while all drives stand still
    std::vector<Equation> conflicting{};  ///< equations that depend on each other once the drives are among them

    /// Whether the drives settle all that moves, and no joint or drive is too many.
    bool settled() const { return free.empty() && conflicting.empty(); }
};

/// At a random pose of this seed.
template <class T>
Mobility mobility(const Structure& s, std::uint64_t seed, std::span<const double> numbers = {}) {
    Structure joints = s;
    joints.drives.clear();
    const Instant<T> at = random_instant<T>(s, seed, numbers);
    const VelocityEquations<T> without = velocity_equations(joints, at), with = velocity_equations(s, at);
    const Reduced<T> loose = reduced(without), driven = reduced(with);
    Mobility m;
    m.counted = static_cast<int>(without.unknowns) - static_cast<int>(without.equations.size());
    m.mobility = static_cast<int>(without.unknowns - loose.rank);
    m.redundant = without.equations.size() - loose.rank;
    for (std::size_t i = 0; i < without.equations.size(); ++i)
        if (loose.dependent[i]) m.dependent.push_back(without.equations[i]);
    for (std::size_t i = 0; i < with.equations.size(); ++i)
        if (driven.dependent[i]) m.conflicting.push_back(with.equations[i]);
    for (std::size_t link = 1; link < s.links; ++link)
        if (driven.moving[3 * link - 3] || driven.moving[3 * link - 2] || driven.moving[3 * link - 1])
            m.free.push_back(link);
    return m;
}

}  // namespace mechwright::linkage
