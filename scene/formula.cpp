// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/formula.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/nearest_name.hpp"
#include "scene/formula_names.hpp"

namespace dmp::scene {

namespace {

using namespace formula_names;

/// A subexpression of the formula.
struct Term {
    std::size_t begin = 0;  ///< its first character in the text
    std::string formula;    ///< for muParser, in SI units, every operation in parentheses
    std::string in_si;      ///< the same with units
    Dimension dimension;
    bool zero = false;               ///< a bare 0, which has any dimension
    std::optional<double> constant;  ///< its value if it contains no variable
};

/// Recursive-descent parser for the grammar in the header, one function per precedence level.
class FormulaReader {
  public:
    explicit FormulaReader(const WrittenText& text, PlacesKnown places = PlacesKnown::now)
        : text_(text), all_(text.text), places_(places) {}

    Term read() {
        Term whole = choice();
        if (at() < all_.size()) fail(at(), "unexpected " + shown(at()), "check the operators and parentheses");
        return whole;
    }

    [[noreturn]] void fail(std::size_t offset, const std::string& what, const std::string& what_to_do) const {
        throw InputError(text_.at(offset), what + " in \"" + text_.text + "\"", what_to_do);
    }

  private:
    using Level = Term (FormulaReader::*)();

    Term choice() {
        const Nesting nesting(*this);
        Term condition = disjunction();
        if (!take("?")) return condition;
        need_number(condition, "the condition before '?'");
        const Term yes = choice();
        const std::size_t colon = at();
        if (!take(":")) fail(colon, "expected ':' but found " + shown(colon), "write condition ? value : other value");
        const Term no = choice();
        Term result;
        result.begin = condition.begin;
        result.dimension = common(yes, no, colon, "':'");
        result.zero = yes.zero && no.zero;
        result.formula = "(" + condition.formula + "?" + yes.formula + ":" + no.formula + ")";
        result.in_si = "(" + condition.in_si + "?" + yes.in_si + ":" + no.in_si + ")";
        return result;
    }

    Term disjunction() { return logical({"||"}, &FormulaReader::conjunction); }
    Term conjunction() { return logical({"&&"}, &FormulaReader::comparison); }

    Term logical(std::string_view sign, Level next) {
        Term left = (this->*next)();
        while (take(sign)) {
            const Term right = (this->*next)();
            need_number(left, "the left of '" + std::string(sign) + "'");
            need_number(right, "the right of '" + std::string(sign) + "'");
            left = joined(left, sign, right, {});
        }
        return left;
    }

    Term comparison() {
        Term left = sum();
        while (true) {
            const std::size_t location = at();
            const auto sign = take_one_of({"<=", ">=", "==", "!=", "<", ">"});
            if (sign.empty()) return left;
            const Term right = sum();
            static_cast<void>(common(left, right, location, "'" + std::string(sign) + "'"));  // for the check only
            left = joined(left, sign, right, {});
        }
    }

    Term sum() {
        Term left = product();
        while (true) {
            const std::size_t location = at();
            const auto sign = take_one_of({"+", "-"});
            if (sign.empty()) return left;
            const Term right = product();
            const Dimension dimension = common(left, right, location, "'" + std::string(sign) + "'");
            const bool zero = left.zero && right.zero;
            auto constant = left.constant;
            if (constant && right.constant) *constant += sign == "+" ? *right.constant : -*right.constant;
            if (!right.constant) constant.reset();
            left = joined(left, sign, right, dimension);
            left.zero = zero;
            left.constant = constant;
        }
    }

    Term product() {
        Term left = signed_term();
        while (true) {
            const auto sign = take_one_of({"*", "/"});
            if (sign.empty()) return left;
            const Term right = signed_term();
            const bool times = sign == "*";
            const Dimension dimension = times ? left.dimension * right.dimension : left.dimension / right.dimension;
            auto constant = left.constant;
            if (constant && right.constant) *constant *= times ? *right.constant : 1 / *right.constant;
            if (!right.constant) constant.reset();
            left = joined(left, sign, right, dimension);
            left.constant = constant;
        }
    }

