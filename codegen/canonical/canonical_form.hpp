#pragma once

#include <ginac/ginac.h>

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "codegen/canonical/rational_function.hpp"
#include "perturb/symbol_table.hpp"

namespace secular {

/// The canonical form of a real rational expression in `order`'s symbols ("pi" stands for GiNaC's Pi). This and
/// canonical_model.cpp are the only places where an expression leaves GiNaC. Throws std::logic_error for anything
/// that is not a real rational function of these symbols.
class CanonicalForm {
 public:
  CanonicalForm(const SymbolTable& symbols, const SymbolOrder& order);
  RationalFunction of(const GiNaC::ex& expression) const;

 private:
  using Terms = std::map<std::vector<int>, GiNaC::numeric, std::greater<>>;  ///< coefficients by exponents
  template <class Taken>
  GiNaC::ex split(const GiNaC::ex& product, std::vector<int>& exponents, const Taken& taken) const;
  void add_terms(const GiNaC::ex& expanded, const std::vector<int>& common, Terms& terms) const;
  void mark_denominators(const GiNaC::ex& expression, std::vector<bool>& marked) const;
  using Groups = std::map<std::vector<int>, GiNaC::exvector>;
  bool add_factored(const Groups& groups, Terms& above, Terms& below) const;
  void lowest_terms(const GiNaC::ex& expanded, Terms& above, Terms& below) const;

  std::map<GiNaC::ex, std::size_t, GiNaC::ex_is_less> place_;  ///< of a symbol in the order
  GiNaC::symbol pi_{"pi"};
};

}  // namespace secular
