// Boxes and regions of the built-in kinds: against all poses of a fine scan by each kind's own drawing, differences,
// and the linkage that `expand` makes of it.

#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/linkage/of_kinds/expand.h"
#include "tests/mechanism/kinds_with_rooms.h"

namespace mechwright::linkage_scans {

namespace {

/// By names that all kinds have.
const std::string rooms_of_any = R"(
[[room]]
name = "all"
direction = 27
[[room]]
name = "feet"
of = "pivots"
[[region]]
name = "bay"
keep = "in"
polygon = [[-30, -31], [33, -30], [29, 35], [-28, 34]]
[[region]]
name = "post"
keep = "out"
circle = { centre = [21, 17], radius = 1 }
[[region]]
name = "block"
keep = "out"
polygon = [[-20, -22], [-18, -25], [-24, -26]]
[[region]]
name = "wall"
keep = "in"
half-plane = { through = [0, 24], direction = 170 }
)";

/// The least over all poses of something of their points.
template <class Of>
double least_in(const std::vector<Places>& poses, const Of& of) {
    double least = std::numeric_limits<double>::infinity();
    for (const Places& pose : poses)
        least = std::min(least, of(pose));
    return least;
}

template <class Of>
double least_of_points(const std::vector<Places>& poses, const Of& of) {
    return least_in(poses, [&](const Places& pose) {
        double least = std::numeric_limits<double>::infinity();
        for (const Vector<double>& at : pose)
            least = std::min(least, of(at));
        return least;
    });
}

double side_of(const std::vector<Places>& poses, double degrees) {
    return -(least_of_points(poses, [&](const Vector<double>& at) { return along_way(at, degrees); }) +
             least_of_points(poses, [&](const Vector<double>& at) { return -along_way(at, degrees); }));
}

double outside_of(const std::vector<Places>& poses, const std::string& kind, const Places& region) {
    return least_in(poses, [&](const Places& pose) {
        double least = std::numeric_limits<double>::infinity();
        for (const std::vector<std::size_t>& link : outlines_of(kind)) {
            Places outline;
            for (const std::size_t point : link)
                outline.push_back(pose[point]);
            least = std::min(least, between_outlines(outline, region));
        }
        return least;
    });
}

double inside_of(const std::vector<Places>& poses, const Places& polygon) {
    return least_of_points(poses, [&](const Vector<double>& at) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vector<double> side = polygon[(i + 1) % polygon.size()] - polygon[i];
            least = std::min(least, cross(side, at - polygon[i]) / std::hypot(side.x, side.y));
        }
        return least;
    });
}

/// Least distances and greatest sides of a scan fall short by what lies between its steps.
void expect_scanned(const KindWithRooms& of, const std::string& motion) {
    SCOPED_TRACE(of.kind + motion);
    const AnalysedRoom found = analysed_room(of.text() + motion + rooms_of_any);
    const std::vector<Places> poses = poses_of(found.design, 20000);
    ASSERT_GT(poses.size(), 10000u);
    const auto expect_side = [&](const std::string& quantity, double scanned) {
        EXPECT_NEAR(value_in(found.document, quantity), scanned, 1e-5) << quantity;
        EXPECT_GE(value_in(found.document, quantity), scanned - 1e-12) << quantity;
    };
    const auto expect_margin = [&](const std::string& quantity, double scanned) {
        EXPECT_NEAR(value_in(found.document, quantity), scanned, 1e-5) << quantity;
        EXPECT_LE(value_in(found.document, quantity), scanned + 1e-12) << quantity;
    };
    expect_side("all.width", side_of(poses, 27));
    expect_side("all.height", side_of(poses, 117));
    EXPECT_NEAR(value_in(found.document, "all.area"),
                value_in(found.document, "all.width") * value_in(found.document, "all.height"), 1e-10);
    expect_margin("bay.margin", inside_of(poses, {{-30, -31}, {33, -30}, {29, 35}, {-28, 34}}));
    expect_margin("post.margin", outside_of(poses, of.kind, {{21, 17}}) - 1);
    expect_margin("block.margin", outside_of(poses, of.kind, {{-20, -22}, {-18, -25}, {-24, -26}}));
    expect_margin("wall.margin", least_of_points(poses, [](const Vector<double>& at) {
                      return along_way(at - Vector<double>{0, 24}, 260);
                  }));
}

