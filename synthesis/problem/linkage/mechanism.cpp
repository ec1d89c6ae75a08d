#include "synthesis/problem/linkage/mechanism.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "analysis/linkage/motion/travel.h"
#include "synthesis/mechanism/linkage/branches.h"
#include "synthesis/mechanism/linkage/mechanism.h"
#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/linkage/larger_groups.h"
#include "synthesis/problem/linkage/model.h"
#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/linkage/sides.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/toml/made_table.h"
#include "synthesis/problem/units.h"
#include "synthesis/target/with_targets.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

constexpr double fastest_link = 1e4;  ///< turns of a link for one of the drive: it is followed in small steps

/// A dyad as [assembly] names it.
const std::string& key_of(const Linkage& linkage, const linkage::Group& group) {
    const bool named = group.by_slide && group.joint < linkage.slides.size() && !linkage.slides[group.joint].empty();
    return named ? linkage.slides[group.joint] : linkage.pins[group.pin];
}

struct Assemblies {
    std::vector<std::vector<std::int8_t>> sides{};
    std::vector<std::string> names{};
    std::vector<std::string> documents{};
    std::vector<linkage::Assembled> starts{};  ///< of larger groups
};

/// `larger` is null where there are no larger groups.
void add_assembly(const Linkage& linkage, const std::vector<std::int8_t>& sides, const LargerAssembly* larger,
                  Assemblies& all) {
    std::string name;
    Json document = Json::object();
    for (const linkage::Group& group : linkage.order.groups) {
        if (group.choice == linkage::none || is_redundant(linkage, group.links[0])) continue;
        const std::string& key = key_of(linkage, group);
        const int side = sides[group.choice];
        name += fmt::format("{}{} {}", name.empty() ? "" : ", ", key, word_of(group, side));
        document[key] = side_document(linkage, group, side);
    }
    for (std::size_t i = 0; larger != nullptr && i < larger->indices.size(); ++i) {
        const std::string key = name_of_larger(linkage, i);
        name += fmt::format("{}{} {}", name.empty() ? "" : ", ", key, larger->indices[i]);
        document[key] = larger_document(linkage, i, larger->indices[i]);
    }
    all.sides.push_back(sides);
    if (larger != nullptr) all.starts.push_back(larger->assembled);
    if (name.empty()) return;
    all.names.push_back(std::move(name));
    all.documents.push_back(document.dump());
}

Assemblies assemblies_of(const Linkage& linkage) {
    Assemblies all;
    for (const LargerAssembly& one : linkage.assembled)
        add_assembly(linkage, one.sides, &one, all);
    if (linkage.order.closed())
        for_each_assembly(linkage.sides, most_open_sides,
                          [&](const std::vector<std::int8_t>& sides) { add_assembly(linkage, sides, nullptr, all); });
    return all;
}

std::vector<double> usual(std::span<const DimensionRange> ranges) {
    std::vector<double> dimensions;
    for (const DimensionRange& range : ranges)
        dimensions.push_back(range.start.value_or(range.min + (range.max - range.min) / 2));
    return dimensions;
}

/// How many times as fast as the drive the fastest link turns, as far as drives and gears say it.
double greatest_turn(const LinkageModel& model, std::span<const double> dimensions) {
    double greatest = 0;
    for (const double turns :
         linkage::detail::turns_of_links(driven(model, dimensions, 0), model.structure).value_or(std::vector<double>{}))
        greatest = std::max(greatest, std::isfinite(turns) ? std::abs(turns) : std::numeric_limits<double>::max());
    return greatest;
}

/// Whether all links have the same directions.
bool faces_alike(const linkage::Pose<double>& a, const linkage::Pose<double>& b) {
    constexpr double within = 1e-9;
    for (std::size_t i = 0; i < a.links.size(); ++i)
        if (!(std::hypot(a.links[i].along.x - b.links[i].along.x, a.links[i].along.y - b.links[i].along.y) <= within))
            return false;
    return true;
}

