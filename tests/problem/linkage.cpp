// Files of linkages: what is read, and what wrong ones are told.

#include "synthesis/problem/linkage/linkage.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "tests/analysis/random_linkage.h"
#include "tests/long_form.h"
#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

/// Its lines: 1 schema, 2 mechanism, 3 [dimensions], 4 ground, 5 [links], 6 frame, 7 crank, 8 coupler, 9 rocker,
/// 10 [drive], 11 link. What is added starts in line 12.
const std::string four_bar_text =
    "schema = 1\n"
    "mechanism = \"linkage\"\n"
    "[dimensions]\n"
    "ground = 4\n"
    "[links]\n"
    "frame = { A = [0, 0], D = [\"ground\", 0] }\n"
    "crank = { A = [0, 0], B = [1, 0] }\n"
    "coupler = { B = [0, 0], C = [3.5, 0], P = [2, 1] }\n"
    "rocker = { D = [0, 0], C = [3, 0] }\n"
    "[drive]\n"
    "link = \"crank\"\n";

std::string changed(const std::string& from, const std::string& to, std::string text = four_bar_text) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// The messages of a linkage's text, as `says` takes them.
ReadProblem told(const std::string& text) {
    ReadProblem read;
    read.messages = parse_linkage(text, "p.toml").messages;
    return read;
}

Linkage good(const std::string& text) {
    ReadLinkage read = parse_linkage(text, "p.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return read.linkage;
}

}  // namespace

TEST(LinkageFile, IsReadInTheOrderOfItsText) {
    const Linkage l = good(four_bar_text);
    EXPECT_EQ(l.links, (std::vector<std::string>{"frame", "crank", "coupler", "rocker"}));
    EXPECT_EQ(l.pins, (std::vector<std::string>{"A", "D", "B", "C", "P"}));
    EXPECT_TRUE(l.given());
    EXPECT_EQ(l.mobility.mobility, 1);
    ASSERT_EQ(l.order.groups.size(), 2u);
    EXPECT_EQ(l.sides, std::vector<std::int8_t>{1});
    // A link as a table of its own is the same as one in a line.
    const Linkage tables = good(
        "schema = 1\nmechanism = \"linkage\"\n[links.frame]\nA = [0, 0]\nD = [4, 0]\n[links.zeta]\nA = [0, 0]\nB = [1, "
        "0]\n"
        "[links.coupler]\nB = [0, 0]\nC = [3.5, 0]\n[links.rocker]\nD = [0, 0]\nC = [3, 0]\n[drive]\nlink = "
        "\"zeta\"\n");
    EXPECT_EQ(tables.links, (std::vector<std::string>{"frame", "zeta", "coupler", "rocker"}));
}

TEST(LinkageFile, TakesSumsOfDimensions) {
    const auto ground = [](const std::string& expression) {
        const Linkage l =
            good(changed("ground = 4", "ground = 4\nlong = { min = 1, max = 9, start = 3 }\nhalf = \"long / 2\"",
                         changed("\"ground\"", "\"" + expression + "\"",
                                 four_bar_text + "[placement]\norigin-x = \"half - 0.5 ground\"\n")));
        const auto numbers = numbers_of(l, usual_dimensions(l));
        return linkage::place_of<double>(linkage::coordinates_on(l.structure.pins[1], 0), numbers).x;
    };
    EXPECT_EQ(ground("ground"), 4);
    EXPECT_EQ(ground("ground + 2 half - 3"), 4);
    EXPECT_EQ(ground("-ground + 3 * long / 2 + 1e0"), 1.5);
    EXPECT_EQ(ground("half + -1.5 + ground"), 4);
    for (const char* wrong : {"ground -1", "ground+1", "2ground", "ground * 2", "ground * half", "(ground)",
                              "ground / 0", "", "ground ground", "ground +", "1e999", "ground - - 1 x"})
        EXPECT_FALSE(parse_linkage(changed("\"ground\"", "\"" + std::string(wrong) + "\""), "p.toml").ok()) << wrong;
}

