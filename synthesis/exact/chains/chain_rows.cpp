#include "synthesis/exact/chains/chain_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "synthesis/exact/chains/link_frames.h"

namespace mechwright {

namespace {

using Point = std::complex<double>;
using homotopy::SecondDyad;

constexpr std::size_t of_frame = 0;

/// A sum of multiples of numbers.
Affine sum_of(const std::vector<std::pair<double, const Affine*>>& terms) {
    Affine sum;
    for (const auto& [factor, affine] : terms) {
        sum.constant += factor * affine->constant;
        for (const auto& [dimension, multiple] : affine->terms) {
            const auto known = std::find_if(sum.terms.begin(), sum.terms.end(),
                                            [d = dimension](const auto& term) { return term.first == d; });
            if (known == sum.terms.end())
                sum.terms.emplace_back(dimension, factor * multiple);
            else
                known->second += factor * multiple;
        }
    }
    return sum;
}

/// What slides: its line, and the pin that it leads or that leads it.
struct Sliding {
    const linkage::Line& line;
    std::size_t pin;
    const linkage::Slide* slide;  ///< null of a slot
};

std::optional<Sliding> sliding_of(const linkage::Structure& s, const GuidedChains& chains) {
    const std::size_t pin = chains.second == SecondDyad::ram ? chains.moving : chains.fixed;
    if (chains.slide != linkage::none) return Sliding{s.slides[chains.slide].line, pin, &s.slides[chains.slide]};
    if (chains.slot != linkage::none) return Sliding{s.slots[chains.slot].line, pin, nullptr};
    return {};
}

/// The angle of a line on its link.
std::optional<Affine> angle_of(const LinkReader& reader, const linkage::Line& line) {
    if (line.by_angle) return reader.numbers.number(line.angle);
    const auto from = reader.numbers.constant_place(line.through), to = reader.numbers.constant_place(line.towards);
    if (!from || !to || *from == *to) return {};
    return Affine{std::arg(*to - *from), {}};
}

/// That the pin's place on the link of the line keeps its distance from it.
bool add_line(const LinkReader& reader, const Sliding& sliding, const Affine& angle, const Point& along,
              const Point& pin, std::vector<ChainRow>& rows) {
    if (sliding.line.through.polar && !reader.numbers.constant_place(sliding.line.through)) return false;
    Point origin = pin;
    const Affine zero;
    const Affine* offset = &zero;
    if (sliding.slide) {
        const auto turned = reader.numbers.constant(reader.numbers.number(sliding.slide->angle));
        const auto at = reader.numbers.constant_place(reader.at(sliding.pin, sliding.slide->link));
        if (!turned || !at) return false;
        origin -= std::polar(1.0, *turned) * *at;
        offset = &reader.numbers.number(sliding.slide->offset);
    }
    rows.push_back({angle, std::arg(along), true});
    const Point left = Point(0, 1) * along;
    const double distance = (std::conj(left) * origin).real();
    if (const auto through = reader.numbers.constant_place(sliding.line.through))
        rows.push_back({*offset, distance - (std::conj(left) * *through).real(), false});
    else
        rows.push_back({sum_of({{1, offset},
                                {left.real(), &reader.numbers.number(sliding.line.through.first)},
                                {left.imag(), &reader.numbers.number(sliding.line.through.second)}}),
                        distance, false});
    return true;
}

}  // namespace

std::vector<ChainReading> readings_of(const Problem& problem, const GuidedChains& chains, const GuidedParts& parts,
                                      std::complex<double> guided_point) {
    const LinkageModel& model = *problem.mechanism->model.as<LinkageModel>();
    const LinkReader reader{model, {problem.dimensions, model}, model.scale.constant};
    const bool ram = chains.second == SecondDyad::ram, rocker = chains.second == SecondDyad::rocker;
    const auto sliding = sliding_of(model.structure, chains);
    const Point normal = ram ? parts.second.fixed : parts.second.moving;
    const Point along = Point(0, 1) * normal;
    std::optional<KnownLine> line;
    if (sliding) {
        const auto angle = angle_of(reader, sliding->line);
        if (!angle) return {};
        line = KnownLine{*angle, along};
    }
    std::vector<KnownPin> on_frame{{reader.at(chains.crank_pivot, of_frame), parts.crank.fixed}};
    const std::vector<KnownPin> on_crank{{reader.at(chains.crank_pivot, chains.crank), parts.crank.fixed},
                                         {reader.at(chains.crank_pin, chains.crank), parts.crank.moving}};
    std::vector<KnownPin> on_body{{reader.at(chains.crank_pin, chains.body), parts.crank.moving},
                                  {reader.at(chains.point, chains.body), guided_point}};
    std::vector<KnownPin> on_rocker;
    if (!ram) on_frame.push_back({reader.at(chains.fixed, of_frame), parts.second.fixed});
    if (chains.moving != linkage::none)
        on_body.insert(on_body.begin() + 1, {reader.at(chains.moving, chains.body), parts.second.moving});
    if (rocker)
        on_rocker = {{reader.at(chains.fixed, chains.link), parts.second.fixed},
                     {reader.at(chains.moving, chains.link), parts.second.moving}};
    std::vector<ChainReading> all;
    const auto read = [&](const LinkFrame& frame, const LinkFrame& crank, const LinkFrame& body, double sense) {
        ChainReading reading{{}, frame.direction, crank.direction, body.direction, sense * along};
        reading.rows.push_back({model.placement[0], frame.origin.real(), false});
        reading.rows.push_back({model.placement[1], frame.origin.imag(), false});
        reading.rows.push_back({model.placement[2], std::arg(frame.direction), true});
        const auto add = [&](const std::vector<KnownPin>& pins, const LinkFrame& of) {
            for (const KnownPin& pin : pins)
                reader.numbers.add_place(reading.rows, pin.at, of.on_link(pin.drawn));
        };
        add(on_frame, frame);
        add(on_crank, crank);
        add(on_body, body);
        if (rocker) {
            const auto frames = reader.frames_of(on_rocker, {});
            if (frames.empty()) return;
            add(on_rocker, frames.front());
        } else {
            const LinkFrame& of = ram ? frame : body;
            const Point pin = ram ? parts.second.moving : parts.second.fixed;
            if (!add_line(reader, *sliding, line->angle, sense * along / of.direction, of.on_link(pin), reading.rows))
                return;
        }
        all.push_back(std::move(reading));
    };
    for (const LinkFrame& frame : reader.frames_of_frame(on_frame, ram ? line : std::nullopt))
        for (const LinkFrame& crank : reader.frames_of(on_crank, {}))
            for (const LinkFrame& body : reader.frames_of(on_body, ram || rocker ? std::nullopt : line))
                for (const double sense : {1.0, -1.0})
                    if (sense > 0 || !rocker) read(frame, crank, body, sense);
    return all;
}

}  // namespace mechwright
