#pragma once

#include <string>
#include <vector>

#include "codegen/canonical/rational_function.hpp"

namespace secular {

/// Writes rational functions as C++ (or as readable text), sharing powers: omega0^3 becomes the temporary omega0_3.
class CppWriter {
 public:
  /// `prefix` stands before symbols in code ("p." for a struct member, "" for local variables).
  CppWriter(SymbolOrder order, std::string scalar);

  /// The expression in C++. Powers above one are asked for as temporaries, see definitions().
  std::string expression(const RationalFunction& value);
  /// Declarations of every temporary that expressions since the last clear() need, one a line, dependencies first.
  std::vector<std::string> definitions() const;
  /// Symbols that expressions used, in declared order.
  std::vector<std::string> used_symbols() const;
  /// Multiplications, divisions and additions of everything written so far.
  int operations() const { return operations_; }

 private:
  std::string power(std::size_t symbol, int exponent);
  std::string polynomial(const std::vector<PolynomialTerm>& terms, bool& single);

  SymbolOrder order_;
  std::string scalar_;
  std::vector<int> highest_power_;
  int operations_ = 0;
};

/// A local variable's name for a model's symbol: the symbol itself, or s_NAME_s where C++, a macro or the generated
/// code itself might use the name. Symbols are letters, digits and '_'; different symbols get different names.
std::string safe_identifier(const std::string& symbol);

/// The same for a namespace named after a model or a case.
std::string safe_namespace(const std::string& name);

/// A rational function as model text: "3*alpha3/8 - ...", parseable by the model reader (pi written Pi).
std::string formula_text(const RationalFunction& value, const SymbolOrder& order);

}  // namespace secular