/// After how many turns of the drive it closes, by the usual dimensions; 0 where it never does.
int turns_of_cycle(LinkageModel model, std::span<const double> dimensions) {
    if (greatest_turn(model, dimensions) > fastest_link) return 0;
    const int turns = linkage::turns_of_cycle(model.structure, driven(model, dimensions, 0)).value_or(0);
    if (model.order.closed() || model.driven_by_slide()) return turns;
    // A larger group may be in another assembly after a turn, and links geared to it elsewhere.
    for (model.turns = turns; model.turns > 0 && model.turns <= linkage::most_turns; model.turns += turns) {
        model.identity = std::make_shared<const char>();
        linkage::Driven<double> moving = driven(model, dimensions, 0);
        const auto goes_round = [](const auto& group) { return group.way && group.way->whole; };
        const bool limited = std::any_of(moving.groups.begin(), moving.groups.end(), [](const auto& group) {
            return !group.way || group.way->to() - group.way->from() < group.way->period;
        });
        if (limited) return turns;
        if (!std::all_of(moving.groups.begin(), moving.groups.end(), goes_round)) continue;
        const double start = model.starts[0].input;
        if (!moving.place(start)) return turns;
        const linkage::Pose<double> before = moving.pose;
        if (moving.place(start + 2 * std::numbers::pi * model.turns) && faces_alike(before, moving.pose))
            return model.turns;
    }
    return 0;
}

/// How far the stops of a master that turns are apart, for the usual dimensions; 0 where it has none.
double stops_apart(const Linkage& linkage) {
    const linkage::Drive& master = linkage.structure.drives.front();
    if (master.of_slide || !master.stops.min || !master.stops.max) return 0;
    const std::vector<double> numbers = numbers_of(linkage, usual_dimensions(linkage));
    return numbers[*master.stops.max] - numbers[*master.stops.min];
}

/// Whether something is asked over an input range, and something else beside it.
bool covers_several(const Linkage& linkage) {
    const bool has_path = std::any_of(linkage.guided.begin(), linkage.guided.end(),
                                      [](const GuidedPoint& guided) { return !guided.follows; });
    return linkage.over_input.size() + (has_path ? 1 : 0) > 1 && !linkage.over_input.empty();
}

/// The least or the greatest value of a sum over ranges of its dimensions.
double end_of(const Affine& sum, std::span<const DimensionRange> ranges, bool greatest) {
    double end = sum.constant;
    for (const auto& [dimension, factor] : sum.terms) {
        const DimensionRange& range = ranges[dimension];
        end += factor * ((factor > 0) == greatest ? range.max : range.min);
    }
    return end;
}

/// Between which displacements the slide that drives can be in any design: its stops where it has such, else the ends
/// of the motion that the file gives, else as far as all lengths in a row reach.
std::array<double, 2> reach_of_slide(const Linkage& linkage, const LinkageModel& model) {
    const std::vector<DimensionRange> ranges = ranges_of(linkage);
    double all = 0;
    for (std::size_t i = 0; i < model.numbers.size(); ++i)
        if (model.lengths[i])
            all += std::max(std::abs(end_of(model.numbers[i], ranges, false)),
                            std::abs(end_of(model.numbers[i], ranges, true)));
    std::array<double, 2> reach{-all, all};
    if (linkage.crank_range) reach = {linkage.crank_range->x, linkage.crank_range->y};
    const linkage::Stops& stops = model.structure.drives.front().stops;
    if (stops.min) reach[0] = end_of(model.numbers[*stops.min], ranges, false);
    if (stops.max) reach[1] = end_of(model.numbers[*stops.max], ranges, true);
    return {reach[0], std::max(reach[0], reach[1])};
}

bool has_targets(const Linkage& linkage) { return !linkage.guided.empty() || !linkage.over_input.empty(); }

}  // namespace

