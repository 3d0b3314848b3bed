// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/expression.hpp"

#include <array>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <muParser.h>

namespace dmp::scene {

namespace {

constexpr std::array variable_names = {"t", "x", "y", "z", "X", "Y", "Z"};

}  // namespace

/// muParser with its variables, whose addresses must not change.
struct Expression::Parser {
    mu::Parser parser;
    std::array<double, variable_names.size()> values{};

    explicit Parser(const std::string& formula) {
        try {
            parser.DefineConst("pi", std::numbers::pi);
            for (std::size_t k = 0; k < variable_names.size(); ++k)
                parser.DefineVar(variable_names.at(k), &values.at(k));
            parser.SetExpr(formula);
            // Only once: GetUsedVar() makes muParser compile the formula again.
            const auto used = parser.GetUsedVar();
            for (std::size_t k = 0; k < variable_names.size(); ++k) uses.at(k) = used.contains(variable_names.at(k));
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

    std::array<bool, variable_names.size()> uses{};
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
    return at(t, Vec(x, y, z), Vec(x, y, z));
}

double Expression::at(double t, const Vec& now, const Vec& at_start) const {
    if (!parser_) return 0;
    parser_->values = {t, now[0], now[1], now[2], at_start[0], at_start[1], at_start[2]};
    return parser_->parser.Eval();
}

bool Expression::depends_on(std::string_view variable) const {
    for (std::size_t k = 0; k < variable_names.size(); ++k)
        if (variable_names.at(k) == variable) return parser_ && parser_->uses.at(k);
    return false;
}

bool Expression::depends_on_position() const { return depends_on("x") || depends_on("y") || depends_on("z"); }

bool Expression::depends_on_initial_position() const { return depends_on("X") || depends_on("Y") || depends_on("Z"); }

}  // namespace dmp::scene
