#pragma once
/// \file
/// A linkage as its problem file describes it (`mechanism = "linkage"`): names bound to a structure, whose numbers are
/// sums of multiples of dimensions.

#include <toml++/toml.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/linkage/structure/mobility.h"
#include "analysis/linkage/structure/order.h"
#include "analysis/linkage/structure/structure.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/problem/affine.h"
#include "synthesis/problem/messages.h"
#include "synthesis/problem/problem.h"
#include "synthesis/problem/reader.h"

namespace mechwright {

/// What a number counts.
enum class Measure : std::uint8_t { unknown, length, angle, ratio };

std::string_view name_of(Measure measure);

struct LinkageDimension {
    std::string name;
    double min = 0;  ///< in the file's units, as all numbers here; a given one has min == max
    double max = 0;
    std::optional<double> start{};
    std::vector<double> choices{};  ///< as DimensionRange has them
    double step = 0;
    std::optional<Affine> tied{};  ///< to others, of which none is tied
    Measure measure = Measure::unknown;

    bool given() const { return !tied && min == max; }
};

/// A number of the structure, in the file's units.
struct LinkageNumber {
    Affine value{};
    Measure measure = Measure::length;
};

struct LinkageSignal {
    std::string name;
    std::string_view kind{};  ///< the key that says what it is: "angle", "x", ...
    linkage::Signal value{};  ///< of a transmission angle `of` is the pin
    Unit unit = Unit::none;   ///< of its values
};

/// Where the frame is in the drawing, and its scale.
struct LinkageAnchor {
    LinkageDimension range{};     ///< of a number of its own
    std::optional<Affine> sum{};  ///< of dimensions
};

/// Points of [sketch], in the frame's axes.
struct LinkageSketch {
    double input = 0;                                              ///< of the master, radians or a length
    std::vector<std::pair<std::size_t, Vector<double>>> points{};  ///< by pins
};

/// Larger groups in one assembly, with the sides of the dyads that they hang on.
struct LargerAssembly {
    std::vector<std::int8_t> sides{};
    std::vector<std::size_t> indices{};  ///< for each larger group: which it is, from 1, of those that it has there
    linkage::Assembled assembled{};
    linkage::Pose<double> pose{};
};

struct Linkage {
    std::string file;
    std::string title;
    Units units;
    std::vector<std::string> links;  ///< the frame first, then as in the text; those of circular slots last
    std::vector<std::string> pins;
    std::vector<std::string> slides;  ///< empty where a slide has no name
    std::vector<LinkageDimension> dimensions;
    std::vector<LinkageNumber> numbers;
    linkage::Structure structure;
    std::vector<LinkageDrive> drives;
    std::vector<LinkageSignal> signals;
    std::array<LinkageAnchor, 4> placement{};     ///< origin-x, origin-y, tilt, scale; file's units
    bool scaled = false;                          ///< the file says a scale
    std::optional<Vector<double>> crank_range{};  ///< radians, or displacements
    std::optional<double> at;  ///< a crank angle of its motion, radians; a displacement where a slide is driven
    std::vector<GuidedPoint> guided{};             ///< by paths, by poses, by lines, by arcs
    std::vector<LinkageInputTarget> over_input{};  ///< functions, lines, arcs
    std::vector<LinkageRoom> rooms{};              ///< in radians
    std::vector<LinkageRegion> regions{};          ///< the same
    linkage::Mobility mobility;
    linkage::Order order;
    std::vector<std::int8_t> sides;  ///< for each choice of the order 1, -1, or 0 for either
    std::optional<LinkageSketch> sketch{};
    std::optional<double> motion_at{};         ///< of [motion], as `at`
    std::vector<std::optional<int>> larger;    ///< which assembly of each larger group, from 1; 0 for either
    std::vector<LargerAssembly> assembled{};   ///< those that it can be in, with its usual dimensions
    std::vector<std::size_t> larger_counts{};  ///< how many each larger group was found to have at that input
    std::string unassembled{};                 ///< why none is settled, where it has larger groups and none is
    std::vector<std::size_t> redundant;        ///< links that are left out of order: the others place what they join
    std::vector<std::size_t> kept_by_redundant{};  ///< inner pins of dyads whose side these decide

    /// Whether every dimension is a number.
    bool given() const;
};

/// Numbers of the structure for dimensions in the file's units (those that are tied are left unread), angles in
/// radians.
std::vector<double> numbers_of(const Linkage& linkage, const std::vector<double>& dimensions);

/// Whether a link is left out of the order: its side follows from the others.
bool is_redundant(const Linkage& linkage, std::size_t link);

/// The dimensions of a linkage where they are given; of a range its start, else its middle.
std::vector<double> usual_dimensions(const Linkage& linkage);

inline constexpr std::array<std::string_view, 5> ready_made_quantities{
    "transmission-angle-worst", "total-length", "link-ratio", "full-turn-margin", "joint-distance-least"};

/// What the name of a quantity means, its signals aside, which it names by their index among all; else `fault` says
/// what is wrong with it, and what would be right.
std::optional<LinkageMeasure> to_linkage_quantity(const Linkage& linkage, std::string_view name, std::string& fault);

struct ReadLinkage {
    Linkage linkage;                ///< complete only if ok()
    std::vector<Message> messages;  ///< errors and warnings in the order of their places
    bool unreadable = false;

    bool ok() const;
};

/// Reads a file, or a text, that names the mechanism "linkage".
ReadLinkage read_linkage(const std::string& file);
ReadLinkage parse_linkage(std::string_view text, const std::string& file);

}  // namespace mechwright

namespace mechwright::reading {

/// What of a linkage has been read without an error, so that what builds on it can be read, too: errors of other
/// sections do not hide what is wrong there.
struct LinkageParts {
    bool structure = false;  ///< links and joints, which move as their drives say, and where they are
    bool motion = false;     ///< over which inputs they do
    bool signals = false;    ///< with rooms and regions: what can be asked for
    bool targets = false;    ///< points and signals that targets name
};

/// The same from a table.
LinkageParts read_linkage_table(const toml::table& table, Linkage& made, Messages& messages);

}  // namespace mechwright::reading
