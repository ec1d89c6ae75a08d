#include "synthesis/mechanism/linkage/table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "analysis/linkage/measuring/margins.h"
#include "synthesis/mechanism/linkage/drawing/drawing.h"
#include "synthesis/mechanism/linkage/measured_over.h"

namespace mechwright {

namespace {

/// Names in files have no spaces; those of what stands for a circular slot have.
bool is_named(const std::string& name) { return name.find(' ') == std::string::npos; }

/// Whether the angle of a link is the input under the same name.
bool is_input(const LinkageModel& model, std::size_t link) {
    const linkage::Drive& drive = model.structure.drives.front();
    return model.links[link] == "crank" && !drive.of_slide && drive.link == link && drive.on == 0;
}

std::string input_column(const LinkageModel& model) {
    if (model.driven_by_slide()) return "displacement";
    for (std::size_t link = 1; link < model.links.size(); ++link)
        if (model.links[link] == "crank" && !is_input(model, link)) return "input-angle";
    return "crank-angle";
}

struct Column {
    enum class Of : std::uint8_t { input, link, pin_x, pin_y, slide, signal };
    Of of = Of::input;
    std::size_t index = 0;
    std::string name{};
    Unit unit = Unit::length;
};

/// Those of the input, links, points and slides, but where a signal has the same name; then those of signals.
std::vector<Column> columns_of(const LinkageModel& model) {
    using Of = Column::Of;
    std::vector<Column> columns;
    const auto add = [&](Of of, std::size_t index, std::string name, Unit unit) {
        const bool is_signal = of != Of::signal && of != Of::input &&
                               std::any_of(model.signal_names.begin(), model.signal_names.end(),
                                           [&](const NamedSignal& signal) { return signal.name == name; });
        if (!is_signal) columns.push_back({of, index, std::move(name), unit});
    };
    add(Of::input, 0, input_column(model), model.driven_by_slide() ? Unit::length : Unit::angle);
    for (std::size_t link = 1; link < model.links.size(); ++link)
        if (is_named(model.links[link]) && !is_input(model, link))
            add(Of::link, link, model.links[link] + "-angle", Unit::angle);
    for (std::size_t pin = 0; pin < model.pins.size(); ++pin) {
        if (!is_named(model.pins[pin])) continue;
        add(Of::pin_x, pin, model.pins[pin] + "-x", Unit::length);
        add(Of::pin_y, pin, model.pins[pin] + "-y", Unit::length);
    }
    for (std::size_t i = 0; i < model.slides.size(); ++i) {
        const std::string& name = model.slides[i];
        add(Of::slide, i, (name.empty() ? "slide-" + std::to_string(i + 1) : name) + "-displacement", Unit::length);
    }
    for (std::size_t i = 0; i < model.signals.size(); ++i)
        add(Of::signal, i, model.signal_names[i].name, model.signal_names[i].unit);
    return columns;
}

/// All signals at an input; angles are counted on from the start of the motion. At a limit speeds are infinite.
std::vector<double> signal_values(const LinkageModel& model, const Motion& motion, std::span<const double> dimensions,
                                  double crank_angle) {
    constexpr std::size_t derivatives = 2;  // of the poses, which accelerations need
    const LinkageMeasure measure{LinkageMeasure::Kind::total_length, model.signals};
    Motion over_motion = motion;
    over_motion.of = &measure;
    const measuring::Over over(over_motion);
    auto values = measuring::measured<double, derivatives>(over, dimensions, model.signals);
    const linkage::Travel whole = over.travel();
    const double input = model.input_of(crank_angle);
    const bool first = input == whole.from, at_end = !whole.whole && (first || input == whole.to);
    linkage::Course course =
        linkage::course_along(over.driven(dimensions), at_end ? whole : linkage::Travel{whole.from, input});
    // Where the linkage does not close at the start angles are those of the pose alone.
    if (!course.turns.empty()) values.start_at(course);
    const auto near = course.turns.near(input);
    const linkage::Limit limit = at_end ? linkage::limit_at(values, input, near) : linkage::Limit{};
    (first ? course.travel.first : course.travel.last) = limit;
    std::vector<double> all;
    for (std::size_t i = 0; i < model.signals.size(); ++i)
        all.push_back(limit.exists() ? linkage::value_at_limit(values, {i, 0}, course, !first)
                                     : values.value(i, input, near).c[0]);
    return all;
}

bool row(const Motion& motion, std::span<const double> dimensions, double crank_angle, std::span<double> out) {
    const LinkageModel& model = linkage_of(motion.model);
    linkage::Driven<double> linkage = driven(model, dimensions, motion.assembly);
    if (!place_within(linkage, motion, crank_angle)) return false;
    const LinkagePlacement placement = placement_of(model, dimensions);
    const linkage::Pose<double>& pose = linkage.pose;
    const std::vector<double> numbers = numbers_of(model, dimensions);
    const LinkageShape shape{model.structure, numbers, model.links, model.pins, placement.scale};
    std::vector<double> signals;
    if (!model.signals.empty()) signals = signal_values(model, motion, dimensions, crank_angle);
    auto next = out.begin();
    for (const Column& column : columns_of(model)) {
        const std::size_t i = column.index;
        switch (column.of) {
            case Column::Of::input: *next++ = crank_angle; break;
            case Column::Of::link: *next++ = std::atan2(pose.links[i].along.y, pose.links[i].along.x); break;
            case Column::Of::pin_x: *next++ = placement.in_drawing(pose.pins[i]).x; break;
            case Column::Of::pin_y: *next++ = placement.in_drawing(pose.pins[i]).y; break;
            case Column::Of::slide: *next++ = slide_displacement(shape, i, pose); break;
            case Column::Of::signal: *next++ = signals[i]; break;
        }
    }
    return true;
}

}  // namespace

MotionTable linkage_table(const LinkageModel& model) {
    MotionTable table{{}, {}, row};
    for (Column& column : columns_of(model)) {
        table.columns.push_back(std::move(column.name));
        table.units.push_back(column.unit);
    }
    return table;
}

}  // namespace mechwright
