// Where figures show the dimensions of mechanisms: each once, and as long as it is.

#include "synthesis/report/drawing/figure/figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/linkage/drawing/figure.h"
#include "synthesis/report/drawing/figure/layout.h"
#include "synthesis/report/drawing/figure/problem_figure.h"
#include "tests/drawing/designs.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

constexpr double panel_width = 430;

const char* const with_figures[] = {"four-bar", "slider-crank", "crank-shaper", "whitworth", "drag-link", "cam"};

/// Numbers that no figure could show: those of segments that the figure's motion has not, and what a kind has not.
bool is_nowhere(const Mechanism& mechanism, const Dimension& dimension) {
    if (dimension.name.empty()) return true;
    if (!is_cam(mechanism)) return false;
    const CamKind kind = cam_kind(mechanism);
    if (kind.follower == CamFollower::knife && dimension.name == "roller-radius") return true;
    if (!dimension.of_segment) return false;
    if (kind.contour != cam::ContourKind::none) return true;
    for (const char* shown : {"angle-1", "angle-2", "angle-3", "angle-4", "lift-1", "lift-3"})
        if (dimension.name == shown) return false;
    return true;
}

TEST(Figure, ShowsEveryDimensionOnce) {
    for (const auto& mechanism : mechanisms()) {
        ASSERT_TRUE(mechanism->drawing && mechanism->drawing->figure) << mechanism->name;
        std::map<std::string, int> shown;
        for (const FigurePanel& panel : mechanism->drawing->figure(mechanism))
            for (const FigureDimension& dimension : panel.dimensions)
                ++shown[dimension.name];
        for (const Dimension& dimension : mechanism->dimensions)
            EXPECT_EQ(shown[dimension.name], is_nowhere(*mechanism, dimension) ? 0 : 1)
                << mechanism->meaning << ": " << dimension.name;
        for (const auto& [name, count] : shown)
            EXPECT_TRUE(count == 0 || find_dimension(*mechanism, name) >= 0) << name;
    }
}

double difference_of_turns(double a, double b) { return std::remainder(a - b, 2 * std::numbers::pi); }

/// The direction from one place of the picture to another, as an angle of the drawing.
double direction(const Vector<double>& from, const Vector<double>& to) {
    return std::atan2(from.y - to.y, to.x - from.x);
}

/// What the picture has between the ends of a dimension is what the design has.
void expect_measured(const FigurePanel& panel, const PanelLayout& layout, const DrawnDimension& drawn) {
    const std::string& name = drawn.of.name;
    const double value = panel.design[name], near = 1e-6;
    if (drawn.of.as == ShownAs::angle) {
        EXPECT_NEAR(difference_of_turns(direction(drawn.arc.vertex, drawn.to), direction(drawn.arc.vertex, drawn.from)),
                    std::remainder(value, 2 * std::numbers::pi), near)
            << name;
        EXPECT_NEAR(drawn.arc.turn, value, near) << name;
        ASSERT_EQ(drawn.zero.size(), 1u);
        EXPECT_NEAR(difference_of_turns(direction(drawn.zero[0].from, drawn.zero[0].to),
                                        direction(drawn.arc.vertex, drawn.from)),
                    0, near)
            << name;
        return;
    }
    const double length = dot(drawn.to - drawn.from, drawn.along) / layout.view.scale;
    EXPECT_NEAR(drawn.of.unit * length, value, 1e-6 * std::abs(value)) << panel.title << ": " << name;
    EXPECT_NEAR(std::hypot(drawn.to.x - drawn.from.x, drawn.to.y - drawn.from.y), std::abs(length) * layout.view.scale,
                near)
        << name;
}

TEST(Figure, DrawsDimensionsAsLongAsTheyAre) {
    for (const auto& mechanism : mechanisms())
        for (const FigurePanel& panel : mechanism->drawing->figure(mechanism)) {
            const PanelLayout layout = lay_out(panel, panel_width);
            for (const DrawnDimension& drawn : layout.dimensions) {
                const auto index = static_cast<std::size_t>(find_dimension(*panel.design.mechanism, drawn.of.name));
                const DimensionKind kind = panel.design.mechanism->dimensions[index].kind;
                const bool measurable = kind != DimensionKind::force && kind != DimensionKind::rate;
                EXPECT_EQ(drawn.of.as != ShownAs::word, measurable) << drawn.of.name;
                if (measurable) expect_measured(panel, layout, drawn);
            }
        }
}

