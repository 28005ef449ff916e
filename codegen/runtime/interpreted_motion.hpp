#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/canonical/motion_derivative.hpp"
#include "codegen/canonical/motion_parts.hpp"
#include "codegen/runtime/formula_set.hpp"
#include "estimator/model/compiled_model.hpp"

namespace secular {

/// Equations of motion computed from their canonical form. `model` must outlive it.
class InterpretedMotion {
 public:
  explicit InterpretedMotion(const CanonicalModel& model);

  /// The point at which functions are evaluated; `symbol_values` in the model's order of symbols.
  struct Point {
    const double* parameters;
    const double* symbol_values;
    const ExcitationSample* excitation;
    const double* displacement;
    const double* velocity;
  };
  /// See the functions of CompiledModel.
  void mass_matrix(const Point& point, double* mass) const;
  void acceleration(const Point& point, double* acceleration) const;
  void acceleration_by_state(const Point& point, double* slope) const;
  void acceleration_by_parameters(const Point& point, double* slope) const;

 private:
  struct ArgumentPart {
    enum class Source { displacement, velocity, parameter, one };
    Source source = Source::one;
    std::size_t index = 0;
    double weight = 1;
  };
  struct InnerTerm;
  struct Factor {
    const CanonicalFactor* canonical = nullptr;
    std::vector<ArgumentPart> argument;  ///< of abs and sgn: empty for one coordinate
    std::vector<InnerTerm> inner = {};   ///< of smooth functions
  };
  struct InnerTerm {
    std::size_t coefficient = 0;  ///< in its TermList's formulas
    std::vector<Factor> factors;
  };
  struct Term {
    std::size_t coefficient = 0;  ///< in its TermList's formulas
    std::vector<Factor> factors;
    std::size_t mode = 0, column = 0;
    std::optional<std::size_t> acceleration_of;
    double weight = 1;
  };
  struct TermList {
    FormulaSet formulas;
    std::vector<Term> terms;
    std::size_t columns = 1;
    std::deque<CanonicalFactor> factors;  ///< what the terms point to
  };
  struct Part {
    std::optional<std::size_t> strength;  ///< of MotionPart
    TermList list;

    bool acts(const Point& point) const { return !strength || point.parameters[*strength] != 0; }
  };
  void add(TermList& list, const CanonicalMotionTerm& canonical, std::size_t mode, std::size_t column,
           double weight) const;
  void add_slopes(TermList& list, const std::vector<MotionVariable>& variables) const;
  Factor prepared(const CanonicalFactor& factor, FormulaSet& formulas) const;
  static double argument(const Factor& factor, const Point& point);
  static double value(const Factor& factor, const Point& point, const FormulaSet::Values& coefficient);
  static double function(const Factor& factor, const Point& point, const FormulaSet::Values& coefficient);
  /// take(term, its value) for the terms with an acceleration, or without one, of the parts that act.
  template <class Take>
  void each_term(const Point& point, bool inertia, const Take& take) const;
  void acceleration_slopes(const TermList& list, const Point& point, double* slope) const;

  const CanonicalModel& model_;
  std::deque<Part> parts_;  ///< stay where they are: terms point into them
  TermList by_state_, by_parameters_;
};

}  // namespace secular
