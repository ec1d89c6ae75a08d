#include "synthesis/study/points.h"

#include <algorithm>
#include <bit>
#include <boost/random/sobol.hpp>
#include <cmath>

#include "analysis/numbers/low_discrepancy.h"

namespace mechwright {

namespace {

/// Of neighbours the first and the last point of a strand are solved without help from the others: long strands save
/// time, but a small study must have enough of them for all cores.
constexpr std::uint64_t least_points_of_strand = 4, most_points_of_strand = 16;
/// Samples of tolerances are evaluated, not solved.
constexpr std::uint64_t samples_of_strand = 1024;

double fraction(std::uint64_t bits) { return std::ldexp(static_cast<double>(bits >> 11) + 0.5, -53); }

/// A permutation of 0 ... count - 1, a number at a time: a Feistel network on the least even number of bits that holds
/// `count`, walked on until the number is one of them.
std::uint64_t permuted(std::uint64_t number, std::uint64_t count, std::uint64_t key) {
    constexpr int rounds = 6;
    const int half = std::max(1, (static_cast<int>(std::bit_width(count - 1)) + 1) / 2);
    const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
    do {
        std::uint64_t left = number >> half, right = number & mask;
        for (int round = 0; round < rounds; ++round) {
            const std::uint64_t next = left ^ (mixed(mixed(key + static_cast<std::uint64_t>(round)) ^ right) & mask);
            left = right;
            right = next;
        }
        number = (left << half) | right;
    } while (number >= count);
    return number;
}

/// Sobol's sequence with the direction numbers of Joe and Kuo (Boost), shifted digitally by the seed.
std::vector<double> sobol_point(const Study& study, std::uint64_t point) {
    const std::size_t axes = study.axes.size();
    std::vector<std::uint64_t> bits(axes, 0);  // of point 0, which Boost leaves out
    if (point > 0) {
        boost::random::sobol_engine<std::uint64_t, 64> sequence(axes);
        sequence.seed(point - 1);
        sequence.generate(bits.begin(), bits.end());
    }
    std::vector<double> parts;
    for (std::size_t i = 0; i < axes; ++i)
        parts.push_back(fraction(bits[i] ^ mixed(mixed(study.seed) ^ i)));
    return parts;
}

/// McKay, Beckman and Conover: on each axis every one of `count` cells of equal width has one point.
std::vector<double> latin_point(const Study& study, std::uint64_t point) {
    std::vector<double> parts;
    for (std::size_t i = 0; i < study.axes.size(); ++i) {
        const std::uint64_t key = mixed(mixed(study.seed) ^ i);
        const auto cell = static_cast<double>(permuted(point, study.count, key));
        parts.push_back((cell + fraction(mixed(key ^ mixed(point)))) / static_cast<double>(study.count));
    }
    return parts;
}

/// The value at a part of the way along an axis, 0 to 1.
AxisValue value_at(const StudyAxis& axis, double part) {
    if (axis.range) return {.number = axis.range->at(part)};
    const auto count = static_cast<double>(axis.values.size());
    return {.index = std::min(axis.values.size() - 1, static_cast<std::size_t>(part * count))};
}

AxisValue step_of(const StudyAxis& axis, std::uint64_t step) {
    if (!axis.range) return {.index = static_cast<std::size_t>(step)};
    const std::uint64_t steps = axis.range->count - 1;
    return {.number = axis.range->at(steps == 0 ? 0 : static_cast<double>(step) / static_cast<double>(steps))};
}

std::vector<AxisValue> one_at_a_time(const Study& study, std::uint64_t point) {
    std::vector<AxisValue> values(study.axes.size(), AxisValue{.as_in_file = true});
    if (point == 0) return values;
    --point;
    for (std::size_t i = 0; i < values.size(); point -= study.axes[i].count(), ++i) {
        if (point >= study.axes[i].count()) continue;
        values[i] = step_of(study.axes[i], point);
        break;
    }
    return values;
}

std::vector<AxisValue> grid_point(const Study& study, std::uint64_t point) {
    std::vector<AxisValue> values(study.axes.size());
    for (std::size_t i = values.size(); i-- > 0; point /= study.axes[i].count())
        values[i] = step_of(study.axes[i], point % study.axes[i].count());
    return values;
}

std::uint64_t pieces(std::uint64_t count, std::uint64_t size) { return (count + size - 1) / size; }

/// The piece of a number of points from `first` on.
Strand piece(std::uint64_t first, std::uint64_t count, std::uint64_t size, std::uint64_t number, bool neighbours) {
    const std::uint64_t begin = number * size;
    return {first + begin, std::min(size, count - begin), neighbours};
}

bool has_neighbours(const StudyAxis& axis) { return axis.numeric(); }

std::uint64_t strand_size(const Study& study) {
    if (study.tolerances()) return samples_of_strand;
    return std::clamp(pieces(point_count(study), most_points_of_strand), least_points_of_strand, most_points_of_strand);
}

Strand one_at_a_time_strand(const Study& study, std::uint64_t number) {
    if (number == 0) return {0, 1, false};
    --number;
    std::uint64_t first = 1;
    for (const StudyAxis& axis : study.axes) {
        const std::uint64_t strands = pieces(axis.count(), strand_size(study));
        if (number < strands) return piece(first, axis.count(), strand_size(study), number, has_neighbours(axis));
        number -= strands;
        first += axis.count();
    }
    return {first, 0, false};
}

}  // namespace

std::uint64_t point_count(const Study& study) {
    if (study.tolerances() || study.random()) return study.count;
    std::uint64_t count = 1;
    for (const StudyAxis& axis : study.axes)
        count = study.design == StudyDesign::grid ? count * axis.count() : count + axis.count();
    return count;
}

std::vector<AxisValue> point_values(const Study& study, std::uint64_t point) {
    if (study.tolerances()) return {};
    if (study.design == StudyDesign::grid) return grid_point(study, point);
    if (study.design == StudyDesign::one_at_a_time) return one_at_a_time(study, point);
    const std::vector<double> parts =
        study.design == StudyDesign::sobol ? sobol_point(study, point) : latin_point(study, point);
    std::vector<AxisValue> values;
    for (std::size_t i = 0; i < parts.size(); ++i)
        values.push_back(value_at(study.axes[i], parts[i]));
    return values;
}

std::uint64_t strand_count(const Study& study) {
    if (study.tolerances() || study.random()) return pieces(study.count, strand_size(study));
    if (study.design == StudyDesign::grid) {
        const std::uint64_t along = study.axes.back().count();
        return point_count(study) / along * pieces(along, strand_size(study));
    }
    std::uint64_t strands = 1;
    for (const StudyAxis& axis : study.axes)
        strands += pieces(axis.count(), strand_size(study));
    return strands;
}

Strand strand_at(const Study& study, std::uint64_t number) {
    if (study.tolerances() || study.random()) return piece(0, study.count, strand_size(study), number, false);
    if (study.design == StudyDesign::one_at_a_time) return one_at_a_time_strand(study, number);
    const std::uint64_t along = study.axes.back().count();
    const std::uint64_t of_line = pieces(along, strand_size(study));
    return piece(number / of_line * along, along, strand_size(study), number % of_line,
                 has_neighbours(study.axes.back()));
}

}  // namespace mechwright
