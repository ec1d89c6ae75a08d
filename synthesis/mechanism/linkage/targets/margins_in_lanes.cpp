#include "synthesis/mechanism/linkage/targets/margins_in_lanes.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "analysis/linkage/placing/needed_place.h"
#include "analysis/numbers/lanes.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/linkage/targets/working_row.h"

namespace mechwright {

namespace {

constexpr std::size_t of_group = std::tuple_size_v<Group>;
constexpr std::size_t most_spots = 768, most_drives = 8;  // for which no memory is asked for

/// The inputs of a drive, and their directions where it turns.
struct InputGroup {
    Group input{}, cosine{}, sine{};
};

/// What eight designs are placed by.
struct Designs {
    const LinkageModel& model;
    const linkage::Needed& needed;
    std::span<const std::int8_t> sides;
    std::span<const Group> dimensions;
    std::span<const InputGroup> drives;
};

template <class T>
T number_at(const Affine& number, std::span<const Group> dimensions, std::size_t first) {
    T sum(number.constant);
    for (const auto& [dimension, factor] : number.terms)
        sum = sum + T(factor) * loaded<T>(dimensions[dimension], first);
    return sum;
}

/// As NeededGuidance places a single design and takes the least of its margins.
template <class T>
[[gnu::always_inline]] inline void least_margins(const Designs& designs, std::size_t first, std::span<T> row,
                                                 std::span<T> numbers, Group& least) {
    const linkage::Needed& needed = designs.needed;
    constexpr double any = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = number_at<T>(designs.model.numbers[i], designs.dimensions, first);
    linkage::set_design<T, T>(needed, numbers, designs.sides, row, any);
    for (std::size_t i = 0; i < designs.drives.size(); ++i) {
        const InputGroup& drive = designs.drives[i];
        linkage::set_input<T>(needed, i, loaded<T>(drive.input, first),
                              {loaded<T>(drive.cosine, first), loaded<T>(drive.sine, first)}, row);
    }
    linkage::place_needed<T>(needed, row, any);
    T margin(any), sum(0.0);
    for (const linkage::MarginSpots& spots : needed.margins)
        for (const linkage::Spot spot : {spots.outer, spots.inner}) {
            margin = select(row[spot] >= margin, margin, row[spot]);
            sum = sum + row[spot];
        }
    const T told = select(sum >= T(-any), margin, sum);  // which is no number where one of them is none
    told.write(least.data() + first);
}

template <class T>
[[gnu::always_inline]] inline void least_margins(const Designs& designs, Group& least) {
    WorkingRow<T, most_spots> room;
    const std::span<T> row = room.of(designs.needed.size);
    const std::span<T> numbers = row.subspan(designs.needed.number(0), designs.needed.numbers);
    for (std::size_t first = 0; first < of_group; first += T::count)
        least_margins<T>(designs, first, row, numbers, least);
}

// One body for each instruction set, with everything it calls made part of it.

[[gnu::flatten]] void least_baseline(const Designs& designs, Group& least) {
    least_margins<BaselineLanes>(designs, least);
}
#if defined(__x86_64__)
[[gnu::flatten, gnu::target("avx2")]] void least_avx2(const Designs& designs, Group& least) {
    least_margins<Avx2Lanes>(designs, least);
}
[[gnu::flatten, gnu::target("avx512f")]] void least_avx512(const Designs& designs, Group& least) {
    least_margins<Avx512Lanes>(designs, least);
}
#endif

void least_in(InstructionSet set, const Designs& designs, Group& least) {
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return least_avx512(designs, least);
    if (set == InstructionSet::avx2) return least_avx2(designs, least);
#endif
    static_cast<void>(set);
    least_baseline(designs, least);
}

/// By plain code: functions of the library that are called from what is compiled for an instruction set wait for the
/// upper halves of registers.
InputGroup inputs_of_drive(const linkage::DriveLaw& law, bool turns, double factor, const Group& crank_angles) {
    InputGroup made;
    for (std::size_t lane = 0; lane < of_group; ++lane) {
        made.input[lane] = linkage::input_by(law, factor * crank_angles[lane]);
        const Vector<double> direction = turns ? unit_at(made.input[lane]) : Vector<double>{1, 0};
        made.cosine[lane] = direction.x;
        made.sine[lane] = direction.y;
    }
    return made;
}

}  // namespace

bool has_margins_in_lanes(const Mechanism& mechanism) {
    if (!is_described(mechanism) || !mechanism.point) return false;
    const auto& guided = linkage_of(mechanism.model.data()).guided;
    return std::all_of(guided.begin(), guided.end(), [](const GuidedPoint& g) { return g.follows || g.needed.closed; });
}

Group margins_in_lanes(InstructionSet set, Form form, std::span<const Group> arguments, const Group& crank_angles) {
    const LinkageModel& model = linkage_of(form.model);
    const linkage::Needed& needed = model.guided[form.guided].needed;
    WorkingRow<InputGroup, most_drives> room;
    const std::span<InputGroup> drives = room.of(model.drives.size());
    for (std::size_t i = 0; i < drives.size(); ++i)
        drives[i] = inputs_of_drive(law_of(model, i), needed.turning[i], model.input_per_argument(), crank_angles);
    Group least{};
    least_in(set, {model, needed, model.sides[form.assembly], arguments, drives}, least);
    return least;
}

}  // namespace mechwright
