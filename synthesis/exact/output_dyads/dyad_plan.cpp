#include "synthesis/exact/output_dyads/dyad_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/exact/chains/link_numbers.h"

namespace mechwright {

namespace {

using Dimensions = std::vector<std::size_t>;

bool contains(const Dimensions& all, std::size_t dimension) {
    return std::find(all.begin(), all.end(), dimension) != all.end();
}

struct Planner {
    const Problem& problem;
    const LinkageModel& model;
    const OutputDyad& dyad;
    LinkNumbers numbers{problem.dimensions, model};

    const linkage::Coordinates& at(std::size_t pin, std::size_t link) const {
        return coordinates_on(model.structure.pins[pin], link);
    }
    std::string pin(std::size_t i) const { return "'" + model.pins[i] + "'"; }
    std::string link(std::size_t i) const { return "'" + model.links[i] + "'"; }
    std::string name(std::size_t dimension) const { return "'" + problem.mechanism->dimensions[dimension].name + "'"; }
    bool start_is_open() const { return !problem.dimensions[start()].fixed(); }
    std::size_t start() const { return problem.mechanism->input->start + 2; }

    /// The dimensions with ranges in a number.
    Dimensions open_in(linkage::Number number) const {
        Dimensions open;
        for (const auto& [dimension, factor] : numbers.number(number).terms)
            if (!problem.dimensions[dimension].fixed()) open.push_back(dimension);
        return open;
    }
    /// Of a place, in the order in which they are searched where there are too many: of an angle before its distance,
    /// since a distance alone is no line.
    Dimensions open_in(const linkage::Coordinates& place) const {
        Dimensions open = open_in(place.polar ? place.second : place.first);
        const Dimensions other = open_in(place.polar ? place.first : place.second);
        open.insert(open.end(), other.begin(), other.end());
        return open;
    }

    const linkage::Coordinates& pivot() const { return at(dyad.pivot, dyad.carrier); }
    const linkage::Coordinates& arm() const { return at(dyad.inner, dyad.lever); }
    const linkage::Coordinates& rod() const { return at(dyad.inner, dyad.rod); }

    /// The numbers that say the dyad, but for the rod.
    std::vector<linkage::Number> own_numbers() const {
        if (dyad.slides()) return {model.structure.slides[dyad.slide].offset};
        return {pivot().first, pivot().second, arm().first, arm().second};
    }
    /// Whether a number says the place of a pin of the rod or the lever on these.
    bool is_of_dyad(linkage::Number number) const {
        const auto has = [&](const linkage::Point& point) {
            return (point.link == dyad.rod || point.link == dyad.lever) &&
                   (point.at.first == number || point.at.second == number);
        };
        return std::any_of(model.structure.pins.begin(), model.structure.pins.end(), [&](const linkage::Pin& pin) {
            return std::any_of(pin.points.begin(), pin.points.end(), has);
        });
    }

