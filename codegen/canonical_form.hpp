#pragma once

#include <ginac/ginac.h>

#include "codegen/rational_function.hpp"
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
  std::vector<PolynomialTerm> polynomial(const GiNaC::ex& expanded, GiNaC::numeric& content) const;
  std::vector<GiNaC::ex> symbols_;
  GiNaC::symbol pi_{"pi"};
};

}  // namespace secular