std::string why_no_mechanism(const Linkage& linkage) {
    if (!linkage.unassembled.empty()) return linkage.unassembled;
    for (const LinkageSignal& signal : linkage.signals)
        if (signal.value.kind == linkage::Signal::Kind::transmission_angle &&
            margin_at(linkage, signal.value.of) == linkage::none)
            return fmt::format("the signal '{}' is the transmission angle of a dyad, and none is closed at '{}'",
                               signal.name, linkage.pins[signal.value.of]);
    if (stops_apart(linkage) > 2 * std::numbers::pi * linkage::most_turns)
        return fmt::format("the stops of its drive are more than {} turns apart: bring them nearer, or leave them out",
                           linkage::most_turns);
    const auto open = static_cast<std::size_t>(std::count(linkage.sides.begin(), linkage.sides.end(), 0));
    if (open > most_open_sides)
        return fmt::format("{} dyads are closed on 'either' side: say the sides of all but {}", open, most_open_sides);
    // A guided point has the crank angle, too, and a body its own.
    const std::size_t count = dimensions_of(linkage).size(),
                      most = has_targets(linkage) ? PointGuidance::most_reads - 2 : Reads::most;
    if (count > most)
        return fmt::format("it has {} dimensions with those of its placement: {} at most can be", count, most);
    const auto& steps = linkage.order.steps;
    if (has_targets(linkage) && std::any_of(steps.begin(), steps.end(), [](const linkage::Step& step) {
            return step.kind == linkage::Step::Kind::unwound;
        }))
        return "a gear of it follows a link that a dyad places, whose whole turns are known along a motion alone; such "
               "a linkage guides no point or body to targets and generates no function in this version";
    return {};
}

std::shared_ptr<const Mechanism> mechanism_of(const Linkage& linkage, std::string sections,
                                              std::span<const std::string> quantities) {
    Assemblies assemblies = assemblies_of(linkage);
    LinkageModel model = model_of(linkage);
    model.sides = std::move(assemblies.sides);
    if (!linkage.order.closed()) {
        const std::vector<DimensionRange> ranges = ranges_of(linkage);
        model.starts = std::move(assemblies.starts);
        for (linkage::Assembled& start : model.starts)
            start.input = model.input_of(start.input);
        model.sketched = usual(ranges);
        for (const Dimension& dimension : dimensions_of(linkage))
            model.sketched_lengths.push_back(scales(dimension.kind));
    }
    model.turns = model.driven_by_slide() ? 1 : turns_of_cycle(model, usual(ranges_of(linkage)));
    if (model.driven_by_slide()) model.reach = reach_of_slide(linkage, model);
    std::vector<NamedMeasure> asked;
    std::string fault;
    for (const std::string& name : quantities)
        if (const std::string plain(without_whole(name));
            const auto quantity = to_linkage_quantity(linkage, plain, fault))
            asked.push_back({plain, *quantity});
    Mechanism made = linkage_mechanism(std::move(model), dimensions_of(linkage), asked);
    made.assemblies = std::move(assemblies.names);
    made.assembly_documents = std::move(assemblies.documents);
    made.made_from = std::move(sections);
    return with_all_targets(std::make_shared<const Mechanism>(std::move(made)));
}

bool is_plain(const Json& json, int depth) {
    constexpr int deepest = 8;
    if (json.is_null() || json.is_binary() || json.is_discarded() || depth > deepest) return false;
    return !json.is_structured() ||
           std::all_of(json.begin(), json.end(), [&](const Json& below) { return is_plain(below, depth + 1); });
}

MadeAgain mechanism_of_sections(const Json& sections, std::span<const std::string> quantities) {
    if (!sections.is_object() || !is_plain(sections)) return {{}, "is no object of sections"};
    Json file{{"schema", 1}, {"mechanism", "linkage"}};
    file.update(sections);
    const reading::MadeTable made = reading::made_table(file);
    reading::Messages messages{.file = {}, .nodes = &made.nodes};
    Linkage linkage;
    reading::read_linkage_table(made.table, linkage, messages);
    if (messages.failed) {
        for (const Message& message : reading::sorted(std::move(messages)))
            if (!message.warning) return {{}, "describes none: " + to_string(message)};
    }
    if (std::string why = why_no_mechanism(linkage); !why.empty()) return {{}, std::move(why)};
    return {mechanism_of(linkage, sections.dump(), quantities), {}};
}

