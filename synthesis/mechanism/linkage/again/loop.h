#pragma once
/// \file
/// Poses of a linkage by the equations of all its joints at once: Newton's method on the places of all links, from a
/// pose nearby. It knows no order of solving, no dyad and no side: what verification measures with, in any number type
/// (derivation; the rows are those of analysis/linkage/structure/mobility.h).

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "analysis/linkage/groups/factors.h"
#include "analysis/linkage/structure/mobility.h"
#include "analysis/linkage/structure/structure.h"

namespace mechwright {

/// Where all links are: their origins, and the turns of their x axes, which are not folded. The frame is the first.
template <class T>
struct LoopPose {
    std::vector<Vector<T>> origins;
    std::vector<T> turns;

    /// The direction of a link's x axis.
    Vector<T> along(std::size_t link) const { return unit_at(turns[link]); }
    template <class Number>
    Vector<T> at(std::size_t link, const Vector<Number>& own) const {
        return origins[link] + turned(own, along(link));
    }
};

/// A pose with more digits, or fewer.
template <class To, class From>
LoopPose<To> pose_as(const LoopPose<From>& pose) {
    LoopPose<To> made;
    for (const Vector<From>& origin : pose.origins)
        made.origins.push_back({number_as<To>(origin.x), number_as<To>(origin.y)});
    for (const From& turn : pose.turns)
        made.turns.push_back(number_as<To>(turn));
    return made;
}

/// A pose with the directions of its links, which take most of the time in fifty digits.
template <class T>
struct DirectedPose {
    const std::vector<Vector<T>>& origins;
    const std::vector<T>& turns;
    std::vector<Vector<T>> directions{};

    explicit DirectedPose(const LoopPose<T>& pose) : origins(pose.origins), turns(pose.turns) {
        for (std::size_t i = 0; i < turns.size(); ++i)
            directions.push_back(pose.along(i));
    }
    const Vector<T>& along(std::size_t link) const { return directions[link]; }
    template <class Number>
    Vector<T> at(std::size_t link, const Vector<Number>& own) const {
        return origins[link] + turned(own, along(link));
    }
    /// After a step (Loop) that has been taken from the pose: directions turn by their small angles, whose sines and
    /// cosines have few terms.
    void turn_on(const std::vector<T>& step) {
        for (std::size_t i = 1; i < directions.size(); ++i) {
            const T angle = -step[3 * i - 1], square = angle * angle;
            T term(1), cosine(1), sine = angle;
            for (int k = 2;; k += 2) {
                term = -term * square / T(k * (k - 1));
                cosine += term;
                sine += term * angle / T(k + 1);
                if (!((term < T(0) ? T(-term) : term) > std::numeric_limits<T>::epsilon() / T(4))) break;
            }
            directions[i] = turned(directions[i], Vector<T>{cosine, sine});
        }
    }
};

namespace loop_detail {

/// Solves a square system by elimination with row pivots, in place. Returns the sign of its determinant; 0 where it is
/// singular to rounding.
template <class T>
int solve_linear(std::vector<T>& a, std::vector<T>& b) {
    using std::abs;
    const std::size_t n = b.size();
    int sign = 1;
    T greatest(0);
    for (const T& entry : a)
        if (abs(entry) > greatest) greatest = abs(entry);
    const T least = greatest * std::numeric_limits<T>::epsilon();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (abs(a[i * n + k]) > abs(a[pivot * n + k])) pivot = i;
        if (!(abs(a[pivot * n + k]) > least)) return 0;
        if ((a[pivot * n + k] < T(0)) != (pivot != k)) sign = -sign;
        if (pivot != k) {
            for (std::size_t j = k; j < n; ++j)
                std::swap(a[k * n + j], a[pivot * n + j]);
            std::swap(b[k], b[pivot]);
        }
        for (std::size_t i = k + 1; i < n; ++i) {
            if (a[i * n + k] == T(0)) continue;
            const T factor = a[i * n + k] / a[k * n + k];
            for (std::size_t j = k + 1; j < n; ++j)
                a[i * n + j] -= factor * a[k * n + j];
            b[i] -= factor * b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j)
            b[k] -= a[k * n + j] * b[j];
        b[k] /= a[k * n + k];
    }
    return sign;
}

}  // namespace loop_detail

/// A linkage by its joints' equations. Where poses are series, its numbers are not.
template <class T>
class Loop {
public:
    using Number = Constant<T>;