TEST(RoomsOfKinds, AreThoseOfAScanOfTheirOwnDrawings) {
    for (const KindWithRooms& of : kinds_with_rooms) {
        expect_scanned(of, "");
        expect_scanned(of, "[motion]\ncrank_range = [-35, 110]\n");
    }
}

TEST(RoomsOfKinds, AreVerifiedFromTheDocumentAlone) {
    for (const KindWithRooms& of : kinds_with_rooms) {
        SCOPED_TRACE(of.kind);
        expect_verified(analysed_room(of.text() + rooms_of_any).document);
    }
}

TEST(RoomsOfKinds, OfMotionsThatEndAtLimitsAreVerified) {
    const AnalysedRoom found = analysed_room(
        text_of_kind("four-bar", "ground = 5\ncrank = 3.5\ncoupler = 2.8\nrocker = 2.9\ntilt = 3") + rooms_of_any);
    ASSERT_FALSE(found.design.motion.full_turn);
    const std::vector<Places> poses = poses_of(found.design, 20000);
    // The ends themselves are hardly in the scan: there the pin goes like the root of the way.
    EXPECT_NEAR(value_in(found.document, "all.width"), side_of(poses, 27), 1e-3);
    EXPECT_GE(value_in(found.document, "all.width"), side_of(poses, 27) - 1e-12);
    expect_verified(found.document);
}

/// All quantities of rooms and regions of both are the same.
void expect_same_when_expanded(const std::string& text) {
    const ExpandedProblem expanded = expand_problem(text, "kind.toml");
    ASSERT_TRUE(expanded.ok()) << to_string(expanded.messages.front());
    const Json own = analysed_room(text).document["quantities"];
    const AnalysedRoom linkage = analysed_room(expanded.text);
    std::size_t compared = 0;
    for (const auto& [name, value] : own.items()) {
        if (without_whole(name).find('.') == std::string_view::npos) continue;
        EXPECT_NEAR(value_in(linkage.document, name), value.get<double>(), 1e-12 * (1 + std::abs(value.get<double>())))
            << name;
        ++compared;
    }
    EXPECT_GE(compared, 10u);
}

TEST(RoomsOfKinds, AreThoseOfTheLinkagesThatTheyAre) {
    for (const KindWithRooms& of : kinds_with_rooms) {
        SCOPED_TRACE(of.kind);
        expect_same_when_expanded(of.text() + rooms_of_any);
        expect_same_when_expanded(of.text() + "[motion]\ncrank_range = [200, 300]\n" + rooms_of_any);
    }
    expect_same_when_expanded(text_of_kind("four-bar", "ground = 5\ncrank = 2\ncoupler = 4.5\nrocker = 4") +
                              rooms_of_any);
    expect_same_when_expanded(
        "schema = 1\nmechanism = \"slider-crank\"\n[units]\nangle = \"rad\"\n[dimensions]\ncrank "
        "= 2\nrod = 5\noffset = 1\ntilt = 0.4\n" +
        rooms_of_any);
}

TEST(RoomsOfKinds, HaveExactDerivatives) {
    for (const KindWithRooms& of : kinds_with_rooms) {
        SCOPED_TRACE(of.kind);
        expect_room_slopes(of.text() + rooms_of_any,
                           {"all.width", "all.area", "bay.margin", "post.margin", "block.margin", "wall.margin"});
    }
}

const std::string between_targets = R"(
[motion]
from = "first-target"
to = "last-target"
before = 5
[path]
timing = "prescribed"
points = [[3, 1], [2, 2], [1, 2]]
crank_angles = [0, 30, 75]
)";

