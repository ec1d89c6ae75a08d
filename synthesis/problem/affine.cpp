#include "synthesis/problem/affine.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "synthesis/problem/text.h"

namespace mechwright {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_of_name(char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '-'; }

struct Scanner {
    std::string_view rest;

    void skip_spaces() {
        while (!rest.empty() && rest.front() == ' ')
            rest.remove_prefix(1);
    }
    bool at_end() const { return rest.empty(); }
    bool take(char c) {
        if (rest.empty() || rest.front() != c) return false;
        rest.remove_prefix(1);
        return true;
    }
    std::optional<double> number() {
        double value = 0;
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
        if (error != std::errc{} || !std::isfinite(value)) return {};
        rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
        return value;
    }
    std::string_view name() {
        std::size_t length = 0;
        while (length < rest.size() && is_of_name(rest[length]))
            ++length;
        const std::string_view found = rest.substr(0, length);
        rest.remove_prefix(length);
        return found;
    }
    bool at_name() const { return !rest.empty() && is_letter(rest.front()); }
    bool at_number() const { return !rest.empty() && (is_digit(rest.front()) || rest.front() == '.'); }
};

constexpr std::string_view form =
    "write sums like \"ground - 0.5 crank + 3\": terms are a number, a name, or both, with '/ number' behind, and "
    "spaces stand around the signs between them";

/// One term without its sign; what is wrong goes to `fault`.
Affine term(Scanner& scanner, const std::function<std::optional<std::size_t>(std::string_view, std::string&)>& find,
            std::string& fault) {
    Affine value;
    double factor = 1;
    bool named = scanner.at_name();
    if (scanner.at_number()) {
        const auto number = scanner.number();
        if (!number) return fault = form, value;
        factor = *number;
        const bool apart = !scanner.at_name();
        scanner.skip_spaces();
        if (scanner.take('*')) {
            scanner.skip_spaces();
            named = scanner.at_name();
            if (!named) return fault = form, value;
        } else {
            named = scanner.at_name();
            if (named && !apart) return fault = form, value;
        }
    } else if (!named) {
        return fault = form, value;
    }
    if (named) {
        const auto index = find(scanner.name(), fault);
        if (!index) return value;
        value.terms.push_back({*index, factor});
    } else {
        value.constant = factor;
    }
    scanner.skip_spaces();
    if (!scanner.take('/')) return value;
    scanner.skip_spaces();
    const auto divisor = scanner.at_number() ? scanner.number() : std::nullopt;
    if (!divisor || *divisor == 0) return fault = "what stands behind '/' must be a number other than 0", value;
    Affine divided;
    add(divided, value, 1 / *divisor);
    return divided;
}

}  // namespace

void add(Affine& sum, const Affine& more, double factor) {
    sum.constant += factor * more.constant;
    for (const auto& [dimension, by] : more.terms) {
        const auto at = std::lower_bound(sum.terms.begin(), sum.terms.end(), dimension,
                                         [](const auto& entry, std::size_t d) { return entry.first < d; });
        if (at != sum.terms.end() && at->first == dimension)
            at->second += factor * by;
        else
            sum.terms.insert(at, {dimension, factor * by});
    }
}

std::string text_of(const Affine& sum, const std::function<std::string(std::size_t)>& name_of) {
    std::string text;
    const auto add_term = [&](double factor, const std::string& name) {
        if (!text.empty()) text += factor < 0 ? " - " : " + ";
        const double size = text.empty() ? factor : std::abs(factor);
        if (name.empty())
            text += fmt::format("{}", size);
        else
            text += size == 1 ? name : size == -1 ? "-" + name : fmt::format("{} {}", size, name);
    };
    for (const auto& [dimension, factor] : sum.terms)
        add_term(factor, name_of(dimension));
    if (sum.constant != 0 || text.empty()) add_term(sum.constant, "");
    return text;
}

ParsedAffine parse_affine(std::string_view text,
                          const std::function<std::optional<std::size_t>(std::string_view, std::string&)>& find) {
    Scanner scanner{text};
    ParsedAffine parsed;
    double sign = 1;
    for (bool first = true;; first = false) {
        scanner.skip_spaces();
        if (!first) {
            if (scanner.at_end()) break;
            const bool minus = scanner.rest.front() == '-';
            if ((!minus && scanner.rest.front() != '+') || scanner.rest.size() < 2 || scanner.rest[1] != ' ') {
                parsed.fault = form;
                return parsed;
            }
            sign = minus ? -1 : 1;
            scanner.rest.remove_prefix(2);
            scanner.skip_spaces();
        }
        if (scanner.take('-')) sign = -sign;
        const Affine one = term(scanner, find, parsed.fault);
        if (!parsed.fault.empty()) return parsed;
        add(parsed.value, one, sign);
        sign = 1;
    }
    return parsed;
}

}  // namespace mechwright
