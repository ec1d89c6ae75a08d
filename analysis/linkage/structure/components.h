#pragma once
/// \file
/// Which equations have to be solved together: a matching of equations to unknowns, and the strongly connected
/// components of what follows from what (Hopcroft and Karp's problem by augmenting paths, Tarjan's algorithm).

#include <algorithm>
#include <cstddef>
#include <vector>

namespace mechwright::linkage {

/// The unknowns of each equation, and which unknowns are only found together.
struct Pattern {
    std::vector<std::vector<std::size_t>> unknowns_of;
    std::size_t unknowns = 0;
    std::vector<std::size_t> twin;  ///< for each unknown another that is found with it, or itself
};

namespace detail {

class Matching {
public:
    explicit Matching(const Pattern& pattern)
        : pattern_(pattern), equation_of(pattern.unknowns, missing), unknown_of(pattern.unknowns_of.size(), missing) {
        for (std::size_t i = 0; i < unknown_of.size(); ++i) {
            seen_.assign(pattern.unknowns, false);
            augment(i);
        }
    }
    bool perfect() const { return std::find(equation_of.begin(), equation_of.end(), missing) == equation_of.end(); }

private:
    static constexpr std::size_t missing = static_cast<std::size_t>(-1);

    bool augment(std::size_t equation) {
        for (const std::size_t unknown : pattern_.unknowns_of[equation]) {
            if (seen_[unknown]) continue;
            seen_[unknown] = true;
            if (equation_of[unknown] != missing && !augment(equation_of[unknown])) continue;
            equation_of[unknown] = equation;
            unknown_of[equation] = unknown;
            return true;
        }
        return false;
    }

    const Pattern& pattern_;
    std::vector<bool> seen_;

public:
    std::vector<std::size_t> equation_of, unknown_of;
};

/// Tarjan's algorithm on the unknowns, up to the first component: one that needs nothing outside itself.
class FirstComponent {
public:
    FirstComponent(const Pattern& pattern, const Matching& matching)
        : pattern_(pattern), matching_(matching), number_(pattern.unknowns, 0), low_(pattern.unknowns, 0) {
        if (pattern.unknowns > 0) visit(0);
        std::sort(found.begin(), found.end());
    }

    std::vector<std::size_t> found;

private:
    void visit(std::size_t unknown) {
        number_[unknown] = low_[unknown] = ++count_;
        stack_.push_back(unknown);
        follow(unknown, pattern_.twin[unknown]);
        for (const std::size_t next : pattern_.unknowns_of[matching_.equation_of[unknown]])
            follow(unknown, next);
        if (!found.empty() || low_[unknown] != number_[unknown]) return;
        found.assign(std::find(stack_.begin(), stack_.end(), unknown), stack_.end());
    }
    void follow(std::size_t unknown, std::size_t next) {
        if (!found.empty()) return;
        if (number_[next] == 0) visit(next);
        low_[unknown] = std::min(low_[unknown], low_[next]);
    }

    const Pattern& pattern_;
    const Matching& matching_;
    std::vector<std::size_t> number_, low_, stack_;
    std::size_t count_ = 0;
};

}  // namespace detail

/// The unknowns of a least set of equations that can be solved by itself; all of them where no matching is perfect.
inline std::vector<std::size_t> first_component(const Pattern& pattern) {
    const detail::Matching matching(pattern);
    if (matching.perfect()) return detail::FirstComponent(pattern, matching).found;
    std::vector<std::size_t> all(pattern.unknowns);
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = i;
    return all;
}

}  // namespace mechwright::linkage