TEST(LinkageFile, TakesSlidesSlotsGearsAndFurtherDrives) {
    const Linkage l = good(R"(schema = 1
mechanism = "linkage"
[dimensions]
lead = 90
[links]
frame = { A = [0, 0], E = [30, 0] }
crank = { A = [0, 0], B = { length = 10, angle = "lead" } }
wheel = { E = [0, 0], W = [5, 0] }
rod = { B = [0, 0], S = [30, 0] }
ram = { S = [0, 0] }
arm = { W = [0, 0], T = [20, 0] }
[[slide]]
link = "ram"
on = "frame"
along = ["A", "E"]
name = "out"
[[slot]]
pin = "T"
in = "frame"
centre = [40, 5]
radius = 12
[[belt]]
links = ["crank", "wheel"]
teeth = [40, 20]
crossed = true
[drive]
link = "crank"
[assembly]
out = "behind"
T = "right"
)");
    ASSERT_EQ(l.order.groups.size(), 4u);
    EXPECT_EQ(l.links.back(), "slot of T");
    using Kind = linkage::Group::Kind;
    EXPECT_EQ(l.order.groups[1].kind, Kind::geared);
    EXPECT_EQ(l.numbers[l.structure.gears[0].ratio].value.constant, -2);
    EXPECT_EQ(l.sides, (std::vector<std::int8_t>{-1, -1}));
    const auto numbers = numbers_of(l, usual_dimensions(l));
    const auto b = linkage::place_of<double>(linkage::coordinates_on(l.structure.pins[2], 1), numbers);
    EXPECT_NEAR(b.x, 0, 1e-15);
    EXPECT_NEAR(b.y, 10, 1e-15);
}

TEST(LinkageFile, SaysSidesWhateverTheOrderOfItsLinks) {
    const auto side = [](const std::string& value) {
        return good(four_bar_text + "[assembly]\nC = " + value + "\n").sides[0];
    };
    EXPECT_EQ(side("\"right\""), -1);
    EXPECT_EQ(side("\"either\""), 0);
    EXPECT_EQ(side("{ side = \"left\", from = \"B\", to = \"D\" }"), 1);
    EXPECT_EQ(side("{ side = \"left\", from = \"D\", to = \"B\" }"), -1);
}

TEST(LinkageFile, AcceptsRedundantJointsThatClose) {
    const std::string text =
        "schema = 1\nmechanism = \"linkage\"\n[dimensions]\ncrank = { min = 2, max = 6 }\n[links]\n"
        "frame = { A = [0, 0], D = [10, 0], G = [5, 3] }\ncrank = { A = [0, 0], B = [\"crank\", 0] }\n"
        "coupler = { B = [0, 0], C = [10, 0], H = [5, 3] }\nrocker = { D = [0, 0], C = [\"crank\", 0] }\n"
        "third = { G = [0, 0], H = [\"crank\", 0] }\n[drive]\nlink = \"crank\"\n";
    // The second crank only points to its pin in the parallelogram that the third keeps one.
    EXPECT_EQ(good(text).redundant, (std::vector<std::size_t>{4, 3}));
    EXPECT_EQ(good(text).kept_by_redundant.size(), 1u);
    EXPECT_TRUE(says(told(changed("H = [\"crank\", 0]", "H = [\"crank + 0.001\", 0]", text)), "p.toml:10:1",
                     {"mobility 0", "1 drive", "'third' is redundant", "misses its pin by"}));
    // Fitting in all dimensions but one.
    EXPECT_TRUE(says(told(changed("H = [5, 3]", "H = [5, \"crank - 1\"]", text)), "p.toml:10:1", {"redundant"}));
}