namespace reading {

void require_regions(Problem& problem) {
    const LinkageModel* model = problem.mechanism ? problem.mechanism->model.as<LinkageModel>() : nullptr;
    if (model == nullptr) return;
    for (const LinkageRegion& region : model->regions)
        if (const int quantity = find_quantity(*problem.mechanism, region.name + ".margin"); quantity >= 0)
            problem.requirements.push_back({static_cast<std::size_t>(quantity), {}, region.margin, {}});
}

bool names_linkage(const toml::table& table) { return table["mechanism"].value_exact<std::string>() == "linkage"; }

namespace {

/// What keeps a linkage from having a motion, or its targets from saying over which.
void check_course(const toml::table& table, const Linkage& linkage, const LinkageModel& model, const Mechanism& made,
                  Messages& messages) {
    const FilePlace place = place_of(*table.get("drive"));
    if (greatest_turn(model, usual(ranges_of(linkage))) > fastest_link)
        return add_error(messages, place,
                         "a link of it turns more than ten thousand times as fast as its drive: give lesser ratios");
    if (model.driven_by_slide() && !linkage.crank_range && is_endless(made.form(0), usual(ranges_of(linkage))))
        return add_error(
            messages, place,
            "nothing ends the motion of the slide that is driven: give it stops, 'min' and 'max' in [drive], "
            "or the motion an end, [motion] crank_range = [0, 100]");
    if (model.turns == 0 && !linkage.crank_range && !model.has_stops())
        return add_error(messages, place,
                         fmt::format("with these ratios it is not where it was after {} turns of its drive or fewer: "
                                     "give the motion an end, [motion] crank_range = [0, 360]",
                                     linkage::most_turns));
    if (model.turns == 0 && covers_several(linkage))
        add_error(messages, place,
                  "with these ratios it never is where it was, so that several targets, each of which may be "
                  "met whole turns later, do not say over which motion: ask for one, or give other ratios");
}

/// The sections that need the mechanism; those that name quantities where its signals are known.
void read_by_mechanism(const toml::table& table, const Linkage& linkage, const LinkageParts& parts, Problem& problem,
                       Messages& messages) {
    if (const std::string why = why_no_mechanism(linkage); !why.empty())
        return add_error(messages, place_of(*table.get("mechanism")),
                         why + "; 'mechwright structure' shows how the linkage is made up");
    problem.title = linkage.title;
    problem.units = linkage.units;
    problem.mechanism = mechanism_of(linkage, sections_of_linkage(table).dump(), quantities_in(table));
    add_whole_quantities(table, problem);
    if (parts.motion)
        check_course(table, linkage, linkage_of(problem.mechanism->model.data()), *problem.mechanism, messages);
    problem.dimensions = ranges_of(linkage);
    problem.dimensions.resize(problem.mechanism->dimensions.size());
    problem.crank_range = linkage.crank_range;
    problem.assemblies.resize(std::max<std::size_t>(problem.mechanism->assemblies.size(), 1));
    std::iota(problem.assemblies.begin(), problem.assemblies.end(), std::size_t{0});
    Section file{&table, "", {1, 1}, keys::of_file()};
    Messages once_more{.file = messages.file, .nodes = messages.nodes};  // these were reported
    read_solver(file, problem, once_more);
    round_lengths(file, problem, messages);
    read_path(file, problem, messages);
    read_poses(file, problem, messages);
    read_range_of_use(file, problem, messages);
    read_function(file, problem, messages);
    read_followed(file, problem, messages);
    resolve_ties(file, problem, messages);
    set_crank_range(problem);
    if (!parts.signals) return;
    read_objective(file, problem, messages);
    check_front(file, problem, messages);
    read_requirements(file, problem, messages);
    require_regions(problem);
    read_study(file, problem, messages);
}

/// Adds what another reading has found, but for what is said of places of which something is said already.
void add_beside(Messages& messages, Messages&& more) {
    std::vector<FilePlace> said;
    for (const Entry& entry : messages.entries)
        said.push_back(entry.order);
    for (Entry& entry : more.entries)
        if (std::find(said.begin(), said.end(), entry.order) == said.end())
            messages.entries.push_back(std::move(entry));
    std::move(more.named_files.begin(), more.named_files.end(), std::back_inserter(messages.named_files));
    messages.unreadable |= more.unreadable;
}

}  // namespace

void read_linkage_problem(const toml::table& table, Problem& problem, Messages& messages) {
    Linkage linkage;
    const LinkageParts parts = read_linkage_table(table, linkage, messages);
    if (!parts.structure || !parts.targets) return;
    if (!messages.failed) return read_by_mechanism(table, linkage, parts, problem, messages);
    Messages more{.file = messages.file, .nodes = messages.nodes};
    read_by_mechanism(table, linkage, parts, problem, more);
    add_beside(messages, std::move(more));
}

}  // namespace reading

}  // namespace mechwright
