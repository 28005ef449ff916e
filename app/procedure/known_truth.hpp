#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "estimator/model/compiled_model.hpp"

namespace secular::app {

/// The numbers that a simulated campaign was made with, where they are known.
class KnownTruth {
 public:
  KnownTruth() = default;
  /// `source`: an experiment or a parameter file that gives every symbol of the model; empty: not known. Throws
  /// InputError.
  KnownTruth(const std::string& source, const CompiledModel& model, const CompiledCase& resonance);

  /// Numbers by symbol of the model.
  KnownTruth(Eigen::VectorXd parameters, const CompiledModel& model, const CompiledCase& resonance)
      : model_(&model), resonance_(&resonance), parameters_(std::move(parameters)) {}

  bool known() const { return parameters_.size() > 0; }
  const Eigen::VectorXd& parameters() const { return parameters_; }  ///< by symbol of the model; empty: not known
  /// Nothing where the numbers are not known, or the model has no such symbol.
  std::optional<double> symbol(std::string_view name) const;
  /// Of a lump of the case, or of a symbol; nothing as above.
  std::optional<double> lump(std::string_view name) const;

 private:
  const CompiledModel* model_ = nullptr;
  const CompiledCase* resonance_ = nullptr;
  Eigen::VectorXd parameters_;
};

}  // namespace secular::app