TEST(LinkageFile, SaysWhatIsWrongWithPlaceAndRemedy) {
    struct Row {
        std::string text, place;
        std::vector<std::string_view> words;
    };
    const std::string& ok = four_bar_text;
    const std::string ranged = changed("ground = 4", "ground = { min = 3, max = 5 }");
    for (const Row& row : std::vector<Row>{
             // Mobility, and how it comes about.
             {changed("rocker = { D = [0, 0], C = [3, 0] }", "rocker = { D = [0, 0], Cc = [3, 0] }"),
              "p.toml:5:1",
              {"mobility 3", "3 x 3 moving links - 2 x 3 pins", "1 drive", "'coupler', 'rocker' still move", "'Cc'",
               "'rocker' only: did you mean 'C'?"}},
             {changed("P = [2, 1] }", "P = [2, 1] }\nstay = { A = [0, 0], P = [3, 0] }"),
              "p.toml:5:1",
              {"mobility 0", "1 drive", "hold the same twice", "drive 1", "fit between its pins", "Take away"}},
             {ok + "[[slide]]\nlink = \"rocker\"\non = \"frame\"\npoint = \"A\"\ndirection = 0\n",
              "p.toml:5:1",
              {"mobility 0", "one of these equations follows from others", "hold the same twice", "slide 1"}},
             {changed("link = \"crank\"", "link = \"crank\"\n[links.loose]\nX = [0, 0]\nY = [1, 0]"),
              "p.toml:12:8",
              {"'loose' hangs free"}},
             {changed("[drive]\nlink = \"crank\"\n", "[[drive]]\nlink = \"crank\"\n[[drive]]\nlink = \"rocker\"\n"),
              "p.toml:5:1",
              {"mobility 1", "2 drives", "drive 1, drive 2", "drive"}},
             // Loops that cannot close.
             {changed("C = [3, 0]", "C = [9, 0]"),
              "p.toml:5:1",
              {"closed at 'C' never closes", "0.5 mm are missing", "crank angle 180"}},
             {changed("B = [1, 0]", "B = [0, 0]", changed("C = [3.5, 0]", "C = [0, 0]")),
              "p.toml:8:1",
              {"'B' and 'C'", "'coupler' coincide"}},
             // Names.
             {changed("\"ground\"", "\"grund\""), "p.toml:6:28", {"no dimension 'grund'; did you mean 'ground'?"}},
             {changed("link = \"crank\"", "link = \"krank\""),
              "p.toml:11:8",
              {"no link 'krank'; did you mean 'crank'?"}},
             {ok + "[assembly]\nc = \"left\"\n", "p.toml:13:1", {"no dyad with two assemblies", "C"}},
             {ok + "[assembly]\nC = \"ahead\"\n", "p.toml:13:5", {"side", "left", "right", "either"}},
             {ok + "[signals]\ns = { angle = \"rokcer\" }\n", "p.toml:13:15", {"did you mean 'rocker'?"}},
             {ok + "[signals]\ns = { x = \"Q\" }\n", "p.toml:13:11", {"no point 'Q'"}},
             {ok + "[signals]\ns = { x = \"P\", y = \"P\" }\n", "p.toml:13:1", {"exactly one of"}},
             {ok + "[signals]\nlink-ratio = { x = \"P\" }\n", "p.toml:13:1", {"quantity already"}},
             {ok + "[signals]\ns = { x = \"P\" }\n[[require]]\nquantity = \"s.most\"\nmin = 1\n",
              "p.toml:15:12",
              {"'s.most' is no quantity"}},
             {ok + "[signals]\nswing = { x = \"P\" }\n[objective]\nminimize = \"swnig.range\"\n",
              "p.toml:15:12",
              {"no signal 'swnig'; did you mean 'swing'?"}},
             {changed("crank = {", "Rocker = {", changed("link = \"crank\"", "link = \"Rocker\"")),
              "p.toml:9:1",
              {"'Rocker' and 'rocker' differ by case only"}},
             {changed("P = [2, 1]", "p.q = [2, 1]"), "", {"p.toml:8"}},
             {changed("ground = 4", "ground = 4\nscale = 2"), "p.toml:5:1", {"cannot be the name of a dimension"}},
             {changed("frame =", "frmae ="), "p.toml:5:1", {"no 'frame'"}},
             // Units.
             {changed("ground = 4", "ground = 4\nboth = 3",
                      changed("B = [1, 0]", "B = { length = \"both\", angle = \"both\" }")),
              "p.toml:8:54",
              {"'both' is used as an angle here and as a length in line 8"}},
             {changed("ground = 4", "ground = 4\nspare = 3"), "p.toml:5:1", {"nothing uses the dimension 'spare'"}},
             {ok + "[signals]\na = { angle = \"crank\" }\nb = { x = \"P\" }\nc = { sum = { a = 1, b = 1 } }\n",
              "p.toml:15:1",
              {"different units"}},
             {ok + "[signals]\na = { sum = { b = 1 } }\nb = { sum = { a = 1 } }\n", "p.toml:13:1", {"made of itself"}},
             {changed("ground = 4", "ground = \"half\"\nhalf = \"ground\""), "p.toml:4:1", {"circle"}},
             // Sections.
             {ok + "[[drive]]\nlink = \"rocker\"\n", "p.toml:12:1", {"drive"}},
             {changed("[drive]\nlink = \"crank\"\n", ""), "p.toml:1:1", {"[drive] is missing"}},
             {changed("link = \"crank\"", "link = \"crank\"\nturn = 3"), "p.toml:12:1", {"turn"}},
             {ok + "[[slide]]\nlink = \"rocker\"\non = \"frame\"\n", "p.toml:12:1", {"no line", "along"}},
             {ok + "[[slide]]\nlink = \"rocker\"\non = \"frame\"\nalong = [\"A\", \"C\"]\n",
              "p.toml:15:15",
              {"'C' is no point of the link 'frame'", "A, D"}},
             {ok + "[[slot]]\npin = \"P\"\nin = \"coupler\"\nalong = [\"B\", \"C\"]\n",
              "p.toml:14:6",
              {"point of 'coupler' itself"}},
             {ok + "[[gear]]\nlinks = [\"crank\", \"crank\"]\nratio = 2\n", "p.toml:12:1", {"differ from each other"}},
             {ok + "[[gear]]\nlinks = [\"crank\", \"rocker\"]\n", "p.toml:12:1", {"either 'ratio' or 'teeth'"}},
             {ok + "[[rack]]\nlink = \"crank\"\nwheel = \"rocker\"\nradius = 1\n", "p.toml:13:8", {"does not slide"}},
             {ok + "[placement]\nscale = 0\n", "p.toml:13:9", {"greater than 0"}},
             {changed("A = [0, 0], B", "A = [0], B"), "p.toml:7:15", {"[x, y] or { length = ..., angle = ... }"}},
             {changed("min = 3", "min = 6", ranged), "p.toml:4:18", {"'min' 6 is greater than 'max' 5"}},
         }) {
        const ReadProblem read = told(row.text);
        EXPECT_FALSE(read.ok()) << row.text;
        bool found = false;
        for (const Message& message : read.messages) {
            const std::string text = to_string(message);
            bool all = text.starts_with(row.place);
            for (const std::string_view word : row.words)
                all = all && text.find(word) != std::string::npos;
            found = found || all;
        }
        EXPECT_TRUE(found) << row.place << " " << row.words.front() << " is not among\n" << all_messages(read);
    }
}

