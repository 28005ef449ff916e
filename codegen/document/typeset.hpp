#pragma once

#include <string>
#include <vector>

#include "codegen/canonical/rational_function.hpp"
#include "codegen/document/symbol_name.hpp"

/// Formulas as trees of what is printed, not of what is computed: built once, rendered as LaTeX or MathML.
namespace secular::typeset {

struct Expression {
  enum class Kind {
    number,       ///< text: digits
    symbol,       ///< text: a model's identifier, see symbol_name()
    constant,     ///< text: "i", "e", "d" (upright), "partial"
    words,        ///< text: upright text within a formula
    indexed,      ///< symbol parts[0] with the subscripts parts[1], parts[2], ...
    accent,       ///< over the symbol parts[0]; text: "bar", "dot", "ddot", "hat"
    product,      ///< parts side by side
    fraction,     ///< parts[0] over parts[1]
    power,        ///< parts[0] to the power `exponent`
    sum,          ///< parts, each with a sign
    bracket,      ///< (parts[0])
    modulus,      ///< |parts[0]|
    mean,         ///< <parts[0]>
    root,         ///< square root of parts[0]
    function,     ///< text(parts[0]): "cos", "sin", "sgn"
    exponential,  ///< e to the power parts[0]
  };
  Kind kind = Kind::number;
  std::string text;
  std::vector<Expression> parts;
  std::vector<bool> negative;  ///< of a sum, by part
  int exponent = 1;
  bool verbatim = false;  ///< of a symbol: another one would look the same
  bool operator==(const Expression&) const = default;
};

/// One expression of each kind, see Expression::Kind.
Expression number(long value);  ///< not negative
Expression symbol(std::string identifier);
Expression constant(std::string name);
Expression words(std::string text);
Expression indexed(Expression symbol, std::vector<Expression> subscripts);
Expression accent(std::string mark, Expression symbol);
Expression fraction(Expression above, Expression below);
Expression bracket(Expression inner);
Expression modulus(Expression inner);
Expression mean(Expression inner);
Expression root(Expression inner);
Expression function(std::string name, Expression argument);
Expression exponential(Expression exponent);
/// `base` itself for power 1; sums, products and fractions get brackets.
Expression power(Expression base, int exponent);
/// How a symbol is written.
SymbolName name_of(const Expression& symbol);
/// A name of several letters, which needs space around it.
bool is_word(const Expression& formula);
/// Holds a fraction on its main line.
bool is_tall(const Expression& formula);
/// d`quantity`/dt.
Expression rate_of(Expression quantity);

/// A product written factor by factor; the factors of a product become its own, negative powers go below a fraction
/// line.
class Product {
 public:
  Product& times(Expression factor, int exponent = 1);
  bool empty() const { return above_.empty() && below_.empty(); }
  /// 1 without factors. A sum among several factors gets brackets.
  Expression expression() const;

 private:
  std::vector<Expression> above_, below_;
};

/// A sum written term by term, with the signs of the coefficients drawn out.
class Sum {
 public:
  explicit Sum(const SymbolOrder& order) : order_(&order) {}
  /// Adds coefficient * (i) * factors; a polynomial standing alone adds its terms one by one, a sum of fractions
  /// these.
  Sum& add(const RationalFunction& coefficient, const Product& factors = {}, bool imaginary = false);
  Sum& add(Expression term, bool negative);
  bool empty() const { return sum_.parts.empty(); }
  /// 0 without terms, the term itself if it is one positive term.
  Expression expression() const;

 private:
  Sum& add(const Fraction& value, const Product& factors, bool imaginary);

  const SymbolOrder* order_;
  Expression sum_{Expression::Kind::sum, {}, {}, {}, 1, false};
};

/// A rational function alone.
Expression expression_of(const RationalFunction& value, const SymbolOrder& order);

struct Equation {
  Expression left, right;
};

}  // namespace secular::typeset
