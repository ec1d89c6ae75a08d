#include "synthesis/mechanism/drawing/figure.h"

#include <algorithm>
#include <iterator>
#include <numbers>

namespace mechwright {

MovingDesign figure_design(const std::shared_ptr<const Mechanism>& mechanism,
                           const std::vector<std::pair<std::string_view, double>>& dimensions, std::size_t assembly) {
    MovingDesign design{mechanism, {}, std::vector<double>(mechanism->dimensions.size()), false, false};
    for (const auto& [name, value] : dimensions) {
        const auto index = static_cast<std::size_t>(find_dimension(*mechanism, name));
        const bool angle = mechanism->dimensions[index].kind == DimensionKind::angle;
        design.dimensions[index] = angle ? value * std::numbers::pi / 180 : value;
    }
    design.motion = motion_of(*mechanism, design.dimensions, assembly, nullptr);
    return design;
}

namespace {

std::vector<FigurePanel> panels_of(const std::shared_ptr<const Mechanism>& listed) {
    const bool has_figure = listed->drawing && listed->drawing->figure != nullptr;
    return has_figure ? listed->drawing->figure(listed) : std::vector<FigurePanel>{};
}

}  // namespace

std::vector<FigurePanel> figure_of(std::string_view mechanism_name) {
    std::vector<FigurePanel> own, shared;
    const auto add = [](FigurePanel& panel, std::vector<FigurePanel>& to) {
        if (std::none_of(to.begin(), to.end(), [&](const auto& p) { return p.title == panel.title; }))
            to.push_back(std::move(panel));
    };
    for (const auto& mechanism : mechanisms()) {
        if (mechanism->name != mechanism_name) continue;
        std::vector<FigurePanel> panels = panels_of(mechanism);
        for (std::size_t i = 0; i < panels.size(); ++i)
            add(panels[i], i == 0 ? own : shared);
    }
    std::move(shared.begin(), shared.end(), std::back_inserter(own));
    return own;
}

std::vector<FigurePanel> figure_of(const Mechanism& mechanism) {
    std::vector<FigurePanel> panels;
    for (const auto& listed : mechanisms())
        if (listed->name == mechanism.name && listed->meaning == mechanism.meaning) panels = panels_of(listed);
    std::erase_if(panels, [&](const FigurePanel& panel) {
        return std::none_of(panel.dimensions.begin(), panel.dimensions.end(),
                            [&](const FigureDimension& d) { return find_dimension(mechanism, d.name) >= 0; });
    });
    return panels;
}

}  // namespace mechwright