/// Crank pin and rocker pivot are 9 apart at the least, at a crank angle of 0.5 deg. By a billionth more the links
/// close over less than 0.01 deg, by a billionth less nowhere.
TEST(LinkageFile, ClosesWhereItDoesOverANarrowRangeOnly) {
    const auto file = [](const std::string& rocker) {
        return changed("D = [\"ground\", 0]", "D = { length = 10, angle = 0.5 }",
                       changed("C = [3.5, 0], P", "C = [5, 0], P",
                               changed("C = [3, 0]", "C = [" + rocker + ", 0]", changed("ground = 4\n", ""))));
    };
    good(file("4.000000001"));
    EXPECT_TRUE(
        says(told(file("3.999999999")), "p.toml:4:1", {"never closes: 1e-09 mm are missing", "crank angle 0.5"}));
}

TEST(LinkageFile, SaysAllErrorsAtOnce) {
    const ReadProblem read = told(changed("link = \"crank\"", "link = \"krank\"",
                                          changed("\"ground\"", "\"grund\"", four_bar_text + "[signals]\ns = 3\n")));
    EXPECT_GE(read.messages.size(), 3u) << all_messages(read);
}

/// Whether a problem is told so many errors, and one at each of these places, each with words.
void expect_told(const std::string& text,
                 std::initializer_list<std::pair<const char*, std::initializer_list<std::string_view>>> errors) {
    const ReadProblem problem = read(text);
    EXPECT_FALSE(problem.ok());
    EXPECT_EQ(problem.messages.size(), errors.size()) << all_messages(problem);
    for (const auto& [place, words] : errors)
        EXPECT_TRUE(says(problem, place, words));
}

