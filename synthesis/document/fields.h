#pragma once
/// \file
/// The members of a result document: one list for who writes it, who reads it and the schema that is published
/// (`mechwright schema result`). Angles are in the document's unit. A number that is not finite is never written: its
/// member is left out.

#include <array>
#include <cstddef>
#include <string_view>

#include "synthesis/mechanism/cam/document/fields.h"
#include "synthesis/problem/schema/key.h"
#include "synthesis/problem/schema/keys.h"

namespace mechwright::fields {

template <std::size_t N>
using Words = std::array<std::string_view, N>;

/// Two lists as one.
template <std::size_t A, std::size_t B>
constexpr std::array<Key, A + B> joined(const std::array<Key, A>& first, const std::array<Key, B>& second) {
    std::array<Key, A + B> all{};
    for (std::size_t i = 0; i < A + B; ++i)
        all[i] = i < A ? first[i] : second[i - A];
    return all;
}

inline constexpr Words<5> statuses{"solved", "infeasible", "limit", "unverified", "interrupted"};
inline constexpr Words<4> sides{"left", "right", "ahead", "behind"};
inline constexpr Words<2> senses{"maximize", "minimize"};
inline constexpr Words<2> reductions{"sum", "max"};
inline constexpr Words<8> certificates{"half-planes", "curvature", "limit", "bound",
                                       "count",       "zero",      "given", "ranges"};
/// The names of WeightedHalfPlane::Origin, in its order.
inline constexpr Words<4> half_planes{"pressure angle", "height", "least offset", "greatest offset"};

inline constexpr std::array problem{
    Key{"file", Shape::text, "As it was given.", true}, Key{"sha256", Shape::text, "Of the file's bytes.", true},
    Key{"text", Shape::text, "The file's bytes, unless it names other files."},
    Key{"title", Shape::text, "The problem's title.", true}, Key{"mechanism", Shape::name, "What is designed.", true}};

inline constexpr std::array libraries{Key{"ipopt", Shape::text, "Version of Ipopt.", true},
                                      Key{"nlopt", Shape::text, "Version of NLopt.", true},
                                      Key{"eigen", Shape::text, "Version of Eigen.", true}};

inline constexpr std::array program{
    Key{"version", Shape::text, "Version of mechwright.", true},
    Key{"libraries", Shape::table, "Versions of what it is made with.", true, {}, libraries}};

inline constexpr std::array units{Key{"angle", Shape::word, "Unit of angles.", true, keys::angle_units},
                                  Key{"length", Shape::text, "Name of the unit of lengths.", true},
                                  Key{"force", Shape::word, "Unit of forces.", false, keys::force_units},
                                  Key{"mass", Shape::word, "Unit of masses.", false, keys::mass_units}};

inline constexpr std::array range{
    Key{"min", Shape::number, "Least value.", true}, Key{"max", Shape::number, "Greatest value.", true},
    Key{"step", Shape::number, "It is the least value or whole steps more.", false, {}, {}, positive}};
inline constexpr std::array choices{Key{"choices", Shape::numbers, "The values that it may have.", true}};
inline constexpr std::array range_of_use{
    Key{"from", Shape::word, "Where it begins.", true, keys::use_begins},
    Key{"to", Shape::word, "Where it ends.", true, keys::use_ends},
    Key{"before", Shape::number, "Crank angle by which it begins before that.", true},
    Key{"after", Shape::number, "Crank angle by which it ends after that.", true}};
inline constexpr std::array tie{Key{"of", Shape::text, "The dimension that it follows.", true},
                                Key{"times", Shape::number, "How many times that.", true}};

inline constexpr std::array side{Key{"side", Shape::word, "On which it is closed.", true, sides},
                                 Key{"from", Shape::text, "Pin that the side counts from."},
                                 Key{"to", Shape::text, "Pin that it counts to."}};

/// As the file of a linkage has them.
inline constexpr std::array linkage{Key{"units", Shape::value, "Units of angles and lengths."},
                                    Key{"dimensions", Shape::value, "Dimensions: numbers, ranges, and sums of others."},
                                    Key{"links", Shape::value, "Points of each link, by their places on it."},
                                    Key{"slide", Shape::value, "Links that slide."},
                                    Key{"slot", Shape::value, "Pins in slots."},
                                    Key{"gear", Shape::value, "Pairs of gears."},
                                    Key{"belt", Shape::value, "Belts."},
                                    Key{"rack", Shape::value, "Racks."},
                                    Key{"drive", Shape::value, "What is driven."},
                                    Key{"assembly", Shape::value, "Sides of dyads that were asked for."},
                                    Key{"sketch", Shape::value, "Where points are about."},
                                    Key{"placement", Shape::value, "Where the frame is in the drawing."},
                                    Key{"motion", Shape::value, "An input that belongs to the motion."},
                                    Key{"signals", Shape::value, "What is measured along the motion."},
                                    Key{"room", Shape::value, "Boxes that parts need."},
                                    Key{"region", Shape::value, "Where parts keep in, or out of."},
                                    Key{"path", Shape::value, "What points are guided along paths."},
                                    Key{"poses", Shape::value, "What bodies are guided through poses."},
                                    Key{"function", Shape::value, "The signal that is a function of the input."},
                                    Key{"line", Shape::value, "The point that follows a line."},
                                    Key{"arc", Shape::value, "The point that follows an arc."}};

/// Beside the dimensions by name.
inline constexpr std::array design{
    Key{"assembly", Shape::value, "How the links are put together: a word, or of a linkage the side of each dyad."},
    Key{"rotation", Shape::word, "Sense of rotation of a cam.", false, cam_rotation_names},
    Key{"laws", Shape::texts, "Law of motion of each segment of a cam, empty where it has none."},
    Key{"kind", Shape::text, "What kind of linkage the dimensions make.", true}};

inline constexpr std::array term{
    Key{"quantity", Shape::text, "What is optimised.", true}, Key{"sense", Shape::word, "Which way.", true, senses},
    Key{"weight", Shape::number, "Weight in the sum."}, Key{"value", Shape::number, "What the design has."}};

inline constexpr std::array objective{
    Key{"quantity", Shape::text, "What is optimised, where it is one."},
    Key{"sense", Shape::word, "Which way.", false, senses},
    Key{"terms", Shape::tables, "What is optimised, where it is several.", false, {}, term},
    Key{"reduce", Shape::word, "Whether the weighted sum of several counts or the worst.", false, reductions},
    Key{"value", Shape::number, "What the design has."}};

inline constexpr std::array wish{
    Key{"quantity", Shape::text, "What is optimised before the objective.", true},
    Key{"sense", Shape::word, "Which way.", true, senses},
    Key{"within", Shape::number, "By how much it may be worse than its best.", true},
    Key{"best", Shape::number, "The best that was found."},
    Key{"limit", Shape::number, "The worst that was allowed for the sake of what comes after."},
    Key{"value", Shape::number, "What the design has."}};

inline constexpr std::array requirement{
    Key{"quantity", Shape::text, "What is limited.", true},
    Key{"value", Shape::number, "What the design has."},
    Key{"equal", Shape::number, "The value that it has to have."},
    Key{"min", Shape::number, "Its least value."},
    Key{"max", Shape::number, "Its greatest value."},
    Key{"violation", Shape::number, "By how much it is missed, relative; 0 where it is met."},
    Key{"active", Shape::flag, "Whether the design stands at the limit."}};

inline constexpr std::array path{
    Key{"points", Shape::pairs, "Points that shall be passed.", true},
    Key{"timing", Shape::word, "Whether the crank angles are prescribed.", true, keys::path_timings},
    Key{"closed", Shape::flag, "Whether the crank has to turn fully.", true},
    Key{"weights", Shape::numbers, "Weight of each point."},
    Key{"prescribed_angles", Shape::numbers, "Crank angle at each point, or displacement, counted from crank-start."},
    Key{"reached", Shape::pairs, "Where the design's point stands for each of them."},
    Key{"crank_angles", Shape::open_numbers, "Crank angle there, or displacement."},
    Key{"distances", Shape::numbers, "Distance from each point."},
    Key{"name", Shape::text, "Of one of several paths and poses: what its quantities are called by."},
    Key{"weight",
        Shape::number,
        "Of one of several: weight of its mean square in that of all.",
        false,
        {},
        {},
        positive}};

inline constexpr std::array poses = joined(
    path, std::array{Key{"directions", Shape::open_numbers, "The angle at each, null where any will do.", true},
                     Key{"body_length", Shape::number, "Length by which angles are weighed against distances.", true},
                     Key{"reached_directions", Shape::open_numbers, "The angle of the body for each of them."}});

inline constexpr std::array error{Key{"x", Shape::number, "Where it is."},
                                  Key{"error", Shape::number, "The error there."}};

/// Of one of several.
inline constexpr std::array name_and_weight{
    Key{"name", Shape::text, "Of one of several functions, lines and arcs: what its quantities are called by."},
    Key{"weight",
        Shape::number,
        "Of one of several: weight of its mean square in that of all.",
        false,
        {},
        {},
        positive}};

inline constexpr std::array function = joined(
    std::array{Key{"expression", Shape::text, "The function of x."}, Key{"x", Shape::ends, "Range of x."},
               Key{"samples", Shape::pairs, "[x, y], in place of an expression."},
               Key{"accuracy_points", Shape::numbers, "Where an exact method meets it."},
               Key{"extremes", Shape::tables, "Where the error is extreme.", false, {}, error},
               Key{"alternating", Shape::whole_number, "Extremes as great as the greatest, with alternating signs."},
               Key{"free", Shape::whole_number, "Dimensions that were free to make the error small."}},
    name_and_weight);

inline constexpr std::array distance{Key{"crank_angle", Shape::number, "Where it is."},
                                     Key{"distance", Shape::number, "The distance there."}};

inline constexpr std::array followed = joined(
    std::array{Key{"full_turn", Shape::flag, "Whether the crank has to turn fully.", true},
               Key{"extremes", Shape::tables, "Where the distance is extreme.", false, {}, distance},
               Key{"alternating", Shape::whole_number, "Extremes as great as the greatest, with alternating signs."},
               Key{"free", Shape::whole_number, "Dimensions that were free to make the distance small."}},
    name_and_weight);

inline constexpr std::array dwell_extreme{
    Key{"input", Shape::number, "Crank angle, or displacement of the slide that drives, where it is.", true},
    Key{"value", Shape::number, "The signal there.", true},
    Key{"off", Shape::number, "By how much it is more than the middle value there.", true}};

inline constexpr std::array dwell{
    Key{"quantity", Shape::text, "The deviation that is to be least.", true},
    Key{"middle", Shape::number, "Halfway between the least and the greatest value of the signal.", true},
    Key{"extremes", Shape::tables, "Where the signal is extreme.", true, {}, dwell_extreme},
    Key{"alternating", Shape::whole_number,
        "Extremes as far from the middle as the farthest, on alternating sides of it.", true},
    Key{"free", Shape::whole_number, "Numbers that were free to make it still: dimensions left open, and the middle.",
        true},
    Key{"held", Shape::whole_number,
        "Limits at which the design stands: requirements, and ends of the ranges of dimensions.", true},
    Key{"balanced", Shape::flag, "Extremes and limits balance: to first order no design near is as still.", true}};

inline constexpr std::array warning{
    Key{"name", Shape::text, "Why the mechanism is close to a singular position.", true},
    Key{"margin", Shape::number, "By how much, a length."},
    Key{"relative", Shape::number, "The same over the longest length."},
    Key{"impossible", Shape::flag, "Whether there is no such mechanism at all."},
    Key{"warned_below", Shape::number, "Relative margins below this are warned of.", true}};

inline constexpr std::array check{Key{"name", Shape::text, "What was checked.", true},
                                  Key{"passed", Shape::flag, "Whether it holds.", true},
                                  Key{"detail", Shape::text, "What was found, with numbers.", true}};

inline constexpr std::array verification{Key{"passed", Shape::flag, "Whether every check holds.", true},
                                         Key{"checks", Shape::tables, "What was checked.", true, {}, check}};

inline constexpr std::array alternative{
    Key{"design", Shape::names, "Dimensions and what kind of mechanism they make.", true},
    Key{"objective", Shape::number, "Value of the objective."},
    Key{"path_angles", Shape::numbers, "Crank angle, or displacement, at each point of the path."},
    Key{"distances", Shape::numbers, "Distance from each point of the path."},
    Key{"cognate_of", Shape::whole_number,
        "Draws the same curve as the result's design (0) or the alternative of this number."},
    Key{"verification", Shape::table, "What was checked of it.", false, {}, verification},
    Key{"defect", Shape::text, "Why it is no use as a mechanism."}};

inline constexpr std::array solutions{
    Key{"tracked", Shape::whole_number, "Paths to solutions that were followed, over the complex numbers.", true},
    Key{"distinct", Shape::whole_number, "Regular solutions.", true},
    Key{"at_infinity", Shape::whole_number, "Paths that ended at infinity.", true},
    Key{"singular", Shape::whole_number, "Paths that ended at singular solutions.", true},
    Key{"real", Shape::whole_number, "Real ones of the distinct solutions.", true},
    Key{"certified", Shape::whole_number, "Real ones that are proven to exist, each alone in a small ball.", true},
    Key{"defect_free", Shape::whole_number, "Designs that passed verification.", true}};

/// A place on a cam's motion.
inline constexpr std::array half_plane{
    Key{"of", Shape::word, "What the half-plane follows from.", true, half_planes},
    Key{"segment", Shape::whole_number, "Of the motion, from 1."},
    Key{"piece", Shape::whole_number, "Of the segment."},
    Key{"at", Shape::number, "Part of the segment."},
    Key{"limit", Shape::number, "On the pressure angle."},
    Key{"side", Shape::whole_number, "1: the pressure angle is at most the limit, -1: at least its negative."},
    Key{"weight", Shape::number, "Multiplier.", true}};

inline constexpr std::array certificate_part{
    Key{"assembly", Shape::whole_number, "Which sense of rotation and which laws.", true},
    Key{"half_planes", Shape::tables, "That the cam's centre has to lie in.", false, {}, half_plane},
    Key{"segment", Shape::whole_number, "Of the motion, from 1."}, Key{"piece", Shape::whole_number, "Of the segment."},
    Key{"at", Shape::number, "Part of the segment."}};

inline constexpr std::array certificate{
    Key{"kind", Shape::word, "What kind of proof it is.", true, certificates},
    Key{"dimension", Shape::text, "Whose least value is bounded."},
    Key{"parts", Shape::tables, "A proof for each assembly.", false, {}, certificate_part},
    Key{"limit", Shape::text, "Name of the limit in closed form."},
    Key{"quantity", Shape::text, "What is limited."},
    Key{"value", Shape::number, "The limit."}};

inline constexpr std::array discrete{
    Key{"problems", Shape::whole_number, "How many were solved with ranges in place of allowed values.", true},
    Key{"continuous", Shape::number, "The objective that the ranges allow where any value of them may be taken."},
    Key{"gap", Shape::number, "By how much values that were not looked at may be better, as far as was found."},
    Key{"combinations", Shape::whole_number, "Combinations of allowed values, where each of them was looked at."},
    Key{"left_out", Shape::whole_number,
        "Parts of the allowed values in which a search found no design and nothing proves that there is none."}};

inline constexpr std::array start_sources{
    Key{"preferred", Shape::whole_number, "At the preferred values."},
    Key{"drawn", Shape::whole_number, "At candidates drawn in the ranges."},
    Key{"four_bars", Shape::whole_number,
        "At candidates drawn about four-bars among the links of a linkage that follow the path by themselves."},
    Key{"nearby", Shape::whole_number, "Near the ends of other searches."}};

inline constexpr std::array search{
    Key{"method", Shape::text, "How the design was found.", true},
    Key{"complete", Shape::flag, "Whether the answer is proven.", true},
    Key{"argument", Shape::text, "The proof in words."},
    Key{"certificate", Shape::table, "What verification checks the proof by.", false, {}, certificate},
    Key{"drawn", Shape::whole_number, "Candidates for starts of local searches."},
    Key{"assembled", Shape::whole_number,
        "Of the candidates: those that close where they have to; they were screened."},
    Key{"optimised", Shape::whole_number, "Of these: those at which local searches began, most of them cut short."},
    Key{"sources", Shape::table, "Where local searches began.", false, {}, start_sources},
    Key{"starts", Shape::whole_number, "Local searches.", true},
    Key{"local_optima", Shape::whole_number, "Distinct feasible local optima that were found.", true},
    Key{"hits", Shape::whole_number, "Starts that ended at the best one.", true},
    Key{"missed_chance", Shape::number, "Estimated chance that a better local optimum was not seen."},
    Key{"bound", Shape::number, "No design has a better objective than this."},
    Key{"boxes", Shape::whole_number, "Boxes that were examined for the bound."},
    Key{"solutions", Shape::table, "What became of all solutions of an exact problem.", false, {}, solutions},
    Key{"free_numbers", Shape::whole_number,
        "Of a family of designs that meet the targets exactly: how many numbers can be chosen; the most compact is "
        "shown."},
    Key{"discrete", Shape::table, "Branch and bound over allowed values.", false, {}, discrete},
    Key{"evaluations", Shape::whole_number, "Of the functions of the nonlinear program.", true},
    Key{"seed", Shape::whole_number, "What the starts were drawn from.", true},
    Key{"seconds", Shape::number, "What the run took."}};

/// What is said of one design.
inline constexpr std::array finding{
    Key{"design", Shape::names, "Dimensions and what kind of mechanism they make."},
    Key{"circuit", Shape::whole_number, "Of a linkage the circuit that it moves on, from 1."},
    Key{"branch", Shape::whole_number, "Of a linkage the branch of that circuit, from 1."},
    Key{"used_crank_angles", Shape::ends, "Least and greatest crank angle of the range of use."},
    Key{"objective", Shape::table, "What is optimised.", false, {}, objective},
    Key{"wishes", Shape::tables, "What came before the objective, in order.", false, {}, wish},
    Key{"requirements", Shape::tables, "What the design has to meet.", false, {}, requirement},
    Key{"quantities", Shape::names, "Value of every quantity that is defined for the design."},
    Key{"path", Shape::table, "The path that is followed.", false, {}, path},
    Key{"poses", Shape::table, "The poses that are passed.", false, {}, poses},
    Key{"function", Shape::table, "The function that is generated.", false, {}, function},
    Key{"line", Shape::table, "The line that is followed.", false, {}, followed},
    Key{"arc", Shape::table, "The arc that is followed.", false, {}, followed},
    Key{"dwells", Shape::tables, "Signals that are to be as still as can be.", false, {}, dwell},
    Key{"warnings", Shape::tables, "Margins of a design close to a singular position.", false, {}, warning},
    Key{"verification",
        Shape::table,
        "What was checked of it, independently of the optimiser.",
        false,
        {},
        verification}};

inline constexpr std::array of_run{
    Key{"schema", Shape::whole_number, "Version of the format: 1.", true, {}, {}, keys::first_schema},
    Key{"problem", Shape::table, "Which problem it answers.", true, {}, problem},
    Key{"program", Shape::table, "What it was made by.", true, {}, program},
    Key{"units", Shape::table, "Units of its numbers.", true, {}, units},
    Key{"status", Shape::word, "How the run ended.", false, statuses},
    Key{"note", Shape::text, "One sentence for the user where the status needs one."},
    Key{"tolerance", Shape::number, "Relative, on every requirement.", true, {}, {}, positive},
    Key{"dimensions", Shape::names,
        "What was given: a number, a range, choices, a multiple of another dimension, or a sum of such.", true},
    Key{"cam", Shape::table, "What was given of a cam.", false, {}, cam},
    Key{"linkage", Shape::value, "Of a linkage the sections that describe it, as its problem file has them."},
    Key{"signals", Shape::value, "Of a built-in kind what is measured along the motion, as its problem file has it."},
    Key{"room",
        Shape::tables,
        "Of a built-in kind boxes that parts need, as its problem file has them.",
        false,
        {},
        keys::room},
    Key{"region",
        Shape::tables,
        "Of a built-in kind where parts keep in, or out of, as its problem file has them.",
        false,
        {},
        keys::region},
    Key{"crank_range", Shape::ends, "Crank angles that the file limits the motion to."},
    Key{"range_of_use",
        Shape::table,
        "The stretch of the crank that designs are judged over.",
        false,
        {},
        range_of_use},
    Key{"settings", Shape::names, "How the mechanism is judged."},
    Key{"instant", Shape::flag, "Whether velocities at one crank angle are asked for."},
    Key{"front", Shape::value, "Designs none of which is as good as another in both objectives."},
    Key{"alternatives",
        Shape::tables,
        "Other local optima that passed verification, best first; then those that did not.",
        false,
        {},
        alternative},
    Key{"search", Shape::table, "What was done.", false, {}, search}};

/// All members, at the top of a document.
inline constexpr std::array document = joined(of_run, finding);

}  // namespace mechwright::fields

