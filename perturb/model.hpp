#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "perturb/expression.hpp"
#include "perturb/symbol_table.hpp"

namespace secular {

/// One degree of freedom and its equation of motion. For a Lagrangian model `equation` is absent and `force` is the
/// non-conservative right-hand side.
struct Mode {
  std::string coordinate;
  std::string frequency;  ///< symbol of the natural frequency
  FormulaSource source;
  std::optional<Equation> equation;
  std::optional<Expression> force;
};

/// F*cos(Omega*t): `amplitude` is F, `frequency` is Omega.
struct Excitation {
  std::string amplitude;
  std::string frequency;
};

/// Multiples of frequencies that formulas may hold: far beyond any harmonic that is measured, and small enough for
/// powers of such terms to be counted in an int.
inline constexpr int largest_multiple = 1000;

/// An integer relation between frequencies: sum_j multiples[j] * f_j = coefficient * eps^order * detuning, over the
/// natural frequencies and then the excitation frequencies.
struct ResonanceRelation {
  std::vector<int> multiples;
  std::string detuning;  ///< empty: exactly resonant
  int order = 0;
  GiNaC::numeric coefficient = 1;
  std::string text;
  std::uint32_t line = 0;
};

struct ResonanceCase {
  std::string name;
  std::vector<ResonanceRelation> relations;
  std::map<std::string, int> order;  ///< power of eps a coefficient symbol brings
  /// Coefficients of added effects: what the expansion does not reach still acts in the full equations.
  std::set<std::string> may_act_nowhere;
  bool degree_ordering = false;
  bool automatic_order = false;  ///< `order` is what choose_orders found
  int expand_to = 2;
  std::vector<bool> mode_at_rest;
  bool excited = true;
  std::uint32_t line = 0;

  std::string place() const;  ///< "line 12, case primary", for messages
};

/// A named combination of symbols, so that printed results read like the source.
struct Shorthand {
  std::string name;
  FormulaSource source;
  Expression expression;
};

struct Lagrangian {
  FormulaSource kinetic_source, potential_source;
  Expression kinetic, potential;
};

struct RestPosition;

/// A model file (schema 1), read and checked. Physics once, resonance cases many.
struct Model {
  std::string file;
  std::string name;
  std::string source;
  std::vector<Mode> modes;
  std::optional<Lagrangian> lagrangian;
  std::vector<Excitation> excitations;
  std::vector<std::string> parameters;  ///< coefficient symbols in order of first appearance
  std::vector<std::string> strengths;   ///< of added effects (AddedEffect), among the parameters
  std::vector<ResonanceCase> cases;
  std::vector<Shorthand> shorthands;
  std::map<std::string, double> nominal;
  SymbolTable symbols;
  /// With `reference = "rest"`: what became of the model as the file states it. All else here is about rest.
  std::shared_ptr<const RestPosition> rest = nullptr;
  bool rests_at_zero = true;  ///< false while its rest position is looked for: functions may be of any argument

  const ResonanceCase& find_case(const std::string& name) const;  ///< throws InputError listing the cases
  GiNaC::ex frequency(std::size_t index) const;                ///< natural frequencies, then excitation frequencies
  const std::string& frequency_name(std::size_t index) const;  ///< in the same order
  std::size_t frequency_count() const { return modes.size() + excitations.size(); }
};

/// Throws InputError with file, line and the offending piece.
Model read_model(const std::filesystem::path& path);
/// `name` stands for the file in messages.
Model read_model_text(const std::string& text, const std::string& name);

}  // namespace secular
