// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/script_numbers.hpp"

#include <charconv>
#include <cmath>
#include <numbers>

namespace dmp::geometry {

namespace {

constexpr int deepest_number = 50;  // brackets and signs

/// Recursive descent, a function for each level of precedence; none as soon as something else stands there.
class Expression {
  public:
    using Value = std::optional<double>;

    Expression(const std::vector<ScriptToken>& tokens, const std::map<std::string, double>& known, std::size_t begin,
               std::size_t end)
        : tokens_(tokens), known_(known), at_(begin), end_(end) {}

    Value whole() {
        const Value value = sum();
        return at_ == end_ ? value : std::nullopt;
    }

  private:
    [[nodiscard]] bool is(char symbol) const { return at_ < end_ && tokens_[at_].is_symbol(symbol); }

    Value sum() {
        Value value = product();
        while (value && (is('+') || is('-'))) {
            const double sign = tokens_[at_++].is_symbol('+') ? 1 : -1;
            const Value next = product();
            value = next ? Value(*value + sign * *next) : std::nullopt;
        }
        return value;
    }
    Value product() {
        Value value = power();
        while (value && (is('*') || is('/'))) {
            const bool times = tokens_[at_++].is_symbol('*');
            const Value next = power();
            value = next ? Value(times ? *value * *next : *value / *next) : std::nullopt;
        }
        return value;
    }
    Value power() {
        const Value base = single();
        if (!base || !is('^')) return base;
        ++at_;
        const Value exponent = deeper([&] { return power(); });
        return exponent ? Value(std::pow(*base, *exponent)) : std::nullopt;
    }
    Value single() {
        if (at_ == end_) return std::nullopt;
        const ScriptToken& token = tokens_[at_++];
        if (token.is_symbol('-') || token.is_symbol('+')) {
            const Value value = deeper([&] { return power(); });
            return value ? Value(token.is_symbol('-') ? -*value : *value) : std::nullopt;
        }
        if (token.is_symbol('(')) {
            const Value value = deeper([&] { return sum(); });
            if (!is(')')) return std::nullopt;
            ++at_;
            return value;
        }
        if (token.kind == TokenKind::number) {
            double value = 0;
            const auto [stop, error] = std::from_chars(token.text.data(), token.text.data() + token.text.size(), value);
            return error == std::errc() ? Value(value) : std::nullopt;
        }
        if (token.is_word("Pi")) return std::numbers::pi;
        const auto found = token.kind == TokenKind::word ? known_.find(token.text) : known_.end();
        return found == known_.end() ? std::nullopt : Value(found->second);
    }
    template <class Read>
    Value deeper(const Read& read) {
        if (depth_ == deepest_number) return std::nullopt;
        ++depth_;
        const Value value = read();
        --depth_;
        return value;
    }

    const std::vector<ScriptToken>& tokens_;
    const std::map<std::string, double>& known_;
    std::size_t at_, end_;
    int depth_ = 0;
};

}  // namespace

ScriptNumbers::ScriptNumbers(const std::vector<ScriptToken>& tokens) : tokens_(tokens) {
    const auto is = [&](std::size_t i, char symbol) { return i < tokens.size() && tokens[i].is_symbol(symbol); };
    std::map<std::string, std::vector<std::size_t>> set_at;  // by name: where a value begins
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].kind != TokenKind::word) continue;
        const bool sets = is(i + 1, '=') && !is(i + 2, '=');
        const bool changes =
            (is(i + 1, '+') || is(i + 1, '-') || is(i + 1, '*') || is(i + 1, '/')) &&
            (is(i + 2, '=') || (is(i + 2, '+') && is(i + 1, '+')) || (is(i + 2, '-') && is(i + 1, '-')));
        const bool counts = i > 0 && tokens[i - 1].is_word("For");
        if (sets || changes || counts) set_at[tokens[i].text].push_back(i + 2);
    }
    // In the order of the script, as one may be made of others.
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const auto found = tokens[i].kind == TokenKind::word ? set_at.find(tokens[i].text) : set_at.end();
        if (found == set_at.end() || found->second.size() != 1 || found->second.front() != i + 2 || !is(i + 1, '='))
            continue;
        std::size_t end = i + 2;
        while (end < tokens.size() && !is(end, ';') && !is(end, ',') && !is(end, ']')) ++end;
        if (const auto number = value(i + 2, end)) known_[tokens[i].text] = *number;
    }
}

std::optional<double> ScriptNumbers::value(std::size_t begin, std::size_t end) const {
    return Expression(tokens_, known_, begin, end).whole();
}

}  // namespace dmp::geometry