// Sections that have nothing to do with each other hide nothing of each other, and no error brings others after it.
TEST(LinkageFile, SaysErrorsOfAllSectionsAtOnce) {
    expect_told(four_bar_text +
                    "[assembly]\nC = \"lefft\"\n[signals]\nswing = { angle = \"rocker\" }\n"
                    "[function]\nsignal = \"swing\"\nexpression = \"x^1.5\"\nx = [1, 4]\n"
                    "input = { start = 30, range = 90 }\noutput = { start = 30, range = 60 }\n"
                    "accuracy_points = 7\n"
                    "[[require]]\nquantity = \"transmission-angle-worst\"\nmn = 40\n"
                    "[objective]\nminimise = \"function-max\"\n[solver]\nstarts = -3\n",
                {{"p.toml:13:5", {"'lefft'", "left"}},
                 {"p.toml:22:19", {"3, 4 or 5", "7"}},
                 {"p.toml:23:1", {"asks for nothing"}},
                 {"p.toml:25:1", {"'mn'", "min"}},
                 {"p.toml:26:1", {"minimize"}},
                 {"p.toml:27:1", {"'minimise'", "minimize"}},
                 {"p.toml:29:10", {"starts"}}});
    // A signal that cannot be read, and what is asked of it: the one error is its own.
    expect_told(
        four_bar_text +
            "[signals]\nswing = { angle = \"rockr\" }\n[path]\npoint = \"P\"\n"
            "points = [[1, 2], [3]]\n[[require]]\nquantity = \"swing.range\"\nmin = 40\n"
            "[assembly]\nQ = \"right\"\n",
        {{"p.toml:13:19", {"'rockr'", "rocker"}}, {"p.toml:16:19", {"point 2"}}, {"p.toml:21:1", {"'Q'", "no dyad"}}});
    // Motion and study.
    expect_told(four_bar_text +
                    "[motion]\nat = \"x\"\n[assembly]\nC = \"up\"\n[path]\npoint = \"P\"\n"
                    "points = [[1, 2], [3]]\n",
                {{"p.toml:13:6", {"at"}}, {"p.toml:15:5", {"'up'"}}, {"p.toml:18:19", {"point 2"}}});
    // A dimension that nothing uses.
    expect_told(changed("ground = 4", "ground = 4\nspare = 3") + "[assembly]\nC = \"up\"\n",
                {{"p.toml:5:1", {"'spare'"}}, {"p.toml:14:5", {"'up'"}}});
    expect_told(four_bar_text +
                    "[objective]\nminimize = \"total-length\"\nwieght = 2\n[study]\n\"dimensions.grund\" = [3, 4]\n",
                {{"p.toml:14:1", {"'wieght'", "weight"}}, {"p.toml:15:1", {"dimensions.grund = 3", "'grund'"}}});
    // A structure that does not hold together is told with what else can be read.
    expect_told(changed("rocker = { D = [0, 0], C = [3, 0] }", "rocker = { D = [0, 0], E = [3, 0] }") +
                    "[objective]\nminimise = \"total-length\"\n",
                {{"p.toml:5:1", {"mobility"}}, {"p.toml:12:1", {"minimize"}}, {"p.toml:13:1", {"'minimise'"}}});
}

TEST(LinkageFile, IsAProblemLikeAnyOther) {
    const ReadProblem read = parse_problem(four_bar_text, "p.toml");
    ASSERT_TRUE(read.ok()) << all_messages(read);
    EXPECT_EQ(read.problem.mechanism->name, "linkage");
    EXPECT_EQ(read.problem.mechanism->assemblies, std::vector<std::string>{"C left"});
    EXPECT_EQ(read.problem.mechanism->dimensions.front().name, "ground");
    EXPECT_EQ(why_not_whole(*read.problem.mechanism), "");
}

TEST(LinkageFile, NeedsAnEndWhereItsGearsNeverComeBack) {
    const std::string text =
        changed("crank = {", "wheel = { A = [0, 0], W = [1, 0] }\ncrank = {",
                changed("[drive]", "[[gear]]\nlinks = [\"crank\", \"wheel\"]\nratio = 1.2345678901\n[drive]"));
    const ReadProblem endless = parse_problem(text, "p.toml");
    EXPECT_FALSE(endless.ok());
    EXPECT_NE(all_messages(endless).find("crank_range"), std::string::npos) << all_messages(endless);
    EXPECT_TRUE(parse_problem(text + "[motion]\ncrank_range = [0, 360]\n", "p.toml").ok());
}

TEST(LinkageFile, OfRandomBytesIsReadOrRefused) {
    std::mt19937_64 draw(7);
    const std::string pieces[]{"\"",     "[",     "]",     "{ ",        " }",    "A",           "frame",
                               "= ",     "1e300", "-",     ", ",        "\n",    "[[slide]]\n", "[[gear]]\n",
                               "either", "crank", "\"P\"", "[links]\n", "angle", "nan",         "0"};
    int refused = 0;
    for (int i = 0; i < 1500; ++i) {
        std::string text = four_bar_text + "[[slot]]\npin = \"P\"\nin = \"frame\"\nalong = [\"A\", \"D\"]\n";
        for (std::size_t k = 1 + draw() % 3; k > 0; --k) {
            const std::size_t at = draw() % text.size();
            text.replace(at, draw() % 4, pieces[draw() % std::size(pieces)]);
        }
        refused += !parse_linkage(text, "p.toml").ok();
    }
    EXPECT_GT(refused, 1000);
}

