// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/quantity.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "scene/read_scene.hpp"

namespace dmp::scene {

namespace {

[[noreturn]] void fail(const SourceLocation& location, std::string what, std::string what_to_do) {
    throw InputError(location, std::move(what), std::move(what_to_do));
}

constexpr std::string_view unit_pattern = "units are written like m/s^2, mPa*s or J/kg/K";

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

Unit joined(const Unit& a, char sign, const Unit& b) { return a * (sign == '*' ? b : power(b, -1)); }

/// A symbol and its exponent at `begin`; nullopt if there is no unit.
std::optional<UnitReading> read_factor(const WrittenText& text, std::size_t begin, bool (*not_unit)(std::string_view)) {
    const std::string_view all = text.text;
    const std::size_t name_end = end_of_name(all, begin);
    const auto name = all.substr(begin, name_end - begin);
    if (name.empty() || not_unit(name)) return {};
    const auto unit = unit_symbol(name);
    std::size_t next = skip_spaces(all, name_end);
    if (!unit || (next < all.size() && all[next] == '(')) return {};
    if (next >= all.size() || all[next] != '^') return UnitReading{*unit, name_end};

    const std::size_t exponent_begin = next = skip_spaces(all, next + 1);
    if (next < all.size() && (all[next] == '-' || all[next] == '+')) ++next;
    const std::size_t digits = next;
    while (next < all.size() && is_digit(all[next])) ++next;
    int exponent = 0;
    const auto parsed = std::from_chars(all.data() + digits, all.data() + next, exponent);
    if (digits == next || parsed.ec != std::errc{} || exponent > 20 || (next < all.size() && all[next] == '.')) {
        fail(text.at(exponent_begin),
             "the exponent of the unit '" + std::string(name) + "' is not a whole number up to 20",
             "write a whole number such as " + std::string(name) +
                 "^2; to raise a quantity to a power put it in parentheses, such as (2 m)^0.5");
    }
    if (all[exponent_begin] == '-') exponent = -exponent;
    return UnitReading{power(*unit, exponent), next};
}

}  // namespace

std::size_t end_of_number(std::string_view text, std::size_t begin) {
    std::size_t end = begin;
    std::size_t digits = 0;
    while (end < text.size() && is_digit(text[end])) ++end, ++digits;
    if (end < text.size() && text[end] == '.') {
        ++end;
        while (end < text.size() && is_digit(text[end])) ++end, ++digits;
    }
    if (digits == 0) return begin;
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        std::size_t exponent = end + 1;
        if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
        if (exponent < text.size() && is_digit(text[exponent])) {
            end = exponent;
            while (end < text.size() && is_digit(text[end])) ++end;
        }
    }
    return end;
}

std::size_t end_of_name(std::string_view text, std::size_t begin) {
    std::size_t end = begin;
    while (end < text.size()) {
        const auto c = static_cast<unsigned char>(text[end]);
        if (std::isalpha(c) != 0 || c == '_' || c >= 0x80 || (end > begin && std::isdigit(c) != 0)) {
            ++end;
        } else {
            break;
        }
    }
    return end;
}

std::size_t skip_spaces(std::string_view text, std::size_t begin) {
    while (begin < text.size() && std::isspace(static_cast<unsigned char>(text[begin])) != 0) ++begin;
    return begin;
}

std::optional<UnitReading> read_unit_greedily(const WrittenText& text, std::size_t begin,
                                              bool (*not_unit)(std::string_view)) {
    auto reading = read_factor(text, begin, not_unit);
    while (reading) {
        const std::size_t sign = skip_spaces(text.text, reading->end);
        if (sign >= text.text.size() || (text.text[sign] != '*' && text.text[sign] != '/')) break;
        const auto factor = read_factor(text, skip_spaces(text.text, sign + 1), not_unit);
        if (!factor) break;
        reading->unit = joined(reading->unit, text.text[sign], factor->unit);
        reading->end = factor->end;
    }
    return reading;
}

double in_si(std::string_view number, const Unit& unit, const SourceLocation& location) {
    const auto exponent_at = number.find_first_of("eE");
    int exponent = 0;
    bool held = true;
    if (exponent_at != std::string_view::npos) {
        const bool plus = number[exponent_at + 1] == '+';
        const auto digits = number.substr(exponent_at + (plus ? 2 : 1));
        held = std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec == std::errc{};
    }
    double value = 0;
    if (held) {  // add the unit's power of ten to the decimal exponent: rounded once, "0.2 mm" is the double 0.0002
        const std::string text =
            std::string(number.substr(0, exponent_at)) + "e" + std::to_string(exponent + unit.power_of_ten);
        held = std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc{};
        value *= unit.factor;
    }
    if (!held || !std::isfinite(value)) {
        fail(location, "the number " + std::string(number) + " is too large or too small for this machine",
             "check its exponent and its unit");
    }
    return value;
}

bool is_bare_number(std::string_view text) {
    std::size_t at = skip_spaces(text, 0);
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) at = skip_spaces(text, at + 1);
    return skip_spaces(text, end_of_number(text, at)) == text.size();
}

