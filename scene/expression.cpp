// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/expression.hpp"

#include <array>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <muParser.h>

namespace dmp::scene {

/// muParser with its variables, whose addresses must not change.
struct Expression::Parser {
    mu::Parser parser;
    std::array<double, 4> values{};  // t, x, y, z

    explicit Parser(const std::string& formula) {
        try {
            parser.DefineConst("pi", std::numbers::pi);
            parser.DefineVar("t", values.data());
            parser.DefineVar("x", &values[1]);
            parser.DefineVar("y", &values[2]);
            parser.DefineVar("z", &values[3]);
            parser.SetExpr(formula);
            // Only once: GetUsedVar() makes muParser compile the formula again.
            const auto used = parser.GetUsedVar();
            uses_time = used.contains("t");
            uses_position = used.contains("x") || used.contains("y") || used.contains("z");
            parser.Eval();  // muParser compiles and reports errors at the first evaluation
        } catch (const mu::Parser::exception_type& error) {
            throw std::invalid_argument(error.GetMsg());
        }
    }
    Parser(const Parser&) = delete;
    Parser& operator=(const Parser&) = delete;
    Parser(Parser&&) = delete;
    Parser& operator=(Parser&&) = delete;
    ~Parser() = default;

    bool uses_time = false, uses_position = false;
};

Expression::Expression() : formula_("0"), as_written_("0"), in_si_("0") {}

Expression::Expression(std::string formula, std::string as_written, std::string in_si)
    : formula_(std::move(formula)),
      as_written_(std::move(as_written)),
      in_si_(in_si.empty() ? as_written_ : std::move(in_si)),
      parser_(std::make_unique<Parser>(formula_)) {}

// A copy compiles its own parser, so that copies do not share variables.
Expression::Expression(const Expression& other)
    : formula_(other.formula_),
      as_written_(other.as_written_),
      in_si_(other.in_si_),
      parser_(other.parser_ ? std::make_unique<Parser>(formula_) : nullptr) {}

Expression::Expression(Expression&& other) noexcept = default;

Expression& Expression::operator=(const Expression& other) {
    if (this != &other) *this = Expression(other);
    return *this;
}

Expression& Expression::operator=(Expression&& other) noexcept = default;
Expression::~Expression() = default;

double Expression::operator()(double t, double x, double y, double z) const {
    if (!parser_) return 0;
    parser_->values = {t, x, y, z};
    return parser_->parser.Eval();
}

bool Expression::depends_on_time() const { return parser_ && parser_->uses_time; }

bool Expression::depends_on_position() const { return parser_ && parser_->uses_position; }

}  // namespace dmp::scene
