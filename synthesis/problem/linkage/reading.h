#pragma once
/// \file
/// What the readers of a linkage's sections share: what is made so far, and where names stand in the file.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/problem/linkage/linkage.h"
#include "synthesis/problem/toml/in_order.h"
#include "synthesis/problem/toml/section.h"

namespace mechwright::reading {

struct LinkageReading {
    Section& file;
    Linkage& made;
    Messages& messages;
    std::vector<FilePlace> dimension_places{};
    std::vector<Affine> expanded{};       ///< each dimension as a sum of those that are not tied
    std::vector<Affine> ties{};           ///< each tied dimension as the file says it
    std::vector<FilePlace> uses{};        ///< where a dimension's measure was found out
    std::vector<FilePlace> pin_places{};  ///< where a point is first named
    std::vector<FilePlace> link_places{};
    std::vector<FilePlace> drive_places{};
    std::vector<FilePlace> signal_places{};
    std::vector<FilePlace> larger_places{};  ///< where the assemblies of larger groups are said

    /// Limits on what one file describes, far above any mechanism: hostile files end at once.
    static constexpr std::size_t most_links = 100, most_points = 400, most_joints = 100, most_corners = 32;
};

/// Whether a name is one; reports it where it is not.
bool is_name(LinkageReading& reading, std::string_view name, FilePlace place, std::string_view what);

/// Names that differ by case only.
void report_case_twins(LinkageReading& reading, const std::vector<std::string>& names,
                       const std::vector<FilePlace>& places, std::string_view what);

/// A number or an expression; absent if it is neither, which is reported.
std::optional<LinkageNumber> to_linkage_number(LinkageReading& reading, const toml::node& node, std::string_view what,
                                               Measure measure);

/// The same as a number of the structure.
linkage::Number add_number(LinkageReading& reading, LinkageNumber number);
linkage::Number add_constant(LinkageReading& reading, double value, Measure measure);
/// That of a key, or a constant where it has none.
linkage::Number read_structure_number(LinkageReading& reading, Section& section, std::string_view key, Measure measure,
                                      double preset = 0);

/// [x, y] or { length, angle }.
std::optional<linkage::Coordinates> to_coordinates(LinkageReading& reading, const toml::node& node,
                                                   std::string_view what);

/// A link or a point by its name; reports one that there is not.
std::optional<std::size_t> find_link(LinkageReading& reading, std::string_view name, FilePlace place,
                                     std::string_view what);
std::optional<std::size_t> find_pin(LinkageReading& reading, std::string_view name, FilePlace place,
                                    std::string_view what);
std::optional<std::size_t> read_link(LinkageReading& reading, Section& section, std::string_view key, bool required);
/// A slide by its name or its number from 1.
std::optional<std::size_t> find_slide(LinkageReading& reading, const toml::node& node, std::string_view what);

/// Records what a dimension counts, or reports that it counts something else elsewhere.
void use(LinkageReading& reading, std::size_t dimension, Measure measure, FilePlace place);

/// The tables of a list, [[name]], each with its number as a section.
std::vector<Section> sections_in(LinkageReading& reading, std::string_view name, std::span<const Key> keys);

/// Displacements, or turns of a drive, between which a joint stays: of given ones the least is not above the greatest.
linkage::Stops read_stops(LinkageReading& reading, Section& section, Measure measure);

void read_linkage_dimensions(LinkageReading& reading);
/// { min, max } or { choices }; false where it cannot be read, which is reported.
bool read_linkage_range(LinkageReading& reading, const toml::table& table, LinkageDimension& dimension);
/// After every other section: measures of tied dimensions and, where all sections that can name some could be read,
/// dimensions that nothing uses.
void conclude_dimensions(LinkageReading& reading, bool all_named);
void read_links(LinkageReading& reading);
void read_slides(LinkageReading& reading);
void read_slots(LinkageReading& reading);
void read_gears(LinkageReading& reading);
void read_racks(LinkageReading& reading);
void read_drives(LinkageReading& reading);
/// The segments of a drive's motion, into `made`.
void read_drive_motion(LinkageReading& reading, const Section& drive, const toml::node& node, bool of_slide,
                       LinkageDrive& made);
void read_linkage_motion(LinkageReading& reading);
void read_sketch(LinkageReading& reading);
void read_placement(LinkageReading& reading);
/// Whether a word is a quantity or a number already, so that no signal and no target can have it as its name.
bool is_reserved_name(std::string_view name);
/// Rooms and regions; after links and joints.
void read_rooms(LinkageReading& reading);
/// Whether one of them has this name.
bool is_name_of_room(const Linkage& linkage, std::string_view name);
/// The section of signals, after rooms and regions: those of the file follow what there are already, as a built-in kind
/// has some as a linkage.
void read_signal_section(LinkageReading& reading);
/// The quantities that are required or optimised.
void read_asked(LinkageReading& reading);
/// The points that targets name.
void read_linkage_targets(LinkageReading& reading);
/// Mobility, order and, where all dimensions are given, whether it closes: only of a structure without errors.
void settle(LinkageReading& reading);
/// The sides of dyads, and which assemblies larger groups are in; after `settle`.
void read_assembly(LinkageReading& reading);
/// { group, index } or "either" of the larger group that a key names. Returns whether it names one.
bool read_larger_assembly(LinkageReading& reading, std::string_view key, const toml::node& node);
/// Finds the assemblies of larger groups; after `read_assembly`.
void assemble_larger(LinkageReading& reading);

}  // namespace mechwright::reading
