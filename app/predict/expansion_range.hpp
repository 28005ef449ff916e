#pragma once

#include <complex>
#include <utility>
#include <vector>

#include "app/predict/prediction.hpp"
#include "app/shared/model_loading.hpp"

namespace secular::app {

/// Marks the points of a prediction that lie outside of the range in which the case's expansion says something
/// (ModelSource::outside_expansion), with a warning that counts them. The prediction must outlive it.
class ExpansionRange {
 public:
  /// Without the model's file nothing is outside, and a warning says so.
  ExpansionRange(const ModelSource& source, Prediction& prediction);

  void mark_diagram(const ResponseRequest& response);
  void mark_curves(const CurveRequest& request);
  void mark_backbones(const ResponseField& field);

 private:
  bool is_outside(const Eigen::VectorXd& parameters, const std::vector<std::complex<double>>& amplitude) const;
  void warn_of_outside(std::size_t outside, std::size_t all);

  Prediction& prediction_;
  ModelSource::OutsideExpansion outside_;
};

}  // namespace secular::app
