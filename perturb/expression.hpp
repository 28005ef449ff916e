#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace secular {

/// Where a piece of model text stands: file, line and column (from 1).
struct SourcePlace {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

/// A parsed formula: plain data, no algebra. Two readers that share nothing walk it: the derivation (through
/// TermSum) and the certificate (through its own series arithmetic).
struct Expression {
  enum class Kind { number, symbol, sum, product, quotient, power, negation, call };
  Kind kind = Kind::number;
  SourcePlace place;
  std::string text;  ///< number: its digits as written; symbol: its name; call: the function's name
  std::vector<Expression> operands;
};

/// "left = right", or `left` alone with `right` absent.
struct Equation {
  Expression left;
  std::vector<Expression> right;  ///< empty or one
};

/// The text of a formula with the place it was read from, for messages.
struct FormulaSource {
  std::string text;
  std::string file;
  std::uint32_t first_line = 1;
};

/// A function that a formula may call, with its number of arguments.
struct FormulaFunction {
  std::string_view name;
  std::size_t arguments = 1;
};

/// Those of equations of motion: D, D2, abs, sgn, cos, sin, tan, exp, sinh, cosh, tanh, log, atan, sqrt of one
/// argument, max and min of two.
std::span<const FormulaFunction> equation_functions();

/// Parses + - * / ^ ( ) numbers, identifiers and calls f(x) or f(x, y). Powers bind tighter than a leading minus
/// and to the right, as in GiNaC. Throws InputError with line and column for anything else, and for nesting deeper
/// than 200.
Expression parse_expression(const FormulaSource& source,
                            std::span<const FormulaFunction> functions = equation_functions());

/// Same, with exactly one '=' at top level.
Equation parse_equation(const FormulaSource& source);

/// Every identifier of the formula that is not a function name, in order of first appearance.
std::vector<std::string> identifiers(const Expression& expression);

/// Throws InputError at an expression's place.
[[noreturn]] void fail_at(const FormulaSource& source, const SourcePlace& place, const std::string& wrong,
                          const std::string& right = {});

}  // namespace secular