std::vector<TextBox> all_texts(const PanelLayout& layout) {
    std::vector<TextBox> all = layout.texts;
    for (const DrawnDimension& drawn : layout.dimensions)
        all.push_back(drawn.label);
    return all;
}

/// All texts are in the picture, and none is on another.
void expect_apart(const FigurePanel& panel, double width) {
    const PanelLayout layout = lay_out(panel, width);
    const std::vector<TextBox> texts = all_texts(layout);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const Vector<double>& middle = texts[i].middle;
        EXPECT_TRUE(middle.x - 0.5 * texts[i].width >= 0 && middle.x + 0.5 * texts[i].width <= width)
            << panel.title << ": " << texts[i].text;
        EXPECT_TRUE(middle.y - 0.5 * texts[i].height >= 0 && middle.y + 0.5 * texts[i].height <= layout.height)
            << panel.title << ": " << texts[i].text;
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_FALSE(overlap(texts[i], texts[k]))
                << panel.title << ": " << texts[i].text << " and " << texts[k].text;
    }
}

TEST(Figure, LetsNoTextCoverAnother) {
    for (const char* name : with_figures)
        for (const FigurePanel& panel : figure_of(name))
            for (const double width : {380.0, panel_width, 640.0})
                expect_apart(panel, width);
}

/// The linkages that come with mechwright, of which nobody laid the figures out.
TEST(Figure, IsLegibleAndRightForAnyLinkage) {
    for (const auto& entry : std::filesystem::directory_iterator(MECHWRIGHT_SOURCE_DIR "/problems/linkage")) {
        const ReadProblem read = read_problem(entry.path().string());
        const std::vector<FigurePanel> panels = figure_of(read.problem);
        ASSERT_EQ(panels.size(), 1u) << entry.path();
        SCOPED_TRACE(entry.path());
        constexpr double width = 620;
        expect_apart(panels[0], width);
        const PanelLayout layout = lay_out(panels[0], width);
        for (const DrawnDimension& dimension : layout.dimensions)
            expect_measured(panels[0], layout, dimension);
    }
}

/// mechwright draw --figure NAME --out results/figures/NAME.svg
TEST(Figure, IsKeptAsItIsDrawn) {
    for (const std::string name : with_figures)
        EXPECT_EQ(content_of(MECHWRIGHT_SOURCE_DIR "/results/figures/" + name + ".svg"), figure_picture(name)) << name;
}

/// Of a linkage coordinates, distances and directions of points on their links are drawn.
TEST(Figure, ShowsTheLinksPointsAndDimensionsOfALinkage) {
    const FinishedDesign design = given(content_of(MECHWRIGHT_SOURCE_DIR "/problems/linkage/jansen-leg.toml"));
    const FigurePanel panel = linkage_panel(design);
    const PanelLayout layout = lay_out(panel, 620);
    std::set<std::string> drawn;
    for (const DrawnDimension& dimension : layout.dimensions) {
        EXPECT_TRUE(drawn.insert(dimension.of.name).second) << dimension.of.name;
        expect_measured(panel, layout, dimension);
    }
    for (const char* name :
         {"a", "b", "c", "f", "j", "k", "l", "m", "v-along", "v-across", "t-along", "t-across", "foot"})
        EXPECT_TRUE(drawn.contains(name)) << name;
    std::set<std::string> texts;
    for (const TextBox& text : layout.texts)
        texts.insert(text.text);
    for (const char* name : {"O", "C", "X", "Y", "V", "W", "U", "T", "crank", "upper", "lower", "foot", "upper-rod"})
        EXPECT_TRUE(texts.contains(name) || drawn.contains(name)) << name;
}

TEST(Figure, IsOfEveryMechanism) {
    for (const auto& mechanism : mechanisms())
        EXPECT_TRUE(std::find(std::begin(with_figures), std::end(with_figures), mechanism->name) !=
                    std::end(with_figures))
            << mechanism->name;
}

}  // namespace
}  // namespace mechwright::testing
