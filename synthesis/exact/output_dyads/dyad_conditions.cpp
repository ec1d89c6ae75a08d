#include "synthesis/exact/output_dyads/dyad_conditions.h"

#include <Eigen/LU>
#include <algorithm>

#include "analysis/linkage/placing/pose.h"
#include "analysis/numbers/unit_vector.h"
#include "synthesis/exact/poses/dyad_equation.h"

namespace mechwright {

namespace {

template <class T>
struct PlacedLine {
    Vector<T> through;
    Vector<T> direction;
};

/// The lines on which a pin is in the frame of its link, where some of its coordinates are found: one for each that is
/// not. A distance that is not found while its angle is has none.
template <class T>
std::vector<PlacedLine<T>> lines_of(const LinkageModel& model, const linkage::Coordinates& at,
                                    const std::vector<std::size_t>& found, std::span<const T> dimensions) {
    const auto is_known = [&](linkage::Number number) {
        const auto& terms = model.numbers[number].terms;
        return std::none_of(terms.begin(), terms.end(), [&](const auto& term) {
            return std::find(found.begin(), found.end(), term.first) != found.end();
        });
    };
    const bool first = is_known(at.first), second = is_known(at.second);
    const Vector<T> right{T(1), T(0)}, up{T(0), T(1)};
    const T a = model.numbers[at.first].at(dimensions), b = model.numbers[at.second].at(dimensions);
    if (at.polar) {
        if (!second) return {};
        const Vector<T> along = unit_at(b);
        if (!first) return {{{T(0), T(0)}, along}};
        return {{a * along, along}, {a * along, left_of(along)}};
    }
    std::vector<PlacedLine<T>> lines;
    if (first) lines.push_back({{a, T(0)}, up});
    if (second) lines.push_back({{T(0), b}, right});
    return lines;
}

/// The same of a rod and a slide.
template <class T>
OutputConditions<T> slide_conditions(const LinkageModel& model, const DyadPlan& plan, std::size_t start,
                                     const KnownPlaces<T>& known, std::span<const T> dimensions, double size) {
    const T per = T(1) / T(size);
    const Vector<T>& first = known.outer.front();
    OutputConditions<T> made;
    std::size_t row = 0;
    for (std::size_t i = 1; i < known.outer.size(); ++i) {
        const Vector<T> way = per * (known.outer[i] - first);
        const T slid = per * (known.ways[i] - known.ways.front());
        made.rows[row++] = {T((dot(way, way) + slid * slid) / T(2)),
                            T(-way.x),
                            T(-way.y),
                            T(-slid * way.x),
                            T(-slid * way.y),
                            slid,
                            T(0)};
    }
    made.displacements = row;
    const SlideLine<T> line = slide_line(model, plan.dyad, dimensions);
    made.rows[row++] = line_factors(line.along, {T(1), T(0)}, 3);
    made.rows[row++] = line_factors(line.along, {T(0), T(1)}, 3);
    made.moving_lines = 2;
    const Vector<T> at_zero = line.pin + known.ways.front() * line.along - first;
    const T offset = model.numbers[model.structure.slides[plan.dyad.slide].offset].at(dimensions);
    if (plan.found.size() == 1)
        made.rows[row++] = line_factors(per * (at_zero + offset * left_of(line.along)), line.along, 1);
    if (!plan.start_is_found)
        made.rows[row++] = line_factors(per * (at_zero + dimensions[start] * line.along), left_of(line.along), 1);
    made.fixed_lines = row - made.displacements - made.moving_lines;
    return made;
}

template <class T>
OutputConditions<T> conditions_of(const LinkageModel& model, const DyadPlan& plan, std::size_t start,
                                  const KnownPlaces<T>& known, std::span<const T> dimensions, double size) {
    const OutputDyad& dyad = plan.dyad;
    if (dyad.slides()) return slide_conditions(model, plan, start, known, dimensions, size);
    const auto at = [&](std::size_t pin, std::size_t link) -> const linkage::Coordinates& {
        return coordinates_on(model.structure.pins[pin], link);
    };
    const T per = T(1) / T(size);
    const Vector<T>& first = known.outer.front();
    OutputConditions<T> made;
    std::size_t row = 0;
    for (std::size_t i = 1; i < known.outer.size(); ++i) {
        const Vector<T> back = turned(known.turns.front(), linkage::detail::conjugate(known.turns[i]));
        made.rows[row++] = dyad_factors(per * turned(known.outer[i] - first, back), back);
    }
    made.displacements = row;
    for (const PlacedLine<T>& line : lines_of(model, at(dyad.pivot, dyad.carrier), plan.found, dimensions))
        made.rows[row++] = line_factors(per * (first - line.through), line.direction, 3);
    made.moving_lines = row - made.displacements;
    if (plan.start_is_found) return made;
    const Vector<T> turn = turned(known.turns.front(), unit_at(T(T(dyad.sense) * dimensions[start])));
    const std::vector<T> numbers = numbers_of(model, dimensions);
    const Vector<T> pivot = linkage::place_of<T>(at(dyad.pivot, dyad.lever), numbers);
    for (const PlacedLine<T>& line : lines_of(model, at(dyad.inner, dyad.lever), plan.found, dimensions))
        made.rows[row++] = line_factors(per * turned(line.through - pivot, turn), turned(line.direction, turn), 1);
    made.fixed_lines = row - made.displacements - made.moving_lines;
    return made;
}

/// The one dyad where two lines from `lines` on give a pivot its place: all other conditions are linear in the other
/// pivot.
DyadSolutions with_given_pivot(const DyadConditions& rows, Eigen::Index lines, bool moving) {
    DyadSolutions found;
    const Eigen::Index given_at = moving ? 3 : 1;
    const auto solved = [&](const Eigen::Matrix2d& factors, const Eigen::Vector2d& values) {
        const Eigen::FullPivLU<Eigen::Matrix2d> lu(factors);
        found.isolated = found.isolated && lu.isInvertible();
        return Eigen::Vector2d(lu.solve(values));
    };
    const Eigen::Vector2d given = solved(rows.block<2, 2>(lines, given_at), -rows.block<2, 1>(lines, 0));
    Eigen::Matrix2d factors;
    Eigen::Vector2d values;
    for (Eigen::Index i = 0, k = 0; i < 4; ++i) {
        if (i == lines || i == lines + 1) continue;
        const auto equation = moving ? dyad_equation(rows.row(i), 0.0, 0.0, given[0], given[1])
                                     : dyad_equation(rows.row(i), given[0], given[1], 0.0, 0.0);
        factors.row(k) << equation.slopes[moving ? 0 : 2], equation.slopes[moving ? 1 : 3];
        values[k++] = -equation.value;
    }
    const Eigen::Vector2d other = solved(factors, values);
    if (!found.isolated || !other.allFinite()) {
        found.singular = 1;
        return found;
    }
    const Eigen::Vector2d &a = moving ? other : given, &x = moving ? given : other;
    found.dyads.push_back({{a[0], a[1]}, {x[0], x[1]}});
    return found;
}

}  // namespace

OutputConditions<double> output_conditions(const LinkageModel& model, const DyadPlan& plan, std::size_t start,
                                           const KnownPlaces<double>& known, std::span<const double> dimensions,
                                           double size) {
    return conditions_of(model, plan, start, known, dimensions, size);
}

OutputConditions<Digits50> output_conditions(const LinkageModel& model, const DyadPlan& plan, std::size_t start,
                                             const KnownPlaces<Digits50>& known, std::span<const Digits50> dimensions,
                                             double size) {
    return conditions_of(model, plan, start, known, dimensions, size);
}

DyadSolutions dyads_meeting(const OutputConditions<double>& conditions) {
    DyadConditions rows;
    for (std::size_t i = 0; i < conditions.rows.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)) = Eigen::Map<const DyadCondition>(conditions.rows[i].data());
    const auto lines = static_cast<Eigen::Index>(conditions.displacements);
    if (conditions.moving_lines == 2) return with_given_pivot(rows, lines, true);
    if (conditions.fixed_lines == 2)
        return with_given_pivot(rows, lines + static_cast<Eigen::Index>(conditions.moving_lines), false);
    return dyads_meeting(rows);
}

}  // namespace mechwright