    Term signed_term() {
        const Nesting nesting(*this);
        const std::size_t begin = at();
        const auto sign = take_one_of({"-", "+"});
        if (sign.empty()) return power();
        Term term = signed_term();
        term.begin = begin;
        if (sign == "+") return term;
        if (term.constant) *term.constant *= -1;
        term.formula = "(-" + term.formula + ")";
        term.in_si = "(-" + term.in_si + ")";
        return term;
    }

    Term power() {
        Term base = primary();
        const std::size_t location = at();
        if (!take("^")) return base;
        const Term exponent = signed_term();
        need_number(exponent, "the exponent after '^'");
        Dimension dimension;
        if (!base.dimension.none()) {
            const auto raised = exponent.constant ? base.dimension.to_the(*exponent.constant) : std::nullopt;
            if (!raised) {
                fail(location,
                     base.dimension.name_with_article() + " is raised to " +
                         (exponent.constant ? "a power that leaves no "
                                              "whole or half unit"
                                            : "a power that is not constant"),
                     "use a constant exponent such as 2 or 0.5, or divide by a quantity first");
            }
            dimension = *raised;
        }
        Term result = joined(base, "^", exponent, dimension);
        if (base.constant && exponent.constant) result.constant = std::pow(*base.constant, *exponent.constant);
        return result;
    }

    Term primary() {
        const std::size_t begin = at();
        if (end_of_number(all_, begin) > begin) return number();
        const std::size_t name_end = end_of_name(all_, begin);
        if (name_end > begin) {
            const std::size_t next = skip_spaces(all_, name_end);
            const bool call = next < all_.size() && all_[next] == '(';
            return call ? function(begin, name_end) : name(begin, name_end);
        }
        if (!take("(")) {
            fail(begin, begin < all_.size() ? "unexpected " + shown(begin) : "the formula ends too early",
                 "expected a number, a name or '(' here");
        }
        Term inside = choice();
        close(begin);
        inside.begin = begin;
        return inside;
    }

    Term number() {
        const std::size_t begin = at();
        position_ = end_of_number(all_, begin);
        const auto digits = all_.substr(begin, position_ - begin);
        Unit unit;
        bool with_unit = false;
        if (const auto reading = read_unit_greedily(text_, at(), is_value)) {
            unit = reading->unit;
            position_ = reading->end;
            with_unit = true;
        }
        refuse_missing_operator(std::string(digits), with_unit);

        Term term;
        term.begin = begin;
        term.constant = in_si(digits, unit, text_.at(begin));
        term.dimension = unit.dimension;
        term.zero = !with_unit && *term.constant == 0;
        term.formula = exact_text(*term.constant);
        term.in_si = unit.dimension.none() ? term.formula : "(" + term.formula + " " + unit.dimension.si_unit() + ")";
        return term;
    }

    /// Throws if a number is not followed by an operator, a parenthesis or the end.
    void refuse_missing_operator(const std::string& digits, bool with_unit) const {
        const std::size_t next = at();
        const std::size_t name_end = end_of_name(all_, next);
        const std::string name(all_.substr(next, name_end - next));
        if (!name.empty()) {
            const std::size_t after = skip_spaces(all_, name_end);
            const bool call = after < all_.size() && all_[after] == '(';
            if (with_unit || call || is_value(name)) {
                fail(next, "missing operator before '" + name + "'", "write * or / between them");
            }
            const std::string nearest = nearest_unit(name);
            fail(next, "unknown unit '" + name + "' after " + digits,
                 nearest.empty() ? "units are written like m/s^2, with the SI symbols and prefixes"
                                 : "did you mean '" + nearest + "'?");
        }
        if (end_of_number(all_, next) > next || (next < all_.size() && all_[next] == '(')) {
            fail(next, "missing operator before " + shown(next), "write an operator such as * or / there");
        }
    }

