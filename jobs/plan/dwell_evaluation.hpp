#pragma once

#include <Eigen/Core>

#include "jobs/plan/planning.hpp"
#include "motion/response/response_field.hpp"

namespace secular {

/// What dwells of a plan tell and cost, by its inputs. Request and plan must outlive it.
class DwellEvaluation {
 public:
  DwellEvaluation(const PlanRequest& request, const PlanResult& plan);

  const ResponseField& field() const { return field_; }
  /// The grid of frequencies and levels that the request's ranges hold, in values that a file shows in full.
  CandidateRequest grid() const;
  /// Fisher information of a dwell, unknowns x unknowns, in their units.
  Eigen::MatrixXd information(const DwellState& state, int ensembles) const;
  /// Time of a programme's dwells and the standard deviations that they give the unknowns.
  void finish(Programme& programme) const;

 private:
  Eigen::MatrixXd symmetry() const;

  const PlanRequest& request_;
  const PlanResult& plan_;
  ResponseField field_;
};

}  // namespace secular