    std::string why_no_rod() const {
        const auto from = numbers.constant_place(at(dyad.outer, dyad.rod));
        if (from && numbers.direction_to(rod(), *from) && open_in(rod()).size() == 1) return {};
        return fmt::format(
            "it finds the length of the rod {0}: give {1} a place on it, like [0, 0], and {2} one beside "
            "or above it with a range, like [\"rod\", 0]",
            link(dyad.rod), pin(dyad.outer), pin(dyad.inner));
    }
    /// That all but the offset of what slides is given.
    std::string why_no_slide() const {
        const linkage::Slide& slide = model.structure.slides[dyad.slide];
        Dimensions open = open_in(at(dyad.inner, dyad.lever));
        const auto add = [&](const Dimensions& more) { open.insert(open.end(), more.begin(), more.end()); };
        add(open_in(slide.angle));
        add(open_in(slide.line.through));
        add(slide.line.by_angle ? open_in(slide.line.angle) : open_in(slide.line.towards));
        if (model.scale.constant != 1 || !model.scale.terms.empty()) return "the linkage has a scale: leave it out";
        if (open.empty() && open_in(slide.offset).size() <= 1) return {};
        return fmt::format(
            "of what slides it finds the offset alone, and where the output starts: give its line, and the "
            "place of {} on {}",
            pin(dyad.inner), link(dyad.lever));
    }
    std::string why_no_lever() const {
        const auto from = numbers.constant_place(at(dyad.pivot, dyad.lever));
        if (!from) return fmt::format("give {} a place on {}, like [0, 0]", pin(dyad.pivot), link(dyad.lever));
        const std::size_t open = open_in(arm()).size();
        if (start_is_open() && open == 2)
            return fmt::format(
                "turning {0} on {1} and the start of the output is the same: give one of them, like "
                "{2} = [\"output\", 0]",
                pin(dyad.inner), link(dyad.lever), model.pins[dyad.inner]);
        if (start_is_open() && (open == 0 || !numbers.direction_to(arm(), *from)))
            return fmt::format(
                "where the output may start anywhere it finds the length of {0}: give {1} a place beside "
                "or above {2} with a range, like [\"output\", 0]",
                link(dyad.lever), pin(dyad.inner), pin(dyad.pivot));
        return {};
    }
    /// That each dimension stands for one number, and for nothing that is known.
    std::string why_not_by_itself(const Dimensions& own) const {
        for (auto one = own.begin(); one != own.end(); ++one) {
            if (std::find(own.begin(), one, *one) != one)
                return fmt::format("{} stands in several coordinates of the dyad: give each a name of its own",
                                   name(*one));
            for (linkage::Number i = 0; i < model.numbers.size(); ++i) {
                if (contains(own_numbers(), i) || is_of_dyad(i) || !contains(open_in(i), *one)) continue;
                return fmt::format(
                    "{} is found with the dyad that ends on the output, and places other links, too: "
                    "give it, or another name",
                    name(*one));
            }
        }
        for (const linkage::Number i : own_numbers())
            if (open_in(i).size() > 1)
                return "a coordinate of the dyad that ends on the output is a sum of several dimensions with ranges: "
                       "give all but one of them";
        return {};
    }
    /// Whether a place that is to be found is given by its distance alone, which is a circle.
    bool is_on_circle(const linkage::Coordinates& place, const Dimensions& found) const {
        const auto is_found = [&](linkage::Number number) {
            const Dimensions open = open_in(number);
            return !open.empty() && contains(found, open.front());
        };
        return place.polar && is_found(place.second) && !is_found(place.first);
    }
};

std::size_t points_of(const FunctionTarget& f) {
    return f.expression.empty() ? f.samples.size() : f.accuracy_points.size();
}

std::string why_not_so_many(const Planner& p, std::size_t points, std::size_t open) {
    if (points == 0) return "it needs accuracy_points in [function]: 3, 4 or 5, or a list of x";
    if (points >= 2 && points <= open) return {};
    if (points > 5 || points < 2)
        return fmt::format("it meets from 2 to 5 points of a function, and there are {}: {}", points,
                           points < 2 ? "give more" : "slsqp finds the least error");
    if (p.dyad.slides())
        return fmt::format(
            "{} accuracy points need as many numbers with ranges: of the length of {}, the offset of {} "
            "and the start of the output; {} of them have one",
            points, p.link(p.dyad.rod), p.link(p.dyad.lever), open);
    return fmt::format(
        "{} accuracy points need as many numbers with ranges of the dyad that ends on the output: the "
        "length of {}, the place of {} on {} (two) or its length and the start of the output, the "
        "place of {} on {} (two); {} of them have one",
        points, p.link(p.dyad.rod), p.pin(p.dyad.inner), p.link(p.dyad.lever), p.pin(p.dyad.pivot),
        p.link(p.dyad.carrier), open);
}

}  // namespace

DyadPlan dyad_plan(const Problem& problem) {
    DyadPlan plan;
    const auto refuse = [&](std::string why) {
        plan.why_not = std::move(why);
        return plan;
    };
    const LinkageModel& model = *problem.mechanism->model.as<LinkageModel>();
    const auto dyad = output_dyad(model);
    if (!dyad)
        return refuse(
            "of linkages it finds the last dyad alone: the output of the function has to be the angle, against the "
            "frame, of a link on a pivot that a rod turns, or the displacement of a slide that it moves, and what both "
            "hang on is placed before");
    plan.dyad = *dyad;
    const Planner p{problem, model, *dyad};
    if (std::string why = p.why_no_rod(); !why.empty()) return refuse(std::move(why));
    const bool slides = dyad->slides();
    if (std::string why = slides ? p.why_no_slide() : p.why_no_lever(); !why.empty()) return refuse(std::move(why));
    const Dimensions of_pivot = slides ? p.open_in(model.structure.slides[dyad->slide].offset) : p.open_in(p.pivot()),
                     of_arm = slides ? Dimensions{} : p.open_in(p.arm()), of_rod = p.open_in(p.rod());
    Dimensions own = of_pivot;
    own.insert(own.end(), of_arm.begin(), of_arm.end());
    own.insert(own.end(), of_rod.begin(), of_rod.end());
    if (std::string why = p.why_not_by_itself(own); !why.empty()) return refuse(std::move(why));
    const std::size_t points = points_of(*problem.function), open = own.size() + (p.start_is_open() ? 1U : 0U);
    if (std::string why = why_not_so_many(p, points, open); !why.empty()) return refuse(std::move(why));
    // What may be searched instead of found, the first first; the rod never is.
    Dimensions in_order = of_pivot;
    if (p.start_is_open()) in_order.push_back(p.start());
    in_order.insert(in_order.end(), of_arm.begin(), of_arm.end());
    const Dimensions searched(in_order.begin(), in_order.begin() + static_cast<std::ptrdiff_t>(open - points));
    plan.start_is_found = p.start_is_open() && !contains(searched, p.start());
    for (const std::size_t dimension : own)
        if (!contains(searched, dimension)) plan.found.push_back(dimension);
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i)
        if (!problem.dimensions[i].fixed() && !contains(plan.found, i) && !(i == p.start() && plan.start_is_found))
            plan.searched.push_back(i);
    if (slides) return plan;
    for (const auto* place : {&p.pivot(), &p.arm()})
        if (p.is_on_circle(*place, plan.found) && !(place == &p.arm() && plan.start_is_found))
            return refuse(
                fmt::format("the distance of {} is given and its angle is not: give the distance a range, or "
                            "the angle",
                            p.pin(place == &p.pivot() ? dyad->pivot : dyad->inner)));
    return plan;
}

}  // namespace mechwright