    Term name(std::size_t begin, std::size_t end) {
        const std::string word(all_.substr(begin, end - begin));
        position_ = end;
        Term term;
        term.begin = begin;
        term.formula = term.in_si = word;
        if (word == "pi") {
            term.constant = std::numbers::pi;
            return term;
        }
        const auto* const found =
            std::find_if(variables.begin(), variables.end(), [&](auto& v) { return v.name == word; });
        if (found != variables.end()) {
            term.dimension = found->dimension;
            return term;
        }
        if (is_initial_position(word)) {
            switch (places_) {
                case PlacesKnown::now:
                    fail(begin, "'" + word + "' is a place in the initial state, which only a [[force]] knows",
                         "write x, y or z for the present place, or leave it out");
                case PlacesKnown::now_and_at_start:
                    term.dimension = length;
                    return term;
            }
        }
        if (unit_symbol(word)) fail(begin, "the unit '" + word + "' stands without a number", "write 1 " + word);
        const auto nearest = nearest_name(word, known_names());
        fail(begin, "unknown name '" + word + "'",
             nearest.empty() ? "use t, x, y, z, pi or functions such as sin, exp, sqrt, min"
                             : "did you mean '" + nearest + "'?");
    }

    Term function(std::size_t begin, std::size_t end) {
        const std::string word(all_.substr(begin, end - begin));
        const auto* const found =
            std::find_if(functions.begin(), functions.end(), [&](auto& f) { return f.name == word; });
        if (found == functions.end()) {
            if (is_variable_or_constant(word)) {
                fail(end, "missing operator after '" + word + "'", "write * between '" + word + "' and '('");
            }
            const auto nearest = nearest_name(word, known_names());
            fail(begin, "unknown function '" + word + "'",
                 nearest.empty() ? "use sin, cos, tan, exp, ln, sqrt, abs, min, max, tanh or other functions"
                                 : "did you mean '" + nearest + "'?");
        }
        position_ = end;
        const std::size_t parenthesis = at();
        take("(");
        std::vector<Term> arguments;
        if (at() < all_.size() && all_[at()] != ')') {
            do {
                arguments.push_back(choice());
            } while (take(","));
        }
        close(parenthesis);
        if (arguments.size() < found->fewest || arguments.size() > found->most) {
            fail(begin, word + " is given " + std::to_string(arguments.size()) + " values",
                 found->most == any_count ? "give it one or more, joined by commas"
                                          : "give it " + std::to_string(found->fewest));
        }
        return called(*found, begin, arguments);
    }

    Term called(const Function& function, std::size_t begin, const std::vector<Term>& arguments) {
        const std::string word(function.name);
        Term result;
        result.begin = begin;
        result.formula = result.in_si = word + "(";
        Term like = arguments[0];
        for (const Term& argument : arguments) {
            if (function.rule == Rule::number_to_number) need_number(argument, word);
            like.dimension = common(like, argument, argument.begin, word);
            like.zero = like.zero && argument.zero;
            result.formula += (&argument == arguments.data() ? "" : ",") + argument.formula;
            result.in_si += (&argument == arguments.data() ? "" : ",") + argument.in_si;
        }
        result.formula += ")";
        result.in_si += ")";
        if (function.rule == Rule::keeps || function.rule == Rule::like_to_same) result.dimension = like.dimension;
        if (function.rule == Rule::square_root) {
            const auto root = like.dimension.to_the(0.5);
            if (!root) {
                fail(arguments[0].begin,
                     "sqrt is given " + like.dimension.name_with_article() + ", whose root has no unit",
                     "take the root of a quantity whose unit is a whole power");
            }
            result.dimension = *root;
        }
        return result;
    }

    /// The common dimension of two terms. Throws if their dimensions differ and neither is a bare 0.
    [[nodiscard]] Dimension common(const Term& a, const Term& b, std::size_t location, const std::string& by) const {
        if (a.zero) return b.dimension;
        if (b.zero || a.dimension == b.dimension) return a.dimension;
        fail(location, by + " joins " + a.dimension.name_with_article() + " and " + b.dimension.name_with_article(),
             "both need the same dimension");
    }

    void need_number(const Term& term, const std::string& by) const {
        if (term.dimension.none()) return;
        fail(term.begin, by + " is given " + term.dimension.name_with_article() + ", expected a plain number",
             "divide it by a quantity of the same dimension, such as 1 " + term.dimension.si_unit());
    }

