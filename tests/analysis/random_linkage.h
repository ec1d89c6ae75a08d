#pragma once
/// \file
/// Random linkages, most of them sound: a crank and random dyads, one upon the other; some of them then changed by
/// chance.

#include <cstdint>
#include <random>
#include <string>

#include "tests/analysis/made_linkage.h"

namespace mechwright::test {

struct RandomLinkage {
    std::mt19937_64 engine;
    MadeLinkage made{};

    explicit RandomLinkage(std::uint64_t seed) : engine(seed) {}

    double number(double from, double to) {
        return from + (to - from) * (static_cast<double>(engine() >> 11) * 0x1p-53);
    }
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine() % n); }
    std::size_t any_link() { return below(made.s.links); }
    linkage::Line line(std::size_t on) { return made.line(on, number(-2, 2), number(-2, 2), number(-3, 3)); }
    std::string name() { return "P" + std::to_string(made.pins.size()); }
    /// A new point of a link, by its pin's name.
    std::string point(std::size_t link) {
        const std::string n = name();
        made.points(link, {{n.c_str(), number(-4, 4), number(-4, 4)}});
        return n;
    }
    std::string any_pin() { return made.pins.empty() ? point(any_link()) : made.pins[below(made.pins.size())]; }
    std::size_t bar(const std::string& a, const std::string& b) {
        return made.link({{a.c_str(), number(-1, 1), 0}, {b.c_str(), number(3, 6), number(-1, 1)}});
    }

    void add_crank() {
        const std::string pivot = point(0);
        made.drive(made.link({{pivot.c_str(), 0, 0}, {"crank pin", number(0.5, 1.5), 0}}));
    }
    /// A crank with one dyad or more, `most` at most.
    void add_crank_and_dyads(std::size_t most) {
        add_crank();
        for (std::size_t k = 1 + below(most); k > 0; --k)
            add_dyad();
    }
    void add_dyad() {
        const std::string a = point(any_link()), b = point(any_link()), c = name();
        switch (below(8)) {
            case 0:
            case 1:
                bar(a, c);
                bar(b, c);
                break;
            case 2: {  // a slide at the end of a bar
                const std::size_t on = any_link();
                bar(a, c);
                made.slide(made.link({{c.c_str(), number(-1, 1), number(-1, 1)}}), line(on), number(-1, 1),
                           number(-1, 1));
                break;
            }
            case 3: {  // the same without a block
                const std::size_t on = any_link();
                bar(a, c);
                made.slot(c, line(on));
                break;
            }
            case 4:  // a slotted lever over a pin
                made.slot(b, line(made.link({{a.c_str(), 0, 0}})));
                break;
            case 5: {  // a block that slides on a lever
                const std::size_t lever = made.link({{a.c_str(), 0, 0}});
                made.slide(made.link({{b.c_str(), number(-1, 1), number(-1, 1)}}), line(lever), number(-1, 1),
                           number(-1, 1));
                break;
            }
            case 6: {  // no dyad: a plate on three bars
                const std::string pins[]{name(), name() + "b", name() + "c"};
                const std::size_t plate = made.link({});
                for (const std::string& pin : pins) {
                    made.points(plate, {{pin.c_str(), number(-3, 3), number(-3, 3)}});
                    bar(point(any_link()), pin);
                }
                break;
            }
            default: {  // a yoke on a slide, its slot over a pin
                const std::size_t on = any_link(), yoke = made.link({});
                made.slide(yoke, line(on), number(-1, 1), number(-1, 1));
                made.slot(a, line(yoke));
            }
        }
    }
    void add_wheel() {
        const std::size_t first = any_link(), carrier = any_link();
        const std::string at = point(carrier);
        const std::size_t wheel = made.link({{at.c_str(), 0, 0}, {name().c_str(), number(0.5, 1), 0}});
        if (first != carrier) made.gear(first, wheel, carrier, number(-2, 2), number(-1, 1));
    }
    void change() {
        linkage::Structure& s = made.s;
        const std::size_t link = any_link();
        switch (below(6)) {
            case 0: {
                const std::size_t pin = made.pin(any_pin());
                if (!linkage::is_on(s.pins[pin], link))
                    s.pins[pin].points.push_back({link, made.at(number(-3, 3), number(-3, 3))});
                break;
            }
            case 1:
                if (const std::size_t pin = made.pin(any_pin()); s.pins[pin].points.size() > 1)
                    s.pins[pin].points.pop_back();
                break;
            case 2:
                if (const std::size_t on = any_link(); on != link && link != 0) made.slide(link, line(on));
                break;
            case 3:
                if (const std::string pin = any_pin(); !linkage::is_on(s.pins[made.pin(pin)], link))
                    made.slot(pin, line(link));
                break;
            case 4:
                if (link != 0) made.drive(link);
                break;
            default:
                if (!s.slides.empty()) s.slides.pop_back();
        }
    }
};

inline MadeLinkage random_linkage(std::uint64_t seed) {
    RandomLinkage random(seed);
    random.add_crank();
    for (std::size_t i = random.below(5); i > 0; --i)
        random.below(8) == 0 ? random.add_wheel() : random.add_dyad();
    for (std::size_t i = random.below(2) * random.below(4); i > 0; --i)
        random.change();
    return random.made;
}

}  // namespace mechwright::test