TEST(RoomsOfKinds, OverARangeOfUseAreThoseOfTheLinkages) {
    const std::string start = "crank-start = 40\n";
    for (const KindWithRooms& of : {kinds_with_rooms[0], kinds_with_rooms[1]}) {
        SCOPED_TRACE(of.kind);
        const std::string text = text_of_kind(of.kind, of.dimensions + "\n" + start) + between_targets + rooms_of_any +
                                 "[[require]]\nquantity = \"all.width.whole\"\nmin = 0\n";
        const Json quantities = analysed_room(text).document["quantities"];
        EXPECT_LT(quantities["all.width"].get<double>(), quantities["all.width.whole"].get<double>());
        EXPECT_GT(quantities["bay.margin"].get<double>(), quantities["bay.margin.whole"].get<double>());
        expect_same_when_expanded(text);
    }
}

/// Beyond the input range of a line the crank goes on turning.
TEST(RoomsOfKinds, OverInputRangesAreThoseOfTheLinkages) {
    for (const KindWithRooms& of : {kinds_with_rooms[0], kinds_with_rooms[1]})
        for (const char* turns : {"", "full_turn = true\n[[require]]\nquantity = \"all.area.whole\"\nmin = 0\n"}) {
            SCOPED_TRACE(of.kind + turns);
            expect_same_when_expanded(of.text() + "[line]\nstart = 25\nrange = 80\nangle = 20\noffset = 3\n" + turns +
                                      rooms_of_any);
        }
}

TEST(RoomsOfKinds, OverARangeOfUseAreVerified) {
    const AnalysedRoom found =
        analysed_room(text_of_kind("four-bar", "ground = 5\ncrank = 2\ncoupler = 4.5\nrocker = 4\ncrank-start = 40") +
                      between_targets + rooms_of_any);
    EXPECT_LT(value_in(found.document, "all.area"), value_in(found.document, "all.area.whole"));
    EXPECT_LE(value_in(found.document, "post.margin.whole"), value_in(found.document, "post.margin"));
    expect_verified(found.document);
}

TEST(RoomsOfKinds, HaveExactDerivativesOverRangesOfTheInput) {
    const std::string line = "[line]\nstart = { min = 10, max = 50 }\nrange = { min = 50, max = 90 }\n";
    for (const std::string& target : {line, between_targets})
        for (const KindWithRooms& of : {kinds_with_rooms[0], kinds_with_rooms[1]}) {
            const ReadProblem read = testing::read_without_fault(of.text() + target + rooms_of_any);
            ASSERT_TRUE(read.ok());
            const Mechanism& m = *read.problem.mechanism;
            std::size_t seen = 0;
            for (const Quantity& quantity : m.input->quantities) {
                if (quantity.of.as<LinkageMeasure>() == nullptr) continue;
                ++seen;
                std::vector<double> arguments;
                for (const std::size_t i : quantity.reads)
                    arguments.push_back(read.problem.dimensions[i].min);
                const bool has_numbers = m.input->start != no_dimension;
                EXPECT_EQ(arguments.size(), m.plain->dimensions.size() + (has_numbers ? 2 : 0));
                arguments.resize(m.plain->dimensions.size());
                arguments.insert(arguments.end(), {0.4, 1.3});
                Motion motion;
                motion.is_range_of_use = true;
                testing::expect_slopes(m, quantity, motion, arguments);
            }
            EXPECT_EQ(seen, 10u);
        }
}

TEST(RoomsOfKinds, AreDrawnBesideTheKindsOwnGround) {
    for (const KindWithRooms& of : kinds_with_rooms) {
        SCOPED_TRACE(of.kind);
        const auto count = [](const Scene& scene, Layer layer) {
            return std::count_if(scene.fixed.begin(), scene.fixed.end(),
                                 [&](const Outline& outline) { return outline.layer == layer; });
        };
        const Scene bare = scene_of(analysed_room(of.text()).design, 1e-4),
                    scene = scene_of(analysed_room(of.text() + rooms_of_any).design, 1e-4);
        EXPECT_EQ(count(bare, Layer::room), 0);
        EXPECT_EQ(count(scene, Layer::room), 6);
        EXPECT_EQ(count(scene, Layer::ground), count(bare, Layer::ground));
        EXPECT_GE(scene.high.x, 33 - 1e-9);  // all of it is in the picture
    }
}

}  // namespace

}  // namespace mechwright::linkage_scans
