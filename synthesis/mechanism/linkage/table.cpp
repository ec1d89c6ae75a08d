#include "synthesis/mechanism/linkage/table.h"

#include <cmath>

#include "synthesis/mechanism/linkage/drawing/drawing.h"

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

/// Whether a link has a column for its angle.
bool has_column(const LinkageModel& model, std::size_t link) {
    return is_named(model.links[link]) && !is_input(model, link);
}

bool row(const Motion& motion, std::span<const double> dimensions, double crank_angle, std::span<double> out) {
    const LinkageModel& model = linkage_of(motion.model);
    linkage::Driven<double> linkage = driven(model, dimensions, motion.assembly);
    if (!place_within(linkage, motion, crank_angle)) return false;
    const LinkagePlacement placement = placement_of(model, dimensions);
    const linkage::Pose<double>& pose = linkage.pose;
    auto next = out.begin();
    *next++ = crank_angle;
    for (std::size_t link = 1; link < model.links.size(); ++link)
        if (has_column(model, link)) *next++ = std::atan2(pose.links[link].along.y, pose.links[link].along.x);
    for (std::size_t i = 0; i < model.pins.size(); ++i) {
        if (!is_named(model.pins[i])) continue;
        const Vector<double> at = placement.in_drawing(pose.pins[i]);
        *next++ = at.x;
        *next++ = at.y;
    }
    const std::vector<double> numbers = numbers_of(model, dimensions);
    const LinkageShape shape{model.structure, numbers, model.links, model.pins, placement.scale};
    for (std::size_t i = 0; i < model.structure.slides.size(); ++i)
        *next++ = slide_displacement(shape, i, pose);
    return true;
}

}  // namespace

MotionTable linkage_table(const LinkageModel& model) {
    MotionTable table{{input_column(model)}, {model.driven_by_slide() ? Unit::length : Unit::angle}, row};
    const auto add = [&table](std::string name, Unit unit) {
        table.columns.push_back(std::move(name));
        table.units.push_back(unit);
    };
    for (std::size_t link = 1; link < model.links.size(); ++link)
        if (has_column(model, link)) add(model.links[link] + "-angle", Unit::angle);
    for (const std::string& pin : model.pins) {
        if (!is_named(pin)) continue;
        add(pin + "-x", Unit::length);
        add(pin + "-y", Unit::length);
    }
    for (std::size_t i = 0; i < model.slides.size(); ++i)
        add((model.slides[i].empty() ? "slide-" + std::to_string(i + 1) : model.slides[i]) + "-displacement",
            Unit::length);
    return table;
}

}  // namespace mechwright
