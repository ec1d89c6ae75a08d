#pragma once
/// \file
/// Linkages of tests, made by names as a problem file says them; and the same pose found by other means: Newton on the
/// equations of the joints as they are defined, in fifty digits.

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "analysis/linkage/placing/place.h"
#include "analysis/linkage/structure/order.h"
#include "tests/analysis/precise.h"

namespace mechwright::test {

struct MadeLinkage {
    linkage::Structure s{};
    std::vector<double> numbers{};
    std::vector<std::string> pins{};

    linkage::Number number(double value) {
        numbers.push_back(value);
        return numbers.size() - 1;
    }
    linkage::Coordinates at(double x, double y) {
        const linkage::Number first = number(x);
        return {first, number(y)};
    }
    std::size_t pin(const std::string& name) {
        for (std::size_t i = 0; i < pins.size(); ++i)
            if (pins[i] == name) return i;
        pins.push_back(name);
        s.pins.emplace_back();
        return pins.size() - 1;
    }
    struct Place {
        const char* name;
        double x, y;
    };
    void points(std::size_t link, std::initializer_list<Place> places) {
        for (const Place& p : places)
            s.pins[pin(p.name)].points.push_back({link, at(p.x, p.y)});
    }
    std::size_t link(std::initializer_list<Place> places) {
        points(s.links, places);
        return s.links++;
    }
    linkage::Line line(std::size_t on, double x, double y, double angle) {
        linkage::Line l;
        l.on = on;
        l.through = at(x, y);
        l.angle = number(angle);
        l.by_angle = true;
        return l;
    }
    std::size_t slide(std::size_t link, const linkage::Line& on, double angle = 0, double offset = 0) {
        const linkage::Number turned = number(angle);
        s.slides.push_back({link, on, turned, number(offset)});
        return s.slides.size() - 1;
    }
    void slot(const std::string& name, const linkage::Line& in) { s.slots.push_back({pin(name), in}); }
    void gear(std::size_t first, std::size_t second, std::size_t carrier, double ratio, double phase = 0) {
        const linkage::Number r = number(ratio);
        s.gears.push_back({first, second, carrier, r, number(phase)});
    }
    void drive(std::size_t link, std::size_t on = 0) { s.drives.push_back({false, link, on, 0}); }
    void drive_slide(std::size_t slide) { s.drives.push_back({true, 0, 0, slide}); }
};

/// A linkage made ready for a number type.
template <class T>
struct Placed {
    const MadeLinkage& made;
    linkage::Order order = linkage::order_of(made.s);
    std::vector<T> numbers = std::vector<T>(made.numbers.begin(), made.numbers.end());
    std::vector<linkage::Sized<T>> sizes = linkage::sizes_of(made.s, order, std::span<const T>(numbers));
    linkage::Pose<T> pose = linkage::empty_pose<T>(made.s, order);
    bool closed = false;

    Placed(const MadeLinkage& linkage, const std::vector<T>& drives, const std::vector<std::int8_t>& sides)
        : made(linkage) {
        place(drives, sides);
    }
    bool place(const std::vector<T>& drives, const std::vector<std::int8_t>& sides) {
        closed = linkage::place<T>(order, sizes, {drives, sides}, pose);
        return closed;
    }
    const Vector<T>& operator[](const char* name) const {
        for (std::size_t i = 0; i < made.pins.size(); ++i)
            if (made.pins[i] == name) return pose.pins[i];
        throw name;
    }
};

/// What the joints and drives of a linkage want to be zero, from the links' places as x, y, angle for each moving one.
std::vector<Precise> misses(const MadeLinkage& made, const std::vector<Precise>& drives,
                            const std::vector<Precise>& places);

/// The places that Newton's method finds from those of a pose; its steps fall below 1e-40.
std::vector<Precise> places_by_newton(const MadeLinkage& made, const std::vector<double>& drives,
                                      const linkage::Pose<double>& near);

/// The greatest distance between the origins of a pose and exact places, and between directions times `size`.
double error_of(const linkage::Pose<double>& pose, const std::vector<Precise>& places, double size);

}  // namespace mechwright::test
