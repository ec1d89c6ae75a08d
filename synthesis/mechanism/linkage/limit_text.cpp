#include "synthesis/mechanism/linkage/limit_text.h"

#include <fmt/format.h>

#include <utility>

namespace mechwright {

std::string stop_text(const linkage::Step& step, std::span<const std::string> pins,
                      std::span<const std::string> slides) {
    const char* which = step.reversed ? "max" : "min";
    if (step.input != linkage::none)
        return step.input == 0 ? fmt::format("the stop '{}' of the drive", which)
                               : fmt::format("the stop '{}' of drive {}", which, step.input + 1);
    if (step.far_pin != linkage::none) return fmt::format("an end of the circular slot of '{}'", pins[step.pin]);
    if (step.pin != linkage::none) return fmt::format("the stop '{}' of the slot of '{}'", which, pins[step.pin]);
    const std::string& name = slides[step.joint];
    return name.empty() ? fmt::format("the stop '{}' of slide {}", which, step.joint + 1)
                        : fmt::format("the stop '{}' of slide '{}'", which, name);
}

std::string limit_text(const linkage::Order& order, const linkage::Limit& limit, std::span<const std::string> links,
                       std::span<const std::string> pins, std::span<const std::string> slides) {
    using Kind = linkage::Step::Kind;
    if (!limit.exists()) return {};
    const linkage::Step& step = linkage::step_of(order, limit.margin);
    if (step.kind == Kind::together) {
        std::string names;
        std::size_t last = linkage::none;
        for (const linkage::LinkUnknown& unknown : order.larger[step.joint].unknowns)
            if (unknown.link != std::exchange(last, unknown.link))
                names += fmt::format("{}'{}'", names.empty() ? "" : ", ", links[unknown.link]);
        return fmt::format("where {} turn back together", names);
    }
    if (step.kind == Kind::stopped) return "at " + stop_text(step, pins, slides);
    if (step.is_of_lines())
        return step.kind == Kind::tied ? fmt::format("where the lines that hold '{}' become parallel", links[step.link])
                                       : fmt::format("where the lines that hold '{}' become parallel", pins[step.pin]);
    const std::string& pin = pins[step.kind == Kind::dyad ? step.pin : step.far_pin];
    const bool of_links = step.kind == Kind::dyad && step.second.kind == linkage::Locus::Kind::circle;
    return of_links ? fmt::format("where the dyad closed at '{}' is {}", pin, limit.inner ? "folded" : "stretched out")
                    : fmt::format("where the dyad closed at '{}' is square to its line", pin);
}

}  // namespace mechwright
