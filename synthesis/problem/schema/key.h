#pragma once
/// \file
/// The members of tables in files, as data: what readers, writers and the published schemas know of a name stands in
/// one place.

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

namespace mechwright {

/// What stands behind a name.
enum class Shape {
    number,
    whole_number,
    flag,
    text,
    word,          ///< one of `words`
    word_list,     ///< one of `words`, or a list of some
    texts,         ///< a list of strings
    name,          ///< of something that the mechanism or the program knows: filled in where that is known
    names,         ///< an object with such names
    numbers,       ///< a list of numbers
    open_numbers,  ///< a list of numbers, null where there is none
    ends,          ///< [from, to]
    pairs,         ///< a list of [x, y]
    poses,         ///< a list of [x, y, angle], or [x, y]
    range,         ///< a number, or { min, max } with or without start and step, or { choices }
    ranges,        ///< a list of these
    tied_range,    ///< one of these, or a tie to other dimensions
    range_or_sum,  ///< of a linkage: one of these, or a sum of dimensions
    expression,    ///< of a linkage: a number, or a sum of dimensions
    place,         ///< of a linkage: a point by its name, [x, y], or { length, angle }
    table,         ///< with the keys `below`
    tables,        ///< a list of such tables
    value          ///< a shape of its own, which the schema's maker fills in
};

/// What a number can be.
struct Limits {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool above = false;  ///< greater than `least`, not equal to it
    bool below = false;  ///< less than `most`, not equal to it
};

inline constexpr Limits positive{.least = 0, .above = true};
inline constexpr Limits not_negative{.least = 0};

struct Key {
    std::string_view name;
    Shape shape;
    std::string_view meaning;  ///< for whoever reads the schema, or is shown it by an editor
    bool required = false;
    std::span<const std::string_view> words{};
    std::span<const Key> below{};
    Limits limits{};
};

/// The key of a name, or null.
constexpr const Key* find_key(std::span<const Key> keys, std::string_view name) {
    for (const Key& key : keys)
        if (key.name == name) return &key;
    return nullptr;
}

/// A name as it stands in a list: does not compile where the list does not have it.
template <const auto& keys>
struct NamesOf {
    consteval const char* operator()(const char* name) const {
        if (find_key(keys, name) == nullptr) throw "the list does not have this name";
        return name;
    }
};

namespace keys {

template <std::size_t N>
using Words = std::array<std::string_view, N>;

}  // namespace keys

}  // namespace mechwright