Quantity parse_quantity(const WrittenText& text, const Dimension* wanted) {
    const std::string_view all = text.text;
    std::size_t at = skip_spaces(all, 0);
    double sign = 1;
    if (at < all.size() && (all[at] == '-' || all[at] == '+')) {
        sign = all[at] == '-' ? -1 : 1;
        at = skip_spaces(all, at + 1);
    }
    const std::size_t number_end = end_of_number(all, at);
    const auto none_reserved = [](std::string_view) { return false; };
    if (number_end == at) {
        const auto unit = read_factor(text, at, none_reserved);
        if (unit && skip_spaces(all, unit->end) == all.size())
            fail(text.at(at), "found the unit \"" + text.text + "\" without a number",
                 "write a number before it, such as \"1 " + std::string(all.substr(at, unit->end - at)) + "\"");
        fail(text.at(at), "expected a number in \"" + text.text + "\"",
             "write a number and its unit, such as \"0.1 mm\"");
    }
    const auto number = all.substr(at, number_end - at);
    const SourceLocation number_location = text.at(at);
    at = skip_spaces(all, number_end);
    UnitReading reading{{}, at};
    const bool starts_with_one = at < all.size() && all[at] == '1' && end_of_number(all, at) == at + 1;
    if (starts_with_one) {  // "50 1/s"
        reading.end = at + 1;
        std::size_t next = skip_spaces(all, at + 1);
        while (next < all.size() && (all[next] == '/' || all[next] == '*')) {
            const auto factor = read_factor(text, skip_spaces(all, next + 1), none_reserved);
            if (!factor) break;
            reading.unit = joined(reading.unit, all[next], factor->unit);
            reading.end = factor->end;
            next = skip_spaces(all, factor->end);
        }
    } else if (const auto unit = read_unit_greedily(text, at, none_reserved)) {
        reading = *unit;
    }
    std::size_t rest = skip_spaces(all, reading.end);
    if (rest < all.size()) {
        if (all[rest] == '*' || all[rest] == '/') rest = skip_spaces(all, rest + 1);
        const std::size_t name_end = end_of_name(all, rest);
        const std::string name(all.substr(rest, name_end - rest));
        if (name.empty()) {
            const std::string found =
                rest < all.size() ? "unexpected '" + std::string(1, all[rest]) + "'" : "unexpected end";
            fail(text.at(rest), found + " in \"" + text.text + "\"", std::string(unit_pattern));
        }
        if (unit_symbol(name)) {
            fail(text.at(rest), "unexpected '" + name + "' in \"" + text.text + "\"",
                 "join units with * or /: " + std::string(unit_pattern));
        }
        const std::string nearest = nearest_unit(name, wanted);
        fail(text.at(rest), "unknown unit '" + name + "' in \"" + text.text + "\"",
             nearest.empty() ? std::string(unit_pattern) + ", with the SI symbols and prefixes"
                             : "did you mean '" + nearest + "'?");
    }
    return {sign * in_si(number, reading.unit, number_location), reading.unit.dimension};
}

std::string exact_text(double value) {
    std::array<char, 32> buffer{};
    auto* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

std::string last_word(const std::string& path) {
    const auto dot = path.rfind('.');
    return dot == std::string::npos ? path : path.substr(dot + 1);
}

namespace {

/// The SI unit from which a unit differs by one prefix: "Pa*s" for "mPa*s"; empty if it is one, or none is found.
std::string without_prefix(const std::string& unit) {
    const auto quantity_of = [](const std::string& of) -> std::optional<Quantity> {
        try {
            return parse_quantity({"1 " + of, {}, {}});
        } catch (const InputError&) {
            return {};
        }
    };
    const auto own = quantity_of(unit);
    if (!own || own->si == 1) return {};
    for (std::size_t k = 0; k < unit.size(); ++k) {
        std::string shorter = unit;
        shorter.erase(k, 1);
        const auto other = quantity_of(shorter);
        if (other && other->si == 1 && other->dimension == own->dimension) return shorter;
    }
    return {};
}

}  // namespace

Expected::Expected(std::string example) : example_(std::move(example)) {
    dimension_ = parse_quantity({example_, {}, {}}).dimension;
    const std::size_t begin = example_.starts_with('-') ? 1 : 0;
    unit_ = example_.substr(skip_spaces(example_, end_of_number(example_, begin)));
}

std::string Expected::phrase() const { return dimension_.name_with_article() + " such as \"" + example_ + "\""; }

InputError Expected::missing_unit(const SourceLocation& location, const std::string& written,
                                  const std::string& subject) const {
    const auto with = [&](const std::string& unit) { return "\"" + written + " " + unit + "\""; };
    const std::string si = without_prefix(unit_);
    const std::string quoted = with(unit_) + (si.empty() ? "" : " or " + with(si));
    if (subject.empty()) {
        return {location, "missing unit: found " + written + ", expected " + phrase(),
                "write " + quoted + ", with the unit you mean"};
    }
    const std::string key = last_word(subject);
    return {location, "missing unit: " + key + " = " + written + ", expected " + phrase(),
            "write " + key + " = " + quoted + ", with the unit you mean"};
}

double Expected::read(const WrittenText& text, const std::string& subject) const {
    const Quantity found = parse_quantity(text, &dimension_);
    if (found.dimension == dimension_) return found.si;
    const bool bare = is_bare_number(text.text);
    if (bare && found.si == 0) return 0;
    if (bare) throw missing_unit(text.location, text.text, subject);
    throw InputError(text.location,
                     (subject.empty() ? "" : subject + ": ") + "found \"" + text.text + "\" (" +
                         found.dimension.name() + "), expected " + phrase(),
                     "give " + dimension_.name_with_article() + (subject.empty() ? "" : " for " + last_word(subject)));
}

double read_quantity(const std::string& text, const std::string& expected_unit, const SourceLocation& location) {
    return Expected("1 " + expected_unit).read({text, location, {}}, "");
}

}  // namespace dmp::scene