namespace {

std::string exactly(double value) { return fmt::format("{}", value); }

std::string line_text(const MadeLinkage& m, const linkage::Line& line, const std::string& key) {
    return fmt::format("{} = \"L{}\"\npoint = [{}, {}]\ndirection = {}\n", key, line.on,
                       exactly(m.numbers[line.through.first]), exactly(m.numbers[line.through.second]),
                       exactly(m.numbers[line.angle]));
}

/// The file that describes a random structure; its links are called L1, L2 and so on.
std::string file_of(const MadeLinkage& m) {
    std::string text = "schema = 1\nmechanism = \"linkage\"\n[units]\nangle = \"rad\"\n";
    for (std::size_t link = 0; link < m.s.links; ++link) {
        text += link == 0 ? "[links.frame]\n" : fmt::format("[links.L{}]\n", link);
        for (std::size_t i = 0; i < m.pins.size(); ++i)
            for (const linkage::Point& p : m.s.pins[i].points)
                if (p.link == link)
                    text += fmt::format("N{} = [{}, {}]\n", i, exactly(m.numbers[p.at.first]),
                                        exactly(m.numbers[p.at.second]));
    }
    for (const linkage::Slide& s : m.s.slides)
        text += fmt::format("[[slide]]\nlink = \"L{}\"\n{}angle = {}\noffset = {}\n", s.link,
                            line_text(m, s.line, "on"), exactly(m.numbers[s.angle]), exactly(m.numbers[s.offset]));
    for (const linkage::Slot& s : m.s.slots)
        text += fmt::format("[[slot]]\npin = \"N{}\"\n{}", s.pin, line_text(m, s.line, "in"));
    for (const linkage::Gear& g : m.s.gears)
        text += fmt::format("[[gear]]\nlinks = [\"L{}\", \"L{}\"]\ncarrier = \"L{}\"\nratio = {}\nphase = {}\n",
                            g.first, g.second, g.carrier, exactly(m.numbers[g.ratio]), exactly(m.numbers[g.phase]));
    for (const linkage::Drive& d : m.s.drives)
        text += fmt::format("[[drive]]\nlink = \"L{}\"\n", d.link);
    for (std::size_t at = 0; (at = text.find("\"L0\"", at)) != std::string::npos;)
        text.replace(at, 4, "\"frame\"");
    return text;
}

}  // namespace

TEST(LinkageFile, OfRandomStructuresHasTheMobilityOfFiftyDigits) {
    int taken = 0, refused = 0;
    const auto last = static_cast<std::uint64_t>(cases_to_try(50, 200));
    for (std::uint64_t seed = 1; seed <= last; ++seed) {
        const MadeLinkage made = random_linkage(seed);
        const auto exact = linkage::mobility<Precise>(made.s, 11, made.numbers);
        const ReadLinkage read = parse_linkage(file_of(made), "p.toml");
        const bool whole = std::none_of(made.s.pins.begin(), made.s.pins.end(), [](const linkage::Pin& pin) {
            return pin.points.empty();  // a point that chance has taken away from its only link
        });
        if (!whole) continue;
        if (read.ok()) {
            ++taken;
            EXPECT_EQ(read.linkage.mobility.mobility, exact.mobility) << seed;
            EXPECT_EQ(read.linkage.mobility.redundant, exact.redundant) << seed;
            EXPECT_TRUE(exact.settled() || !read.linkage.redundant.empty()) << seed;
            continue;
        }
        ++refused;
        std::string told;
        for (const Message& message : read.messages)
            told += to_string(message) + "\n";
        if (exact.settled())
            EXPECT_TRUE(told.find("never closes") != std::string::npos ||
                        told.find("do not close at any input") != std::string::npos)
                << seed << "\n"
                << told;
        else
            EXPECT_TRUE(told.find(fmt::format("mobility {}", exact.mobility)) != std::string::npos ||
                        told.find("hangs free") != std::string::npos ||
                        told.find("a slot is in another link") != std::string::npos)
                << seed << "\n"
                << told;
    }
    EXPECT_GT(taken, cases_to_try(12, 50));
    EXPECT_GT(refused, cases_to_try(7, 30));
}

}  // namespace mechwright::test
