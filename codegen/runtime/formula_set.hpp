#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "codegen/canonical/rational_function.hpp"

namespace secular {

/// Rational functions prepared for evaluation in double precision, in the same order of operations as generated
/// code: powers by repeated multiplication, products from left to right, sums from the first term, divisors
/// inverted once.
class FormulaSet {
 public:
  /// `symbols`: how many the formulas' exponents refer to.
  explicit FormulaSet(std::size_t symbols) : symbols_(symbols), highest_power_(symbols, 0) {}

  /// Adds a formula and returns its index.
  std::size_t add(const RationalFunction& formula);

  /// Values of the formulas at one point.
  class Values {
   public:
    /// `symbol_values` by index of the symbols.
    Values(const FormulaSet& set, const double* symbol_values);
    double operator[](std::size_t formula) const;

   private:
    double polynomial(std::size_t begin, std::size_t end) const;
    void raise(std::size_t symbol, double value);
    const FormulaSet& set_;
    std::size_t stride_;
    std::vector<double> powers_;  ///< [symbol, then inverse of a divisor][exponent - 1]
  };

 private:
  struct Factor {
    std::size_t symbol = 0, exponent = 1;
  };
  struct Term {
    double coefficient = 1;
    std::size_t begin = 0, end = 0;  ///< of its factors
  };
  struct Formula {
    std::size_t numerator = 0, denominator = 0, end = 0;  ///< of its terms
    bool divides = false;
  };
  void add_terms(const std::vector<PolynomialTerm>& terms);
  std::size_t divisor(const std::shared_ptr<const std::vector<PolynomialTerm>>& sum);

  struct Divisor {
    std::size_t begin = 0, end = 0;  ///< of its terms
  };

  std::size_t symbols_;
  std::vector<std::size_t> highest_power_;  ///< of symbols, then of inverses of divisors
  std::map<std::vector<std::pair<std::string, std::vector<int>>>, std::size_t> number_of_;  ///< of a divisor
  std::vector<Divisor> divisors_;
  std::vector<Factor> factors_;
  std::vector<Term> terms_;
  std::vector<Formula> formulas_;
};

}  // namespace secular
