#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "perturb/model.hpp"

namespace secular::verify {

/// The equations of motion as numbers, evaluated directly on the parsed text of the model: nothing of the
/// derivation engine is used. Lagrangian models are not supported.
class FullEquations {
 public:
  /// `values`: every parameter, frequency and excitation amplitude by name. The model must outlive this.
  FullEquations(const Model& model, std::map<std::string, double> values);

  /// Accelerations at time t, from equations that are linear in them.
  std::vector<double> acceleration(double t, const std::vector<double>& displacement,
                                   const std::vector<double>& velocity) const;

 private:
  double value(const Expression& e, const FormulaSource& source, double t, const std::vector<double>& q,
               const std::vector<double>& v, const std::vector<double>& a) const;

  // What a leaf of the parsed text stands for, looked up once.
  struct Leaf {
    enum class Kind { constant, coordinate, time } kind = Kind::constant;
    std::size_t coordinate = 0;
    double value = 0;
  };
  void look_up(const Expression& e, const FormulaSource& source);

  const Model& model_;
  std::map<std::string, double> values_;
  std::unordered_map<const Expression*, Leaf> leaves_;
};

/// Displacements at equally spaced times, [mode][sample], by an adaptive Runge-Kutta-Fehlberg 7(8) method.
std::vector<std::vector<double>> integrated(const FullEquations& equations, std::vector<double> displacement,
                                            std::vector<double> velocity, double step, std::size_t samples);

}  // namespace secular::verify
