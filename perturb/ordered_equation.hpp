#pragma once

#include <map>
#include <string>
#include <vector>

#include "perturb/term_sum.hpp"

namespace secular {

/// One term of an equation of motion moved to the right-hand side, with the power of eps it carries in a case.
struct OrderedTerm {
  FactorProduct factors;
  int order = 0;
  GiNaC::ex coefficient;
};

/// A function of an equation and the power of coordinates and velocities to which its series counts in a case.
struct ExpandedFunction {
  SmoothFunction function;
  int degree = 0;
};

/// D2(v) + omega^2 v = sum of terms.
struct OrderedEquation {
  std::vector<OrderedTerm> right_hand_side;
  std::vector<ExpandedFunction> expanded;
};

/// Assigns powers of eps by the case's `order` table (or by degree) and checks that what is left at order 0 is the
/// linear oscillator D2(v) + omega^2*v, plus possibly hard forcing. Smooth functions are expanded about rest; the
/// terms that a term with a function is expanded into are ordered by degree in every case: their degree in
/// coordinates and velocities minus one, plus the orders of coefficients. Terms with an excitation are left out
/// where the case is not excited. Throws InputError for a coefficient symbol without an order, and for any other
/// term at order 0.
std::vector<OrderedEquation> ordered_equations(const Model& model, const ResonanceCase& resonance);

/// The argument of a nonsmooth factor as model text: "v - gap", "D(v1) + 1/2*D(v2)".
std::string argument_text(const std::map<std::string, Factor::Weight>& argument);

/// A factor product as the model text writes it, for messages: "v*D2(v)".
std::string to_string(const FactorProduct& product, const Model& model);

}  // namespace secular