    Loop(const linkage::Structure& structure, std::vector<Number> numbers)
        : s_(structure), numbers_(std::move(numbers)), rounded_(rounded(structure, numbers_)) {
        for (std::size_t i = 0; i < s_.links; ++i)
            for (const linkage::Pin& pin : s_.pins)
                if (linkage::is_on(pin, i)) grow(place(linkage::coordinates_on(pin, i)));
        for (const linkage::Slide& slide : s_.slides)
            grow(place(slide.line.through));
    }

    /// The greatest distance by which it is described; 1 where there is none.
    Number size() const { return size_ > Number(0) ? size_ : Number(1); }

    /// Moves a pose to the one next to it at these inputs of the drives. Returns the sign of the equations' determinant
    /// there, which changes from one assembly of a dyad to the other and nowhere along a branch; 0 where Newton's
    /// method finds no pose.
    int solve(std::span<const T> inputs, LoopPose<T>& pose) const {
        if constexpr (!plain_doubles<T>)
            if (const int sign = solve_from_doubles(inputs, pose); sign != 0) return sign;
        constexpr int most_steps = 40;
        const T close = settled_within(), far = T(4) * size() + farthest(pose);
        T last = std::numeric_limits<T>::max();
        for (int step = 0; step < most_steps; ++step) {
            const DirectedPose<T> here(pose);
            const linkage::VelocityEquations<T> rows = linkage::velocity_equations(s_, instant(here));
            std::vector<T> a = rows.rows, b = residuals(inputs, here);
            const int sign = rows.equations.size() == rows.unknowns ? loop_detail::solve_linear(a, b) : 0;
            if (sign == 0) return 0;
            const T moved = move(pose, b);
            if (!(moved < far)) return 0;
            // As near as rounding lets it come: the steps become no shorter.
            constexpr double settled = plain_doubles<T> ? 1e-9 : 1e-27;
            if (moved <= close || (moved < T(settled) && !(moved < last))) return sign;
            // Beyond a limit, where no pose is, steps grow sooner or later: in many digits each of them is dear.
            if constexpr (!plain_doubles<T>)
                if (moved > T(2) * last) return 0;
            last = moved;
        }
        return 0;
    }

    /// Whether joints and drives are between their stops in a pose.
    bool is_between_stops(std::span<const T> inputs, const LoopPose<T>& pose) const {
        const auto holds = [this](const linkage::Stops& stops, const auto& value_of_it) {
            if (!stops.any()) return true;
            const T value = value_of_it();
            return (!stops.min || value >= numbers_[*stops.min]) && (!stops.max || value <= numbers_[*stops.max]);
        };
        for (std::size_t i = 0; i < s_.drives.size(); ++i)
            if (!holds(s_.drives[i].stops, [&] { return inputs[i]; })) return false;
        for (std::size_t i = 0; i < s_.slides.size(); ++i)
            if (!holds(s_.slides[i].stops, [&] { return displacement(i, pose); })) return false;
        const auto is_within = [&](const linkage::Slot& slot) {
            return holds(slot.stops, [&] {
                const Vector<T> way = pin(slot.pin, pose) - pose.at(slot.line.on, place(slot.line.through));
                return dot(direction(slot.line, pose), way);
            });
        };
        return std::all_of(s_.slots.begin(), s_.slots.end(), is_within) &&
               std::all_of(s_.circular.begin(), s_.circular.end(),
                           [&](const linkage::CircularSlot& slot) { return !slot.ends || is_within(*slot.ends); });
    }

    /// Velocities of all links for unit speeds of the drives as given: origins and turns. To predict with: doubles say
    /// what they are where they can.
    bool velocities(std::span<const T> speeds, const LoopPose<T>& pose, LoopPose<T>& out) const {
        if constexpr (!plain_doubles<T>) {
            const LoopPose<double> near = pose_as<double>(pose);
            linkage::Factors factors;
            LoopPose<double> plain;
            if (rounded_.factor(near, factors) && rounded_.velocities(in_doubles(speeds), near, plain)) {
                out = pose_as<T>(plain);
                return true;
            }
        }
        const linkage::VelocityEquations<T> rows = linkage::velocity_equations(s_, instant(DirectedPose<T>(pose)));
        std::vector<T> a = rows.rows, b(rows.equations.size(), T(0));
        for (std::size_t i = 0; i < rows.equations.size(); ++i)
            if (rows.equations[i].by == linkage::Joined::drive) b[i] = speeds[rows.equations[i].index];
        if (rows.equations.size() != rows.unknowns || loop_detail::solve_linear(a, b) == 0) return false;
        out = {std::vector<Vector<T>>(s_.links, Vector<T>{T(0), T(0)}), std::vector<T>(s_.links, T(0))};
        for (std::size_t i = 1; i < s_.links; ++i) {
            out.origins[i] = {b[3 * i - 3], b[3 * i - 2]};
            out.turns[i] = b[3 * i - 1];
        }
        return true;
    }

