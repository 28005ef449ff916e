#pragma once

#include <optional>
#include <vector>

#include "jobs/predict/expansion_range.hpp"
#include "jobs/predict/prediction.hpp"
#include "jobs/shared/model_loading.hpp"

namespace secular {

/// Marks the points of a prediction that lie outside of ExpansionRange, with a warning that counts them. The
/// prediction must outlive it.
class RangeMarks {
 public:
  /// Without the model's file nothing is outside, and a warning says so. `threads`: of marking.
  RangeMarks(const ModelSource& source, Prediction& prediction, unsigned threads);

  void mark_diagram(const ResponseRequest& response);
  void mark_curves(const CurveRequest& request);
  void mark_backbones(const ResponseField& field);

 private:
  struct Place {
    Eigen::VectorXd parameters;
    const std::vector<std::complex<double>>* amplitude;
    bool* outside;
    bool counts;  ///< special points lie among others
  };
  void mark(std::vector<Place> places);
  void warn_of_moved_rest(const std::vector<Place>& places);

  Prediction& prediction_;
  LockedExcitations locked_;
  unsigned threads_;
  std::optional<ExpansionRange> range_;
};

}  // namespace secular
