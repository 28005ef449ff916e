#pragma once

#include <map>
#include <vector>

#include "codegen/canonical/rational_function.hpp"

namespace secular {

/// Sum of rational functions of the parameters times integer powers of variables (amplitudes, excitations, a
/// detuning): sum_i c_i v_1^n_i1 v_2^n_i2 ... What the variables are is told by whoever makes the sum.
class VariableSum {
 public:
  using Powers = std::vector<int>;

  /// Coefficients of one product of powers whose denominators do not fit together stay apart.
  void add(const Powers& powers, const RationalFunction& coefficient);
  void add(const VariableSum& other, long numerator = 1, long denominator = 1);

  const std::map<Powers, std::vector<RationalFunction>>& terms() const { return terms_; }
  bool empty() const { return terms_.empty(); }
  /// Exactly zero, also where denominators do not fit together.
  bool is_zero() const;
  /// Whether a coefficient depends on the symbol, by its index in the order.
  bool depends_on_symbol(std::size_t symbol) const;
  /// Whether a term holds a power of the variable.
  bool depends_on_variable(std::size_t variable) const;
  /// Lowest power of a variable; 0 without terms.
  int lowest_power(std::size_t variable) const;

  /// Derivative by one variable, the others constant.
  VariableSum derivative(std::size_t variable) const;
  /// Times a power of one variable.
  VariableSum times_power(std::size_t variable, int power) const;
  friend VariableSum operator*(const VariableSum& a, const VariableSum& b);
  friend VariableSum operator+(VariableSum a, const VariableSum& b);
  friend VariableSum operator-(VariableSum a, const VariableSum& b);

 private:
  std::map<Powers, std::vector<RationalFunction>> terms_;
};

}  // namespace secular
