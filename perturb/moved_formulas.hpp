#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "perturb/model.hpp"
#include "perturb/rest_position.hpp"

namespace secular {

/// Formulas of a model whose coordinates come to count from its rest position: x_rest + x stands for x. Functions
/// become functions of what is zero at rest, by their addition theorems, with their values at rest as symbols:
///   sin(x_rest + x) = sin_x_rest*cos(x) + cos_x_rest*sin(x).
/// And formulas stand for the coefficients that follow from the rest position.
class MovedFormulas {
 public:
  /// `rest`: by mode, the symbol of its rest position; empty where that is zero.
  /// `taken`: names that no value of a function may have.
  MovedFormulas(const Model& model, std::vector<std::string> rest, const SymbolTable& taken)
      : model_(model), rest_(std::move(rest)), taken_(taken) {}

  void replace(const std::string& coefficient, Expression by) { replaced_[coefficient] = std::move(by); }

  /// Throws InputError for functions that have no such form.
  Expression moved(const Expression& e, const FormulaSource& source);
  Model moved(const Model& stated);

  /// Of all functions so far.
  const std::vector<RestValue>& values() const { return values_; }

 private:
  bool moves(const Expression& e) const;
  std::optional<Expression> at_rest(const Expression& e, const FormulaSource& source);
  Expression from_rest(const Expression& e, const FormulaSource& source);
  Expression moved_symbol(const Expression& e) const;
  Expression moved_call(const Expression& e, const FormulaSource& source);
  Expression moved_power(const Expression& e, std::pair<long, long> exponent, const FormulaSource& source);
  void refuse_corner(const Expression& e, const FormulaSource& source) const;
  Expression value_of(SmoothKind kind, std::pair<long, long> exponent, const Expression& argument,
                      const SourcePlace& place);

  const Model& model_;
  std::vector<std::string> rest_;
  const SymbolTable& taken_;
  std::map<std::string, Expression> replaced_;
  std::vector<RestValue> values_;
};

}  // namespace secular
