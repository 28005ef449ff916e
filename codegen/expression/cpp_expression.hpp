#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "codegen/canonical/rational_function.hpp"

namespace secular {

/// Writes rational functions as C++, sharing powers and divisors: omega0^3 becomes omega0_3, 1/(omega1 - 2*omega2)
/// per_0, its square per_0_2, a product of several such over_0. `scalar`: their type.
class CppWriter {
 public:
  CppWriter(SymbolOrder order, std::string scalar);

  /// The expression in C++. Powers above one and divisors are asked for as temporaries, see definitions().
  std::string expression(const RationalFunction& value);
  /// The number of a divisor, which makes its name: per_0.
  std::size_t number_of(const std::shared_ptr<const std::vector<PolynomialTerm>>& divisor);
  /// Declarations of every temporary that expressions so far need, one a line, dependencies first.
  std::vector<std::string> definitions() const;
  /// Symbols that expressions used, in declared order.
  std::vector<std::string> used_symbols() const;

 private:
  struct Divisor {
    std::shared_ptr<const std::vector<PolynomialTerm>> sum;
    std::string text;
    int highest_power = 1;
  };
  struct Before {
    using Sum = std::shared_ptr<const std::vector<PolynomialTerm>>;
    bool operator()(const Sum& a, const Sum& b) const { return a != b && compare(*a, *b) < 0; }
  };
  std::string power(std::size_t symbol, int exponent);
  std::string polynomial(const std::vector<PolynomialTerm>& terms, bool& single);
  std::string fraction(const Fraction& part, bool& negative);
  std::string divided_by(const std::vector<DivisorPower>& divisors);

  SymbolOrder order_;
  std::string scalar_;
  std::vector<int> highest_power_;
  std::vector<Divisor> divisors_;
  std::vector<std::string> products_;  ///< of inverse divisors
  std::map<Before::Sum, std::size_t, Before> number_of_;
};

/// A local variable's name for a model's symbol: the symbol itself, or s_NAME_s where C++, a macro or the generated
/// code itself might use the name. Symbols are letters, digits and '_'; different symbols get different names.
std::string safe_identifier(const std::string& symbol);

/// The same for a namespace named after a model or a case.
std::string safe_namespace(const std::string& name);

/// A rational function as model text: "3*alpha3/8 - ...", parseable by the model reader (pi written Pi).
std::string formula_text(const RationalFunction& value, const SymbolOrder& order);

}  // namespace secular