    /// Factors the equations' derivatives in a pose, by turns times the size; false where they are singular, or where a
    /// row has less of its own, of 1: so little as the first that the other branch of a dyad may be within the noise of
    /// doubles.
    static constexpr double regular = 1e-4;
    bool factor(const LoopPose<double>& pose, linkage::Factors& factors,
                double least = regular) const requires plain_doubles<T> {
        const linkage::VelocityEquations<double> rows = linkage::velocity_equations(s_, instant(DirectedPose<T>(pose)));
        if (rows.equations.size() != rows.unknowns) return false;
        factors = linkage::Factors(rows.unknowns);
        for (std::size_t i = 0; i < rows.unknowns; ++i)
            for (std::size_t j = 0; j < rows.unknowns; ++j)
                factors.at(i, j) = rows.rows[i * rows.unknowns + j] / (j % 3 == 2 ? size() : 1);
        return factors.factor() != 0 && factors.least_pivot() > least;
    }

    /// By how much each equation is missed, in the order of the velocity equations.
    std::vector<T> residuals(std::span<const T> inputs, const DirectedPose<T>& pose) const {
        std::vector<T> missed;
        for (const linkage::Pin& pin : s_.pins)
            for (std::size_t k = 1; k < pin.points.size(); ++k) {
                const Vector<T> apart = pose.at(pin.points[0].link, place(pin.points[0].at)) -
                                        pose.at(pin.points[k].link, place(pin.points[k].at));
                missed.push_back(apart.x);
                missed.push_back(apart.y);
            }
        for (const linkage::Slide& slide : s_.slides) {
            missed.push_back(folded(pose.turns[slide.link] - pose.turns[slide.line.on] - numbers_[slide.angle]));
            const Vector<T> from_line = pose.origins[slide.link] - pose.at(slide.line.on, place(slide.line.through));
            missed.push_back(dot(left_of(direction(slide.line, pose)), from_line) - numbers_[slide.offset]);
        }
        for (const linkage::Slot& slot : s_.slots)
            missed.push_back(dot(left_of(direction(slot.line, pose)),
                                 pin(slot.pin, pose) - pose.at(slot.line.on, place(slot.line.through))));
        for (const linkage::Gear& gear : s_.gears) {
            const T& carrier = pose.turns[gear.carrier];
            missed.push_back(pose.turns[gear.second] - carrier -
                             numbers_[gear.ratio] * (pose.turns[gear.first] - carrier) - numbers_[gear.phase]);
        }
        for (const linkage::Rack& rack : s_.racks)
            missed.push_back(displacement(rack.slide, pose) -
                             numbers_[rack.radius] * (pose.turns[rack.wheel] - pose.turns[rack.carrier]) -
                             numbers_[rack.phase]);
        for (std::size_t i = 0; i < s_.drives.size(); ++i) {
            const linkage::Drive& drive = s_.drives[i];
            missed.push_back(drive.of_slide ? T(displacement(drive.slide, pose) - inputs[i])
                                            : folded(pose.turns[drive.link] - pose.turns[drive.on] - inputs[i]));
        }
        return missed;
    }
    /// A point of a link by its place there.
    Vector<Number> place(const linkage::Coordinates& at) const { return linkage::place_of<Number>(at, numbers_); }
    template <class Pose>
    Vector<T> pin(std::size_t index, const Pose& pose) const {
        const linkage::Point& point = s_.pins[index].points[0];
        return pose.at(point.link, place(point.at));
    }
    /// The displacement of a slide.
    template <class Pose>
    T displacement(std::size_t slide, const Pose& pose) const {
        const linkage::Slide& one = s_.slides[slide];
        return dot(direction(one.line, pose), pose.origins[one.link] - pose.at(one.line.on, place(one.line.through)));
    }
    template <class Pose>
    Vector<T> direction(const linkage::Line& line, const Pose& pose) const {
        return turned(linkage::direction_of<Number>(line, numbers_), pose.along(line.on));
    }

private:
    void grow(const Vector<Number>& at) {
        const Number length = hypotenuse(at.x, at.y);
        if (length > size_) size_ = length;
    }
    T farthest(const LoopPose<T>& pose) const {
        T greatest(0);
        for (const Vector<T>& origin : pose.origins) {
            const T length = hypotenuse(origin.x, origin.y);
            if (length > greatest) greatest = length;
        }
        return greatest;
    }
    linkage::Instant<T> instant(const DirectedPose<T>& pose) const {
        linkage::Instant<T> at;
        at.origins = pose.origins;
        for (std::size_t i = 0; i < s_.pins.size(); ++i)
            at.pins.push_back(pin(i, pose));
        for (const linkage::Slide& slide : s_.slides)
            at.slides.push_back(direction(slide.line, pose));
        for (const linkage::Slot& slot : s_.slots)
            at.slots.push_back(direction(slot.line, pose));
        for (const linkage::Gear& gear : s_.gears)
            at.ratios.push_back(numbers_[gear.ratio]);
        for (const linkage::Rack& rack : s_.racks)
            at.radii.push_back(numbers_[rack.radius]);
        return at;
    }
    /// An angle without its whole turns, of which directions know nothing.
    static T folded(const T& angle) {
        const T turn = T(2) * pi<T>();
        return angle - turn * T(std::floor(number_as<double>(T(angle / turn)) + 0.5));
    }
    /// Subtracts a step; how far it moves the farthest place, over the size, or turns.
    T move(LoopPose<T>& pose, const std::vector<T>& step) const {
        using std::abs;
        T greatest(0);
        for (std::size_t i = 1; i < s_.links; ++i) {
            const T &x = step[3 * i - 3], &y = step[3 * i - 2], &turn = step[3 * i - 1];
            pose.origins[i].x -= x;
            pose.origins[i].y -= y;
            pose.turns[i] -= turn;
            for (const T& moved : {T(abs(x) / size()), T(abs(y) / size()), T(abs(turn))})
                if (!(moved <= greatest)) greatest = moved;
        }
        return greatest;
    }