/// The names of members, as far as the lists have them.
namespace mechwright::names {

inline constexpr NamesOf<fields::alternative> of_alternative;
inline constexpr NamesOf<fields::cam> of_cam;
inline constexpr NamesOf<fields::certificate> of_certificate;
inline constexpr NamesOf<fields::choices> of_choices;
inline constexpr NamesOf<fields::check> of_check;
inline constexpr NamesOf<fields::design> of_design;
inline constexpr NamesOf<fields::discrete> of_discrete;
inline constexpr NamesOf<fields::distance> of_distance;
inline constexpr NamesOf<fields::document> of_document;
inline constexpr NamesOf<fields::dwell> of_dwell;
inline constexpr NamesOf<fields::dwell_extreme> of_dwell_extreme;
inline constexpr NamesOf<fields::error> of_error;
inline constexpr NamesOf<fields::finding> of_finding;
inline constexpr NamesOf<fields::followed> of_followed;
inline constexpr NamesOf<fields::function> of_function;
inline constexpr NamesOf<fields::half_plane> of_half_plane;
inline constexpr NamesOf<fields::libraries> of_libraries;
inline constexpr NamesOf<fields::objective> of_objective;
inline constexpr NamesOf<fields::certificate_part> of_part;
inline constexpr NamesOf<fields::path> of_path;
inline constexpr NamesOf<fields::poses> of_poses;
inline constexpr NamesOf<fields::problem> of_problem;
inline constexpr NamesOf<fields::program> of_program;
inline constexpr NamesOf<fields::range> of_range;
inline constexpr NamesOf<fields::requirement> of_requirement;
inline constexpr NamesOf<fields::search> of_search;
inline constexpr NamesOf<fields::segment> of_segment;
inline constexpr NamesOf<fields::solutions> of_solutions;
inline constexpr NamesOf<fields::start_sources> of_start_sources;
inline constexpr NamesOf<fields::term> of_term;
inline constexpr NamesOf<fields::tie> of_tie;
inline constexpr NamesOf<fields::range_of_use> of_use;
inline constexpr NamesOf<fields::units> of_units;
inline constexpr NamesOf<fields::verification> of_verification;
inline constexpr NamesOf<fields::warning> of_warning;
inline constexpr NamesOf<fields::wish> of_wish;

}  // namespace mechwright::names