    static Term joined(const Term& left, std::string_view sign, const Term& right, Dimension dimension) {
        Term result;
        result.begin = left.begin;
        result.formula = "(" + left.formula + std::string(sign) + right.formula + ")";
        result.in_si = "(" + left.in_si + std::string(sign) + right.in_si + ")";
        result.dimension = dimension;
        return result;
    }

    void close(std::size_t opened) {
        if (!take(")")) {
            fail(at(), "expected ')' but found " + shown(at()),
                 "close the parenthesis opened at character " + std::to_string(opened + 1) + " of the formula");
        }
    }

    /// Start of the next token.
    [[nodiscard]] std::size_t at() const { return skip_spaces(all_, position_); }

    bool take(std::string_view sign) {
        const std::size_t begin = at();
        if (!all_.substr(begin).starts_with(sign)) return false;
        position_ = begin + sign.size();
        return true;
    }

    std::string_view take_one_of(std::initializer_list<std::string_view> signs) {
        for (const auto sign : signs) {
            if (take(sign)) return sign;
        }
        return {};
    }

    /// The token at `offset`, for a message.
    [[nodiscard]] std::string shown(std::size_t offset) const {
        if (offset >= all_.size()) return "the end";
        const std::size_t end = std::max({end_of_number(all_, offset), end_of_name(all_, offset), offset + 1});
        return "'" + std::string(all_.substr(offset, end - offset)) + "'";
    }

    /// Limits the recursion depth, so that ten thousand parentheses are an error instead of a stack overflow.
    class Nesting {
      public:
        explicit Nesting(FormulaReader& reader) : reader_(reader) {
            if (++reader_.depth_ > 200) {
                reader_.fail(reader_.at(), "more than 200 parentheses and signs inside each other",
                             "use fewer levels of parentheses");
            }
        }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;
        ~Nesting() { --reader_.depth_; }

      private:
        FormulaReader& reader_;
    };

    const WrittenText& text_;
    std::string_view all_;
    PlacesKnown places_;
    std::size_t position_ = 0;
    int depth_ = 0;
};

Expression compiled(const Term& whole, const WrittenText& text, const std::string& subject) {
    try {
        return Expression(whole.formula, text.text, whole.in_si);
    } catch (const std::invalid_argument& error) {
        throw InputError(text.location, subject + ": the formula cannot be evaluated: " + error.what(),
                         "write a shorter formula");
    }
}

}  // namespace

Expression read_formula(const WrittenText& text, const Expected& expected, const std::string& subject,
                        PlacesKnown places) {
    FormulaReader reader(text, places);
    const Term whole = reader.read();
    if (!whole.zero && whole.dimension != expected.dimension()) {
        if (is_bare_number(text.text)) throw expected.missing_unit(text.location, text.text, subject);
        throw InputError(
            text.at(skip_spaces(text.text, 0)),
            subject + ": found \"" + text.text + "\" (" + whole.dimension.name() + "), expected " + expected.phrase(),
            "check the units of its factors: the whole formula must be " + expected.dimension().name_with_article());
    }
    return compiled(whole, text, subject);
}

Expression read_formula(const WrittenText& text, const std::string& subject) {
    return compiled(FormulaReader(text).read(), text, subject);
}

bool is_formula_word(std::string_view name) {
    return unit_symbol(name) || is_variable_or_constant(name) ||
           std::ranges::find(functions, name, &Function::name) != functions.end();
}

Quantity constant_formula(const WrittenText& text, const std::string& subject) {
    const Term whole = FormulaReader(text).read();
    const Expression expression = compiled(whole, text, subject);
    if (expression.depends_on_time() || expression.depends_on_position())
        throw InputError(text.location, subject + ": \"" + text.text + "\" depends on t, x, y or z",
                         "give a formula of numbers");
    const double value = expression(0);
    if (!std::isfinite(value))
        throw InputError(text.location, subject + ": \"" + text.text + "\" is no finite number",
                         "check for a division by zero, or a root or logarithm of a negative number");
    return {value, whole.dimension};
}

}  // namespace dmp::scene