    static T settled_within() { return std::numeric_limits<T>::epsilon() * 64; }

    /// The same linkage in doubles; nothing where it is in doubles itself, or in series, which are of one pose.
    struct Nothing {};
    static constexpr bool is_rounded = !plain_doubles<T> && std::is_same_v<Number, T>;
    using Rounded = std::conditional_t<is_rounded, Loop<double>, Nothing>;
    static Rounded rounded(const linkage::Structure& structure, const std::vector<Number>& numbers) {
        if constexpr (is_rounded)
            return Rounded(structure, in_doubles(numbers));
        else
            return {};
    }
    static std::vector<double> in_doubles(std::span<const T> numbers) {
        std::vector<double> plain;
        for (const T& number : numbers)
            plain.push_back(number_as<double>(number));
        return plain;
    }

    /// As solve, by Newton's method in doubles and then by its last factors on equations of all digits, each of whose
    /// steps adds as many digits as doubles have; 0 where that does not converge so fast, as near limits.
    int solve_from_doubles(std::span<const T> inputs, LoopPose<T>& pose) const {
        constexpr int most_steps = 12;
        constexpr double gained = 1e-8;  // by each step at least
        LoopPose<double> near = pose_as<double>(pose);
        const int sign = rounded_.solve(in_doubles(inputs), near);
        linkage::Factors factors;
        if (sign == 0 || !rounded_.factor(near, factors)) return 0;
        LoopPose<T> found = pose_as<T>(near);
        DirectedPose<T> here(found);
        std::vector<double> step(factors.size());
        std::vector<T> exact(factors.size());
        double last = 1;
        for (int i = 0; i < most_steps; ++i) {
            const std::vector<T> missed = residuals(inputs, here);
            // Of order one, so that no digit of what is missed falls below the least of doubles.
            T most(0);
            for (const T& one : missed)
                if (const T size = one < T(0) ? T(-one) : one; size > most) most = size;
            if (most == T(0)) break;
            for (std::size_t k = 0; k < step.size(); ++k)
                step[k] = number_as<double>(T(missed[k] / most));
            factors.solve(step);
            for (std::size_t k = 0; k < step.size(); ++k)
                exact[k] = most * T(k % 3 == 2 ? step[k] / rounded_.size() : step[k]);
            const T moved = move(found, exact);
            if (moved <= settled_within()) break;
            const double far = number_as<double>(moved);
            if (!(far <= gained * last)) return 0;
            last = far;
            here.turn_on(exact);
        }
        pose = std::move(found);
        return sign;
    }

    const linkage::Structure& s_;
    std::vector<Number> numbers_;
    Rounded rounded_;
    Number size_{0};
};

}  // namespace mechwright
